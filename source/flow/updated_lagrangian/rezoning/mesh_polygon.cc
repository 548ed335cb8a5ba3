#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/crossing.h>
#include <sandglass/flow/updated_lagrangian/rezoning/mesh_polygon.h>
#include <sandglass/scene/gmsh_mesh.h>

#include <gmsh.h>

#include <map>
#include <sstream>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// A model of Gmsh for a scope.
    class Model
    {
    public:
      Model()
      {
        gmsh::model::add("body");
      }

      Model(const Model &) = delete;
      Model &
      operator=(const Model &) = delete;

      ~Model()
      {
        gmsh::model::mesh::removeSizeCallback();
        gmsh::model::remove();
      }
    };



    /// Points of the geometry by place: a loop that touches itself or another
    /// one has one point there.
    using Points = std::map<std::pair<double, double>, int>;

    std::vector<int>
    add_loops(const std::vector<std::vector<Point<2>>> &loops, Points &points)
    {
      std::vector<int> tags;
      for (const auto &loop : loops)
        {
          const auto tag_of = [&points](const Point<2> &p) {
            int &tag = points[{p[0], p[1]}];
            if (tag == 0)
              tag = gmsh::model::geo::addPoint(p[0], p[1], 0.);
            return tag;
          };
          std::vector<int> lines;
          for (unsigned int i = 0; i < loop.size(); ++i)
            lines.push_back(
              gmsh::model::geo::addLine(tag_of(loop[i]),
                                        tag_of(loop[(i + 1) % loop.size()])));
          for (const int line : lines)
            gmsh::model::geo::mesh::setTransfiniteCurve(line, 2);
          tags.push_back(gmsh::model::geo::addCurveLoop(lines));
        }
      return tags;
    }



    void
    generate(const SizeField &size)
    {
      gmsh::model::geo::synchronize();
      gmsh::option::setNumber("Mesh.Algorithm", 6); // frontal Delaunay
      gmsh::option::setNumber("Mesh.RandomSeed", 1);
      gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
      // Short pieces of the boundary need short edges beside them.
      gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
      gmsh::model::mesh::setSizeCallback(
        [&size](int, int, const double x, const double y, double) {
          return size.at(Point<2>(x, y));
        });
      gmsh::model::mesh::generate(2);
    }



    /// Take the triangles from Gmsh's model, the polygons' corners as they are.
    Triangles
    take_triangles(const std::vector<std::vector<Point<2>>> &loops,
                   const Points                             &points,
                   const int                                 surface)
    {
      Triangles                           result;
      std::map<std::size_t, unsigned int> index_of;
      std::vector<std::size_t>            tags;
      std::vector<double>                 coordinates, unused;
      for (const auto &loop : loops)
        for (const Point<2> &p : loop)
          {
            gmsh::model::mesh::getNodes(
              tags, coordinates, unused, 0, points.at({p[0], p[1]}));
            if (index_of.emplace(tags.at(0), result.corners.size()).second)
              result.corners.push_back(p);
          }
      gmsh::model::mesh::getNodes(tags, coordinates, unused, 2, surface);
      for (unsigned int i = 0; i < tags.size(); ++i)
        {
          index_of[tags[i]] = result.corners.size();
          result.corners.emplace_back(coordinates[3 * i],
                                      coordinates[3 * i + 1]);
        }

      constexpr int            triangle = 2;
      std::vector<std::size_t> nodes;
      tags.clear();
      gmsh::model::mesh::getElementsByType(triangle, tags, nodes);
      for (unsigned int i = 0; i < nodes.size(); i += 3)
        {
          std::array<unsigned int, 3> cell;
          for (unsigned int v = 0; v < 3; ++v)
            cell[v] = index_of.at(nodes[i + v]);
          const Point<2> &corner = result.corners[cell[0]];
          if (cross(result.corners[cell[1]] - corner,
                    result.corners[cell[2]] - corner) < 0.)
            std::swap(cell[1], cell[2]);
          result.cells.push_back(cell);
        }
      return result;
    }
  } // namespace



  Triangles
  mesh_polygon(const std::vector<std::vector<Point<2>>> &loops,
               const SizeField                          &size)
  {
    Triangles result;
    try
      {
        // Gmsh would end the program.
        Point<2> place;
        if (find_crossing(loops, place))
          {
            std::ostringstream where;
            where << "its surface crosses itself at (" << place << ") m";
            throw std::runtime_error(where.str());
          }
        call_gmsh([&]() {
          const Model model;
          Points      points;
          const auto  tags    = add_loops(loops, points);
          const int   surface = gmsh::model::geo::addPlaneSurface(tags);
          generate(size);
          result = take_triangles(loops, points, surface);
        });
        if (result.cells.empty())
          throw std::runtime_error("no triangles");
      }
    catch (const std::exception &error)
      {
        std::ostringstream message;
        message << "Gmsh can't mesh the body of material at ("
                << loops.at(0).at(0) << ") m anew: " << error.what()
                << ". Try smaller elements or time steps.";
        throw RunError(message.str());
      }
    return result;
  }
} // namespace Sandglass
