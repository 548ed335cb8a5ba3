#ifndef sandglass_flow_updated_lagrangian_motion_moving_body_h
#define sandglass_flow_updated_lagrangian_motion_moving_body_h

#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/flow/updated_lagrangian/motion/motion_setting.h>
#include <sandglass/flow/updated_lagrangian/motion/moving_grid.h>
#include <sandglass/flow/updated_lagrangian/motion/rigid_contact.h>
#include <sandglass/flow/updated_lagrangian/newmark_motion.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezone.h>

#include <functional>
#include <memory>
#include <vector>

namespace Sandglass
{
  /// All that is known of the material at one time: what re-zoning maps, with
  /// acceleration and displacement as nodal fields, stress and the law's state
  /// as point fields.
  struct MaterialState
  {
    MeshState at;
    /// Of the mass quadrature points, cell by cell, in kg.
    std::vector<double> point_masses;
  };

  /**
   * The material between two re-zonings, as finite elements in motion: what
   * NewmarkMotion needs, made for one mesh.
   */
  class MovingBody
  {
  public:
    /**
     * @param state  its mesh has walls as marks. Stress is brought back to what
     *               the law admits.
     * @param time,first_step  see NewmarkMotion::go_on(), in s.
     */
    MovingBody(const MotionSetting &setting,
               const MaterialState &state,
               const double         time,
               const double         first_step);

    MaterialState
    state() const;

    /// Masses of the cells in kg (plane strain: per m).
    std::vector<double>
    cell_masses() const;

    TriangleMesh
    mesh() const
    {
      return grid.displaced(motion.displacement());
    }

    /// Of the cells, all the same.
    unsigned int
    n_points_per_cell() const
    {
      return grid.elements.quadrature.size();
    }

    void
    save(boost::archive::binary_oarchive &archive) const;

    /// What save() has written of a body of this mesh.
    void
    load(boost::archive::binary_iarchive &archive);

    const MotionSetting                  &setting;
    const MovingGrid                      grid;
    const std::unique_ptr<Equilibrium<2>> equilibrium;
    const std::vector<double>             point_masses;
    const ConsistentMass<2>               consistent_mass;
    RigidContact                          contact;
    NewmarkMotion<2>                      motion;

  private:
    /// Of the nodes of this mesh when it was made, in m.
    MeshField displacement_before;
  };

  /// Of each cell, the sum over its points, of which all cells have equally
  /// many.
  std::vector<double>
  sums_by_cell(const std::vector<double> &of_points,
               const unsigned int         n_cells);

  /// Masses of points of even density in a mesh without displacement.
  std::vector<double>
  even_point_masses(const TriangleMesh &mesh,
                    const Depth        &depth,
                    const double        density);

  /**
   * Masses of the mass quadrature points, from a density at the stress
   * quadrature points, each body's scaled to what it has to have.
   *
   * @param body_masses  in kg.
   */
  std::vector<double>
  point_masses_of(const TriangleMesh        &mesh,
                  const Depth               &depth,
                  const std::vector<double> &density,
                  const std::vector<double> &body_masses);

  /// Weight of point masses at a grid's nodes, in N with ghost entries.
  DisplacementVector
  weight_of(const MovingGrid          &grid,
            const std::vector<double> &point_masses,
            const Tensor<1, 2>        &gravity);
} // namespace Sandglass

#endif
