#include <sandglass/base/exceptions.h>
#include <sandglass/material/law_failure.h>
#include <sandglass/material/umat_library.h>

#include <dlfcn.h>

#include <cstring>
#include <filesystem>
#include <system_error>

// Abaqus' names and order of the arguments; all are passed by reference.
#define SANDGLASS_UMAT_ARGUMENTS                                              \
  double *STRESS, double *STATEV, double *DDSDDE, double *SSE, double *SPD,   \
    double *SCD, double *RPL, double *DDSDDT, double *DRPLDE, double *DRPLDT, \
    const double *STRAN, const double *DSTRAN, const double *TIME,            \
    const double *DTIME, const double *TEMP, const double *DTEMP,             \
    const double *PREDEF, const double *DPRED, const char *CMNAME,            \
    const int *NDI, const int *NSHR, const int *NTENS, const int *NSTATV,     \
    const double *PROPS, const int *NPROPS, const double *COORDS,             \
    const double *DROT, double *PNEWDT, const double *CELENT,                 \
    const double *DFGRD0, const double *DFGRD1, const int *NOEL,              \
    const int *NPT, const int *LAYER, const int *KSPT, const int *KSTEP,      \
    const int *KINC

namespace
{
  using FortranUmat = void(SANDGLASS_UMAT_ARGUMENTS, std::size_t);
  using CUmat       = void(SANDGLASS_UMAT_ARGUMENTS);
  using Sizes       = void(int *n_constants, int *n_state_variables);

  const std::string section = "Material";

  /// The linker's last complaint.
  std::string
  linker_message()
  {
    const char *const message = dlerror();
    return message ? message : "unknown";
  }

  /// F of the step, to first order: its strain is that of the turned axes.
  Eigen::Matrix3d
  deformation_gradient(const Sandglass::UmatCall &call)
  {
    const auto     &strain = call.strain_increment;
    Eigen::Matrix3d stretch =
      Eigen::Vector3d(1. + strain[0], 1. + strain[1], 1. + strain[2])
        .asDiagonal();
    stretch(0, 1) = stretch(1, 0) = 0.5 * strain[3];
    if (call.n_shear == 3)
      {
        stretch(0, 2) = stretch(2, 0) = 0.5 * strain[4];
        stretch(1, 2) = stretch(2, 1) = 0.5 * strain[5];
      }
    return stretch * call.rotation;
  }
} // namespace

// What Abaqus offers to subroutines to end an analysis. A library that calls
// them finds them in the program, whose link options export them.
extern "C" void
xit_()
{
  throw Sandglass::LawFailure("it called XIT");
}

extern "C" void
stdb_abqerr_(const int  *severity,
             const char *message,
             const int *,
             const double *,
             const char *,
             const std::size_t length,
             const std::size_t)
{
  if (*severity == -3)
    throw Sandglass::LawFailure("it called STDB_ABQERR: " +
                                std::string(message, length));
}

namespace Sandglass
{
  UmatLibrary::UmatLibrary(const MaterialConstants &constants)
    : constants(constants.umat_constants)
  {
    const std::string &given = constants.umat_library;
    if (given.empty())
      throw InputError(section,
                       "UMAT library",
                       given,
                       "the path of a shared library is needed, because the "
                       "model is UMAT");
    std::error_code unreadable; // not an exception, whatever the path is
    if (!std::filesystem::is_regular_file(given, unreadable))
      throw InputError(section, "UMAT library", given, "there is no such file");

    // A name without a slash would be looked for in the system's directories.
    path = std::filesystem::absolute(given).string();
    if (void *const opened = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
      handle = std::shared_ptr<void>(opened, dlclose);
    else
      throw InputError(section,
                       "UMAT library",
                       given,
                       "the file can't be loaded as a shared library (" +
                         linker_message() + ")");

    fortran_subroutine = symbol("umat_");
    c_function         = symbol("umat");
    if (!fortran_subroutine && !c_function)
      throw InputError(section,
                       "UMAT library",
                       given,
                       "the library has neither umat_ (Fortran's subroutine "
                       "UMAT) nor umat (C)");
    check_sizes(constants);
  }



  void
  UmatLibrary::check_sizes(const MaterialConstants &constants) const
  {
    void *const sizes = symbol("sandglass_umat_sizes_");
    if (!sizes)
      return;
    int n_constants = 0, n_state_variables = 0;
    reinterpret_cast<Sizes *>(sizes)(&n_constants, &n_state_variables);

    const auto refuse_unless = [this](const std::string &name,
                                      const std::size_t  given,
                                      const int          needed,
                                      const std::string &what) {
      if (given != static_cast<std::size_t>(needed))
        throw InputError("section '" + section + "', parameter '" + name +
                           "': " + std::to_string(given) + " " + what +
                           ", and the library '" + path + "' needs " +
                           std::to_string(needed),
                         section,
                         name);
    };
    refuse_unless("UMAT constants",
                  constants.umat_constants.size(),
                  n_constants,
                  "constants");
    refuse_unless("UMAT state variables",
                  constants.n_umat_state_variables,
                  n_state_variables,
                  "state variables");
  }



  void *
  UmatLibrary::symbol(const char *const name) const
  {
    return dlsym(handle.get(), name);
  }



  void
  UmatLibrary::operator()(UmatCall &call) const
  {
    const int n_normal = 3;
    const int n        = n_normal + call.n_shear;
    const int n_state  = call.state.size();
    const int n_props  = constants.size();
    const int one      = 1;

    // Some compilers' checks refuse the address of an empty array.
    double              no_number = 0.;
    double *const       state = n_state > 0 ? call.state.data() : &no_number;
    const double *const props = n_props > 0 ? constants.data() : &no_number;

    // Outputs that nobody reads, and inputs that are not known.
    double       energies[3] = {}, heat = 0., heat_by_temperature = 0.;
    double       stress_by_temperature[6] = {}, heat_by_strain[6] = {};
    const double strain[6] = {}, time[2] = {}, place[3] = {}, nothing = 0.;
    const double length = 1.;
    char         name[80];
    std::memset(name, ' ', sizeof(name));
    std::memcpy(name, "SANDGLASS", 9);

    const Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d end   = deformation_gradient(call);

    const auto run = [&](const auto function, const auto... hidden) {
      function(call.stress.data(),
               state,
               call.stiffness.data(),
               &energies[0],
               &energies[1],
               &energies[2],
               &heat,
               stress_by_temperature,
               heat_by_strain,
               &heat_by_temperature,
               strain,
               call.strain_increment.data(),
               time,
               &call.time_step,
               &nothing,
               &nothing,
               &nothing,
               &nothing,
               name,
               &n_normal,
               &call.n_shear,
               &n,
               &n_state,
               props,
               &n_props,
               place,
               call.rotation.data(),
               &call.new_time_step_share,
               &length,
               start.data(),
               end.data(),
               &one,
               &one,
               &one,
               &one,
               &one,
               &one,
               hidden...);
    };
    if (fortran_subroutine)
      run(reinterpret_cast<FortranUmat *>(fortran_subroutine), sizeof(name));
    else
      run(reinterpret_cast<CUmat *>(c_function));
  }
} // namespace Sandglass
