#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/gates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    double
    middle_of_face(const Mesh<dim> &mesh, const typename Mesh<dim>::Face &face)
    {
      double             x = 0.;
      const unsigned int n = mesh.vertices_per_face();
      for (unsigned int v = 0; v < n; ++v)
        x += mesh.vertices[face.vertices[v]][0] / n;
      return x;
    }



    std::string
    names_of(const std::vector<Outlet> &outlets)
    {
      std::string names;
      for (unsigned int i = 0; i < outlets.size(); ++i)
        names += (i > 0 ? ", " : "") + name_of_outlet(i, outlets.size());
      return names.empty() ? "none, since nothing can leave" : names;
    }
  } // namespace



  template <int dim>
  Gates<dim>::Gates(const Mesh<dim> &mesh, const GateParameters &parameters)
    : mesh(mesh)
    , parameters(parameters)
    , outlets(parameters.are_on() ? find_outlets(mesh) : std::vector<Outlet>())
    , has_axis(
        std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const auto &face) {
          return face.role == BoundaryRole::axis;
        }))
  {
    if (!are_on())
      return;
    std::set<std::string> names;
    for (unsigned int i = 0; i < outlets.size(); ++i)
      {
        names.insert(name_of_outlet(i, outlets.size()));
        Extent extent{std::numeric_limits<double>::max(),
                      std::numeric_limits<double>::lowest()};
        for (const unsigned int face : outlets[i].faces)
          for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
            {
              const double x = mesh.vertices[mesh.faces[face].vertices[v]][0];
              extent.left    = std::min(extent.left, x);
              extent.right   = std::max(extent.right, x);
            }
        extents.push_back(extent);
      }
    for (const auto &gate : parameters.openings)
      if (names.count(gate.first) == 0)
        throw InputError("Gates",
                         "Openings",
                         to_text(gate),
                         "the mesh has no outlet '" + gate.first +
                           "'; allowed are " + names_of(outlets));
    if (has_axis && parameters.opens_from != GateParameters::OpensFrom::middle)
      throw InputError("Gates",
                       "Opens from",
                       "left or right",
                       "allowed is middle with half a section, which is the "
                       "same on both sides");
  }



  template <int dim>
  bool
  Gates<dim>::is_in_opening(const double  x,
                            const Extent &extent,
                            const double  share) const
  {
    using OpensFrom = GateParameters::OpensFrom;
    if (share >= 1.)
      return true;
    const double width = extent.right - extent.left;
    // Half a section has its middle at the axis.
    if (parameters.opens_from == OpensFrom::middle)
      return has_axis && extent.left <= 0. && extent.right >= 0. ?
               std::abs(x) < share * std::max(-extent.left, extent.right) :
               std::abs(x - (extent.left + extent.right) / 2.) <
                 share * width / 2.;
    return parameters.opens_from == OpensFrom::left ?
             x < extent.left + share * width :
             x > extent.right - share * width;
  }



  template <int dim>
  typename Gates<dim>::ClosedFaces
  Gates<dim>::closed_at(const double time) const
  {
    if (!are_on())
      return {};
    ClosedFaces closed(mesh.faces.size(), false);
    for (unsigned int i = 0; i < outlets.size(); ++i)
      {
        const double share =
          parameters.open_share(name_of_outlet(i, outlets.size()), time);
        for (const unsigned int face : outlets[i].faces)
          closed[face] = !is_in_opening(middle_of_face(mesh, mesh.faces[face]),
                                        extents[i],
                                        share);
      }
    return closed;
  }



  template <int dim>
  Mesh<dim>
  Gates<dim>::close(const ClosedFaces &closed) const
  {
    Mesh<dim> result = mesh;
    if (!are_on())
      return result;
    const unsigned int n = mesh.vertices_per_face();
    for (const Outlet &outlet : outlets)
      {
        std::set<unsigned int> of_closed, of_open;
        for (const unsigned int face : outlet.faces)
          (closed[face] ? of_closed : of_open)
            .insert(mesh.faces[face].vertices.begin(),
                    mesh.faces[face].vertices.begin() + n);

        // The gate's edge is one vertex for both sides.
        std::map<unsigned int, unsigned int> below;
        for (const unsigned int vertex : of_closed)
          if (of_open.count(vertex) == 0)
            {
              below[vertex] = result.vertices.size();
              result.vertices.push_back(mesh.vertices[vertex]);
            }
        const auto lower = [&below](auto &vertices) {
          for (unsigned int &vertex : vertices)
            if (const auto entry = below.find(vertex); entry != below.end())
              vertex = entry->second;
        };
        std::set<unsigned int> of_fall_region;
        for (const unsigned int cell : outlet.cells)
          {
            auto &vertices = result.cells[cell].vertices;
            of_fall_region.insert(vertices.begin(),
                                  vertices.begin() + mesh.vertices_per_cell());
            lower(vertices);
          }
        const auto bounds_fall_region = [&](const auto &face) {
          return face.role != BoundaryRole::outlet &&
                 std::all_of(face.vertices.begin(),
                             face.vertices.begin() + n,
                             [&](const unsigned int vertex) {
                               return of_fall_region.count(vertex) > 0;
                             });
        };
        for (unsigned int i = 0; i < mesh.faces.size(); ++i)
          if (bounds_fall_region(mesh.faces[i]))
            lower(result.faces[i].vertices);
        for (const unsigned int face : outlet.faces)
          if (closed[face])
            {
              auto lower_side = mesh.faces[face];
              lower(lower_side.vertices);
              lower_side.role = BoundaryRole::fall_side;
              result.faces.push_back(lower_side);
            }
      }
    return result;
  }



#define INSTANTIATE(dim) template class Gates<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
