#include <sandglass/flow/updated_lagrangian/motion/check_new_mesh.h>
#include <sandglass/flow/updated_lagrangian/rezoning/crossing.h>
#include <sandglass/flow/updated_lagrangian/rezoning/divide_loop.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>

#include <cmath>
#include <sstream>

namespace Sandglass
{
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



  void
  check_area(const RezoningJumps &jumps, const double element_size)
  {
    // Corners of a free surface are rounded, at most by some of an element.
    constexpr double largest_share = 0.01, most_elements = 2.;

    const double before     = jumps.before.area;
    const double change     = jumps.after.area - before;
    const double of_element = std::sqrt(3.) / 4. * element_size * element_size;
    if (std::abs(change) <= largest_share * before ||
        std::abs(change) <= most_elements * of_element)
      return;
    std::ostringstream message;
    message.precision(3);
    message << "Re-zoning changes the material's area by "
            << 100. * change / before
            << " %, more than the 1 % allowed. Try a smaller Element size, or "
               "a shorter Time step.";
    throw RunError(message.str());
  }



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
} // namespace Sandglass
