#ifndef sandglass_particle_stage_internal_force_h
#define sandglass_particle_stage_internal_force_h

#include <sandglass/particle_stage/cell_sums.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/cell_integrals.h>

#include <vector>

namespace Sandglass
{
  /**
   * Step 3 of Section 4.4: a cell's share of the nodes' internal forces (eq.
   * 9), by either ForceIntegration.
   *
   * The particles' volumes do not fill a cell evenly. With n particles in a
   * cell one that crosses an edge changes the force by 1/n of the stress times
   * the edge, which in finer meshes grows as 1/h beside the cell's weight. This
   * noise shakes the material, and shaken material has less friction
   * (doc/integration.md).
   *
   * With ForceIntegration::cell the mean of the particles' stress is integrated
   * over the cell itself, exactly, and only the deviations from that mean by
   * the particles; in triangles these cancel but for the hoop's part. That is
   * the mixed integration of Al-Kafaji (2013), but for its switch between full
   * and other cells: here the share w of a cell's own integral grows smoothly
   * with the volume ratio r of its stressed particles, w = 1 - (1 - r)^2 up to
   * r = 1. What is left of the particles' integral serves free surfaces.
   */
  template <typename Setting>
  class InternalForce
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;
    using Sums                            = CellSums<Setting, double>;

    InternalForce(const Geometry &geometry, const ForceIntegration integration)
      : geometry(geometry)
    {
      if (integration == ForceIntegration::cell)
        for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
          integrals.push_back(
            integrate_over(geometry.shape(cell), Setting::formulation));
    }

    /// The volume in m^3 over which stress is integrated in a cell.
    double
    volume(const unsigned int cell, const Sums &sums) const
    {
      const double of_particles = sums.values[Sums::stiff_volume];
      return integrals.empty() ?
               of_particles :
               of_particles + filling(cell, of_particles) *
                                (integrals[cell].volume - of_particles);
    }

    /// In N, at each of the cell's nodes.
    CellValues<dim, n_nodes>
    of_cell(const unsigned int cell, const Sums &sums) const
    {
      auto         result       = sums.internal_force(geometry.shape(cell));
      const double of_particles = sums.values[Sums::stiff_volume];
      if (integrals.empty() || !(of_particles > 0.))
        return result;

      if constexpr (Setting::has_uniform_strain)
        {
          const double factor = volume(cell, sums) / of_particles;
          for (auto &node_force : result)
            for (double &component : node_force)
              component *= factor;
        }
      else
        exchange_mean(cell, sums, result);
      return result;
    }

  private:
    /// w in 0 to 1; cells that are more than full count as full.
    double
    filling(const unsigned int cell, const double volume_of_particles) const
    {
      const double empty =
        std::max(0., 1. - volume_of_particles / integrals[cell].volume);
      return 1. - empty * empty;
    }

    /// Take the share w of what the mean stress does in the particles' integral
    /// out of a force, and put the cell's integral in its place.
    void
    exchange_mean(const unsigned int        cell,
                  const Sums               &sums,
                  CellValues<dim, n_nodes> &force) const
    {
      const Shape &shape        = geometry.shape(cell);
      const auto  &integral     = integrals[cell];
      const double of_particles = sums.values[Sums::stiff_volume];
      const double w            = filling(cell, of_particles);
      const double mean_weight  = w / of_particles;
      const auto   point        = sums.mean_point();
      const auto   gradients    = shape.shape_gradients(point);
      const auto   shape_values = Shape::shape_values(point);
      const double radius = shape.to_real(Point<dim>(point[0], point[1]))[0];

      const double *stress = &sums.values[Sums::stress];
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          Pair<double> difference;
          for (unsigned int d = 0; d < dim; ++d)
            difference[d] =
              mean_weight * integral.gradients[i][d] - w * gradients[i][d];
          const auto of_stress =
            nodal_force(stress[0], stress[1], stress[2], difference);
          for (unsigned int d = 0; d < dim; ++d)
            force[i][d] += of_stress[d];
          if constexpr (Setting::has_hoop_strain)
            force[i][0] +=
              stress[3] * (mean_weight * integral.values_over_radius[i] -
                           w * shape_values[i] / radius);
        }
    }

    const Geometry                                &geometry;
    std::vector<CellIntegrals<Setting::cell_type>> integrals; ///< none: not on
  };
} // namespace Sandglass

#endif
