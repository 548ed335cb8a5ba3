#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/output/field_collector.h>
#include <sandglass/output/particle_fields.h>

#include <algorithm>
#include <numeric>

namespace Sandglass
{
  unsigned int
  Layers::of(const Point<3> &initial_location) const
  {
    const double depth =
      (fill_top - initial_location[1]) / (fill_top - fill_bottom);
    // Rounding must not divide a row of particles on the edge of a layer.
    constexpr double rounding = 1e-6;
    return 1 + static_cast<unsigned int>(
                 std::clamp(n * depth + rounding, 0., n - 0.5));
  }



  namespace
  {
    /// Compression positive, in Pa.
    float
    pressure(const std::array<double, 6> &stress)
    {
      return -(stress[Component::xx] + stress[Component::yy] +
               stress[Component::zz]) *
             (1. / 3.);
    }
  } // namespace



  const std::vector<Field<ParticleInLayers>> particle_table = {
    {"velocity",
     "m/s",
     [](const ParticleInLayers &p) { return p.particle.velocity; },
     "of the particle"},
    {"stress",
     "Pa",
     [](const ParticleInLayers &p) { return p.particle.stress; },
     "Cauchy stress, tension positive"},
    {"pressure",
     "Pa",
     [](const ParticleInLayers &p) { return pressure(p.particle.stress); },
     "mean stress, compression positive"},
    {"density",
     "kg/m^3",
     [](const ParticleInLayers &p) {
       return static_cast<float>(p.particle.density);
     },
     "of the bulk material"},
    {"mass",
     "kg",
     [](const ParticleInLayers &p) { return p.particle.mass; },
     "of the particle; in plane strain per metre of depth"},
    {"displacement",
     "m",
     [](const ParticleInLayers &p) {
       return Tensor<1, 3>(p.particle.location - p.particle.initial_location);
     },
     "from the position before the static stage"},
    {"layer",
     "1",
     [](const ParticleInLayers &p) {
       return static_cast<std::int32_t>(
         p.layers.of(p.particle.initial_location));
     },
     "of the 16 of the initial height, counted from the top"},
    // Ids need the 32 bits without a sign.
    {"id",
     "1",
     [](const ParticleInLayers &p) {
       return static_cast<std::int64_t>(p.particle.id);
     },
     "the same as long as the particle exists"}};



  namespace
  {
    /// Fields of the law's state variables.
    class LawStateFields
    {
    public:
      explicit LawStateFields(const std::vector<StateVariable> &variables)
        : variables(variables)
        , values(variables.size())
      {}

      void
      add(const double *law_state)
      {
        for (unsigned int i = 0; i < variables.size(); ++i)
          {
            const unsigned int n = variables[i].n_components;
            values[i].insert(values[i].end(), law_state, law_state + n);
            law_state += n;
          }
      }

      void
      append_to(std::vector<VtuPiece::Field> &fields)
      {
        for (unsigned int i = 0; i < variables.size(); ++i)
          fields.push_back({variables[i].name,
                            variables[i].n_components,
                            std::move(values[i]),
                            variables[i].n_components == 6 ?
                              VtuPiece::symmetric_tensor_components :
                              std::vector<std::string>()});
      }

    private:
      const std::vector<StateVariable> variables;
      std::vector<std::vector<float>>  values;
    };
  } // namespace



  VtuPiece
  particle_fields(const FlowView &view, const Layers &layers)
  {
    const unsigned int               n = view.n_particles();
    FieldCollector<ParticleInLayers> fields(particle_table, n);
    LawStateFields                   law_state(view.state_variables());

    VtuPiece piece;
    piece.points.reserve(3 * n);
    view.for_each_particle([&](const ParticleRecord &particle) {
      for (unsigned int d = 0; d < 3; ++d)
        piece.points.push_back(particle.location[d]);
      fields.add({particle, layers});
      law_state.add(particle.law_state);
    });

    piece.cells.resize(n);
    std::iota(piece.cells.begin(), piece.cells.end(), 0);
    piece.points_per_cell = 1;
    piece.point_fields    = fields.take();
    law_state.append_to(piece.point_fields);
    return piece;
  }
} // namespace Sandglass
