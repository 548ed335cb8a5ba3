#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/body_totals.h>

namespace Sandglass
{
  BodyTotals &
  BodyTotals::operator+=(const BodyTotals &other)
  {
    area += other.area;
    mass += other.mass;
    momentum += other.momentum;
    kinetic_energy += other.kinetic_energy;
    return *this;
  }



  BodyTotals
  sum(const std::vector<BodyTotals> &bodies)
  {
    BodyTotals result;
    for (const BodyTotals &body : bodies)
      result += body;
    return result;
  }



  std::vector<double>
  cell_masses(const TriangleMesh        &mesh,
              const Quadrature<2>       &quadrature,
              const Depth               &depth,
              const std::vector<double> &density)
  {
    const auto volumes = quadrature_volumes(mesh, quadrature, depth);
    AssertDimension(density.size(), volumes.size());
    std::vector<double> masses(mesh.cells.size(), 0.);
    for (std::size_t i = 0; i < volumes.size(); ++i)
      masses[i / quadrature.size()] += density[i] * volumes[i];
    return masses;
  }



  std::vector<BodyTotals>
  body_totals(const TriangleMesh        &mesh,
              const Quadrature<2>       &quadrature,
              const Depth               &depth,
              const std::vector<double> &density,
              const MeshField           &velocity)
  {
    AssertDimension(velocity.n_components, 2);
    AssertDimension(velocity.values.size(), 2 * mesh.nodes.size());
    const auto volumes = quadrature_volumes(mesh, quadrature, depth);
    const auto areas   = cell_areas(mesh);
    AssertDimension(density.size(), volumes.size());

    std::vector<BodyTotals> totals(mesh.n_bodies());
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        BodyTotals &body = totals[mesh.bodies[cell]];
        body.area += areas[cell];
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const std::size_t i    = cell * quadrature.size() + q;
            const double      mass = density[i] * volumes[i];
            Tensor<1, 2>      v;
            evaluate_in_cell(
              mesh, velocity, cell, quadrature.point(q), v.begin_raw());
            body.mass += mass;
            body.momentum += mass * v;
            body.kinetic_energy += mass * v.norm_square() / 2.;
          }
      }
    return totals;
  }



  void
  restore_mass(const TriangleMesh            &mesh,
               const std::vector<BodyTotals> &wanted,
               const std::vector<BodyTotals> &actual,
               std::vector<double>           &density)
  {
    const std::size_t n_points = density.size() / mesh.cells.size();
    for (std::size_t i = 0; i < density.size(); ++i)
      {
        const unsigned int body = mesh.bodies[i / n_points];
        density[i] *= wanted[body].mass / actual[body].mass;
      }
  }



  void
  restore_momentum(const TriangleMesh            &mesh,
                   const std::vector<BodyTotals> &wanted,
                   const std::vector<BodyTotals> &actual,
                   const std::array<bool, 2>     &is_restored,
                   MeshField                     &velocity)
  {
    const auto bodies = bodies_of_nodes(mesh);
    for (unsigned int node = 0; node < bodies.size(); ++node)
      for (unsigned int d = 0; d < 2; ++d)
        if (is_restored[d] && bodies[node] != numbers::invalid_unsigned_int)
          {
            const unsigned int body = bodies[node];
            velocity.at(node)[d] +=
              (wanted[body].momentum[d] - actual[body].momentum[d]) /
              actual[body].mass;
          }
  }
} // namespace Sandglass
