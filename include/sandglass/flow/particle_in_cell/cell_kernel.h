#ifndef sandglass_flow_particle_in_cell_cell_kernel_h
#define sandglass_flow_particle_in_cell_cell_kernel_h

#include <sandglass/base/instruction_sets.h>
#include <sandglass/base/prefetch.h>
#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/particle_cloud.h>

#include <utility>

namespace Sandglass
{
  /// Values at the nodes of one cell, gathered from or to be added to a field.
  template <std::size_t n_components, std::size_t n_nodes>
  using CellValues = std::array<std::array<double, n_components>, n_nodes>;

  template <std::size_t n_components, std::size_t n_nodes>
  CellValues<n_components, n_nodes>
  gather(const NodalField<n_components>          &field,
         const std::array<unsigned int, n_nodes> &nodes)
  {
    CellValues<n_components, n_nodes> values;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        values[i][c] = field.at(nodes[i])[c];
    return values;
  }

  template <std::size_t n_components, std::size_t n_nodes>
  void
  scatter(const CellValues<n_components, n_nodes> &values,
          const std::array<unsigned int, n_nodes> &nodes,
          NodalField<n_components>                &field)
  {
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        field.at(nodes[i])[c] += values[i][c];
  }

  /// sum_i a_i . b_i. It is one term for a sum over cells, which would have to
  /// wait for each of several.
  template <std::size_t n_components, std::size_t n_nodes>
  double
  scalar_product(const CellValues<n_components, n_nodes> &a,
                 const CellValues<n_components, n_nodes> &b)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        sum += a[i][c] * b[i][c];
    return sum;
  }

  template <typename Number, std::size_t n_values, std::size_t... k>
  void
  set_to_zero(std::array<Number, n_values> &values, std::index_sequence<k...>)
  {
    ((values[k] = Number(0.)), ...);
  }

  /// Set the numbers one by one: GCC turns a loop into `rep stos`, which takes
  /// longer to start than this takes in all.
  template <typename Number, std::size_t n_values>
  void
  set_to_zero(std::array<Number, n_values> &values)
  {
    set_to_zero(values, std::make_index_sequence<n_values>());
  }

  /// Call `kernel(cell)` with the index of each cell that holds particles.
  template <typename Layout, typename Kernel>
  void
  for_each_filled_cell(const ParticleBlocks<Layout> &blocks,
                       const Kernel                 &kernel)
  {
    for (const unsigned int cell : blocks.cells())
      if (blocks.first_block(cell) != blocks.none)
        kernel(cell);
  }

  /// Like for_each_filled_cell(), for what each step does: compiled by itself,
  /// with all that the kernel calls inlined, for what this processor has. Left
  /// to itself GCC inlines the loop into the step, and then finds that too
  /// large to inline what the loop calls.
  template <typename Layout, typename Kernel>
  void
  for_each_filled_cell_in_a_step(const ParticleBlocks<Layout> &blocks,
                                 const Kernel                 &kernel)
  {
    run_with_widest_vectors([&]() { for_each_filled_cell(blocks, kernel); });
  }

  /**
   * Like for_each_filled_cell(), for a kernel that goes through the cell's
   * particles: the first blocks of cells to come are fetched into the cache
   * meanwhile. On fine meshes, where particles that change cell have brought
   * the blocks out of order, the processor doesn't foresee them.
   */
  template <typename Layout, typename Kernel>
  void
  for_each_cell_of_particles(const ParticleBlocks<Layout> &blocks,
                             const Kernel                 &kernel)
  {
    const auto &cells = blocks.cells();
    for (unsigned int n = 0; n < cells.size(); ++n)
      if (blocks.first_block(cells[n]) != blocks.none)
        {
          if (n + prefetch_distance < cells.size())
            blocks.prefetch(cells[n + prefetch_distance]);
          kernel(cells[n]);
        }
  }

  /// sum_i N_i v_i
  template <typename Number, std::size_t dim, std::size_t n_nodes>
  std::array<Number, dim>
  interpolate(const CellValues<dim, n_nodes>    &nodal_values,
              const std::array<Number, n_nodes> &shape_values)
  {
    std::array<Number, dim> value;
    for (unsigned int d = 0; d < dim; ++d)
      {
        value[d] = shape_values[0] * nodal_values[0][d];
        for (unsigned int i = 1; i < n_nodes; ++i)
          value[d] += shape_values[i] * nodal_values[i][d];
      }
    return value;
  }

  /// sum_i v_i dN_i/dx: row d is the gradient of component d.
  template <typename Number, std::size_t dim, std::size_t n_nodes>
  std::array<std::array<Number, dim>, dim>
  gradient_of(
    const CellValues<dim, n_nodes>                     &nodal_values,
    const std::array<std::array<Number, dim>, n_nodes> &shape_gradients)
  {
    std::array<std::array<Number, dim>, dim> gradient;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        {
          gradient[d][e] = nodal_values[0][d] * shape_gradients[0][e];
          for (unsigned int i = 1; i < n_nodes; ++i)
            gradient[d][e] += nodal_values[i][d] * shape_gradients[i][e];
        }
    return gradient;
  }

  /// Sum of a gradient's diagonal: for a velocity the volumetric rate.
  template <std::size_t dim>
  double
  trace(const std::array<std::array<double, dim>, dim> &gradient)
  {
    double sum = gradient[0][0];
    for (unsigned int d = 1; d < dim; ++d)
      sum += gradient[d][d];
    return sum;
  }

  /// The point of a cell whose coordinates are all one over the number of
  /// nodes: a simplex's centroid, where a cell is looked at as a whole.
  template <typename Shape>
  std::array<double, Shape::dim>
  point_within()
  {
    std::array<double, Shape::dim> point;
    point.fill(1. / Shape::n_nodes);
    return point;
  }

  /// sum_i a_i b_i
  template <std::size_t dim>
  double
  scalar_product(const std::array<double, dim> &a,
                 const std::array<double, dim> &b)
  {
    double sum = a[0] * b[0];
    for (unsigned int d = 1; d < dim; ++d)
      sum += a[d] * b[d];
    return sum;
  }
} // namespace Sandglass

#endif
