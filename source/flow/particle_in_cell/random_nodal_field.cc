#include <deal.II/dofs/dof_tools.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/particle_in_cell/random_nodal_field.h>

#include <cstdint>
#include <cstring>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// One round of the SplitMix64 generator (Steele, Lea and Flood 2014).
    std::uint64_t
    mix(std::uint64_t value)
    {
      value += 0x9e3779b97f4a7c15u;
      value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
      value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
      return value ^ (value >> 31);
    }

    std::uint64_t
    bits_of(const double value)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      return bits;
    }
  } // namespace



  template <int dim>
  void
  fill_with_random_numbers(NodalField<dim> &field, const Scene<dim> &scene)
  {
    std::map<types::global_dof_index, Point<dim>> positions;
    DoFTools::map_dofs_to_support_points(scene.mapping,
                                         scene.dof_handler,
                                         positions);
    for (unsigned int node = 0; node < scene.nodes->locally_owned_size();
         ++node)
      {
        const Point<dim> &position =
          positions.at(scene.nodes->local_to_global(node));
        std::uint64_t state = bits_of(position[0]);
        for (unsigned int d = 1; d < dim; ++d)
          state = mix(state) ^ bits_of(position[d]);
        for (unsigned int d = 0; d < dim; ++d)
          {
            state             = mix(state);
            field.at(node)[d] = 2. * (state >> 11) / double(1ul << 53) - 1.;
          }
      }
    field.update_ghosts();
  }



#define INSTANTIATE(dim)                                         \
  template void fill_with_random_numbers<dim>(NodalField<dim> &, \
                                              const Scene<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
