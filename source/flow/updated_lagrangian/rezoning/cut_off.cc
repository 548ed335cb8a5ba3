#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/cut_off.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    bool
    is_below(const TriangleMesh &mesh,
             const unsigned int  cell,
             const double        level)
    {
      for (unsigned int edge = 0; edge < 3; ++edge)
        {
          const QuadraticCurve curve = mesh.edge_points(cell, edge);
          if (curve[0][1] > level || bezier_corner(curve)[1] > level)
            return false;
        }
      return true;
    }



    /// The mesh of some of the cells, with boundary and bodies.
    TriangleMesh
    part_of(const TriangleMesh &mesh, const std::vector<unsigned int> &cells)
    {
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> marks;
      for (const auto &[cell, edge, mark] : mesh.boundary)
        marks[{cell, edge}] = mark;
      TriangleMesh part;
      part.order = mesh.order;
      part.nodes = mesh.nodes;
      for (const unsigned int cell : cells)
        part.cells.push_back(mesh.cells[cell]);
      find_boundary(part,
                    [&](const unsigned int cell, const unsigned int edge) {
                      const auto known = marks.find({cells[cell], edge});
                      return known == marks.end() ? TriangleMesh::free_surface :
                                                    known->second;
                    });
      return part;
    }



    /// Whether each body is smaller than it may be.
    std::vector<bool>
    find_slivers(const TriangleMesh &mesh,
                 const SizeField    &size,
                 const double        smallest_share)
    {
      std::vector<double> areas(mesh.n_bodies(), 0.);
      std::vector<double> smallest(mesh.n_bodies(), 0.);
      const auto          areas_of_cells = cell_areas(mesh);
      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        {
          const double       edge = size.at(middle_of_cell(mesh, cell));
          const unsigned int body = mesh.bodies[cell];
          areas[body] += areas_of_cells[cell];
          smallest[body] =
            std::max(smallest[body],
                     smallest_share * std::sqrt(3.) / 4. * edge * edge);
        }
      std::vector<bool> is_sliver;
      for (unsigned int body = 0; body < areas.size(); ++body)
        is_sliver.push_back(areas[body] < smallest[body]);
      return is_sliver;
    }



    /// Give each body nodes of its own, without those that no cell has.
    std::vector<unsigned int>
    separate_nodes(TriangleMesh &mesh)
    {
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> index_of;
      std::vector<unsigned int>                                     old_nodes;
      std::vector<Point<2>>                                         positions;
      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
          {
            unsigned int &node = mesh.cells[cell][i];
            const auto [known, is_new] =
              index_of.emplace(std::make_pair(node, mesh.bodies[cell]),
                               old_nodes.size());
            if (is_new)
              {
                old_nodes.push_back(node);
                positions.push_back(mesh.nodes[node]);
              }
            node = known->second;
          }
      mesh.nodes = std::move(positions);
      return old_nodes;
    }
  } // namespace



  CutOff
  cut_off(const TriangleMesh        &mesh,
          const std::vector<double> &masses,
          const double               level,
          const SizeField           &size,
          const double               smallest_share,
          const std::vector<bool>   &is_spoilt)
  {
    AssertDimension(masses.size(), mesh.cells.size());
    CutOff                    result;
    std::vector<unsigned int> above;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      if (!is_spoilt.empty() && is_spoilt[cell])
        {
          result.mass_spoilt += masses[cell];
          ++result.n_cells_spoilt;
        }
      else if (is_below(mesh, cell, level))
        {
          result.mass_below += masses[cell];
          ++result.n_cells_below;
        }
      else
        above.push_back(cell);

    const TriangleMesh rest      = part_of(mesh, above);
    const auto         is_sliver = find_slivers(rest, size, smallest_share);
    for (unsigned int cell = 0; cell < above.size(); ++cell)
      if (is_sliver[rest.bodies[cell]])
        {
          result.mass_slivers += masses[above[cell]];
          ++result.n_cells_sliver;
        }
      else
        result.cells.push_back(above[cell]);

    result.mesh  = part_of(mesh, result.cells);
    result.nodes = separate_nodes(result.mesh);
    return result;
  }
} // namespace Sandglass
