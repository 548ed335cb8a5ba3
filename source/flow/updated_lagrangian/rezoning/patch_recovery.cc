#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/patch_recovery.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int n_quadratic_terms = 6;

    /// Enough for a quadratic polynomial that also averages.
    constexpr unsigned int wanted_points = 2 * n_quadratic_terms;

    /// Powers of a polynomial's variables: constant, linear, quadratic.
    Eigen::Matrix<double, 1, n_quadratic_terms>
    powers(const Tensor<1, 2> &x)
    {
      Eigen::Matrix<double, 1, n_quadratic_terms> result;
      result << 1., x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1];
      return result;
    }

    /// Terms that so many points determine with some to spare.
    unsigned int
    n_terms(const unsigned int n_points)
    {
      return n_points > 8 ? n_quadratic_terms : n_points > 3 ? 3 : 1;
    }
  } // namespace



  PatchRecovery::PatchRecovery(const TriangleMesh  &mesh,
                               const Quadrature<2> &quadrature,
                               const MeshField     &field,
                               const double         margin)
    : mesh(mesh)
    , field(field)
    , n_points(quadrature.size())
    , margin(margin)
  {
    AssertDimension(field.values.size(),
                    field.n_components * n_points * mesh.cells.size());
    find_patches();
    const auto positions = quadrature_positions(mesh, quadrature);
    for (Patch &patch : patches)
      fit(patch, positions);
    find_bounds();
    find_differences(quadrature);
  }



  void
  PatchRecovery::find_patches()
  {
    // Bodies may touch in a corner.
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> index_of;
    patch_at.resize(mesh.cells.size());
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int v = 0; v < 3; ++v)
        {
          const unsigned int corner = mesh.cells[cell][v];
          const auto [known, is_new] =
            index_of.emplace(std::make_pair(corner, mesh.bodies[cell]),
                             patches.size());
          if (is_new)
            {
              patches.emplace_back();
              patches.back().centre = mesh.nodes[corner];
            }
          patch_at[cell][v] = known->second;
          patches[known->second].cells.push_back(cell);
        }
  }



  std::vector<unsigned int>
  PatchRecovery::enlarged(const Patch &patch) const
  {
    std::set<unsigned int> cells(patch.cells.begin(), patch.cells.end());
    for (std::size_t n_before = 0;
         cells.size() * n_points < wanted_points && cells.size() > n_before;)
      {
        n_before                           = cells.size();
        const std::set<unsigned int> inner = cells;
        for (const unsigned int cell : inner)
          for (const unsigned int neighbour : patch_at[cell])
            cells.insert(patches[neighbour].cells.begin(),
                         patches[neighbour].cells.end());
      }
    return {cells.begin(), cells.end()};
  }



  void
  PatchRecovery::fit(Patch &patch, const std::vector<Point<2>> &positions) const
  {
    std::vector<unsigned int> points;
    for (const unsigned int cell : enlarged(patch))
      for (unsigned int q = 0; q < n_points; ++q)
        points.push_back(cell * n_points + q);
    for (const unsigned int point : points)
      patch.radius =
        std::max(patch.radius, patch.centre.distance(positions[point]));

    const unsigned int terms = n_terms(points.size());
    Eigen::MatrixXd    matrix(points.size(), terms);
    Eigen::MatrixXd    right_side(points.size(), field.n_components);
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const Tensor<1, 2> x =
          (positions[points[i]] - patch.centre) / patch.radius;
        const double weight = std::exp(-2. * x.norm_square());
        matrix.row(i)       = weight * powers(x).head(terms);
        for (unsigned int c = 0; c < field.n_components; ++c)
          right_side(i, c) = weight * field.at(points[i])[c];
      }
    patch.coefficients =
      Eigen::MatrixXd::Zero(n_quadratic_terms, field.n_components);
    // The rank may be lower where points lie on a line.
    patch.coefficients.topRows(terms) =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(matrix).solve(
        right_side);
  }



  void
  PatchRecovery::find_bounds()
  {
    lower = upper = MeshField::zero(field.n_components, mesh.cells.size());
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int c = 0; c < field.n_components; ++c)
        {
          double low = field.at(cell * n_points)[c], high = low;
          for (const unsigned int patch : patch_at[cell])
            for (const unsigned int neighbour : patches[patch].cells)
              for (unsigned int q = 0; q < n_points; ++q)
                {
                  const double value = field.at(neighbour * n_points + q)[c];
                  low                = std::min(low, value);
                  high               = std::max(high, value);
                }
          lower.at(cell)[c] = low - margin * (high - low);
          upper.at(cell)[c] = high + margin * (high - low);
        }
  }



  void
  PatchRecovery::find_differences(const Quadrature<2> &quadrature)
  {
    differences = field;
    std::vector<double> values(field.n_components);
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int q = 0; q < n_points; ++q)
        {
          blend(cell, quadrature.point(q), values.data());
          for (unsigned int c = 0; c < field.n_components; ++c)
            differences.at(cell * n_points + q)[c] -= values[c];
        }
    if (n_points == 3)
      {
        Eigen::Matrix3d at_points;
        for (unsigned int q = 0; q < 3; ++q)
          at_points.row(q) << 1., quadrature.point(q)[0],
            quadrature.point(q)[1];
        linear_shares = at_points.inverse();
      }
  }



  void
  PatchRecovery::blend(const unsigned int cell,
                       const Point<2>    &r,
                       double            *values) const
  {
    const Point<2> position = position_in_cell(mesh, cell, r);
    const auto     shares   = shape_values(1, r); // barycentric coordinates

    std::fill_n(values, field.n_components, 0.);
    for (unsigned int v = 0; v < 3; ++v)
      {
        const Patch &patch = patches[patch_at[cell][v]];
        const auto   terms = powers((position - patch.centre) / patch.radius);
        for (unsigned int c = 0; c < field.n_components; ++c)
          values[c] += shares[v] * terms.dot(patch.coefficients.col(c));
      }
  }



  bool
  PatchRecovery::evaluate(const Location &location, double *values) const
  {
    const unsigned int cell = location.cell;
    const Point<2>    &r    = location.reference_point;
    blend(cell, r, values);
    Eigen::RowVector3d shares = Eigen::RowVector3d::Ones();
    if (n_points == 3)
      shares = Eigen::RowVector3d(1., r[0], r[1]) * linear_shares;
    for (unsigned int q = 0; q < n_points && (n_points == 1 || n_points == 3);
         ++q)
      for (unsigned int c = 0; c < field.n_components; ++c)
        values[c] += shares[q] * differences.at(cell * n_points + q)[c];

    bool is_limited = false;
    for (unsigned int c = 0; c < field.n_components; ++c)
      {
        // Rounding of a constant field is no reason to count.
        const double low = lower.at(cell)[c], high = upper.at(cell)[c];
        const double rounding = 1e-12 * std::max(std::abs(low), std::abs(high));
        is_limited            = is_limited || values[c] < low - rounding ||
                     values[c] > high + rounding;
        values[c] = std::min(std::max(values[c], low), high);
      }
    return is_limited;
  }



  std::vector<double>
  PatchRecovery::mean_in(const unsigned int cell) const
  {
    std::vector<double> mean(field.n_components, 0.);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int c = 0; c < field.n_components; ++c)
        mean[c] += field.at(cell * n_points + q)[c] / n_points;
    return mean;
  }
} // namespace Sandglass
