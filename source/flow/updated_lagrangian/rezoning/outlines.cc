#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/rezoning/outlines.h>

#include <cmath>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// An edge of a cell.
    using Edge = std::pair<unsigned int, unsigned int>;

    /// Finds closed sequences of boundary edges.
    class LoopFinder
    {
    public:
      explicit LoopFinder(const TriangleMesh &mesh)
        : mesh(mesh)
        , neighbours(neighbours_of_cells(mesh))
      {
        for (const auto &edge : mesh.boundary)
          marks[{edge.cell, edge.edge}] = edge.mark;
      }

      /// All loops, each with its body.
      std::vector<std::pair<unsigned int, BoundaryLoop>>
      find() const
      {
        std::vector<std::pair<unsigned int, BoundaryLoop>> loops;
        std::map<Edge, bool>                               is_done;
        for (const auto &first : mesh.boundary)
          {
            Edge edge{first.cell, first.edge};
            if (is_done[edge])
              continue;
            loops.push_back({mesh.bodies[first.cell], {}});
            for (; !is_done[edge]; edge = next(edge))
              {
                is_done[edge] = true;
                loops.back().second.push_back(
                  {mesh.edge_points(edge.first, edge.second),
                   marks.at(edge),
                   false});
              }
          }
        return loops;
      }

    private:
      /// The boundary edge that follows: the last of the edges that the cells
      /// round this edge's end have there.
      Edge
      next(const Edge &edge) const
      {
        Edge result{edge.first, (edge.second + 1) % 3};
        while (neighbours[result.first][result.second] !=
               numbers::invalid_unsigned_int)
          {
            const unsigned int corner = mesh.cells[result.first][result.second];
            const unsigned int beyond = neighbours[result.first][result.second];
            unsigned int       v      = 0;
            while (mesh.cells[beyond][v] != corner)
              ++v;
            result = {beyond, v};
          }
        return result;
      }

      const TriangleMesh                            &mesh;
      const std::vector<std::array<unsigned int, 3>> neighbours;
      std::map<Edge, unsigned int>                   marks;
    };



    /// Divide the piece that runs through a point, unless it starts or ends
    /// there.
    void
    keep_point(BoundaryLoop   &loop,
               const Point<2> &point,
               const double    tolerance)
    {
      for (unsigned int i = 0; i < loop.size(); ++i)
        if (loop[i].curve[0].distance(point) <= tolerance)
          {
            loop[i].starts_at_corner = true;
            return;
          }
      for (unsigned int i = 0; i < loop.size(); ++i)
        {
          const BoundaryPiece piece = loop[i];
          const double        t     = nearest_on_curve(piece.curve, point);
          if (position_on_curve(piece.curve, t).distance(point) > tolerance)
            continue;
          loop[i].curve = part_of_curve(piece.curve, 0., t);
          loop.insert(loop.begin() + i + 1,
                      {part_of_curve(piece.curve, t, 1.), piece.mark, true});
          return;
        }
    }



    void
    mark_corners(BoundaryLoop &loop, const CornerRule &rule)
    {
      if (rule.change)
        rule.change(loop);
      for (BoundaryPiece &piece : loop)
        piece.starts_at_corner = false;
      for (const Point<2> &point : rule.fixed_points)
        keep_point(loop, point, rule.tolerance);
      if (rule.mark_of)
        for (BoundaryPiece &piece : loop)
          piece.mark = rule.mark_of(piece);
      for (unsigned int i = 0; i < loop.size(); ++i)
        {
          const BoundaryPiece &before =
            loop[(i + loop.size() - 1) % loop.size()];
          const Tensor<1, 2> arriving = derivative_on_curve(before.curve, 1.);
          const Tensor<1, 2> leaving  = derivative_on_curve(loop[i].curve, 0.);
          const double       turn =
            std::abs(std::atan2(cross(arriving, leaving), arriving * leaving));
          loop[i].starts_at_corner = loop[i].starts_at_corner ||
                                     turn > rule.largest_turn ||
                                     before.mark != loop[i].mark;
        }
    }



    /// Where the boundary touches itself in a node, it has to stay there, lest
    /// new edges cross.
    void
    mark_contacts(std::vector<std::pair<unsigned int, BoundaryLoop>> &loops)
    {
      std::map<std::pair<double, double>, BoundaryPiece *> piece_at;
      for (auto &[body, loop] : loops)
        for (BoundaryPiece &piece : loop)
          {
            const Point<2> &start = piece.curve[0];
            const auto [known, is_new] =
              piece_at.emplace(std::make_pair(start[0], start[1]), &piece);
            if (!is_new)
              piece.starts_at_corner = known->second->starts_at_corner = true;
          }
    }
  } // namespace



  double
  BodyOutline::area() const
  {
    double result = enclosed_area(outside);
    for (const BoundaryLoop &hole : holes)
      result += enclosed_area(hole);
    return result;
  }



  std::vector<BodyOutline>
  find_outlines(const TriangleMesh &mesh, const CornerRule &rule)
  {
    std::vector<BodyOutline> outlines(mesh.n_bodies());
    auto                     loops = LoopFinder(mesh).find();
    for (auto &[body, loop] : loops)
      mark_corners(loop, rule);
    mark_contacts(loops);
    for (auto &[body, loop] : loops)
      {
        if (enclosed_area(loop) < 0.)
          outlines[body].holes.push_back(std::move(loop));
        else if (outlines[body].outside.empty())
          outlines[body].outside = std::move(loop);
        else
          throw RunError("The material's boundary crosses itself.");
      }
    for (const BodyOutline &outline : outlines)
      if (!(outline.area() > 0.))
        throw RunError("A body of the material has no area: its elements have "
                       "turned over.");
    return outlines;
  }
} // namespace Sandglass
