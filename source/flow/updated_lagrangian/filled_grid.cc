#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/filled_grid.h>
#include <sandglass/scene/triangulate.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    Quadrature<dim>
    make_quadrature(const CellType cell_type)
    {
      if (is_simplex(cell_type))
        return QGaussSimplex<dim>(1);
      return QIterated<dim>(QMidpoint<1>(), 2);
    }
  } // namespace



  template <int dim>
  FilledGrid<dim>::FilledGrid(const Scene<dim> &scene)
    : triangulation(
        scene.communicator,
        Triangulation<dim>::none,
        true,
        parallel::shared::Triangulation<dim>::partition_custom_signal)
    , mapping(scene.mapping)
    , finite_element(*scene.finite_element, dim)
    , quadrature(make_quadrature<dim>(scene.mesh.cell_type))
    , dof_handler(triangulation)
    , node_handler(triangulation)
  {
    const MeshPart<dim> part = filled_part(scene.mesh);
    scene_cells              = part.cells;
    scene_vertices           = part.vertices;
    const auto partition     = triangulation.signals.create.connect([&]() {
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_subdomain_id(
          scene.cell_owners[scene_cells[cell->active_cell_index()]]);
    });
    triangulate(part.mesh, triangulation);
    partition.disconnect();

    dof_handler.distribute_dofs(finite_element);
    node_handler.distribute_dofs(*scene.finite_element);
    owned_dofs = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant_dofs);
    partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned_dofs,
                                                          relevant_dofs,
                                                          scene.communicator);

    std::vector<types::global_dof_index> dofs(finite_element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          LocalCell local_cell{cell, {}};
          cell->get_dof_indices(dofs);
          std::transform(dofs.begin(),
                         dofs.end(),
                         local_cell.dofs.begin(),
                         [this](const types::global_dof_index dof) {
                           return partitioner->global_to_local(dof);
                         });
          local_cells.push_back(local_cell);
        }
  }



  template <int dim>
  DisplacementVector
  FilledGrid<dim>::make_vector() const
  {
    Vector vector(partitioner);
    vector.update_ghost_values();
    return vector;
  }



#define INSTANTIATE(dim) template class FilledGrid<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
