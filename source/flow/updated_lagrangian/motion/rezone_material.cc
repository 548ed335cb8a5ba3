#include <deal.II/base/quadrature_lib.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/motion/rezone_material.h>
#include <sandglass/flow/updated_lagrangian/rezoning/crossing.h>
#include <sandglass/flow/updated_lagrangian/rezoning/cut_off.h>
#include <sandglass/flow/updated_lagrangian/rezoning/divide_loop.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    // Lengths over that of an element.

    /// An edge so near to a wall lies on it.
    constexpr double on_wall = 1e-3;
    /// The same where an edge has been divided at a wall's end; and how near
    /// to such an end the boundary runs through it.
    constexpr double at_end = 0.1;
    /// Hollows in corners up to this are filled.
    constexpr double hollow = 0.6;
    /// Elements at the lip, and by how much they may grow from there.
    constexpr double lip_size = 0.5;

    /// A body smaller than this share of an element can't be meshed.
    constexpr double smallest_body = 0.3;



    /// The wall on which a curve lies, or free_surface.
    unsigned int
    wall_of(const QuadraticCurve &curve, const MotionSetting &setting)
    {
      for (unsigned int w = 0; w < setting.walls.size(); ++w)
        {
          const RigidWall &wall      = setting.walls[w];
          double           tolerance = on_wall * setting.element_size;
          for (unsigned int e = 0; e < 2; ++e)
            if (!wall.is_axis() && wall.is_free_end[e])
              for (const Point<2> &p : {curve[0], curve[1]})
                if (p.distance(e == 0 ? wall.start : wall.end) <
                    at_end * setting.element_size)
                  tolerance = at_end * setting.element_size;
          const double l = wall.length();
          if (std::all_of(curve.begin(),
                          curve.end(),
                          [&](const Point<2> &p) {
                            const double along =
                              wall.tangent * (p - wall.start);
                            return std::abs(wall.gap(p)) < tolerance &&
                                   (wall.is_axis() || (along > -tolerance &&
                                                       along < l + tolerance));
                          }) &&
              // Along the wall, with the material on its left.
              (curve[1] - curve[0]) * wall.tangent >
                0.7 * curve[1].distance(curve[0]))
            return w;
        }
      return TriangleMesh::free_surface;
    }



    /// Elements are as long as the material is thick, where that is less than
    /// in the silo's first mesh; but not much smaller.
    SizeField
    size_field(const MotionSetting &setting, const TriangleMesh &mesh)
    {
      constexpr double smallest  = 0.25;
      double           area      = 0.;
      double           perimeter = 0.;
      for (const double of_cell : cell_areas(mesh))
        area += of_cell;
      for (const auto &edge : mesh.boundary)
        {
          const auto curve = mesh.edge_points(edge.cell, edge.edge);
          perimeter += curve[0].distance(curve[1]);
        }
      SizeField size{std::clamp(2. * area / perimeter,
                                smallest * setting.element_size,
                                setting.element_size),
                     {}};
      for (const Point<2> &corner : rigid_corners(setting.scene, setting.walls))
        size.centres.push_back(
          {corner, std::min(size.size, lip_size * setting.element_size), 0.2});
      return size;
    }



    /// A straight piece of boundary.
    BoundaryPiece
    straight_piece(const Point<2> &a, const Point<2> &b)
    {
      return {{{a, b, a + (b - a) / 2.}}, TriangleMesh::free_surface, false};
    }



    /**
     * Fill hollows in corners where one wall follows another: smaller than an
     * element, they can't be resolved, and would be bounded by ever smaller
     * edges.
     */
    void
    fill_corners(BoundaryLoop &loop, const MotionSetting &setting)
    {
      const double near = hollow * setting.element_size;
      const double on   = on_wall * setting.element_size;
      for (const RigidWall &a : setting.walls)
        for (const RigidWall &b : setting.walls)
          {
            if (a.is_axis() || b.is_axis() || a.is_free_end[1] ||
                a.end.distance(b.start) > on)
              continue;
            const Point<2> &corner = a.end;
            // Begin the loop away from the corner.
            const auto far =
              std::find_if(loop.begin(), loop.end(), [&](const auto &piece) {
                return piece.curve[0].distance(corner) > near;
              });
            if (far == loop.end())
              continue;
            std::rotate(loop.begin(), far, loop.end());
            const unsigned int none  = numbers::invalid_unsigned_int;
            unsigned int       first = none, last = none;
            for (unsigned int i = 0; i < loop.size(); ++i)
              {
                const Point<2> &p = loop[i].curve[0];
                if (p.distance(corner) > near)
                  continue;
                if (first == none && std::abs(a.gap(p)) < on)
                  first = i;
                if (first != none && std::abs(b.gap(p)) < on)
                  last = i;
              }
            if (first == none || last == none || last <= first ||
                last - first > 20)
              continue;
            const Point<2> from = loop[first].curve[0];
            const Point<2> to   = loop[last].curve[0];
            BoundaryLoop   pieces;
            if (from.distance(corner) > on)
              pieces.push_back(straight_piece(from, corner));
            if (to.distance(corner) > on)
              pieces.push_back(straight_piece(corner, to));
            if (pieces.empty())
              continue;
            loop.erase(loop.begin() + first, loop.begin() + last);
            loop.insert(loop.begin() + first, pieces.begin(), pieces.end());
          }
    }



    RezoningOptions
    options_of(const MotionSetting &setting, const TriangleMesh &mesh)
    {
      RezoningOptions options;
      options.corners.fixed_points = wall_ends(setting.walls);
      options.corners.tolerance    = at_end * setting.element_size;
      options.corners.mark_of      = [&setting](const BoundaryPiece &piece) {
        return wall_of(piece.curve, setting);
      };
      options.corners.change = [&setting](BoundaryLoop &loop) {
        fill_corners(loop, setting);
      };
      // Sharper turns of the surface stay, others become smooth.
      options.corners.largest_turn = 1.2;
      options.size                 = size_field(setting, mesh);
      options.quadrature           = stress_quadrature(mesh.order);
      options.depth                = setting.depth;
      // Walls and axis take up what moves sidewards.
      options.keeps_momentum = {{false, true}};
      return options;
    }



    Point<2>
    foot_on(const RigidWall &wall, const Point<2> &p)
    {
      return p - wall.gap(p) * wall.normal;
    }



    /// Whether a point of the boundary stands in a wall, where a curved edge
    /// has come out of a division. Under a free end there may be material.
    bool
    stands_in(const RigidWall     &wall,
              const Point<2>      &p,
              const MotionSetting &setting)
    {
      constexpr double slope = 0.2, deepest = 0.15;
      const double     gap     = wall.gap(p);
      const double     along   = wall.tangent * (p - wall.start);
      double           largest = deepest * setting.element_size;
      for (unsigned int e = 0; e < 2; ++e)
        if (!wall.is_axis() && wall.is_free_end[e])
          largest =
            std::min(largest, slope * (e == 0 ? along : wall.length() - along));
      return gap > 0. && (wall.is_axis() || gap < largest) && wall.reaches(p);
    }



    /// Put the nodes of a mesh's wall edges on the walls' lines, and those near
    /// walls' free ends there; nodes on edges go half the way with their ends.
    void
    snap_to_walls(TriangleMesh &mesh, const MotionSetting &setting)
    {
      // Of the nodes at the boundary; none of those at the free surface.
      std::map<unsigned int, std::vector<unsigned int>> walls_of;
      for (const auto &[cell, edge, mark] : mesh.boundary)
        for (const unsigned int n : mesh.edge_nodes(cell, edge))
          {
            auto &walls = walls_of[n];
            if (mark != TriangleMesh::free_surface &&
                std::find(walls.begin(), walls.end(), mark) == walls.end())
              walls.push_back(mark);
          }
      const auto moved = [&](const unsigned int n) {
        Point<2>   p     = mesh.nodes[n];
        const auto found = walls_of.find(n);
        if (found == walls_of.end())
          return p;
        if (found->second.empty())
          {
            for (const RigidWall &wall : setting.walls)
              if (stands_in(wall, p, setting))
                p = foot_on(wall, p);
            return p;
          }
        // Alternating projections end where two lines cross.
        for (unsigned int i = 0; i < (found->second.size() > 1 ? 200 : 1); ++i)
          for (const unsigned int w : found->second)
            p = foot_on(setting.walls[w], p);
        for (const unsigned int w : found->second)
          for (unsigned int e = 0; e < 2; ++e)
            {
              const RigidWall &wall = setting.walls[w];
              const Point<2>  &end  = e == 0 ? wall.start : wall.end;
              if (!wall.is_axis() && wall.is_free_end[e] &&
                  p.distance(end) < at_end * setting.element_size)
                p = end;
            }
        return p;
      };
      std::vector<Point<2>> positions = mesh.nodes;
      for (auto &cell : mesh.cells)
        for (unsigned int i = 0; i < 3; ++i)
          positions[cell[i]] = moved(cell[i]);
      if (mesh.order == 2)
        for (auto &cell : mesh.cells)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const unsigned int n = cell[3 + i];
              const unsigned int a = cell[i], b = cell[(i + 1) % 3];
              const auto         found = walls_of.find(n);
              if (found == walls_of.end())
                positions[n] =
                  mesh.nodes[n] + ((positions[a] - mesh.nodes[a]) +
                                   (positions[b] - mesh.nodes[b])) /
                                    2.;
              else if (found->second.empty())
                positions[n] = moved(n);
              else
                positions[n] =
                  positions[a] + (positions[b] - positions[a]) / 2.;
            }
      mesh.nodes = positions;
    }



    std::vector<double>
    body_masses_of(const TriangleMesh        &mesh,
                   const std::vector<double> &cell_masses)
    {
      std::vector<double> masses(mesh.n_bodies(), 0.);
      for (unsigned int cell = 0; cell < cell_masses.size(); ++cell)
        masses[mesh.bodies[cell]] += cell_masses[cell];
      return masses;
    }
  } // namespace



  Quadrature<2>
  stress_quadrature(const unsigned int order)
  {
    if (order == 1)
      return QGaussSimplex<2>(1);
    return Quadrature<2>({Point<2>(1. / 6., 1. / 6.),
                          Point<2>(2. / 3., 1. / 6.),
                          Point<2>(1. / 6., 2. / 3.)},
                         std::vector<double>(3, 1. / 6.));
  }



  void
  mark_walls(TriangleMesh &mesh, const MotionSetting &setting)
  {
    for (auto &edge : mesh.boundary)
      edge.mark = wall_of(mesh.edge_points(edge.cell, edge.edge), setting);
  }



  RezoningCriterion
  rezoning_criterion(const MotionSetting &setting)
  {
    RezoningCriterion criterion;
    criterion.rigid_corners = rigid_corners(setting.scene, setting.walls);
    return criterion;
  }



  namespace
  {
    /// Where the boundary of a new mesh would cross itself.
    struct Crossing : RunError
    {
      Crossing(const std::string &message, const Point<2> &place)
        : RunError(message)
        , place(place)
      {}

      Point<2> place; ///< in m
    };



    /// Throws Crossing where the new mesh's boundary would.
    void
    check_crossings(const TriangleMesh &mesh, const RezoningOptions &options)
    {
      for (const BodyOutline &outline : find_outlines(mesh, options.corners))
        {
          auto loops = outline.holes;
          loops.push_back(outline.outside);
          std::vector<std::vector<Point<2>>> polygons;
          for (const BoundaryLoop &loop : loops)
            {
              polygons.push_back({});
              for (const auto &piece :
                   divide_loop(loop, options.size, mesh.order))
                polygons.back().push_back(piece.curve[0]);
            }
          Point<2> place;
          if (find_crossing(polygons, place))
            {
              std::ostringstream message;
              message << "The material's surface crosses itself at (" << place
                      << ") m.";
              throw Crossing(message.str(), place);
            }
        }
    }



    /// Straighten the edges of cells that walls or curved edges have turned
    /// over. Throws Crossing where that isn't enough.
    void
    check_cells(TriangleMesh &mesh)
    {
      constexpr double smallest_ratio = 0.05, smallest = 0.005;

      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        if (mesh.order == 2 && jacobian_ratio(mesh, cell) < smallest_ratio)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const auto [start, end, middle]     = mesh.edge_points(cell, i);
              mesh.nodes[mesh.cells[cell][3 + i]] = start + (end - start) / 2.;
            }
      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        if (!(jacobian_ratio(mesh, cell) > smallest_ratio) ||
            !(smallest_angle(mesh, cell) > smallest))
          {
            const Point<2>     place = middle_of_cell(mesh, cell);
            std::ostringstream message;
            message << "A new element has turned over at (" << place << ") m.";
            throw Crossing(message.str(), place);
          }
    }



    /// Add the cells at the boundary that are nearer to a place than this.
    void
    spoil_round(const TriangleMesh &mesh,
                const Point<2>     &place,
                const double        distance,
                std::vector<bool>  &is_spoilt)
    {
      for (const auto &[cell, edge, mark] : mesh.boundary)
        for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
          if (mesh.nodes[mesh.cells[cell][i]].distance(place) < distance)
            is_spoilt[cell] = true;
    }



    /// Cells at the free surface that are distorted beyond a bound.
    void
    spoil_distorted(const TriangleMesh &mesh,
                    const double        smallest_quality,
                    std::vector<bool>  &is_spoilt)
    {
      for (const auto &edge : mesh.boundary)
        if (edge.mark == TriangleMesh::free_surface &&
            (jacobian_ratio(mesh, edge.cell) < smallest_quality ||
             smallest_angle(mesh, edge.cell) < smallest_quality))
          is_spoilt[edge.cell] = true;
    }



    RezonedMaterial
    try_rezoning(const MotionSetting     &setting,
                 const MaterialState     &state,
                 const std::vector<bool> &is_spoilt);
  } // namespace



  RezonedMaterial
  rezone_material(const MotionSetting &setting, const MaterialState &state)
  {
    constexpr unsigned int most_tries = 6;

    TriangleMesh mesh = state.at.mesh;
    mark_walls(mesh, setting);
    std::vector<bool> is_spoilt(mesh.cells.size(), false);
    for (unsigned int i = 1; i < most_tries; ++i)
      try
        {
          return try_rezoning(setting, state, is_spoilt);
        }
      // The surface has folded. Without the elements that have, the body keeps
      // all but their shape.
      catch (const Crossing &crossing)
        {
          spoil_round(mesh,
                      crossing.place,
                      0.25 * i * setting.element_size,
                      is_spoilt);
        }
      catch (const RunError &)
        {
          spoil_distorted(mesh, 0.05 * i, is_spoilt);
        }
    return try_rezoning(setting, state, is_spoilt);
  }



  namespace
  {
    RezonedMaterial
    try_rezoning(const MotionSetting     &setting,
                 const MaterialState     &state,
                 const std::vector<bool> &is_spoilt)
    {
      const RezoningOptions options = options_of(setting, state.at.mesh);
      const unsigned int    n_cells = state.at.mesh.cells.size();
      const auto cell_masses        = sums_by_cell(state.point_masses, n_cells);

      CutOff          cut = cut_off(state.at.mesh,
                           cell_masses,
                           setting.lowest_level,
                           options.size,
                           smallest_body,
                           is_spoilt);
      RezonedMaterial result;
      result.mass_below   = cut.mass_below;
      result.mass_slivers = cut.mass_slivers;
      std::ostringstream text;
      if (cut.is_cut())
        text << cut.n_cells_below << " elements cut off, " << cut.n_cells_sliver
             << " in slivers, " << cut.n_cells_spoilt << " folded; ";
      if (cut.mesh.cells.empty())
        {
          result.mass_slivers += cut.mass_spoilt;
          result.description = text.str() + "nothing is left";
          return result;
        }

      MeshState rest;
      rest.mesh = cut.mesh;
      mark_walls(rest.mesh, setting);
      check_crossings(rest.mesh, options);
      const unsigned int n_points = options.quadrature.size();
      rest.velocity               = state.at.velocity.at_blocks(cut.nodes);
      rest.nodal_fields           = state.at.nodal_fields.at_blocks(cut.nodes);
      rest.density =
        MeshField{1, state.at.density}.at_blocks(cut.cells, n_points).values;
      rest.point_fields = state.at.point_fields.at_blocks(cut.cells, n_points);
      std::vector<double> masses_left;
      for (const unsigned int cell : cut.cells)
        masses_left.push_back(cell_masses[cell]);
      auto body_masses = body_masses_of(rest.mesh, masses_left);
      // What was in folded elements goes to the others.
      const double kept =
        std::accumulate(body_masses.begin(), body_masses.end(), 0.);
      for (double &mass : body_masses)
        mass *= 1. + cut.mass_spoilt / kept;

      Rezoned rezoned    = rezone(rest, options);
      result.state.at    = std::move(rezoned.state);
      TriangleMesh &mesh = result.state.at.mesh;
      snap_to_walls(mesh, setting);
      check_cells(mesh);
      result.state.point_masses = point_masses_of(mesh,
                                                  setting.depth,
                                                  result.state.at.density,
                                                  body_masses);
      result.description        = text.str() + rezoned.jumps.description();
      return result;
    }
  } // namespace
} // namespace Sandglass
