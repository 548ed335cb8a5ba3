#include <sandglass/observers/fields.h>

#include <algorithm>
#include <initializer_list>

namespace Sandglass
{
  unsigned int
  layer_of(const Point<dim> &initial_position, const Scene &scene)
  {
    const double depth = (scene.fill_top - initial_position[1]) /
                         (scene.fill_top - scene.fill_bottom);
    // Rounding must not divide a row of particles on the edge of a layer.
    constexpr double rounding = 1e-6;
    return 1 + static_cast<unsigned int>(
                 std::clamp(n_layers * depth + rounding, 0., n_layers - 0.5));
  }



  namespace
  {
    using Floats   = std::vector<float>;
    using Integers = std::vector<std::int64_t>;

    /// Fields of the particles while they are collected.
    struct ParticleFields
    {
      std::vector<double> points;
      Floats              velocity, stress, pressure, density, displacement;
      std::vector<double> mass;
      Integers            layer, id;

      void
      add(const Particles::ParticleAccessor<dim> &particle,
          const Point<dim>                       &initial_position,
          const Scene                            &scene)
      {
        const auto             state    = particle.get_properties();
        const Point<dim>      &location = particle.get_location();
        const SymmetricTensor4 particle_stress =
          Eigen::Map<const SymmetricTensor4>(&state[Property::stress]);

        append(points, {location[0], location[1], 0.});
        append(velocity,
               {state[Property::velocity], state[Property::velocity + 1], 0.});
        append(stress,
               {particle_stress[Component::xx],
                particle_stress[Component::yy],
                particle_stress[Component::zz],
                particle_stress[Component::xy],
                0.,
                0.});
        append(pressure, {Sandglass::pressure(particle_stress)});
        append(density, {state[Property::density]});
        append(displacement,
               {location[0] - initial_position[0],
                location[1] - initial_position[1],
                0.});
        append(mass, {state[Property::mass]});
        layer.push_back(layer_of(initial_position, scene));
        id.push_back(particle.get_id());
      }

    private:
      template <typename Number>
      static void
      append(std::vector<Number>                &values,
             const std::initializer_list<double> components)
      {
        values.insert(values.end(), components.begin(), components.end());
      }
    };
  } // namespace



  VtuPiece
  particle_fields(ParticleStage &stage)
  {
    ParticleFields                fields;
    const ParticleCloud::Handler &handler = stage.cloud.handler();
    for (const auto &cell : stage.cloud.owned_cells())
      for (const auto &particle : handler.particles_in_cell(cell))
        fields.add(particle,
                   stage.initial_position(particle.get_id()),
                   stage.scene);

    VtuPiece piece;
    for (unsigned int i = 0; i < fields.id.size(); ++i)
      piece.cells.push_back(i);
    piece.points          = std::move(fields.points);
    piece.points_per_cell = 1;
    piece.point_fields    = {
         {"velocity", 3, std::move(fields.velocity), {}},
         {"stress",
          6,
          std::move(fields.stress),
          VtuPiece::symmetric_tensor_components},
         {"pressure", 1, std::move(fields.pressure), {}},
         {"density", 1, std::move(fields.density), {}},
         {"mass", 1, std::move(fields.mass), {}},
         {"displacement", 3, std::move(fields.displacement), {}},
         {"layer", 1, std::move(fields.layer), {}},
         {"id", 1, std::move(fields.id), {}}};
    return piece;
  }
} // namespace Sandglass
