#include <sandglass/output/fields.h>
#include <sandglass/particles/particle_state.h>

#include <algorithm>
#include <initializer_list>
#include <numeric>

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
    using Floats = std::vector<float>;

    /// Fields of the particles while they are collected.
    struct ParticleFields
    {
      std::vector<double> points;
      Floats              velocity, stress, pressure, density, displacement;
      std::vector<double> mass;
      // Ids need the 32 bits without a sign.
      std::vector<std::int64_t> id;
      std::vector<std::int32_t> layer;

      explicit ParticleFields(const unsigned int n)
      {
        points.reserve(3 * n);
        for (Floats *field : {&velocity, &displacement})
          field->reserve(3 * n);
        stress.reserve(6 * n);
        for (Floats *field : {&pressure, &density})
          field->reserve(n);
        mass.reserve(n);
        layer.reserve(n);
        id.reserve(n);
      }

      void
      add(const ParticleState<double> &state,
          const types::particle_index  particle_id,
          const Point<dim>            &initial_position,
          const Scene                 &scene)
      {
        const auto &location = state.location;
        append(points, {location[0], location[1], 0.});
        append(velocity, {state.velocity[0], state.velocity[1], 0.});
        append(stress,
               {state.stress[Component::xx],
                state.stress[Component::yy],
                state.stress[Component::zz],
                state.stress[Component::xy],
                0.,
                0.});
        append(pressure, {Sandglass::pressure(state.stress)});
        append(density, {state.density});
        append(displacement,
               {location[0] - initial_position[0],
                location[1] - initial_position[1],
                0.});
        append(mass, {state.mass});
        layer.push_back(layer_of(initial_position, scene));
        id.push_back(particle_id);
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
    const ParticleBlocks &blocks = stage.cloud.blocks();
    ParticleFields        fields(blocks.n_particles());
    blocks.for_each([&](const ParticleSlot &slot) {
      const types::particle_index id = blocks.id(slot);
      fields.add(load_state(blocks[slot.block], slot.lane),
                 id,
                 stage.initial_position(id),
                 stage.scene);
    });

    VtuPiece piece;
    piece.cells.resize(fields.id.size());
    std::iota(piece.cells.begin(), piece.cells.end(), 0);
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
