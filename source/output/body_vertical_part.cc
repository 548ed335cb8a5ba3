#include <sandglass/output/body_vertical_part.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/output/small_sine.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Shares by which areas and slopes of facets differ from those of the
    /// round walls that they stand for.
    constexpr double same_area = 0.01, same_slope = 0.03;

    constexpr double infinity = std::numeric_limits<double>::infinity();



    std::vector<bool>
    find_filled(const Mesh<3> &mesh)
    {
      std::vector<bool> is_filled(mesh.vertices.size(), false);
      for (const auto &cell : mesh.cells)
        if (cell.is_filled)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            is_filled[cell.vertices[v]] = true;
      return is_filled;
    }



    bool
    points_down(const Tensor<1, 3> &gravity)
    {
      return -gravity[1] > 0. &&
             std::hypot(gravity[0], gravity[2]) <= small_sine * gravity.norm();
    }



    /// The friction that walls have in common; none where they differ or move.
    class CommonFriction
    {
    public:
      void
      add(const Wall<3> &wall)
      {
        is_common = is_common && wall.velocity.norm() == 0. &&
                    (!coefficient || *coefficient == wall.friction_coefficient);
        coefficient = wall.friction_coefficient;
      }

      std::optional<double>
      value() const
      {
        return is_common ? coefficient : std::nullopt;
      }

    private:
      std::optional<double> coefficient;
      bool                  is_common = true;
    };
  } // namespace



  BodyVerticalPart::BodyVerticalPart(const Scene<3> &scene)
    : top(scene.fill_top)
    , foot(scene.fill_bottom)
  {
    rounding = small_sine * (top - foot);
    if (!points_down(scene.gravity))
      return;
    const std::vector<Face> faces = wall_faces(scene);
    // Where the highest wall that is not vertical ends.
    for (const Face &face : faces)
      if (std::abs(face.normal[1]) > small_sine)
        foot = std::max(foot, face.upper);
    if (foot > top - rounding)
      return;
    find_cross_section(scene, faces);
    if (width == 0.)
      return;
    CommonFriction friction;
    for (const Face &face : faces)
      if (face.lower > foot - rounding)
        friction.add(scene.walls[face.wall]);
    friction_coefficient = friction.value();
    has_flat_bottom      = scene.fill_bottom > foot - rounding;
    find_hopper(scene, faces);
  }



  std::vector<BodyVerticalPart::Face>
  BodyVerticalPart::wall_faces(const Scene<3> &scene)
  {
    const std::vector<bool> is_filled = find_filled(scene.mesh);
    std::vector<Face>       faces;
    for (const auto &face : scene.mesh.faces)
      {
        const WallId wall = boundary_part(scene.walls, face.boundary_id()).wall;
        if (wall == no_wall || face.role == BoundaryRole::outlet)
          continue;
        double lower = infinity, upper = -infinity;
        bool   holds_material = true;
        for (unsigned int v = 0; v < scene.mesh.vertices_per_face(); ++v)
          {
            const double y = scene.mesh.vertices[face.vertices[v]][1];
            lower          = std::min(lower, y);
            upper          = std::max(upper, y);
            holds_material = holds_material && is_filled[face.vertices[v]];
          }
        const Tensor<1, 3> area = vector_area(scene.mesh, face);
        if (holds_material)
          faces.push_back(
            {area / area.norm(), area.norm(), lower, upper, wall});
      }
    return faces;
  }



  void
  BodyVerticalPart::find_cross_section(const Scene<3>          &scene,
                                       const std::vector<Face> &faces)
  {
    // The surface of the material: its faces, and which of their edges are
    // neither between two of them nor in a symmetry plane.
    using Edge               = std::pair<unsigned int, unsigned int>;
    const Mesh<3>      &mesh = scene.mesh;
    const unsigned int  n    = mesh.vertices_per_face();
    std::map<Edge, int> rim;
    const auto visit = [&](const Mesh<3>::Face &face, const int count) {
      for (unsigned int v = 0; v < n; ++v)
        rim[std::minmax(face.vertices[v], face.vertices[(v + 1) % n])] += count;
    };
    constexpr int         many = 100;
    std::array<double, 2> lower{{infinity, infinity}},
      upper{{-infinity, -infinity}};
    std::array<bool, 2> is_cut{{false, false}};
    double              area = 0.;
    for (const auto &face : mesh.faces)
      {
        const Tensor<1, 3> of_face = vector_area(mesh, face);
        if (face.role == BoundaryRole::axis)
          {
            visit(face, many);
            for (unsigned int d = 0; d < 2; ++d)
              is_cut[d] =
                is_cut[d] || std::abs(of_face[2 * d]) > 0.5 * of_face.norm();
          }
        double at_surface = 0.;
        for (unsigned int v = 0; v < n; ++v)
          at_surface +=
            std::abs(mesh.vertices[face.vertices[v]][1] - top) <= rounding;
        if (face.role != BoundaryRole::top || at_surface < n)
          continue;
        visit(face, 1);
        area += of_face.norm();
        for (unsigned int v = 0; v < n; ++v)
          for (unsigned int d = 0; d < 2; ++d)
            {
              const double x = mesh.vertices[face.vertices[v]][2 * d];
              lower[d]       = std::min(lower[d], x);
              upper[d]       = std::max(upper[d], x);
            }
      }
    double perimeter = 0.;
    for (const auto &[edge, count] : rim)
      if (count == 1)
        perimeter +=
          mesh.vertices[edge.first].distance(mesh.vertices[edge.second]);
    double area_of_walls = 0.;
    for (const Face &face : faces)
      if (face.lower > foot - rounding &&
          std::abs(face.normal[1]) <= small_sine)
        area_of_walls += face.area;
    if (area == 0. || perimeter == 0. ||
        std::abs(area_of_walls / (perimeter * (top - foot)) - 1.) > same_area)
      return;
    std::array<double, 2> middle;
    for (unsigned int d = 0; d < 2; ++d)
      {
        middle[d]           = is_cut[d] ? 0. : (lower[d] + upper[d]) / 2.;
        const double length = (upper[d] - lower[d]) * (is_cut[d] ? 2. : 1.);
        width               = d == 0 ? length : std::min(width, length);
      }
    hydraulic_radius = area / perimeter;
    const SiloMeasures<3> measures(scene);
    if (measures.outlet_width > 0.)
      outlet_eccentricity = std::hypot(measures.bottom_centre[0] - middle[0],
                                       measures.bottom_centre[2] - middle[1]);
  }



  void
  BodyVerticalPart::find_hopper(const Scene<3>          &scene,
                                const std::vector<Face> &faces)
  {
    CommonFriction friction;
    double         least = infinity, most = 0., along_z = 0.;
    for (const Face &face : faces)
      {
        if (face.upper > foot + rounding)
          continue;
        const double horizontal = std::hypot(face.normal[0], face.normal[2]);
        // Upright ends of a wedge.
        if (std::abs(face.normal[1]) <= small_sine)
          continue;
        friction.add(scene.walls[face.wall]);
        const double slope = std::abs(face.normal[1]) / horizontal;
        least              = std::min(least, slope);
        most               = std::max(most, slope);
        along_z            = std::max(along_z, std::abs(face.normal[2]));
      }
    if (most == 0. || most > (1. + same_slope) * least ||
        1. / most < small_sine || !friction.value())
      return;
    hopper_slope                = (least + most) / 2.;
    hopper_is_wedge             = along_z < small_sine;
    hopper_friction_coefficient = friction.value();
  }



  bool
  BodyVerticalPart::has_wall(const WallRecord &record) const
  {
    return width > 0. && std::abs(record.normal[1]) <= small_sine &&
           record.position[1] > foot - rounding &&
           record.position[1] < top + rounding;
  }



  bool
  BodyVerticalPart::has_bottom(const WallRecord &record) const
  {
    return width > 0. && has_flat_bottom &&
           std::hypot(record.normal[0], record.normal[2]) <= small_sine &&
           record.position[1] < foot + rounding;
  }



  bool
  BodyVerticalPart::has_hopper(const WallRecord &record) const
  {
    return hopper_slope > 0. && std::abs(record.normal[1]) > small_sine &&
           std::hypot(record.normal[0], record.normal[2]) > small_sine &&
           record.position[1] < foot + rounding;
  }
} // namespace Sandglass
