#ifndef sandglass_flow_particle_in_cell_box_friction_h
#define sandglass_flow_particle_in_cell_box_friction_h

#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/walls/wall_parameters.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Sandglass
{
  /**
   * Friction of the front and the back of a box that the plane is the middle
   * of: 2 mu p / W against the motion, per volume, in a box of the depth W
   * (zhou2017). The pressure p on them is the mean of the stresses in the
   * plane, as it is in plastic flow that keeps the volume.
   *
   * A node loses as much of the velocity that it would have at the end of the
   * step as friction can take, all of it where the limit is not reached.
   */
  template <typename Setting>
  class BoxFriction
  {
  public:
    static constexpr int dim = Setting::dim;

    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;

    /// `geometry` has to live as long as this object.
    BoxFriction(const Utilities::MPI::Partitioner &nodes,
                const Geometry                    &geometry,
                const WallParameters              &walls)
      : is_on(walls.box_depth > 0.)
      , geometry(geometry)
      , nodes(nodes)
      , friction_per_depth(
          is_on ? 2. * walls.box_friction_coefficient() / walls.box_depth : 0.)
    {
      if (is_on)
        limits.emplace(nodes);
    }

    /**
     * Slow the nodes down, before contact sees them.
     *
     * @param cells  sums over the particles as they are.
     * @param[in,out] acceleration  of the nodes that this rank owns, in m/s^2.
     * @return the work that friction takes on this rank in the step, in J.
     */
    double
    brake(const Blocks             &blocks,
          const NodalSums<Setting> &cells,
          const NodalSumField<dim> &sums,
          const double              time_step,
          NodalField<dim>          &acceleration)
    {
      using NodalSum = Sandglass::NodalSum<dim>;
      find_limits(blocks, cells);
      double work = 0.;
      for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
        {
          const double *of_node = sums.at(node);
          const double  mass    = of_node[NodalSum::mass];
          if (!(mass > 0.))
            continue;
          std::array<double, dim> velocity;
          double                  square = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              velocity[d] = of_node[NodalSum::momentum + d] / mass +
                            time_step * acceleration.at(node)[d];
              square += velocity[d] * velocity[d];
            }
          const double speed = std::sqrt(square);
          const double loss =
            std::min(speed, time_step * limits->at(node)[0] / mass);
          if (!(loss > 0.))
            continue;
          for (unsigned int d = 0; d < dim; ++d)
            acceleration.at(node)[d] -=
              loss / (speed * time_step) * velocity[d];
          work += mass * loss * (speed - 0.5 * loss);
        }
      return work;
    }

    /// Whether there is a box.
    const bool is_on;

  private:
    /// Each cell's friction in N at its nodes, by their shares of the mass.
    void
    find_limits(const Blocks &blocks, const NodalSums<Setting> &cells)
    {
      using Sums = CellSums<Setting, double>;
      limits->start_sum();
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        const auto  &values   = cells[cell].values;
        const double pressure = -0.5 * (values[Sums::stress + Component::xx] +
                                        values[Sums::stress + Component::yy]);
        if (!(pressure > 0.))
          return;
        const auto masses = cells[cell].lumped_masses();
        double     mass   = 0.;
        for (const double of_node : masses)
          mass += of_node;
        const auto &cell_nodes = geometry.nodes(cell);
        for (unsigned int i = 0; i < masses.size(); ++i)
          limits->at(cell_nodes[i])[0] +=
            friction_per_depth * pressure * masses[i] / mass;
      });
      limits->finish_sum();
    }

    const Geometry                    &geometry;
    const Utilities::MPI::Partitioner &nodes;
    std::optional<NodalField<1>>       limits;             ///< in N
    const double                       friction_per_depth; ///< 2 mu / W, in 1/m
  };
} // namespace Sandglass

#endif
