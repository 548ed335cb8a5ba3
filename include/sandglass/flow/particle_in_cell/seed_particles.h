#ifndef sandglass_flow_particle_in_cell_seed_particles_h
#define sandglass_flow_particle_in_cell_seed_particles_h

#include <sandglass/particles/particle_cloud.h>
#include <sandglass/particles/seeding.h>

#include <algorithm>
#include <vector>

namespace Sandglass
{
  /**
   * Fill this rank's filled cells with the initial particles, at rest and
   * unstressed.
   *
   * @param density    of the unstressed material, in kg/m^3.
   * @param law_state  of the unstressed material: Layout::n_law_numbers
   * numbers.
   */
  template <typename Layout, typename Kinematics, CellType cell_type>
  void
  seed_particles(const Mesh<Layout::dim>                           &mesh,
                 const InitialConfiguration<Kinematics, cell_type> &initial,
                 const double                                       density,
                 const std::vector<double>                         &law_state,
                 ParticleCloud<Layout>                             &cloud)
  {
    const unsigned int n         = initial.points.size();
    const auto         is_filled = [&mesh](const unsigned int cell) {
      return mesh.cells[cell].is_filled;
    };
    const auto &cells = cloud.blocks().cells();
    cloud.change_blocks().reserve(
      std::count_if(cells.begin(), cells.end(), is_filled), n);
    for (const unsigned int cell : cells)
      {
        if (!is_filled(cell))
          continue;
        for (unsigned int k = 0; k < n; ++k)
          {
            Parcel<Layout> parcel{};
            parcel.cell            = cell;
            parcel.id              = n * cell + k;
            parcel.reference_point = initial.points[k];
            parcel.location        = initial.position(parcel.id);
            parcel.properties[Layout::mass] =
              density * initial.volume(parcel.id);
            parcel.properties[Layout::density] = density;
            std::copy_n(law_state.begin(),
                        Layout::n_law_numbers,
                        parcel.properties.begin() + Layout::law_state);
            cloud.insert(parcel);
          }
      }
  }
} // namespace Sandglass

#endif
