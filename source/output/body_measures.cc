#include <sandglass/output/beverloo.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Whether there is a symmetry plane with a normal along x and z.
    std::array<bool, 3>
    find_symmetry_planes(const Mesh<3> &mesh)
    {
      std::array<bool, 3> has_plane{{false, false, false}};
      for (const auto &face : mesh.faces)
        if (face.role == BoundaryRole::axis)
          {
            const Tensor<1, 3> normal = vector_area(mesh, face);
            for (const unsigned int d : {0u, 2u})
              has_plane[d] =
                has_plane[d] || std::abs(normal[d]) > 0.5 * normal.norm();
          }
      return has_plane;
    }



    /// The box around faces of a role, and where a symmetry plane cuts it.
    struct Extent
    {
      static constexpr double infinity =
        std::numeric_limits<double>::infinity();
      Point<3> lower{infinity, infinity, infinity},
        upper{-infinity, -infinity, -infinity};
      std::array<bool, 3> is_cut{{false, false, false}};

      Extent(const Scene<3> &scene, const BoundaryRole role)
        : is_cut(find_symmetry_planes(scene.mesh))
      {
        for (const auto &face : scene.mesh.faces)
          if (face.role == role)
            for (unsigned int v = 0; v < scene.mesh.vertices_per_face(); ++v)
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const double x = scene.mesh.vertices[face.vertices[v]][d];
                  lower[d]       = std::min(lower[d], x);
                  upper[d]       = std::max(upper[d], x);
                }
      }

      bool
      is_empty() const
      {
        return lower[0] > upper[0];
      }

      double
      length(const unsigned int d) const
      {
        return is_empty() ? 0. : (upper[d] - lower[d]) * (is_cut[d] ? 2. : 1.);
      }

      double
      middle(const unsigned int d) const
      {
        return is_cut[d] ? 0. : (lower[d] + upper[d]) / 2.;
      }
    };
  } // namespace



  template <>
  SiloMeasures<3>::SiloMeasures(const Scene<3> &scene)
    : has_open_outlet(std::any_of(scene.mesh.faces.begin(),
                                  scene.mesh.faces.end(),
                                  [](const Mesh<3>::Face &face) {
                                    return is_open(face.role);
                                  }))
  {
    const Extent outlet(scene, BoundaryRole::outlet);
    const Extent wall(scene, BoundaryRole::wall);
    outlet_width  = std::min(outlet.length(0), outlet.length(2));
    bottom_centre = Point<3>(0., scene.fill_bottom, 0.);
    for (const Extent *extent : {&outlet, &wall})
      if (!extent->is_empty())
        {
          bottom_centre[0] = extent->middle(0);
          bottom_centre[2] = extent->middle(2);
          break;
        }

    // Lips are edges of the outlet at a floor or hopper; a slot has none where
    // it ends at walls.
    const Mesh<3>                               &mesh = scene.mesh;
    const unsigned int                           n = mesh.vertices_per_face();
    std::map<std::pair<unsigned, unsigned>, int> kinds;
    constexpr int of_outlet = 1, of_lip = 2, both = 3;
    for (const auto &face : mesh.faces)
      {
        const bool is_outlet = face.role == BoundaryRole::outlet;
        if (!is_outlet && face.role != BoundaryRole::floor &&
            face.role != BoundaryRole::hopper &&
            face.role != BoundaryRole::insert)
          continue;
        for (unsigned int v = 0; v < n; ++v)
          kinds[std::minmax(face.vertices[v], face.vertices[(v + 1) % n])] |=
            is_outlet ? of_outlet : of_lip;
        if (is_outlet)
          outlet_area += scene.symmetry_factor * vector_area(mesh, face).norm();
      }
    double along_z = 0.;
    for (const auto &[edge, kind] : kinds)
      if (kind == both)
        {
          const Tensor<1, 3> along =
            mesh.vertices[edge.second] - mesh.vertices[edge.first];
          lip_length += scene.symmetry_factor * along.norm();
          along_z += scene.symmetry_factor * std::abs(along[2]);
        }
    has_slot = lip_length > 0. && along_z > (1. - 1e-6) * lip_length;
  }



  template <>
  double
  SiloMeasures<3>::beverloo_flow_rate(const double density,
                                      const double gravity,
                                      const double grain_size) const
  {
    return Sandglass::beverloo_flow_rate(density,
                                         gravity,
                                         outlet_area,
                                         lip_length,
                                         !has_slot,
                                         grain_size * outlet_width);
  }
} // namespace Sandglass
