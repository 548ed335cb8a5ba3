#ifndef sandglass_flow_updated_lagrangian_rezoning_body_totals_h
#define sandglass_flow_updated_lagrangian_rezoning_body_totals_h

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <array>
#include <vector>

namespace Sandglass
{
  /// What is kept, or should be; in plane strain all but the area per m.
  struct BodyTotals
  {
    double       area = 0.;           ///< of the section, in m^2
    double       mass = 0.;           ///< in kg
    Tensor<1, 2> momentum;            ///< in kg m/s
    double       kinetic_energy = 0.; ///< in J

    BodyTotals &
    operator+=(const BodyTotals &other);
  };

  /// Sum over the bodies.
  BodyTotals
  sum(const std::vector<BodyTotals> &bodies);

  /// Mass in kg of each cell.
  std::vector<double>
  cell_masses(const TriangleMesh        &mesh,
              const Quadrature<2>       &quadrature,
              const Depth               &depth,
              const std::vector<double> &density);

  /**
   * Totals of each body, as the consistent mass matrix has them that is
   * integrated by this quadrature.
   *
   * @param density   at the quadrature points, in kg/m^3.
   * @param velocity  at the nodes, two components, in m/s.
   */
  std::vector<BodyTotals>
  body_totals(const TriangleMesh        &mesh,
              const Quadrature<2>       &quadrature,
              const Depth               &depth,
              const std::vector<double> &density,
              const MeshField           &velocity);

  /**
   * Scale each body's density so that it has its mass again.
   *
   * @param actual  totals of the bodies now.
   */
  void
  restore_mass(const TriangleMesh            &mesh,
               const std::vector<BodyTotals> &wanted,
               const std::vector<BodyTotals> &actual,
               std::vector<double>           &density);

  /**
   * Add a velocity to each body, the same at all its nodes, so that it has its
   * momentum again. The densities have to be the final ones.
   *
   * @param is_restored  components to which that applies: round an axis the
   *                     radial one is no sum of anything that is kept.
   */
  void
  restore_momentum(const TriangleMesh            &mesh,
                   const std::vector<BodyTotals> &wanted,
                   const std::vector<BodyTotals> &actual,
                   const std::array<bool, 2>     &is_restored,
                   MeshField                     &velocity);
} // namespace Sandglass

#endif
