#include <sandglass/scene/body_tetrahedra.h>
#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/mesh_size.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    namespace Geometry = gmsh::model::occ;



    /**
     * Builds a body's solids in Gmsh by its OpenCASCADE kernel: that of the
     * vertical wall, the hopper, and the fall region.
     */
    class BodySolids
    {
    public:
      explicit BodySolids(const SiloBody &body)
        : body(body)
      {
        gmsh::model::add("silo");
        gmsh::vectorpair solids;
        if (body.silo_height > body.hopper_height)
          solids.push_back(
            upright(body.wall, body.hopper_height, body.silo_height));
        if (body.has_hopper())
          solids.push_back(hopper());
        solids.push_back(upright(body.outlet, -body.fall_region_depth, 0.));
        // Neighbours then share a face.
        gmsh::vectorpair              shared;
        std::vector<gmsh::vectorpair> unused;
        Geometry::fragment({solids[0]},
                           {solids.begin() + 1, solids.end()},
                           shared,
                           unused);
        Geometry::synchronize();
      }

    private:
      /// The closed line around an outline at a height: four edges, of which
      /// one or two lie in the symmetry planes.
      int
      add_wire(const Outline &outline, const double y)
      {
        const double s_least = body.ends_at_plane[0] ? 0. : -1.;
        const double t_least = body.ends_at_plane[1] ? 0. : -1.;
        const std::array<Point<2>, 4> corners   = {{Point<2>(s_least, t_least),
                                                    Point<2>(1., t_least),
                                                    Point<2>(1., 1.),
                                                    Point<2>(s_least, 1.)}};
        const auto                    add_point = [y](const Point<2> &place) {
          return Geometry::addPoint(place[0], y, place[1]);
        };
        std::array<int, 4> points;
        for (unsigned int i = 0; i < 4; ++i)
          points[i] = add_point(outline.at(corners[i]));
        const int middle = outline.is_round ? add_point(outline.middle) : 0;

        std::vector<int> edges;
        for (unsigned int i = 0; i < 4; ++i)
          {
            const unsigned int j        = (i + 1) % 4;
            const bool         in_plane = (i == 0 && body.ends_at_plane[1]) ||
                                  (i == 3 && body.ends_at_plane[0]);
            edges.push_back(
              outline.is_round && !in_plane ?
                Geometry::addCircleArc(points[i], middle, points[j]) :
                Geometry::addLine(points[i], points[j]));
          }
        return Geometry::addCurveLoop(edges);
      }

      std::pair<int, int>
      upright(const Outline &outline, const double bottom, const double top)
      {
        const int surface =
          Geometry::addPlaneSurface({add_wire(outline, bottom)});
        gmsh::vectorpair parts;
        Geometry::extrude({{2, surface}}, 0., top - bottom, 0., parts);
        return *std::find_if(parts.begin(), parts.end(), [](const auto &part) {
          return part.first == 3;
        });
      }

      std::pair<int, int>
      hopper()
      {
        gmsh::vectorpair parts;
        const int        new_tag  = -1;
        const bool       is_solid = true, has_straight_walls = true;
        Geometry::addThruSections({add_wire(body.outlet, 0.),
                                   add_wire(body.wall, body.hopper_height)},
                                  parts,
                                  new_tag,
                                  is_solid,
                                  has_straight_walls);
        return parts.at(0);
      }

      const SiloBody &body;
    };



    void
    generate(const SiloBody &body, const Resolution &resolution)
    {
      const double smallest = resolution.smallest_size(),
                   largest  = resolution.element_size;
      gmsh::model::mesh::setSizeCallback(
        [&](int, int, const double x, const double y, const double z) {
          return std::min(smallest + mesh_size_growth * body.distance_from_lip(
                                                          Point<3>(x, y, z)),
                          largest);
        });
      gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
      gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
      gmsh::model::mesh::generate(3);
      gmsh::model::mesh::removeSizeCallback();
    }
  } // namespace



  Mesh<3>
  mesh_body_by_tetrahedra(const SiloBody &body, const Resolution &resolution)
  {
    Mesh<3> mesh;
    mesh.cell_type = CellType::tetrahedron;
    call_gmsh([&]() {
      const BodySolids solids(body);
      generate(body, resolution);
    });
    const GmshMesh gmsh_mesh = read_gmsh_model();
    mesh.vertices            = gmsh_mesh.nodes;
    for (const auto &element : gmsh_mesh.elements[3])
      {
        Mesh<3>::Cell cell{};
        double        highest = -body.fall_region_depth;
        for (unsigned int v = 0; v < 4; ++v)
          {
            cell.vertices[v] = element.corners.at(v);
            highest = std::max(highest, mesh.vertices[cell.vertices[v]][1]);
          }
        cell.is_filled = highest > body.rounding();
        mesh.cells.push_back(cell);
      }
    if (mesh.cells.empty())
      throw std::runtime_error("there are no tetrahedra");
    return mesh;
  }
} // namespace Sandglass
