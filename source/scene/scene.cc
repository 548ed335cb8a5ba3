#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <sandglass/choices.h>
#include <sandglass/scene/make_walls.h>
#include <sandglass/scene/scene.h>

#include <algorithm>
#include <limits>

namespace Sandglass
{
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

    const bool has_axis =
      std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const auto &edge) {
        return edge.role == BoundaryRole::axis;
      });
    symmetry_factor =
      formulation == Formulation::plane_strain && has_axis ? 2. : 1.;
  }



#define INSTANTIATE(dim) template class Scene<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
