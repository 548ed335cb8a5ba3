#include <sandglass/scene/section_outlet.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
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
    constexpr double plane_error = 0.5, axisymmetric_error = 1.;



    /// The vertices of faces of a kind.
    template <typename IsOfKind>
    std::set<unsigned int>
    vertices_of(const Mesh<2> &mesh, const IsOfKind &is_of_kind)
    {
      std::set<unsigned int> vertices;
      for (const auto &face : mesh.faces)
        if (is_of_kind(face.role))
          vertices.insert(face.vertices.begin(), face.vertices.end());
      return vertices;
    }



    /// For each face of the outlet a number that faces which hang together
    /// share.
    std::vector<unsigned int>
    connected_parts(const std::vector<Mesh<2>::Face> &faces)
    {
      std::vector<unsigned int> part(faces.size());
      for (unsigned int i = 0; i < faces.size(); ++i)
        part[i] = i;
      std::map<unsigned int, unsigned int> face_at;
      for (unsigned int i = 0; i < faces.size(); ++i)
        for (const unsigned int vertex : faces[i].vertices)
          {
            const auto [entry, is_new] = face_at.emplace(vertex, i);
            const unsigned int joined  = part[entry->second];
            if (!is_new)
              std::replace(part.begin(), part.end(), part[i], joined);
          }
      return part;
    }



    std::string
    what_to_set(const SceneParameters &parameters, const SectionOutlet &outlet)
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
             << (parameters.cell_type == CellType::triangle ?
                   "Outlet element size" :
                   "Element size")
             << " = " << size * parameters.refinement << " or less";
      return text.str();
    }
  } // namespace



  std::vector<SectionOutlet>
  section_outlets(const Mesh<2> &mesh)
  {
    std::vector<Mesh<2>::Face> faces;
    std::copy_if(mesh.faces.begin(),
                 mesh.faces.end(),
                 std::back_inserter(faces),
                 [](const auto &face) {
                   return face.role == BoundaryRole::outlet;
                 });
    const auto on_walls = vertices_of(mesh, [](const BoundaryRole role) {
      return is_wall(role) && role != BoundaryRole::outlet;
    });
    const auto on_axis  = vertices_of(mesh, [](const BoundaryRole role) {
      return role == BoundaryRole::axis;
    });
    const auto touches  = [](const auto &face, const auto &vertices) {
      return vertices.count(face.vertices[0]) > 0 ||
             vertices.count(face.vertices[1]) > 0;
    };

    const auto                            part = connected_parts(faces);
    std::map<unsigned int, SectionOutlet> outlets;
    std::set<unsigned int>                halves;
    for (unsigned int i = 0; i < faces.size(); ++i)
      {
        const double length = mesh.vertices[faces[i].vertices[0]].distance(
          mesh.vertices[faces[i].vertices[1]]);
        SectionOutlet &outlet = outlets[part[i]];
        outlet.width += length;
        if (touches(faces[i], on_walls))
          outlet.edge_at_lip = std::max(outlet.edge_at_lip, length);
        if (touches(faces[i], on_axis))
          halves.insert(part[i]);
      }
    std::vector<SectionOutlet> result;
    for (auto &[number, outlet] : outlets)
      {
        outlet.width *= halves.count(number) > 0 ? 2. : 1.;
        result.push_back(outlet);
      }
    return result;
  }



  template <>
  void
  doubt_outlet<2>(const SceneParameters    &parameters,
                  const Mesh<2>            &mesh,
                  std::vector<std::string> &warnings)
  {
    if (!parameters.outlet_is_open)
      return;
    const double error = parameters.formulation == Formulation::axisymmetric ?
                           axisymmetric_error :
                           plane_error;
    for (const SectionOutlet &outlet : section_outlets(mesh))
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
} // namespace Sandglass
