#include <sandglass/base/exceptions.h>
#include <sandglass/study/convergence_study.h>
#include <sandglass/study/smallest_outlet.h>
#include <sandglass/study/study.h>

namespace Sandglass
{
  namespace
  {
    constexpr Study studies[] = {{"convergence", study_convergence},
                                 {"smallest-outlet", study_smallest_outlet}};
  } // namespace



  const Study &
  find_study(const std::string &name)
  {
    std::string names;
    for (const Study &study : studies)
      {
        if (name == study.name)
          return study;
        names += (names.empty() ? "" : ", ") + std::string(study.name);
      }
    throw InputError("--study " + name +
                     ": there is no such study; allowed is " + names);
  }
} // namespace Sandglass
