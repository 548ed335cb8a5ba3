# What the programs of tests and benchmarks share: *.cc but main.cc.

file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cc)
list(REMOVE_ITEM sources ${CMAKE_CURRENT_LIST_DIR}/main.cc)
add_library(test_fixtures STATIC ${sources})
sandglass_setup_target(test_fixtures)
target_include_directories(test_fixtures PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(test_fixtures sandglass_library GTest::gtest)
