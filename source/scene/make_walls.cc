#include <deal.II/base/numbers.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/make_walls.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Sines of angles below this are zero: coordinates in files are rounded.
    constexpr double rounding = 1e-6;



    /// To one or the other side.
    template <int dim>
    Tensor<1, dim>
    normal_of(const Mesh<dim> &mesh, const typename Mesh<dim>::Face &face)
    {
      std::array<Point<dim>, dim> points;
      for (unsigned int v = 0; v < dim; ++v)
        points[v] = mesh.vertices[face.vertices[v]];
      return unit_normal<dim>(points);
    }



    BoundaryRole
    role_by_slope(const double normal_y)
    {
      return std::abs(normal_y) < rounding ? BoundaryRole::wall :
             std::abs(normal_y) > std::sqrt(1. - rounding * rounding) ?
                                             BoundaryRole::floor :
                                             BoundaryRole::hopper;
    }



    /// The names of the walls, with commas between them.
    template <int dim>
    std::string
    names_of(const std::vector<Wall<dim>> &walls)
    {
      std::string names;
      for (const Wall<dim> &wall : walls)
        names += (names.empty() ? "" : ", ") + wall.name;
      return names;
    }



    /// All of them as the parameter file has them.
    std::string
    list(const NamedNumbers &values)
    {
      std::string text;
      for (const auto &named : values)
        text += (text.empty() ? "" : ", ") + to_text(named);
      return text;
    }



    template <int dim>
    Tensor<1, dim>
    velocity(const std::string &name, const WallParameters &parameters)
    {
      Tensor<1, dim> result;
      const auto     own = parameters.velocities.find(name);
      if (own != parameters.velocities.end())
        for (unsigned int d = 0; d < dim && d < own->second.size(); ++d)
          result[d] = own->second[d];
      else if (name == name_of(BoundaryRole::outlet))
        return velocity<dim>(std::string(name_of(BoundaryRole::floor)),
                             parameters);
      return result;
    }



    template <int dim>
    Wall<dim>
    make_wall(const std::string       &name,
              const BoundaryRole       role,
              const types::boundary_id id,
              const WallParameters    &parameters)
    {
      return {name,
              role,
              id,
              std::tan(parameters.friction_angle_of(name) * numbers::PI / 180.),
              velocity<dim>(name, parameters)};
    }



    /// Refuse names that no wall has.
    template <int dim>
    void
    check_names(const std::vector<Wall<dim>> &walls,
                const std::string            &parameter,
                const NamedNumbers           &values)
    {
      for (const auto &[name, numbers] : values)
        if (std::none_of(walls.begin(),
                         walls.end(),
                         [&name = name](const Wall<dim> &wall) {
                           return wall.name == name;
                         }))
          throw InputError("Walls",
                           parameter,
                           to_text({name, numbers}),
                           "the mesh has no wall '" + name +
                             "'; allowed are names of its walls: " +
                             names_of(walls));
    }



    /// Refuse velocities out of a wall's plane.
    template <int dim>
    void
    check_velocities(const std::vector<Wall<dim>> &walls,
                     const Mesh<dim>              &mesh,
                     const Formulation             formulation,
                     const NamedNumbers           &velocities)
    {
      const auto refuse = [&velocities](const std::string &name,
                                        const std::string &allowed) {
        throw InputError("Walls",
                         "Velocities",
                         to_text(*velocities.find(name)),
                         allowed);
      };
      for (const auto &[name, numbers] : velocities)
        if (numbers.size() != dim)
          refuse(name,
                 "allowed are as many numbers as the mesh has dimensions, " +
                   std::to_string(dim));
      for (const auto &face : mesh.faces)
        {
          const WallId wall = boundary_part(walls, face.boundary_id()).wall;
          if (wall == no_wall || velocities.count(walls[wall].name) == 0)
            continue;
          const Tensor<1, dim> &velocity = walls[wall].velocity;
          if (std::abs(velocity * normal_of(mesh, face)) >
              rounding * velocity.norm())
            refuse(walls[wall].name,
                   "allowed is a velocity in the wall's own plane, so that the "
                   "silo keeps its shape");
          if (formulation == Formulation::axisymmetric && velocity[0] != 0.)
            refuse(walls[wall].name,
                   "allowed is a velocity along the axis, with "
                   "Scene/Formulation = axisymmetric");
        }
    }
  } // namespace



  template <int dim>
  std::vector<Wall<dim>>
  make_walls(const Mesh<dim>                       &mesh,
             const std::vector<types::boundary_id> &boundary_ids,
             const Formulation                      formulation,
             const WallParameters                  &parameters)
  {
    std::map<types::boundary_id, BoundaryRole> role_of;
    for (const auto &face : mesh.faces)
      role_of[face.boundary_id()] = face.role;

    std::vector<Wall<dim>> walls;
    for (const BoundaryRole role : {BoundaryRole::wall,
                                    BoundaryRole::floor,
                                    BoundaryRole::hopper,
                                    BoundaryRole::outlet})
      if (role_of.count(boundary_id(role)) > 0)
        walls.push_back(make_wall<dim>(
          std::string(name_of(role)), role, boundary_id(role), parameters));
    for (unsigned int i = 0; i < mesh.named_walls.size(); ++i)
      {
        const types::boundary_id id   = first_named_boundary + i;
        const std::string       &name = mesh.named_walls[i];
        if (std::find(boundary_ids.begin(), boundary_ids.end(), id) ==
            boundary_ids.end())
          continue; // a group of inner faces
        if (parameters.friction_angles.count(name) == 0)
          throw InputError(
            "Walls",
            "Friction angles",
            list(parameters.friction_angles),
            "faces of the mesh's boundary belong to the physical group '" +
              name +
              "'; allowed are the groups axis, wall, floor, hopper, outlet, "
              "fall_side, fall_bottom, top, and walls of other names that have "
              "a friction angle here, as in '" +
              name + ": 20'");
        walls.push_back(make_wall<dim>(name, role_of.at(id), id, parameters));
      }
    check_names(walls, "Friction angles", parameters.friction_angles);
    check_names(walls, "Velocities", parameters.velocities);
    check_velocities(walls, mesh, formulation, parameters.velocities);
    return walls;
  }



  template <int dim>
  void
  settle_named_walls(Mesh<dim> &mesh)
  {
    using Face        = typename Mesh<dim>::Face;
    const auto key_of = [](const Face &face) {
      auto vertices = face.vertices;
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    };
    std::set<decltype(Face::vertices)> of_standard_parts;
    for (const Face &face : mesh.faces)
      if (face.named_wall == Mesh<dim>::standard_part)
        of_standard_parts.insert(key_of(face));

    std::vector<Face>                   faces;
    std::vector<std::set<BoundaryRole>> roles(mesh.named_walls.size());
    for (const Face &face : mesh.faces)
      {
        const bool is_named = face.named_wall != Mesh<dim>::standard_part;
        if (is_named && of_standard_parts.count(key_of(face)) > 0)
          continue;
        faces.push_back(face);
        if (is_named)
          roles[face.named_wall].insert(
            role_by_slope(normal_of(mesh, face)[1]));
      }
    for (Face &face : faces)
      if (face.named_wall != Mesh<dim>::standard_part)
        face.role = roles[face.named_wall].size() == 1 ?
                      *roles[face.named_wall].begin() :
                      BoundaryRole::insert;
    mesh.faces = std::move(faces);
  }



#define INSTANTIATE(dim)                             \
  template std::vector<Wall<dim>> make_walls<dim>(   \
    const Mesh<dim> &,                               \
    const std::vector<dealii::types::boundary_id> &, \
    const Formulation,                               \
    const WallParameters &);                         \
  template void settle_named_walls<dim>(Mesh<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
