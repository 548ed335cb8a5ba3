#ifndef sandglass_flow_particle_in_cell_cell_integration_h
#define sandglass_flow_particle_in_cell_cell_integration_h

#include <sandglass/flow/particle_in_cell/cell_sums.h>
#include <sandglass/flow/particle_in_cell/setting.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/cell_moments.h>

#include <vector>

namespace Sandglass
{
  /**
   * How the stress in a cell is integrated to the nodes' internal forces (eq.
   * 9), by either ForceIntegration.
   *
   * The particles' volumes do not fill a cell evenly. With n particles in a
   * cell one that crosses an edge changes the force by 1/n of the stress times
   * the edge, which in finer meshes grows as 1/h beside the cell's weight. This
   * noise shakes the material, and shaken material has less friction
   * (doc/integration.md).
   *
   * With ForceIntegration::cell the mean of the particles' stress is integrated
   * over the cell as its particles fill it at the start, and only the
   * deviations from that mean by the particles; in plane triangles these
   * cancel. That is the mixed integration of Al-Kafaji (2013), but for its
   * switch between full and other cells: here the share w of a cell's own
   * integral grows smoothly with the volume ratio r of its stressed particles,
   * w = 1 - (1 - r)^2 up to r = 1. What is left of the particles' integral
   * serves free surfaces.
   *
   * The particles' mean strain is exchanged in the same way, so that forces and
   * strains belong to one energy: otherwise the stiffness is not symmetric, and
   * sparsely filled quadrilaterals near the axis throw particles out.
   */
  template <typename Setting>
  class CellIntegration
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Kinematics = typename Setting::Kinematics;
    using Shape      = typename Setting::Shape;
    using Geometry   = CellGeometry<Setting::cell_type>;
    using Sums       = CellSums<Setting, double>;
    using OfNodes    = CellValues<dim, n_nodes>;
    using Vector     = typename Setting::template Vector<>;

    /// @param points  where a cell's particles start, for
    ///                ForceIntegration::cell; none for
    ///                ForceIntegration::particles.
    CellIntegration(const Geometry                &geometry,
                    const std::vector<Point<dim>> &points)
      : geometry(geometry)
    {
      if (!points.empty())
        for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
          {
            const auto moments =
              cell_moments<Kinematics>(geometry.shape(cell), points);
            volumes.push_back(moments.volume);
            if constexpr (!Setting::has_uniform_strain)
              weights_of_filled.push_back(weights(cell, moments.mean_point));
          }
    }

    /// The volume in m^3 over which stress is integrated in a cell.
    double
    volume(const unsigned int cell, const Sums &sums) const
    {
      const double of_particles = sums.values[Sums::dense_volume];
      return volumes.empty() ? of_particles :
                               of_particles + filling(cell, of_particles) *
                                                (volumes[cell] - of_particles);
    }

    /// Volume of a cell's dense particles over its own, at most 1; 1 with
    /// ForceIntegration::particles.
    double
    share_filled(const unsigned int cell, const Sums &sums) const
    {
      return volumes.empty() ?
               1. :
               std::min(1., sums.values[Sums::dense_volume] / volumes[cell]);
    }

    /// Share of the internal force R in N at each of the cell's nodes.
    OfNodes
    force(const unsigned int cell, const Sums &sums) const
    {
      OfNodes      result       = sums.internal_force(geometry.shape(cell));
      const double of_particles = sums.values[Sums::dense_volume];
      if (volumes.empty() || !(of_particles > 0.))
        return result;

      if constexpr (Setting::has_uniform_strain)
        {
          const double factor = volume(cell, sums) / of_particles;
          for (auto &node_force : result)
            for (double &component : node_force)
              component *= factor;
        }
      else
        {
          const double *stress = &sums.values[Sums::stress];
          const Weights weights =
            exchange(cell, sums, volumes[cell] / of_particles);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              const auto of_stress =
                Kinematics::nodal_force(stress, weights.gradients[i]);
              for (unsigned int d = 0; d < dim; ++d)
                result[i][d] += of_stress[d];
              if constexpr (Setting::has_hoop_strain)
                result[i][0] += stress[Sums::n_force_components - 1] *
                                weights.values_over_radius[i];
            }
        }
      return result;
    }

    /// What is added to all particles' velocity gradients and hoop rates.
    struct RateChange
    {
      std::array<Vector, dim> gradient{}; ///< in 1/s
      double                  hoop = 0.;  ///< in 1/s

      double
      volumetric() const
      {
        return trace(gradient) + hoop;
      }
    };

    /// @param velocities  of the cell's nodes, in m/s.
    RateChange
    rate_change(const unsigned int cell,
                const Sums        &sums,
                const OfNodes     &velocities) const
    {
      RateChange change;
      if (volumes.empty() || !(sums.values[Sums::dense_volume] > 0.))
        return change;
      const Weights weights = exchange(cell, sums, 1.);
      if constexpr (!Setting::has_constant_gradients) // or there is none
        change.gradient = gradient_of(velocities, weights.gradients);
      if constexpr (Setting::has_hoop_strain)
        for (unsigned int i = 0; i < n_nodes; ++i)
          change.hoop += velocities[i][0] * weights.values_over_radius[i];
      return change;
    }

  private:
    /// The nodes' weights in the rows of B.
    struct Weights
    {
      std::array<Vector, n_nodes> gradients;          ///< in 1/m
      std::array<double, n_nodes> values_over_radius; ///< in 1/m
    };

    /// w in 0 to 1; cells that are more than full count as full.
    double
    filling(const unsigned int cell, const double volume_of_particles) const
    {
      const double empty =
        std::max(0., 1. - volume_of_particles / volumes[cell]);
      return 1. - empty * empty;
    }

    /// w times a difference: the values at the mean point of the filled cell,
    /// times a factor, less those at the particles' mean point. It is zero for
    /// particles that fill the cell as at the start.
    Weights
    exchange(const unsigned int cell,
             const Sums        &sums,
             const double       factor) const
    {
      const double   w         = filling(cell, sums.values[Sums::dense_volume]);
      const Weights &of_filled = weights_of_filled[cell];
      Weights        result    = weights(cell, sums.mean_point());
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          for (unsigned int d = 0; d < dim; ++d)
            result.gradients[i][d] =
              w * (factor * of_filled.gradients[i][d] - result.gradients[i][d]);
          if constexpr (Setting::has_hoop_strain)
            result.values_over_radius[i] =
              w * (factor * of_filled.values_over_radius[i] -
                   result.values_over_radius[i]);
        }
      return result;
    }

    Weights
    weights(const unsigned int cell, const Vector &point) const
    {
      const Shape &shape = geometry.shape(cell);
      Weights      result;
      result.gradients = shape.shape_gradients(point);
      if constexpr (Setting::has_hoop_strain)
        {
          const double radius       = shape.to_real(point_of(point))[0];
          result.values_over_radius = Shape::shape_values(point);
          const double per_radius   = 1. / radius;
          for (double &value : result.values_over_radius)
            value *= per_radius;
        }
      return result;
    }

    const Geometry &geometry;
    /// Volume of each filled cell, in m^3; none where particles integrate.
    std::vector<double> volumes;
    /// Weights at each filled cell's mean point; none where strain is uniform.
    std::vector<Weights> weights_of_filled;
  };
} // namespace Sandglass

#endif
