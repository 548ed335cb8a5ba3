#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/make_walls.h>
#include <sandglass/scene/scene.h>

#include <algorithm>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Whether a face of the axis is normal to this direction.
    template <int dim>
    bool
    has_symmetry_plane(const Mesh<dim> &mesh, const unsigned int direction)
    {
      if constexpr (dim == 2)
        return std::any_of(mesh.faces.begin(),
                           mesh.faces.end(),
                           [](const auto &edge) {
                             return edge.role == BoundaryRole::axis;
                           });
      constexpr double rounding = 1e-8;
      for (const auto &face : mesh.faces)
        {
          if (face.role != BoundaryRole::axis)
            continue;
          double extent = 0., largest_extent = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              double lower = mesh.vertices[face.vertices[0]][d], upper = lower;
              for (unsigned int v = 1; v < mesh.vertices_per_face(); ++v)
                {
                  const double x = mesh.vertices[face.vertices[v]][d];
                  lower          = std::min(lower, x);
                  upper          = std::max(upper, x);
                }
              largest_extent = std::max(largest_extent, upper - lower);
              if (d == direction)
                extent = upper - lower;
            }
          if (extent <= rounding * largest_extent)
            return true;
        }
      return false;
    }
  } // namespace



  template <int dim>
  Scene<dim>::Scene(const Mesh<dim>                 &mesh,
                    const WallParameters            &walls,
                    const Formulation                formulation,
                    const unsigned int               particles_per_cell,
                    const Tensor<1, dim>            &gravity,
                    const MPI_Comm                   communicator,
                    const Partitioner                partitioner,
                    const std::vector<unsigned int> &weights)
    : mesh(mesh)
    , formulation(formulation)
    , particles_per_cell(particles_per_cell)
    , gravity(gravity)
    , communicator(communicator)
    , partitioner(partitioner)
    , cell_weights(weights.empty() ?
                     Sandglass::cell_weights(mesh, particles_per_cell) :
                     weights)
    , partitioned_mesh(partition(mesh, cell_weights, partitioner, communicator))
    , triangulation(*partitioned_mesh)
    , reference_cell(is_simplex(mesh.cell_type) ?
                       ReferenceCells::get_simplex<dim>() :
                       ReferenceCells::get_hypercube<dim>())
    , mapping(reference_cell.template get_default_linear_mapping<dim>())
    , walls(
        make_walls(mesh, triangulation.get_boundary_ids(), formulation, walls))
    , dof_handler(triangulation)
    , cell_owners(find_cell_owners(triangulation))
  {
    if (is_simplex(mesh.cell_type))
      finite_element = std::make_unique<FE_SimplexP<dim>>(1);
    else
      finite_element = std::make_unique<FE_Q<dim>>(1);
    dof_handler.distribute_dofs(*finite_element);

    IndexSet relevant_dofs;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant_dofs);
    nodes = std::make_shared<const Utilities::MPI::Partitioner>(
      dof_handler.locally_owned_dofs(), relevant_dofs, communicator);

    fill_bottom = std::numeric_limits<double>::max();
    fill_top    = std::numeric_limits<double>::lowest();
    for (const auto &cell : mesh.cells)
      if (cell.is_filled)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          {
            const double y = mesh.vertices[cell.vertices[v]][1];
            fill_bottom    = std::min(fill_bottom, y);
            fill_top       = std::max(fill_top, y);
          }

    symmetry_factor = 1.;
    if (formulation != Formulation::axisymmetric)
      for (unsigned int d = 0; d < dim; ++d)
        if (d != 1 && has_symmetry_plane(mesh, d))
          symmetry_factor *= 2.;
  }



#define INSTANTIATE(dim) template class Scene<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
