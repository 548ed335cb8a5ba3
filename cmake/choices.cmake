# The one table of compile-time choices. What is not listed is not compiled, and
# not offered; what is listed is compiled with all others of its dimension, each
# kinematics with each cell type in files of their own, so that they compile at
# the same time. Of the particle stage only the pass over the particles is
# compiled for each law.

# How the grid's dimensions stand for space: dimension and class, which
# include/sandglass/continuum has in a file of its name.
set(choices_of_kinematics
  "2 PlaneStrain"
  "2 Axisymmetric"
  "3 Solid")

# Shapes of cells: dimension and value of CellType.
set(choices_of_cell_types
  "2 triangle"
  "2 quadrilateral"
  "3 tetrahedron"
  "3 hexahedron")

# Constitutive laws that Material/Model offers: the class, which
# include/sandglass/material has in a file of its name.
set(choices_of_laws
  DruckerPrager
  MatsuokaNakai
  MuI
  VonWolffersdorff
  WuBauer
  Kolymbas
  Lade
  Umat)

# Those of them that Material/Stress rate = Green-Naghdi offers as well, in two
# dimensions.
set(choices_of_laws_with_green_naghdi
  DruckerPrager
  MatsuokaNakai)


# --- What follows from it ------------------------------------------------------

# PlaneStrain -> plane_strain
function(sandglass_file_of result class)
  string(REGEX REPLACE "([a-z])([A-Z])" "\\1_\\2" name ${class})
  string(TOLOWER ${name} name)
  set(${result} ${name} PARENT_SCOPE)
endfunction()

set(laws_includes "")
foreach(law ${choices_of_laws})
  sandglass_file_of(file ${law})
  string(APPEND laws_includes "#include <sandglass/material/${file}.h>\n")
endforeach()
set(laws_of_3 ${choices_of_laws})
list(TRANSFORM choices_of_laws_with_green_naghdi REPLACE "(.+)" "GreenNaghdi<\\1>")
list(APPEND choices_of_laws ${choices_of_laws_with_green_naghdi})
set(laws_of_2 ${choices_of_laws})
foreach(dimension 2 3)
  list(TRANSFORM laws_of_${dimension} REPLACE "(.+)" "INSTANTIATE(\\1)")
  list(JOIN laws_of_${dimension} " " laws_of_${dimension})
endforeach()
set(choices_dimensions "")
set(kinematics_list "")
set(cell_type_list "")
set(kinematics_includes "")
foreach(entry ${choices_of_kinematics})
  string(REPLACE " " ";" entry ${entry})
  list(GET entry 0 dimension)
  list(GET entry 1 kinematics)
  list(APPEND choices_dimensions ${dimension})
  list(APPEND kinematics_list ${kinematics})
  sandglass_file_of(file ${kinematics})
  string(APPEND kinematics_includes "#include <sandglass/continuum/${file}.h>\n")
  set(source ${PROJECT_BINARY_DIR}/source/material_equilibrium_${file}.cc)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/material_equilibrium.cc.in ${source} @ONLY)
  list(APPEND choices_sources ${source})

  foreach(cells ${choices_of_cell_types})
    string(REPLACE " " ";" cells ${cells})
    list(GET cells 0 cells_dimension)
    list(GET cells 1 cell_type)
    if(dimension EQUAL cells_dimension)
      set(laws_to_instantiate ${laws_of_${dimension}})
      set(source ${PROJECT_BINARY_DIR}/source/particle_stage_${file}_${cell_type}.cc)
      configure_file(${CMAKE_CURRENT_LIST_DIR}/particle_stage.cc.in ${source} @ONLY)
      list(APPEND choices_sources ${source})
      set(source ${PROJECT_BINARY_DIR}/source/particle_laws_${file}_${cell_type}.cc)
      configure_file(${CMAKE_CURRENT_LIST_DIR}/particle_laws.cc.in ${source} @ONLY)
      list(APPEND choices_sources ${source})
    endif()
  endforeach()
endforeach()
foreach(cells ${choices_of_cell_types})
  string(REPLACE " " ";" cells ${cells})
  list(GET cells 0 dimension)
  list(GET cells 1 cell_type)
  list(APPEND cell_type_list "CellTypeTag<CellType::${cell_type}, ${dimension}>")
endforeach()
list(REMOVE_DUPLICATES choices_dimensions)
list(TRANSFORM choices_dimensions REPLACE "(.+)" "INSTANTIATE(\\1)")
list(JOIN choices_dimensions " " choices_dimensions)
list(JOIN kinematics_list ", " choices_kinematics)
list(JOIN cell_type_list ", " choices_cell_types)
list(JOIN choices_of_laws ", " choices_laws)
# A header each: many files need the dimensions, few the laws, which take the
# compiler two seconds.
foreach(header "dimensions dimensions" "kinematics all_kinematics" "laws all_laws")
  string(REPLACE " " ";" header ${header})
  list(GET header 0 choices)
  list(GET header 1 file)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/choices_of_${choices}.h.in
    ${PROJECT_BINARY_DIR}/include/sandglass/choices/${file}.h @ONLY)
endforeach()
