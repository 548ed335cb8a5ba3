#ifndef sandglass_particles_cell_geometry_h
#define sandglass_particles_cell_geometry_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/prefetch.h>
#include <sandglass/particles/cell_shape.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/wall.h>

#include <limits>
#include <vector>

namespace Sandglass
{
  /**
   * The shape, neighbours and nodes of each active cell of a scene in flat
   * tables, and the walk that finds the cell of a point.
   *
   * deal.II 9.4.1 decides where a particle is with the unit square, also on
   * triangles, so the walk is our own.
   */
  template <CellType cell_type>
  class CellGeometry
  {
  public:
    using Shape              = CellShape<cell_type>;
    static constexpr int dim = Shape::dim;

    /// Face distances between minus this and 0 count as inside the cell.
    static constexpr double tolerance = 1e-12;

    explicit CellGeometry(const Scene<dim> &scene);

    const Shape &
    shape(const unsigned int cell) const
    {
      return cells[cell].shape;
    }

    /**
     * Indices of the cell's nodes in this rank's nodal vectors (owned nodes
     * first, then ghosts). Only for cells that this rank owns.
     */
    const std::array<unsigned int, Shape::n_nodes> &
    nodes(const unsigned int cell) const
    {
      return cells[cell].nodes;
    }

    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    /// Fetch into the cache what find() reads of a cell.
    void
    prefetch(const unsigned int cell) const
    {
      Sandglass::prefetch(cells[cell]);
    }

    /// Fetch what find() reads of the cells around one that is in the cache.
    void
    prefetch_neighbors(const unsigned int cell) const
    {
      for (const int neighbor : cells[cell].neighbors)
        if (neighbor >= 0)
          prefetch(neighbor);
    }

    /// Where a point lies.
    struct Location
    {
      enum class Kind
      {
        inside,  ///< in `cell`, at `reference_point`
        outside, ///< beyond the boundary face `face` of `cell`
        invalid  ///< not a number
      };

      Kind         kind;
      unsigned int cell;
      Point<dim>   reference_point; ///< with respect to `cell`
      unsigned int face;            ///< only if outside
      BoundaryPart part;            ///< what the face is, only if outside
    };

    /**
     * Walk from cell to neighbour, each time over the face that the point lies
     * farthest beyond, until it lies in a cell or beyond boundary faces only.
     * A point on an edge or vertex stays in the first cell of the walk that
     * has it. Needs about as many steps as there are cells between the start
     * and the point.
     */
    Location
    find(const Point<dim> &point, const unsigned int start_cell) const;

    /// Whether all face distances are at least `margin`; false for NaN.
    template <typename Number>
    static auto
    is_inside(const std::array<Number, dim> &reference_point,
              const double                   margin)
    {
      const auto distances = Shape::face_distances(reference_point);
      auto       result    = distances[0] >= Number(margin);
      for (unsigned int face = 1; face < Shape::n_faces; ++face)
        result = result & (distances[face] >= Number(margin));
      return result;
    }

    static bool
    is_inside(const Point<dim> &reference_point, const double margin)
    {
      return is_inside(components_of<dim>(reference_point), margin);
    }

  private:
    struct CellData
    {
      Shape                                    shape;
      std::array<unsigned int, Shape::n_nodes> nodes;
      /// Index of the cell beyond each face, or -boundary id.
      std::array<int, Shape::n_faces> neighbors;
    };

    Location
    find_by_search(const Point<dim> &point) const;

    std::vector<CellData> cells;
    /// What the boundary's faces are, by boundary id.
    std::vector<BoundaryPart> parts;
  };
} // namespace Sandglass

#endif
