#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/settlement_check.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// rho g H, in Pa.
    template <int dim>
    double
    weight_of_column(const Scene<dim>         &scene,
                     const MaterialParameters &material)
    {
      return material.density * scene.gravity.norm() *
             (scene.fill_top - scene.fill_bottom);
    }



    /// The quantities that may have been given in other units.
    template <int dim>
    std::string
    hint(const Scene<dim> &scene, const MaterialParameters &material)
    {
      std::ostringstream text;
      text << "Material/Young modulus is " << material.young_modulus
           << " Pa, and a column of the material's height of "
           << scene.fill_top - scene.fill_bottom << " m weighs "
           << weight_of_column(scene, material)
           << " Pa. Are lengths in m, Scene/Gravity in m/s^2, "
              "Material/Density in kg/m^3 and Young modulus in Pa? If they "
              "are, try a Young modulus of at least "
           << 40. * weight_of_column(scene, material)
           << " Pa: pressures and flow hardly depend on it.";
      return text.str();
    }



    /// The largest downward displacement of this rank's cells, in m.
    template <int dim>
    double
    largest_settlement(const StaticState<dim> &state, const Scene<dim> &scene)
    {
      double largest = 0.;
      for (const auto &cell : scene.triangulation.active_cell_iterators())
        {
          const unsigned int index = cell->active_cell_index();
          if (!cell->is_locally_owned() || !scene.mesh.cells[index].is_filled)
            continue;
          for (const unsigned int v : cell->vertex_indices())
            largest = std::max(largest, -state.cells[index].displacement[v][1]);
        }
      return largest;
    }
  } // namespace



  template <int dim>
  void
  check_settlement(const StaticState<dim>     &state,
                   const Scene<dim>           &scene,
                   const MaterialParameters   &material,
                   dealii::ConditionalOStream &log)
  {
    const double settlement =
      Utilities::MPI::max(largest_settlement(state, scene), scene.communicator);
    const double share = settlement / (scene.fill_top - scene.fill_bottom);
    if (share <= doubtful_settlement)
      return;
    std::ostringstream message;
    message << "In the state at rest the material has settled by " << settlement
            << " m, " << 100. * share << " % of its height. "
            << hint(scene, material);
    if (share > absurd_settlement)
      throw RunError("Static stage: the material is too soft for its weight. " +
                     message.str());
    log << "Warning: " << message.str() << std::endl;
  }



  template <int dim>
  std::string
  doubt_stiffness(const Scene<dim> &scene, const MaterialParameters &material)
  {
    const double nu = material.poisson_ratio;
    const double modulus =
      material.young_modulus * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
    return weight_of_column(scene, material) / (2. * modulus) <=
               doubtful_settlement ?
             "" :
             " The material is soft for its weight: " + hint(scene, material);
  }



#define INSTANTIATE(dim)                                                    \
  template void        check_settlement<dim>(const StaticState<dim> &,      \
                                      const Scene<dim> &,            \
                                      const MaterialParameters &,    \
                                      dealii::ConditionalOStream &); \
  template std::string doubt_stiffness<dim>(const Scene<dim> &,             \
                                            const MaterialParameters &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
