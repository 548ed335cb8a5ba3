#ifndef sandglass_flow_updated_lagrangian_rezoning_point_locator_h
#define sandglass_flow_updated_lagrangian_rezoning_point_locator_h

#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <vector>

namespace Sandglass
{
  /// Where a point lies in a mesh.
  struct Location
  {
    unsigned int cell;
    Point<2>     reference_point;
    /// The smallest of the barycentric coordinates, negative outside of the
    /// cell.
    double smallest_coordinate;
    /// How far in m the point lay from the body, if it had to be projected.
    double distance = 0.;
  };

  /**
   * Finds the cells in which points lie, and where in them.
   *
   * A point is looked for in all cells whose bounding boxes hold it, by
   * Newton's method for the inverse of the cell's mapping; of several cells the
   * one counts in which its smallest barycentric coordinate is largest. A point
   * outside of its body by less than a tenth of a cell is evaluated there, so
   * that polynomials are continued; one farther away is projected to the
   * nearest point of the body's boundary.
   *
   * The mesh has to outlive this.
   */
  class PointLocator
  {
  public:
    explicit PointLocator(const TriangleMesh &mesh);

    /// Where a point of a body is, or the nearest point of the body.
    Location
    find(const Point<2> &p, const unsigned int body) const;

    /// Whether a point lies in one of the cells, on edges to within 1e-12 of a
    /// cell, and where.
    bool
    find_inside(const Point<2> &p, Location &location) const;

    /// The inverse of a cell's mapping. Returns whether there is a point.
    bool
    invert(const Point<2>    &p,
           const unsigned int cell,
           Point<2>          &reference_point) const;

    /// The boundary edge of a body that is nearest to a point, as an index of
    /// `TriangleMesh::boundary`, and its distance in m.
    std::pair<unsigned int, double>
    nearest_edge(const Point<2> &p, const unsigned int body) const;

  private:
    struct Box
    {
      Point<2> lower, upper;
    };

    Box
    box_of(const unsigned int cell) const;

    /// The bin of a coordinate, within the grid.
    unsigned int
    bin(const double coordinate, const unsigned int direction) const;

    /// The location in the cell that counts. Cells of other bodies are left
    /// out, unless `body` is invalid_unsigned_int. Returns whether there is
    /// one.
    bool
    find_best(const Point<2>    &p,
              const unsigned int body,
              Location          &location) const;

    const TriangleMesh &mesh;
    /// Of each cell, with the margin in which points are looked for.
    std::vector<Box>            boxes;
    Box                         grid;      ///< bounds all boxes
    std::array<unsigned int, 2> n_bins;    ///< of the grid
    Point<2>                    bin_width; ///< in m
    /// Cells whose boxes reach into a bin.
    std::vector<std::vector<unsigned int>> cells_in_bin;
  };
} // namespace Sandglass

#endif
