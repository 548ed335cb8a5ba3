// The file of the state at rest.

#include <deal.II/numerics/data_out.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>

namespace Sandglass
{
  const std::vector<Column<StaticCell>> static_cell_table = {
    {"stress_xx",
     "Pa",
     [](const StaticCell &c) { return c.stress[Component::xx]; },
     "Cauchy stress, tension positive"},
    {"stress_yy",
     "Pa",
     [](const StaticCell &c) { return c.stress[Component::yy]; },
     "likewise"},
    {"stress_zz",
     "Pa",
     [](const StaticCell &c) { return c.stress[Component::zz]; },
     "likewise, out of the plane or round the axis"},
    {"stress_xy",
     "Pa",
     [](const StaticCell &c) { return c.stress[Component::xy]; },
     "likewise"},
    {"volume_ratio",
     "1",
     [](const StaticCell &c) { return c.volume_ratio; },
     "current over initial volume"}};



  template <int dim>
  StaticCell
  StaticStage<dim>::mean_state(const CellAccessor<dim> &cell) const
  {
    StaticCell         mean{};
    const unsigned int n_points = filled_grid.quadrature.size();
    for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto point =
          equilibrium->point_state(filled_grid.point_index(cell, q));
        for (unsigned int c = 0; c < point.stress.size(); ++c)
          mean.stress[c] += point.stress[c] / n_points;
        mean.volume_ratio += point.volume_ratio / n_points;
      }
    return mean;
  }



  template <int dim>
  void
  StaticStage<dim>::write_vtu(const std::string &directory) const
  {
    std::vector<dealii::Vector<double>> means(
      static_cell_table.size(),
      dealii::Vector<double>(filled_grid.triangulation.n_active_cells()));
    for (const auto &cell : filled_grid.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const StaticCell mean = mean_state(*cell);
          for (unsigned int i = 0; i < means.size(); ++i)
            means[i][cell->active_cell_index()] =
              std::get<double>(value_of(static_cell_table[i], mean));
        }

    DataOut<dim> data_out;
    // The numbers' last digits are noise, on which more effort gains little.
    DataOutBase::VtkFlags flags;
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    data_out.set_flags(flags);
    data_out.attach_dof_handler(filled_grid.dof_handler);
    data_out.add_data_vector(
      displacement,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector));
    for (unsigned int i = 0; i < means.size(); ++i)
      data_out.add_data_vector(means[i],
                               static_cell_table[i].name,
                               DataOut<dim>::type_cell_data);
    data_out.build_patches(filled_grid.mapping);
    data_out.write_vtu_in_parallel(directory + "/static.vtu",
                                   scene.communicator);
  }



#define INSTANTIATE(dim) template class StaticStage<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
