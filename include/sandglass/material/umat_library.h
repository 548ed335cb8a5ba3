#ifndef sandglass_material_umat_library_h
#define sandglass_material_umat_library_h

#include <sandglass/material/material_constants.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * What one call of a user-material subroutine gets and gives, in Abaqus'
   * conventions: components 11, 22, 33, 12, 13, 23, shear strains as
   * engineering strains, tension positive. What Sandglass doesn't know
   * (temperature, fields, place, element, total strain and time) is handed over
   * as zero, or one where it counts or divides.
   */
  struct UmatCall
  {
    /// @param n_shear  one in plane strain and axisymmetry, three in space.
    explicit UmatCall(const int n_shear)
      : n_shear(n_shear)
      , stress(3 + n_shear, 0.)
      , strain_increment(3 + n_shear, 0.)
      , stiffness((3 + n_shear) * (3 + n_shear), 0.)
    {}

    int                 n_shear;
    std::vector<double> stress;           ///< in and out, turned, in Pa
    std::vector<double> state;            ///< in and out
    std::vector<double> strain_increment; ///< of the step
    std::vector<double> stiffness; ///< out, Pa, column by column; zero if unset
    double              time_step = 0.; ///< in s; zero in the state at rest
    /// Of the step: x at its end = rotation x at its start.
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    /// Out: the time step that the subroutine asks for, over this one.
    double new_time_step_share = 1.;
  };

  /**
   * A shared library with Abaqus' user-material subroutine: `umat_`, as Fortran
   * compilers name it, or `umat`, written in C. It stays loaded as long as an
   * object or a copy of one lives.
   *
   * The library may also export the subroutine `sandglass_umat_sizes_(nprops,
   * nstatv)`, which sets two integers to what its UMAT needs; without it, wrong
   * numbers can't be found out.
   */
  class UmatLibrary
  {
  public:
    /// Load the library that the constants name. Throws InputError if it can't
    /// be, lacks the subroutine, or says that it needs other sizes.
    explicit UmatLibrary(const MaterialConstants &constants);

    /// Throws LawFailure if the subroutine calls Abaqus' XIT, or STDB_ABQERR
    /// with a severity that ends an analysis.
    void
    operator()(UmatCall &call) const;

  private:
    void
    check_sizes(const MaterialConstants &constants) const;

    void *
    symbol(const char *name) const;

    std::string           path;
    std::shared_ptr<void> handle;
    std::vector<double>   constants;
    /// One of the two; they differ by the hidden length of a Fortran string.
    void *fortran_subroutine;
    void *c_function;
  };
} // namespace Sandglass

#endif
