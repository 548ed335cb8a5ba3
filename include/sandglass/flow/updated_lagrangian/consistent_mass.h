#ifndef sandglass_flow_updated_lagrangian_consistent_mass_h
#define sandglass_flow_updated_lagrangian_consistent_mass_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/flow/updated_lagrangian/node_constraints.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>

#include <functional>
#include <vector>

namespace Sandglass
{
  /**
   * The consistent mass matrix M of a grid: the integrals of density times two
   * nodes' shape functions. Mass moves with the material, so that M stays what
   * it is where the material is when the grid is made.
   *
   * Its rows' sums are the nodes' shares of mass in Equilibrium's weight: a
   * free body falls without strain. In linear triangles, which have one
   * quadrature point, the point's mass is spread evenly over the cell.
   */
  template <int dim>
  class ConsistentMass
  {
  public:
    using Vector = DisplacementVector;

    /// In kg/m^3, at a point of the grid before any displacement.
    using Density = std::function<double(const Point<dim> &)>;

    ConsistentMass(const ElementGrid<dim> &grid,
                   const Formulation       formulation,
                   const Density          &density);

    /// @param point_masses  of the grid's mass quadrature points, cell by cell
    ///                      of ElementGrid::local_cells, in kg. They stand for
    ///                      material on a curved or denser grid, too.
    ConsistentMass(const ElementGrid<dim>    &grid,
                   const std::vector<double> &point_masses);

    /// Add M a to nodal forces, in N.
    /// @param acceleration  a, in m/s^2, with ghost entries.
    /// @param forces        their owned entries are changed.
    void
    add_forces(const Vector &acceleration, Vector &forces) const;

    /// Add M times a factor in 1/s^2 to the tangent of the nodes' equations.
    void
    add_tangent(const double                factor,
                const NodeConstraints<dim> &constraints,
                TangentMatrix<dim>         &tangent) const;

    /// In J (plane strain: per m of depth). Collective.
    /// @param velocity  in m/s, with ghost entries.
    double
    kinetic_energy(const Vector &velocity) const;

    /// In kg (plane strain: per m of depth). Collective.
    double
    total() const;

  private:
    /// Mass of two nodes of a cell, in kg.
    double
    mass(const unsigned int cell_number,
         const unsigned int i,
         const unsigned int j) const
    {
      return masses[(cell_number * n_nodes + i) * n_nodes + j];
    }

    const ElementGrid<dim> &grid;
    const unsigned int      n_nodes; ///< per cell
    /// Cell by cell of ElementGrid::local_cells, row by row.
    std::vector<double> masses;
  };
} // namespace Sandglass

#endif
