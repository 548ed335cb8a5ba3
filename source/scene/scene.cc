#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <sandglass/scene/scene.h>
#include <sandglass/scene/triangulate.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace Sandglass
{
  namespace
  {
    /// Of cells before any flow.
    std::vector<unsigned int>
    weights_at_start(const Mesh &mesh, const unsigned int particles_per_cell)
    {
      constexpr unsigned int    per_particle = 20, of_empty_cell = 1;
      std::vector<unsigned int> weights;
      for (const auto &cell : mesh.cells)
        weights.push_back(cell.is_filled ? per_particle * particles_per_cell :
                                           of_empty_cell);
      return weights;
    }



    /// METIS adds them up in 32 bits.
    std::vector<unsigned int>
    for_metis(std::vector<unsigned int> weights)
    {
      constexpr std::uint64_t largest_sum = 1u << 30;
      const std::uint64_t     sum =
        std::accumulate(weights.begin(), weights.end(), std::uint64_t(0));
      const unsigned int divisor = 1 + sum / largest_sum;
      for (unsigned int &weight : weights)
        weight = std::max(1u, weight / divisor);
      return weights;
    }
  } // namespace



  Scene::Scene(const Mesh                      &mesh,
               const Formulation                formulation,
               const unsigned int               particles_per_cell,
               const Tensor<1, dim>            &gravity,
               const MPI_Comm                   communicator,
               const std::vector<unsigned int> &cell_weights)
    : mesh(mesh)
    , formulation(formulation)
    , particles_per_cell(particles_per_cell)
    , gravity(gravity)
    , communicator(communicator)
    , cell_weights(for_metis(cell_weights.empty() ?
                               weights_at_start(mesh, particles_per_cell) :
                               cell_weights))
    , triangulation(communicator,
                    Triangulation<dim>::none,
                    true,
                    parallel::shared::Triangulation<dim>::partition_metis)
    , reference_cell(mesh.cell_type == CellType::triangle ?
                       ReferenceCells::Triangle :
                       ReferenceCells::Quadrilateral)
    , mapping(reference_cell.get_default_linear_mapping<dim>())
    , dof_handler(triangulation)
  {
    const auto connection = triangulation.signals.weight.connect(
      [this](const auto &cell, auto) -> unsigned int {
        return this->cell_weights[cell->active_cell_index()];
      });
    triangulate(mesh, triangulation);
    connection.disconnect();

    if (mesh.cell_type == CellType::triangle)
      finite_element = std::make_unique<FE_SimplexP<dim>>(1);
    else
      finite_element = std::make_unique<FE_Q<dim>>(1);
    dof_handler.distribute_dofs(*finite_element);

    IndexSet relevant_dofs;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant_dofs);
    nodes = std::make_shared<const Utilities::MPI::Partitioner>(
      dof_handler.locally_owned_dofs(), relevant_dofs, communicator);

    cell_owners = triangulation.get_true_subdomain_ids_of_cells();
    if (cell_owners.empty())
      cell_owners.assign(triangulation.n_active_cells(), 0);

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
      std::any_of(mesh.edges.begin(), mesh.edges.end(), [](const auto &edge) {
        return edge.role == BoundaryRole::axis;
      });
    symmetry_factor =
      formulation == Formulation::plane_strain && has_axis ? 2. : 1.;
  }
} // namespace Sandglass
