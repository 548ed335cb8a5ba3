#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_outlet.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Of numbers of cells.
    constexpr double rounding = 1e-6;
    /// With fewer cells across its outlet a mesh is doubted,
    constexpr double fewest_cells = 8.;
    /// and this many are asked for.
    constexpr double enough_cells = 16.;
    /// Error of the flow rate times the cells across the outlet: see the meshes
    /// of one size in doc/graded-meshes.md.
    constexpr double slot_error = 0.5, round_error = 1.;



    /// Whether the flow rate goes with the width to the power of 1.5, not 2.5.
    bool
    has_slot(const SceneParameters &parameters)
    {
      return parameters.formulation == Formulation::plane_strain ||
             (parameters.formulation == Formulation::three_dimensions &&
              parameters.shape == SceneParameters::Shape::silo &&
              parameters.outlet_shape == SceneParameters::OutletShape::slot);
    }



    std::string
    what_to_set(const SceneParameters &parameters, const MeshOutlet &outlet)
    {
      const double       size = outlet.width / enough_cells;
      std::ostringstream text;
      text.precision(2);
      if (parameters.shape == SceneParameters::Shape::mesh_file)
        text << "make the mesh file's cells at the outlet's lip at most "
             << size << " m large";
      else if (parameters.refinement < 1.)
        text << "set Scene/Refinement = "
             << parameters.refinement * enough_cells / outlet.n_cells()
             << " or more";
      else
        text << "set Scene/Element size = auto, or "
             << (parameters.cell_type != CellType::quadrilateral ?
                   "Outlet element size" :
                   "Element size")
             << " = " << size * parameters.refinement << " or less";
      return text.str();
    }
  } // namespace



  template <int dim>
  void
  doubt_outlet(const SceneParameters    &parameters,
               const Mesh<dim>          &mesh,
               std::vector<std::string> &warnings)
  {
    if (!parameters.outlet_is_open)
      return;
    const double error = has_slot(parameters) ? slot_error : round_error;
    for (const MeshOutlet &outlet : mesh_outlets<dim>(mesh))
      {
        if (outlet.edge_at_lip == 0. ||
            outlet.n_cells() >= fewest_cells * (1. - rounding))
          continue;
        const double percent =
          5. * std::max(1., std::round(20. * error / outlet.n_cells()));
        std::ostringstream message;
        message.precision(2);
        message << "The outlet is only " << outlet.n_cells()
                << " cells wide, by the size of those at its lip: expect a "
                   "flow rate that is wrong by some "
                << percent << " %, mostly too low; "
                << what_to_set(parameters, outlet) << '.';
        warnings.push_back(message.str());
      }
  }



#define INSTANTIATE(dim)                                   \
  template void doubt_outlet<dim>(const SceneParameters &, \
                                  const Mesh<dim> &,       \
                                  std::vector<std::string> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
