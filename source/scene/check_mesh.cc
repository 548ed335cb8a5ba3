#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/check_mesh.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Sandglass
{
  template <int dim>
  void
  check_gravity(const SceneParameters &parameters, const Mesh<dim> &mesh)
  {
    const auto refuse = [&parameters](const std::string &allowed) {
      std::ostringstream value;
      for (const double component : parameters.gravity)
        value << (value.tellp() > 0 ? ", " : "") << component;
      throw InputError("Scene", "Gravity", value.str(), allowed);
    };
    const dealii::Tensor<1, dim> gravity = parameters.gravity_vector<dim>();
    if (gravity[1] > 0.)
      refuse("gravity points upwards; allowed is at most 0 for y, which is the "
             "silo's upward direction");

    auto sideways             = gravity;
    sideways[1]               = 0.;
    constexpr double rounding = 1e-12;
    if (sideways.norm() <= rounding * gravity.norm())
      return;
    if (parameters.formulation == Formulation::axisymmetric)
      refuse("allowed is 0 for x with Formulation = axisymmetric, since "
             "gravity beside the axis is not symmetric about it");
    const bool crosses_plane =
      std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const auto &face) {
        if (face.role != BoundaryRole::axis)
          return false;
        std::array<Point<dim>, dim> corners;
        for (unsigned int v = 0; v < dim; ++v)
          corners[v] = mesh.vertices[face.vertices[v]];
        return std::abs(unit_normal<dim>(corners) * sideways) >
               rounding * gravity.norm();
      });
    if (crosses_plane && dim == 2)
      refuse("allowed is 0 for x with half a section, since gravity across its "
             "symmetry plane is not symmetric; set Symmetry = false, or give "
             "a mesh of the whole section");
    if (crosses_plane)
      refuse("gravity crosses a symmetry plane, which is not symmetric; set "
             "Symmetry planes = none, or give a mesh of the whole silo");
  }



  template <int dim>
  void
  doubt_lengths(const Mesh<dim> &mesh, std::vector<std::string> &warnings)
  {
    // Models have been built from some centimetres on, silos up to 70 m.
    constexpr double smallest = 0.03, largest = 100.;

    double extent = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const auto [lower, upper] =
          std::minmax_element(mesh.vertices.begin(),
                              mesh.vertices.end(),
                              [d](const auto &a, const auto &b) {
                                return a[d] < b[d];
                              });
        extent = std::max(extent, (*upper)[d] - (*lower)[d]);
      }
    if (extent >= smallest && extent <= largest)
      return;
    std::ostringstream message;
    message << "The silo is " << extent
            << " m in size, which is hardly meant: lengths are in metres"
            << (extent > largest ? " (are they in millimetres here?)" : "")
            << ", gravity is in m/s^2, density in kg/m^3, Young's modulus in "
               "Pa.";
    warnings.push_back(message.str());
  }



#define INSTANTIATE(dim)                                    \
  template void check_gravity<dim>(const SceneParameters &, \
                                   const Mesh<dim> &);      \
  template void doubt_lengths<dim>(const Mesh<dim> &,       \
                                   std::vector<std::string> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
