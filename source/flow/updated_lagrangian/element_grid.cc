#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <deal.II/grid/reference_cell.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/scene/triangulate.h>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    const Mapping<dim> &
    linear_mapping(const CellType cell_type)
    {
      const ReferenceCell cell = is_simplex(cell_type) ?
                                   ReferenceCells::get_simplex<dim>() :
                                   ReferenceCells::get_hypercube<dim>();
      return cell.template get_default_linear_mapping<dim>();
    }



    template <int dim>
    FESystem<dim>
    make_element(const CellType cell_type, const unsigned int order)
    {
      Assert(order == 1 || (order == 2 && cell_type == CellType::triangle),
             ExcNotImplemented());
      if (is_simplex(cell_type))
        return FESystem<dim>(FE_SimplexP<dim>(order), dim);
      return FESystem<dim>(FE_Q<dim>(order), dim);
    }



    /// In a triangle the points halfway between its centre and its vertices,
    /// with equal weights.
    template <int dim>
    Quadrature<dim>
    inner_quadrature()
    {
      Assert(dim == 2, ExcNotImplemented());
      if constexpr (dim == 2)
        return Quadrature<dim>({Point<dim>(1. / 6., 1. / 6.),
                                Point<dim>(2. / 3., 1. / 6.),
                                Point<dim>(1. / 6., 2. / 3.)},
                               std::vector<double>(3, 1. / 6.));
      return Quadrature<dim>();
    }



    template <int dim>
    Quadrature<dim>
    make_quadrature(const CellType cell_type, const unsigned int order)
    {
      if (order == 2)
        return inner_quadrature<dim>();
      if (is_simplex(cell_type))
        return QGaussSimplex<dim>(1);
      return QIterated<dim>(QMidpoint<1>(), 2);
    }
  } // namespace



  template <int dim>
  ElementGrid<dim>::ElementGrid(const Mesh<dim>   &mesh,
                                const unsigned int element_order,
                                const MPI_Comm     communicator,
                                const CellOwner   &owner)
    : triangulation(
        communicator,
        Triangulation<dim>::none,
        true,
        parallel::shared::Triangulation<dim>::partition_custom_signal)
    , mapping(linear_mapping<dim>(mesh.cell_type))
    , finite_element(make_element<dim>(mesh.cell_type, element_order))
    , quadrature(make_quadrature<dim>(mesh.cell_type, element_order))
    , mass_quadrature(element_order == 1 ?
                        quadrature :
                        Quadrature<dim>(QGaussSimplex<dim>(3)))
    , dof_handler(triangulation)
    , node_handler(triangulation)
  {
    const auto partition = triangulation.signals.create.connect([&]() {
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_subdomain_id(owner(cell->active_cell_index()));
    });
    triangulate(mesh, triangulation);
    partition.disconnect();

    dof_handler.distribute_dofs(finite_element);
    node_handler.distribute_dofs(finite_element.base_element(0));
    owned_dofs = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant_dofs);
    partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned_dofs,
                                                          relevant_dofs,
                                                          communicator);

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
  ElementGrid<dim>::make_vector() const
  {
    Vector vector(partitioner);
    vector.update_ghost_values();
    return vector;
  }



#define INSTANTIATE(dim) template class ElementGrid<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
