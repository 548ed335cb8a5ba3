#include <sandglass/particles/cell_geometry.h>

namespace Sandglass
{
  template <CellType cell_type>
  CellGeometry<cell_type>::CellGeometry(const Scene<dim> &scene)
    : cells(scene.triangulation.n_active_cells())
  {
    std::vector<types::global_dof_index> dof_indices(Shape::n_nodes);
    for (const auto &cell : scene.dof_handler.active_cell_iterators())
      {
        CellData &data = cells[cell->active_cell_index()];

        std::array<Point<dim>, Shape::n_nodes> vertices;
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          vertices[v] = cell->vertex(v);
        data.shape = Shape(vertices);

        for (unsigned int face = 0; face < Shape::n_faces; ++face)
          if (cell->at_boundary(face))
            {
              const auto id        = cell->face(face)->boundary_id();
              data.neighbors[face] = -static_cast<int>(id);
              if (id >= parts.size())
                parts.resize(id + 1);
              parts[id] = boundary_part(scene.walls, id);
            }
          else
            data.neighbors[face] = cell->neighbor(face)->active_cell_index();

        data.nodes.fill(numbers::invalid_unsigned_int);
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(dof_indices);
            for (unsigned int i = 0; i < Shape::n_nodes; ++i)
              data.nodes[i] = scene.nodes->global_to_local(dof_indices[i]);
          }
      }
  }



  template <CellType cell_type>
  typename CellGeometry<cell_type>::Location
  CellGeometry<cell_type>::find(const Point<dim>  &point,
                                const unsigned int start_cell) const
  {
    if (!std::isfinite(point.square()))
      return {Location::Kind::invalid, start_cell, point, 0, {}};

    unsigned int cell = start_cell;
    // A walk longer than this goes in circles.
    const unsigned int longest_walk = 100 + cells.size() / 10;
    for (unsigned int step = 0; step < longest_walk; ++step)
      {
        const CellData &data      = cells[cell];
        const auto      distances = data.shape.walk_distances(point);

        // Boundary faces only stop the walk when no inner face is passed: a
        // point around the corner of the outlet lies beyond both.
        double farthest_inner = -tolerance, farthest_boundary = -tolerance;
        unsigned int inner_face    = Shape::n_faces,
                     boundary_face = Shape::n_faces;
        for (unsigned int face = 0; face < Shape::n_faces; ++face)
          {
            const bool is_inner = data.neighbors[face] >= 0;
            double    &farthest = is_inner ? farthest_inner : farthest_boundary;
            if (distances[face] < farthest)
              {
                farthest                                = distances[face];
                (is_inner ? inner_face : boundary_face) = face;
              }
          }
        if (inner_face != Shape::n_faces)
          cell = data.neighbors[inner_face];
        else if (boundary_face != Shape::n_faces)
          return {Location::Kind::outside,
                  cell,
                  data.shape.to_reference(point),
                  boundary_face,
                  parts[-data.neighbors[boundary_face]]};
        else
          return {Location::Kind::inside,
                  cell,
                  data.shape.to_reference(point),
                  0,
                  {}};
      }
    return find_by_search(point);
  }



  template <CellType cell_type>
  typename CellGeometry<cell_type>::Location
  CellGeometry<cell_type>::find_by_search(const Point<dim> &point) const
  {
    // The cell that comes nearest to holding the point, by its worst face.
    Location nearest{Location::Kind::outside, 0, point, 0, {}};
    double   largest = std::numeric_limits<double>::lowest();
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      {
        const auto distances = cells[cell].shape.walk_distances(point);
        const auto worst = std::min_element(distances.begin(), distances.end());
        if (*worst <= largest)
          continue;
        largest = *worst;

        const unsigned int face     = worst - distances.begin();
        const int          neighbor = cells[cell].neighbors[face];
        nearest = {*worst >= -tolerance ? Location::Kind::inside :
                                          Location::Kind::outside,
                   cell,
                   cells[cell].shape.to_reference(point),
                   face,
                   neighbor < 0 ? parts[-neighbor] : BoundaryPart()};
      }
    return nearest;
  }



  template class CellGeometry<CellType::triangle>;
  template class CellGeometry<CellType::quadrilateral>;
  template class CellGeometry<CellType::tetrahedron>;
  template class CellGeometry<CellType::hexahedron>;
} // namespace Sandglass
