#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/flow/in_space.h>
#include <sandglass/output/gauges.h>
#include <sandglass/output/section_wall_gauge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    template <int component>
    double
    stress(const GaugeRow &row)
    {
      return row.around.stress_volume[component] / row.around.volume;
    }
  } // namespace



  const std::vector<Column<GaugeRow>> gauge_table = {
    {"time_s", "s", [](const GaugeRow &r) { return r.time; }, "simulated time"},
    {"gauge",
     "",
     [](const GaugeRow &r) { return r.name; },
     "its name in `Output/Gauges`"},
    {"x_m", "m", [](const GaugeRow &r) { return r.point[0]; }, "where it is"},
    {"y_m",
     "m",
     [](const GaugeRow &r) { return r.point[1]; },
     "above the outlet level"},
    {"z_m",
     "m",
     [](const GaugeRow &r) { return r.point[2]; },
     "0 in the plane"},
    {"normal_Pa",
     "Pa",
     [](const GaugeRow &r) { return r.traction.normal; },
     "of the wall there, positive in compression: at t = 0 at rest, later the "
     "mean since the row before; linear between the wall's nodes. `nan` where "
     "the gauge is not on a wall"},
    {"tangential_Pa",
     "Pa",
     [](const GaugeRow &r) { return r.traction.tangential; },
     "likewise; positive where the wall pushes the material up"},
    {"density_kg_per_m3",
     "kg/m^3",
     [](const GaugeRow &r) { return r.around.mass / r.around.volume; },
     "of the material around the gauge, as all that follows: mean over the "
     "particles no farther away than the root of the area of the mesh's cell "
     "there; `nan` where there are none"},
    {"velocity_x_m_per_s",
     "m/s",
     [](const GaugeRow &r) { return r.around.momentum[0] / r.around.mass; },
     "momentum over mass"},
    {"velocity_y_m_per_s",
     "m/s",
     [](const GaugeRow &r) { return r.around.momentum[1] / r.around.mass; },
     "likewise, upwards"},
    {"velocity_z_m_per_s",
     "m/s",
     [](const GaugeRow &r) { return r.around.momentum[2] / r.around.mass; },
     "0 in the plane"},
    {"stress_xx_Pa",
     "Pa",
     stress<Component::xx>,
     "Cauchy stress, tension positive, mean over the volume"},
    {"stress_yy_Pa", "Pa", stress<Component::yy>, "likewise"},
    {"stress_zz_Pa",
     "Pa",
     stress<Component::zz>,
     "likewise; out of the plane or round the axis"},
    {"stress_xy_Pa", "Pa", stress<Component::xy>, "likewise"}};



  namespace
  {
    template <int dim>
    Point<dim>
    point_of(const NamedNumbers::value_type &named)
    {
      if (named.second.size() != dim)
        throw InputError("Output",
                         "Gauges",
                         to_text(named),
                         "allowed are " + std::to_string(dim) +
                           " coordinates in this scene");
      Point<dim> point;
      std::copy(named.second.begin(), named.second.end(), &point[0]);
      return point;
    }



    /// Root of the measure of the mesh's cell at a point: of those whose box
    /// holds it, that with the nearest middle.
    template <int dim>
    double
    reach_at(const Scene<dim>               &scene,
             const Point<dim>               &point,
             const NamedNumbers::value_type &named)
    {
      constexpr double rounding = 1e-6; // of a cell
      double           nearest  = std::numeric_limits<double>::infinity();
      double           measure  = 0.;
      for (const auto &cell : scene.triangulation.active_cell_iterators())
        if (cell->bounding_box().point_inside(point, rounding) &&
            cell->center().distance(point) < nearest)
          {
            nearest = cell->center().distance(point);
            measure = cell->measure();
          }
      if (measure == 0.)
        throw InputError("Output",
                         "Gauges",
                         to_text(named),
                         "allowed are points in the mesh or on its boundary");
      return std::pow(measure, 1. / dim);
    }



    /// Over all ranks. Collective.
    GaugeSums
    sum(const GaugeSums &of_rank, const MPI_Comm communicator)
    {
      constexpr unsigned int n_stresses =
        std::tuple_size_v<decltype(GaugeSums::stress_volume)>;
      std::array<double, 5 + n_stresses> values;
      values[0] = of_rank.mass;
      values[1] = of_rank.volume;
      for (unsigned int d = 0; d < 3; ++d)
        values[2 + d] = of_rank.momentum[d];
      std::copy(of_rank.stress_volume.begin(),
                of_rank.stress_volume.end(),
                values.begin() + 5);

      std::array<double, values.size()> sums;
      Utilities::MPI::sum(ArrayView<const double>(values.data(), values.size()),
                          communicator,
                          ArrayView<double>(sums.data(), sums.size()));
      GaugeSums result;
      result.mass   = sums[0];
      result.volume = sums[1];
      for (unsigned int d = 0; d < 3; ++d)
        result.momentum[d] = sums[2 + d];
      std::copy(sums.begin() + 5, sums.end(), result.stress_volume.begin());
      return result;
    }
  } // namespace



  template <int dim>
  Gauges<dim>::Gauges(const OutputParameters &parameters,
                      const Scene<dim>       &scene)
    : communicator(scene.communicator)
    , table(parameters.directory + "/gauges.csv", gauge_table, GaugeRow())
  {
    for (const auto &named : parameters.gauges)
      {
        const Point<dim> point = point_of<dim>(named);
        gauges.push_back({named.first,
                          in_space(point),
                          reach_at(scene, point, named),
                          GaugeSums(),
                          GaugeSums()});
        if constexpr (dim == 2)
          is_any_on_wall = is_any_on_wall || is_on_wall(scene, point);
      }
  }



  template <int dim>
  void
  Gauges<dim>::add(const ParticleRecord &particle)
  {
    for (Gauge &gauge : gauges)
      {
        if (particle.location.distance_square(gauge.point) >
            gauge.reach * gauge.reach)
          continue;
        const double volume = particle.mass / particle.density;
        gauge.of_rank.mass += particle.mass;
        gauge.of_rank.volume += volume;
        gauge.of_rank.momentum += particle.mass * particle.velocity;
        for (unsigned int c = 0; c < particle.stress.size(); ++c)
          gauge.of_rank.stress_volume[c] += volume * particle.stress[c];
      }
  }



  template <int dim>
  void
  Gauges<dim>::end_pass()
  {
    for (Gauge &gauge : gauges)
      {
        gauge.around  = sum(gauge.of_rank, communicator);
        gauge.of_rank = GaugeSums();
      }
  }



  template <int dim>
  void
  Gauges<dim>::open()
  {
    if (is_on())
      table.open();
  }



  template <int dim>
  void
  Gauges<dim>::refuse_other(const std::string &directory) const
  {
    table.refuse_other(directory);
  }



#define INSTANTIATE(dim) template class Gauges<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
