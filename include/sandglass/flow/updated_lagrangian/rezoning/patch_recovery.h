#ifndef sandglass_flow_updated_lagrangian_rezoning_patch_recovery_h
#define sandglass_flow_updated_lagrangian_rezoning_patch_recovery_h

#include <deal.II/base/quadrature.h>

#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <Eigen/Dense>

#include <array>
#include <functional>
#include <vector>

namespace Sandglass
{
  /**
   * A field that is known at quadrature points, at all places of a mesh.
   *
   * As in the superconvergent patch recovery (zienkiewicz1992), a
   * polynomial is fitted round each corner to the quadrature points of the
   * cells that meet there, by least squares. It is quadratic where there are
   * points enough, and near points count more. Inside of a cell its corners'
   * polynomials are blended by barycentric coordinates. Quadratic fields are
   * therefore kept to rounding, and smooth ones to third order: an L2
   * projection to linear elements would keep linear ones only, and couple all
   * cells.
   *
   * What the polynomials differ by from the field at a cell's own points is
   * added as a linear function, so that material that is meshed anew without
   * having moved keeps its stress, however often that is done.
   *
   * The values are then kept within the bounds of the field at the quadrature
   * points of the cell and of those that share a corner with it, widened by a
   * margin. The mesh has to outlive this.
   */
  class PatchRecovery
  {
  public:
    /**
     * @param field   at the quadrature points, cell by cell.
     * @param margin  by which values may pass their neighbours' bounds, over
     *                these bounds' distance. 0: never. But at the material's
     *                boundary the outermost of the new points may lie farther
     *                out than the old ones, and there a linear field, as a
     *                weight's pressure, is lost with each transfer unless
     *                there is some margin.
     */
    PatchRecovery(const TriangleMesh  &mesh,
                  const Quadrature<2> &quadrature,
                  const MeshField     &field,
                  const double         margin);

    /// All components at a location. Returns whether one had to be limited.
    bool
    evaluate(const Location &location, double *values) const;

    /// Means over the quadrature points of a cell, one for each component.
    std::vector<double>
    mean_in(const unsigned int cell) const;

  private:
    /// Round a corner of a body.
    struct Patch
    {
      Point<2>                  centre;
      double                    radius = 0.; ///< of the points, in m
      std::vector<unsigned int> cells;
      /// Coefficients by powers of (x - centre)/radius, a column a component.
      Eigen::MatrixXd coefficients;
    };

    void
    find_patches();
    /// The cells of a patch, with so many layers of neighbours that there are
    /// points enough.
    std::vector<unsigned int>
    enlarged(const Patch &patch) const;
    void
    fit(Patch &patch, const std::vector<Point<2>> &positions) const;
    void
    find_bounds();
    /// The polynomials of a cell's corners, blended.
    void
    blend(const unsigned int cell,
          const Point<2>    &reference_point,
          double            *values) const;
    /// At each quadrature point, the field less its polynomials.
    void
    find_differences(const Quadrature<2> &quadrature);

    const TriangleMesh &mesh;
    const MeshField     field;
    const unsigned int  n_points; ///< of a cell
    const double        margin;

    std::vector<Patch> patches;
    /// Of each cell's corners.
    std::vector<std::array<unsigned int, 3>> patch_at;
    MeshField                                lower, upper; ///< of each cell
    MeshField                                differences;
    /// Of a cell's three quadrature points: the shares that each has in linear
    /// functions, by 1, x and y of the reference point.
    Eigen::Matrix3d linear_shares;
  };
} // namespace Sandglass

#endif
