#include <deal.II/base/exceptions.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/rezoning/divide_loop.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>
#include <sandglass/flow/updated_lagrangian/rezoning/mesh_outlines.h>
#include <sandglass/flow/updated_lagrangian/rezoning/mesh_polygon.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>
#include <sandglass/scene/gmsh_mesh.h>

#include <algorithm>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Of the smallest to the largest Jacobian of a new cell.
    constexpr double smallest_jacobian_ratio = 0.25;

    /// Edges with their piece, by start and end.
    using PieceOf =
      std::map<std::pair<unsigned int, unsigned int>, const BoundaryPiece *>;



    /// One body, meshed.
    class BodyMesher
    {
    public:
      BodyMesher(const BodyOutline &outline,
                 const SizeField   &size,
                 const unsigned int order)
      {
        pieces.push_back(divide_loop(outline.outside, size, order));
        for (const BoundaryLoop &hole : outline.holes)
          pieces.push_back(divide_loop(hole, size, order));
        std::vector<std::vector<Point<2>>> loops;
        for (const BoundaryLoop &loop : pieces)
          {
            loops.emplace_back();
            for (const BoundaryPiece &piece : loop)
              loops.back().push_back(piece.curve[0]);
          }
        const Triangles triangles = mesh_polygon(loops, size);
        mesh.order                = order;
        mesh.nodes                = triangles.corners;
        for (const auto &[a, b, c] : triangles.cells)
          mesh.cells.push_back({{a, b, c, 0, 0, 0}});
        find_pieces();
        find_boundary(mesh,
                      [this](const unsigned int cell, const unsigned int edge) {
                        return piece_at(cell, edge).mark;
                      });
        if (order == 2)
          {
            add_middles();
            straighten();
          }
      }

      TriangleMesh mesh;
      unsigned int n_straightened = 0;

    private:
      /// By place, since where loops touch, several pieces have one node.
      void
      find_pieces()
      {
        std::map<std::pair<double, double>, unsigned int> node_at;
        const auto key = [](const Point<2> &p) {
          return std::make_pair(p[0], p[1]);
        };
        for (unsigned int node = 0; node < mesh.nodes.size(); ++node)
          node_at.emplace(key(mesh.nodes[node]), node);
        for (const BoundaryLoop &loop : pieces)
          for (unsigned int i = 0; i < loop.size(); ++i)
            {
              const BoundaryPiece &next = loop[(i + 1) % loop.size()];
              piece_of[{node_at.at(key(loop[i].curve[0])),
                        node_at.at(key(next.curve[0]))}] = &loop[i];
            }
      }

      const BoundaryPiece &
      piece_at(const unsigned int cell, const unsigned int edge) const
      {
        const auto found = piece_of.find(
          {mesh.cells[cell][edge], mesh.cells[cell][(edge + 1) % 3]});
        if (found == piece_of.end())
          throw RunError("Gmsh's mesh of a body of material does not end where "
                         "the body does: its surface may have folded onto "
                         "itself.");
        return *found->second;
      }

      void
      add_middles()
      {
        add_edge_nodes(mesh);
        for (const auto &[cell, edge, mark] : mesh.boundary)
          mesh.nodes[mesh.cells[cell][3 + edge]] =
            piece_at(cell, edge).curve[2];
      }

      /// Halve the bulge of edges whose cells are too distorted by it.
      void
      straighten()
      {
        for (const auto &[cell, edge, mark] : mesh.boundary)
          {
            bool is_straightened = false;
            for (unsigned int halvings = 0;
                 halvings < 5 &&
                 jacobian_ratio(mesh, cell) < smallest_jacobian_ratio;
                 ++halvings)
              {
                const auto [start, end, middle] = mesh.edge_points(cell, edge);
                const Point<2> half_way         = start + (end - start) / 2.;
                if (middle.distance(half_way) < 1e-9 * start.distance(end))
                  break;
                mesh.nodes[mesh.cells[cell][3 + edge]] =
                  half_way + (middle - half_way) / 2.;
                is_straightened = true;
              }
            n_straightened += is_straightened;
          }
      }

      std::vector<BoundaryLoop> pieces;
      PieceOf                   piece_of;
    };



    void
    append(TriangleMesh &mesh, const TriangleMesh &body, const unsigned int id)
    {
      const unsigned int first_node = mesh.nodes.size();
      const unsigned int first_cell = mesh.cells.size();
      mesh.nodes.insert(mesh.nodes.end(), body.nodes.begin(), body.nodes.end());
      for (TriangleMesh::Cell cell : body.cells)
        {
          for (unsigned int i = 0; i < body.n_nodes_per_cell(); ++i)
            cell[i] += first_node;
          mesh.cells.push_back(cell);
        }
      for (auto edge : body.boundary)
        {
          edge.cell += first_cell;
          mesh.boundary.push_back(edge);
        }
      mesh.bodies.resize(mesh.cells.size(), id);
    }
  } // namespace



  NewMesh
  mesh_outlines(const std::vector<BodyOutline> &outlines,
                const SizeField                &size,
                const unsigned int              order)
  {
    Assert(order == 1 || order == 2, ExcIndexRange(order, 1, 3));
    const GmshSession session;
    NewMesh           result;
    result.mesh.order = order;
    for (unsigned int body = 0; body < outlines.size(); ++body)
      {
        const BodyMesher mesher(outlines[body], size, order);
        double           area = 0.;
        for (const double cell_area : cell_areas(mesher.mesh))
          area += cell_area;
        result.area_gained.push_back(area - outlines[body].area());
        result.n_straightened += mesher.n_straightened;
        append(result.mesh, mesher.mesh, body);
      }
    return result;
  }
} // namespace Sandglass
