#ifndef sandglass_particles_cell_integrals_h
#define sandglass_particles_cell_integrals_h

#include <sandglass/particles/cell_shape.h>

namespace Sandglass
{
  /// Integrals over a plane cell, or over the ring that it sweeps about the
  /// axis.
  template <CellType cell_type>
  struct CellIntegrals
  {
    static constexpr unsigned int n_nodes = CellShape<cell_type>::n_nodes;

    /// In m^3; plane strain: per metre of depth.
    double volume = 0.;
    /// Of the shape functions' gradients, in m^2.
    std::array<Pair<double>, n_nodes> gradients{};
    /// Of the shape functions over the radius, in m^2; 0 in plane strain.
    std::array<double, n_nodes> values_over_radius{};
  };

  /// Exact but for rounding, also in quadrilaterals that are no parallelograms.
  template <CellType cell_type>
  CellIntegrals<cell_type>
  integrate_over(const CellShape<cell_type> &shape,
                 const Formulation           formulation);
} // namespace Sandglass

#endif
