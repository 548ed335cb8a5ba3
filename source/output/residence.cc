#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/field_collector.h>
#include <sandglass/output/residence.h>
#include <sandglass/output/silo_measures.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  double
  ResidenceCell::spread() const
  {
    const double mean = mean_time();
    return std::sqrt(
      std::max(0., mass_time_square / mass_left() - mean * mean));
  }



  const std::vector<Column<ResidenceRow>> residence_table = {
    {"time_s",
     "s",
     [](const ResidenceRow &r) { return r.time; },
     "simulated time"},
    {"layer",
     "1",
     [](const ResidenceRow &r) { return r.layer; },
     "of the 16 of the initial height, counted from the top"},
    {"mass_left_kg",
     "kg",
     [](const ResidenceRow &r) { return r.mass_left; },
     "of this layer's material that has passed the outlet level since the row "
     "before of the same layer"},
    {"mass_remaining_kg",
     "kg",
     [](const ResidenceRow &r) { return r.mass_remaining; },
     "of this layer's material that is still in the silo"}};



  const std::vector<Field<ResidenceCell>> residence_cell_table = {
    {"residence time",
     "s",
     [](const ResidenceCell &c) { return static_cast<float>(c.mean_time()); },
     "mean time when the material that was here at the start passed the outlet "
     "level, of what has; not a number where nothing has"},
    {"spread of residence time",
     "s",
     [](const ResidenceCell &c) { return static_cast<float>(c.spread()); },
     "its standard deviation within the cell"},
    {"share that has left",
     "1",
     [](const ResidenceCell &c) {
       return static_cast<float>(c.mass_left() / c.initial_mass);
     },
     "of the material that was here at the start"},
    {"initial mass",
     "kg",
     [](const ResidenceCell &c) { return c.initial_mass; },
     "of the whole silo's cells of this kind"}};



  template <int dim>
  Residence::Residence(const OutputParameters &parameters,
                       const Scene<dim>       &scene)
    : is_asked(parameters.writes_residence &&
               SiloMeasures<dim>(scene).has_open_outlet)
    , communicator(scene.communicator)
    , symmetry_factor(scene.symmetry_factor)
    , raster(scene)
    , table(parameters.directory + "/residence.csv",
            residence_table,
            ResidenceRow())
  {
    if (!is_asked)
      return;
    masses.assign(raster.n_cells(), 0.);
    cells.resize(raster.n_cells());
  }



  void
  Residence::add(const ParticleRecord &particle)
  {
    if (!is_asked || particle.location[1] < 0.)
      return;
    const std::size_t cell = raster.cell(particle.initial_location);
    if (cell != ResidenceRaster::nowhere)
      masses[cell] += particle.mass;
  }



  void
  Residence::end_pass(const double time)
  {
    if (!is_asked)
      return;
    std::vector<double> now(masses.size());
    Utilities::MPI::sum(masses, communicator, now);
    masses.assign(masses.size(), 0.);
    const double middle = (last_time + time) / 2.;
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        ResidenceCell &cell = cells[i];
        const double   mass = symmetry_factor * now[i];
        if (!is_started)
          cell.initial_mass = mass;
        else
          {
            cell.mass_time += (cell.mass - mass) * middle;
            cell.mass_time_square += (cell.mass - mass) * middle * middle;
          }
        cell.mass = mass;
      }
    is_started = true;
    last_time  = time;
  }



  std::vector<ResidenceRow>
  Residence::rows(const double time)
  {
    std::vector<double> remaining(Layers::n, 0.);
    for (std::size_t i = 0; i < cells.size(); ++i)
      remaining[raster.layer(i) - 1] += cells[i].mass;
    if (written.empty())
      written = remaining;
    std::vector<ResidenceRow> result;
    for (unsigned int i = 0; i < Layers::n; ++i)
      result.push_back({time, i + 1, written[i] - remaining[i], remaining[i]});
    written = remaining;
    return result;
  }



  void
  Residence::open()
  {
    if (is_asked)
      table.open();
  }



  void
  Residence::write(const std::vector<ResidenceRow> &rows)
  {
    for (const ResidenceRow &row : rows)
      table.add_row(row);
    table.flush();
  }



  void
  Residence::refuse_other(const std::string &directory) const
  {
    table.refuse_other(directory);
  }



  VtuPiece
  Residence::map() const
  {
    VtuPiece piece;
    piece.points_per_cell = raster.points_per_cell();
    piece.cell_dimension  = raster.dimension();
    FieldCollector<ResidenceCell> fields(residence_cell_table, cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].initial_mass > 0.)
        {
          raster.draw(i, piece);
          fields.add(cells[i]);
        }
    piece.cell_fields = fields.take();
    return piece;
  }



  namespace
  {
    /// Sums of equal masses and times, which come in an order that depends on
    /// the ranks, are equal up to this share.
    constexpr double rounding = 1e-9;

    bool
    has_emptied_by_half(const ResidenceCell &cell)
    {
      return cell.mass <= (0.5 + rounding) * cell.initial_mass;
    }
  } // namespace



  ResidenceSummary
  Residence::summary() const
  {
    ResidenceCell all;
    double        in_order = 0., n_pairs = 0.;
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        const ResidenceCell &cell = cells[i];
        all.initial_mass += cell.initial_mass;
        all.mass += cell.mass;
        all.mass_time += cell.mass_time;
        all.mass_time_square += cell.mass_time_square;

        const std::size_t above = raster.above(i);
        if (above == ResidenceRaster::nowhere || cell.initial_mass == 0. ||
            cells[above].initial_mass == 0.)
          continue;
        const bool has_left       = has_emptied_by_half(cell);
        const bool has_left_above = has_emptied_by_half(cells[above]);
        if (!has_left && !has_left_above)
          continue;
        n_pairs += 1.;
        if (has_left &&
            (!has_left_above ||
             cell.mean_time() <= (1. + rounding) * cells[above].mean_time()))
          in_order += 1.;
      }
    return {all.mean_time(), all.spread(), in_order / n_pairs};
  }



#define INSTANTIATE(dim) \
  template Residence::Residence(const OutputParameters &, const Scene<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
