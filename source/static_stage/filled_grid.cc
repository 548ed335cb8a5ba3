#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <sandglass/scene/triangulate.h>
#include <sandglass/static_stage/filled_grid.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    Quadrature<dim>
    make_quadrature(const CellType cell_type)
    {
      if (cell_type == CellType::triangle)
        return QGaussSimplex<dim>(1);
      return QIterated<dim>(QMidpoint<1>(), 2);
    }
  } // namespace



  FilledGrid::FilledGrid(const Scene &scene)
    : triangulation(
        scene.communicator,
        Triangulation<dim>::none,
        true,
        parallel::shared::Triangulation<dim>::partition_custom_signal)
    , mapping(scene.mapping)
    , finite_element(*scene.finite_element, dim)
    , quadrature(make_quadrature(scene.mesh.cell_type))
    , dof_handler(triangulation)
    , node_handler(triangulation)
  {
    const Mesh mesh      = filled_part(scene.mesh, scene_cells);
    const auto partition = triangulation.signals.create.connect([&]() {
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_subdomain_id(
          scene.cell_owners[scene_cells[cell->active_cell_index()]]);
    });
    triangulate(mesh, triangulation);
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



  FilledGrid::Vector
  FilledGrid::make_vector() const
  {
    Vector vector(partitioner);
    vector.update_ghost_values();
    return vector;
  }
} // namespace Sandglass
