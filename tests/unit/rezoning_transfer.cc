// Fields on a new mesh.

#include <sandglass/flow/updated_lagrangian/rezoning/nodal_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/patch_recovery.h>

#include <gtest/gtest.h>

#include "rezoning_meshes.h"

using namespace RezoningTest;

namespace
{
  const std::vector<ScalarFunction> polynomials = {
    [](const Point<2> &) { return 3.; },
    [](const Point<2> &p) { return 1. + 2. * p[0] - 3. * p[1]; },
    [](const Point<2> &p) {
      return p[0] * p[0] - 2. * p[0] * p[1] + 3. * p[1] * p[1] - p[1];
    }};

  MeshField
  transfer_nodes(const TriangleMesh &old_mesh,
                 const TriangleMesh &new_mesh,
                 const MeshField    &field)
  {
    const PointLocator locator(old_mesh);
    return transfer_nodal_field(old_mesh,
                                field,
                                locate_nodes(locator, new_mesh));
  }

  /// The largest error of the functions at the new nodes.
  double
  nodal_error(const TriangleMesh                &old_mesh,
              const TriangleMesh                &new_mesh,
              const std::vector<ScalarFunction> &functions)
  {
    return largest_difference(
      transfer_nodes(old_mesh, new_mesh, values_at(old_mesh.nodes, functions)),
      values_at(new_mesh.nodes, functions));
  }

  TransferredPoints
  transfer_points(const TriangleMesh  &old_mesh,
                  const TriangleMesh  &new_mesh,
                  const Quadrature<2> &quadrature,
                  const MeshField     &field,
                  const double         margin,
                  const Admissible    &is_admissible = {})
  {
    const PointLocator  locator(old_mesh);
    const PatchRecovery recovery(old_mesh, quadrature, field, margin);
    return transfer_point_field(recovery,
                                field.n_components,
                                locate_points(locator, new_mesh, quadrature),
                                is_admissible);
  }

  double
  random_number(std::mt19937 &engine)
  {
    return engine() / 4294967296.;
  }
} // namespace



// Random points of random cells are found where they are, also in strongly
// curved cells.
TEST(RezoningTransfer, PointsAreFound)
{
  TriangleMesh mesh   = mesh_of({circle(Point<2>(), 1., 16), {}}, 0.2);
  auto         engine = random_engine();
  for (Point<2> &node : mesh.nodes)
    node += Point<2>(0.1 * node[1] * node[1], 0.2 * std::sin(3. * node[0]));
  const PointLocator locator(mesh);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const unsigned int cell = engine() % mesh.cells.size();
      double             x = random_number(engine), y = random_number(engine);
      if (x + y > 1.)
        {
          x = 1. - x;
          y = 1. - y;
        }
      const Point<2> p        = position_in_cell(mesh, cell, Point<2>(x, y));
      const Location location = locator.find(p, 0);
      EXPECT_GE(location.smallest_coordinate, -1e-12);
      EXPECT_EQ(location.distance, 0.);
      EXPECT_LT(p.distance(position_in_cell(mesh,
                                            location.cell,
                                            location.reference_point)),
                1e-14);
    }
}



TEST(RezoningTransfer, PointsOutsideAreProjected)
{
  const TriangleMesh mesh     = mesh_of(square(), 0.2);
  const Point<2>     p        = Point<2>(0.33, -0.5);
  const Location     location = PointLocator(mesh).find(p, 0);
  EXPECT_NEAR(location.distance, 0.5, 1e-14);
  EXPECT_LT(position_in_cell(mesh, location.cell, location.reference_point)
              .distance(Point<2>(0.33, 0.)),
            1e-12);
}



// Two bodies side by side: a point in one of them that is said to be the
// other's is looked for there.
TEST(RezoningTransfer, BodiesAreKeptApart)
{
  const auto mesh =
    mesh_outlines({square(), square(Point<2>(1., 0.))}, {0.2}, 2).mesh;
  const PointLocator locator(mesh);
  for (const unsigned int body : {0, 1})
    for (const double x : {0.7, 1., 1.4})
      EXPECT_EQ(mesh.bodies[locator.find(Point<2>(x, 0.5), body).cell], body);
}



TEST(RezoningTransfer, NodalPolynomialsAreKept)
{
  for (const unsigned int order : {1, 2})
    {
      const auto  old_mesh = mesh_of(square(), 0.11, order);
      const auto  new_mesh = mesh_of(square(), 0.07, order);
      std::vector functions(polynomials.begin(),
                            polynomials.begin() + 1 + order);
      EXPECT_LT(nodal_error(old_mesh, new_mesh, functions), 1e-13);
    }
}



// On curved cells, quadratic functions are not polynomials of the reference
// coordinates; linear ones are.
TEST(RezoningTransfer, LinearFieldsAreKeptInADisc)
{
  const BodyOutline disc{circle(Point<2>(), 1., 24), {}};
  const auto        old_mesh = mesh_of(disc, 0.2);
  const auto        new_mesh =
    mesh_outlines(find_outlines(old_mesh, CornerRule()), {0.13}, 2).mesh;
  const std::vector functions(polynomials.begin(), polynomials.begin() + 2);
  EXPECT_LT(nodal_error(old_mesh, new_mesh, functions), 1e-12);
}



// With a margin no polynomial is limited here; without one a linear field is,
// at the boundary only, and a constant one never.
TEST(RezoningTransfer, PointPolynomialsAreKept)
{
  for (const unsigned int n : {1, 2, 3})
    {
      const QGaussSimplex<2> quadrature(n);
      const auto             old_mesh = mesh_of(square(), 0.11);
      const auto             new_mesh = mesh_of(square(), 0.07);
      const auto      old_points = quadrature_positions(old_mesh, quadrature);
      const auto      new_points = quadrature_positions(new_mesh, quadrature);
      const MeshField exact      = values_at(new_points, polynomials);
      const MeshField field      = values_at(old_points, polynomials);

      const auto free =
        transfer_points(old_mesh, new_mesh, quadrature, field, 1e3);
      EXPECT_EQ(free.n_limited, 0);
      EXPECT_LT(largest_difference(free.field, exact), 1e-11);

      const std::vector linear(polynomials.begin(), polynomials.begin() + 2);
      const auto        with_margin = transfer_points(
        old_mesh, new_mesh, quadrature, values_at(old_points, linear), 0.25);
      EXPECT_EQ(with_margin.n_limited, 0);
      EXPECT_LT(largest_difference(with_margin.field,
                                   values_at(new_points, linear)),
                1e-11);

      const auto strict =
        transfer_points(old_mesh, new_mesh, quadrature, field, 0.);
      EXPECT_GT(strict.n_limited, 0);
      for (unsigned int i = 0; i < new_points.size(); ++i)
        {
          const auto  &p     = new_points[i];
          const double depth = std::min({p[0], p[1], 1. - p[0], 1. - p[1]});
          EXPECT_NEAR(strict.field.at(i)[0], 3., 1e-11);
          if (depth > 0.11)
            {
              EXPECT_NEAR(strict.field.at(i)[1], exact.at(i)[1], 1e-11);
            }
        }
    }
}



// A jump makes no values beyond it without a margin, and with one at most the
// margin's share of it.
TEST(RezoningTransfer, JumpsAreNotOvershot)
{
  const QGaussSimplex<2>            quadrature(2);
  const auto                        old_mesh = mesh_of(square(), 0.1);
  const auto                        new_mesh = mesh_of(square(), 0.08);
  const std::vector<ScalarFunction> jump     = {
        [](const Point<2> &p) { return p[0] + p[1] / 2. > 0.7 ? 5. : 2.; }};
  const auto field =
    values_at(quadrature_positions(old_mesh, quadrature), jump);
  for (const double margin : {0., 0.1})
    {
      const auto result =
        transfer_points(old_mesh, new_mesh, quadrature, field, margin);
      EXPECT_GT(result.n_limited, 0);
      for (const double value : result.field.values)
        {
          EXPECT_GE(value, 2. - 3. * margin);
          EXPECT_LE(value, 5. + 3. * margin);
        }
    }
}



// Two components whose sum must not be positive, as of a pressure: the field
// comes near to that at random points.
TEST(RezoningTransfer, ValuesAreAdmissible)
{
  const QGaussSimplex<2> quadrature(2);
  const auto             old_mesh = mesh_of(square(), 0.1);
  const auto             new_mesh = mesh_of(square(), 0.08);
  auto                   engine   = random_engine();
  MeshField              field =
    MeshField::zero(2, old_mesh.cells.size() * quadrature.size());
  for (unsigned int i = 0; i < field.values.size() / 2; ++i)
    {
      const double sum   = -std::pow(random_number(engine), 4);
      const double other = random_number(engine) - 0.5;
      field.at(i)[0]     = sum / 2. + other;
      field.at(i)[1]     = sum / 2. - other;
    }
  const Admissible is_admissible = [](const double *values) {
    return values[0] + values[1] <= 0.;
  };
  const auto count = [&](const TransferredPoints &result) {
    unsigned int n = 0;
    for (unsigned int i = 0; i < result.field.values.size() / 2; ++i)
      n += !is_admissible(result.field.at(i));
    return n;
  };
  EXPECT_GT(count(transfer_points(old_mesh, new_mesh, quadrature, field, 0.25)),
            0);
  EXPECT_EQ(count(transfer_points(
              old_mesh, new_mesh, quadrature, field, 0.25, is_admissible)),
            0);
}



// There and back: errors fall with the third power of the elements' size, of
// nodes as of points, in the mean.
TEST(RezoningTransfer, ThereAndBackConverges)
{
  const QGaussSimplex<2>            quadrature(2);
  const std::vector<ScalarFunction> waves = {[](const Point<2> &p) {
    return std::sin(4. * p[0]) * std::cos(3. * p[1] + 0.3);
  }};
  std::vector<double>               nodal_errors, point_errors;
  for (const double size : {0.1, 0.05, 0.025})
    {
      const auto      first  = mesh_of(square(), size);
      const auto      second = mesh_of(square(), size / 1.1);
      const MeshField nodes  = values_at(first.nodes, waves);
      const MeshField points =
        values_at(quadrature_positions(first, quadrature), waves);
      nodal_errors.push_back(mean_difference(
        nodes,
        transfer_nodes(second, first, transfer_nodes(first, second, nodes))));
      const auto there =
        transfer_points(first, second, quadrature, points, 0.25).field;
      point_errors.push_back(mean_difference(
        points, transfer_points(second, first, quadrature, there, 0.25).field));
    }
  for (const auto &errors : {nodal_errors, point_errors})
    for (unsigned int i = 1; i < errors.size(); ++i)
      {
        const double order = std::log2(errors[i - 1] / errors[i]);
        std::cout << "error " << errors[i] << ", order " << order << std::endl;
        EXPECT_NEAR(order, 3., 0.4);
      }
}
