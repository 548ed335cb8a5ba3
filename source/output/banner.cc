#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>

#include <sandglass/output/banner.h>
#include <sandglass/version.h>

#include <gmsh.h>
#include <vtkVersionMacros.h>

#include <sstream>

namespace Sandglass
{
  std::string
  name_and_version()
  {
    return "Sandglass " SANDGLASS_VERSION " (" SANDGLASS_GIT_HASH ")";
  }



  std::string
  banner(const MPI_Comm communicator)
  {
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    std::ostringstream text;
    text << name_and_version() << ", " << SANDGLASS_BUILD_TYPE << " build, "
         << n_ranks << (n_ranks == 1 ? " rank\n" : " ranks\n") << "deal.II "
         << DEAL_II_PACKAGE_VERSION << ", Trilinos "
         << DEAL_II_TRILINOS_VERSION_MAJOR << '.'
         << DEAL_II_TRILINOS_VERSION_MINOR << '.'
         << DEAL_II_TRILINOS_VERSION_SUBMINOR << ", Gmsh " << GMSH_API_VERSION
         << ", VTK " << VTK_VERSION << '\n';
    return text.str();
  }
} // namespace Sandglass
