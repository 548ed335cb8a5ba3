#include <sandglass/continuum/formulation.h>
#include <sandglass/output/section_corner_shares.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  /// Traction of a wall on the material at a point, in Pa.
  using Traction = std::function<Tensor<1, 2>(const Point<2> &)>;

  /// Straight walls, each divided into edges of a mesh that has nothing else,
  /// with the records of given tractions.
  struct Walls
  {
    Formulation                   formulation = Formulation::plane_strain;
    Mesh<2>                       mesh;
    std::vector<Wall<2>>          walls;
    std::vector<WallRecord>       records;
    std::vector<Tensor<1, 3>>     forces;
    std::vector<Tensor<1, 3>>     expected;
    std::map<std::string, WallId> wall_named;

    unsigned int
    add_vertex(const Point<2> &point)
    {
      for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.vertices[v].distance(point) < 1e-9)
          return v;
      mesh.vertices.push_back(point);
      return mesh.vertices.size() - 1;
    }

    /// A wall of this name, or one more part of it, with the material on its
    /// left as seen from `start` to `end`.
    void
    add(const std::string &name,
        const Point<2>    &start,
        const Point<2>    &end,
        const unsigned int n_edges,
        const Traction    &traction)
    {
      const auto [wall, is_new] = wall_named.insert({name, walls.size()});
      if (is_new)
        {
          walls.push_back({name,
                           BoundaryRole::hopper,
                           static_cast<types::boundary_id>(
                             first_named_boundary + walls.size())});
          mesh.named_walls.push_back(name);
        }
      const Tensor<1, 2> along = (end - start) / start.distance(end);
      const Tensor<1, 3> normal({along[1], -along[0], 0.});
      for (unsigned int i = 0; i <= n_edges; ++i)
        {
          const auto at = [&](const double j) -> Point<2> {
            return start + j / n_edges * (end - start);
          };
          const Point<2>     point  = at(i);
          const unsigned int vertex = add_vertex(point);
          double             area   = 0.;
          for (const int side : {-1, 1})
            if (i + side <= n_edges)
              area += area_of(point, at(double(i) + side));
          const Tensor<1, 2> t = traction(point);
          records.push_back({wall->second,
                             vertex,
                             Point<3>(point[0], point[1], 0.),
                             normal,
                             area,
                             {}});
          expected.push_back(area * Tensor<1, 3>({t[0], t[1], 0.}));
          if (i < n_edges)
            mesh.faces.push_back({{{vertex, add_vertex(at(i + 1.))}},
                                  BoundaryRole::hopper,
                                  wall->second});
        }
      forces = expected;
    }

    /// Of the edge between both, what belongs to the first.
    double
    area_of(const Point<2> &point, const Point<2> &other) const
    {
      const double length = point.distance(other);
      return formulation == Formulation::plane_strain ?
               length / 2. :
               length * numbers::PI * (2. * point[0] + other[0]) / 3.;
    }

    std::vector<unsigned int>
    records_at(const Point<2> &point) const
    {
      std::vector<unsigned int> found;
      for (unsigned int i = 0; i < records.size(); ++i)
        if (records[i].position.distance(Point<3>(point[0], point[1], 0.)) <
            1e-9)
          found.push_back(i);
      return found;
    }

    /// Record all force at a point with the last of the walls there.
    void
    give_all_to_last(const Point<2> &point)
    {
      const auto   here = records_at(point);
      Tensor<1, 3> sum;
      for (const unsigned int i : here)
        {
          sum += forces[i];
          forces[i] = Tensor<1, 3>();
        }
      forces[here.back()] = sum;
    }

    std::vector<Tensor<1, 3>>
    shared() const
    {
      return CornerShares(mesh, walls, records).share(forces);
    }

    /// Relative to the largest expected force.
    double
    largest_error() const
    {
      const auto found = shared();
      double     error = 0., scale = 0.;
      for (unsigned int i = 0; i < found.size(); ++i)
        {
          error = std::max(error, (found[i] - expected[i]).norm());
          scale = std::max(scale, expected[i].norm());
        }
      return error / scale;
    }
  };



  Tensor<1, 3>
  sum(const std::vector<Tensor<1, 3>> &forces)
  {
    Tensor<1, 3> result;
    for (const auto &force : forces)
      result += force;
    return result;
  }



  /// Pressure p + slope s and friction mu times it, on a wall with this outward
  /// normal; friction acts counterclockwise from there.
  Traction
  linear(const Point<2>     &start,
         const Tensor<1, 2> &normal,
         const double        p,
         const double        slope,
         const double        mu)
  {
    return [=](const Point<2> &point) {
      const double pressure = p + slope * point.distance(start);
      return -pressure * normal +
             mu * pressure * Tensor<1, 2>({-normal[1], normal[0]});
    };
  }



  Tensor<1, 2>
  outward(const Point<2> &start, const Point<2> &end)
  {
    const Tensor<1, 2> along = (end - start) / start.distance(end);
    return Tensor<1, 2>({along[1], -along[0]});
  }



  /// A hopper, and a wall that goes on from its end: a kink to either side or
  /// none at all. Tractions jump there.
  class Kink : public testing::TestWithParam<std::tuple<Formulation, Point<2>>>
  {
  protected:
    Kink()
    {
      walls.formulation  = std::get<0>(GetParam());
      const Point<2> end = std::get<1>(GetParam());
      walls.add("hopper",
                lip,
                kink,
                8,
                linear(lip, outward(lip, kink), 12e3, 5e3, 0.3));
      walls.add(
        "wall", kink, end, 7, linear(kink, outward(kink, end), 7e3, -3e3, 0.4));
    }

    const Point<2> lip{0.2, 0.}, kink{0.8, 1.};
    Walls          walls;
  };
} // namespace



TEST_P(Kink, each_wall_has_its_own)
{
  walls.give_all_to_last(kink);
  EXPECT_NEAR(walls.largest_error(), 0., 1e-12);
}



// A corner that slides along the hopper takes over what the wall's next nodes
// bore.
TEST_P(Kink, unloaded_nodes_get_their_load_back)
{
  walls.give_all_to_last(kink);
  const unsigned int corner = walls.records_at(kink).front();
  const unsigned int next   = walls.records_at(kink).back() + 1;
  for (const auto &[node, share] :
       {std::make_pair(next, 0.6), std::make_pair(next + 1, 0.1)})
    {
      walls.forces[corner] += share * walls.forces[node];
      walls.forces[node] *= 1. - share;
    }
  EXPECT_NEAR(walls.largest_error(), 0., 1e-12);
}



TEST_P(Kink, total_is_kept_whatever_the_forces)
{
  auto                                   random = random_engine(1);
  std::uniform_real_distribution<double> scatter(-1., 1.);
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      for (auto &force : walls.forces)
        for (unsigned int d = 0; d < 2; ++d)
          force[d] = 1e3 * scatter(random);
      EXPECT_NEAR((sum(walls.shared()) - sum(walls.forces)).norm(), 0., 1e-8);
    }
}



TEST_P(Kink, where_nothing_presses_there_is_no_traction)
{
  for (const unsigned int i : walls.records_at(kink))
    walls.forces[i] = Tensor<1, 3>();
  const auto found = walls.shared();
  for (const unsigned int i : walls.records_at(kink))
    EXPECT_EQ(found[i].norm(), 0.);
}



TEST_P(Kink, free_ends_keep_what_they_have)
{
  auto                                   random = random_engine(2);
  std::uniform_real_distribution<double> scatter(0.5, 1.5);
  for (auto &force : walls.forces)
    force *= scatter(random);
  const auto found = walls.shared();
  for (const Point<2> &end : {lip, std::get<1>(GetParam())})
    for (const unsigned int i : walls.records_at(end))
      EXPECT_EQ((found[i] - walls.forces[i]).norm(), 0.);
}



INSTANTIATE_TEST_SUITE_P(
  Either,
  Kink,
  testing::Combine(testing::Values(Formulation::plane_strain,
                                   Formulation::axisymmetric),
                   testing::Values(Point<2>(0.8, 2.),    // convex
                                   Point<2>(1.8, 1.5),   // concave
                                   Point<2>(0.3, 1.8),   // a sharp corner
                                   Point<2>(1.4, 2.)))); // in the same plane



// Round walls have a corner at each node, and no other nodes.
TEST(CornerShares, round_wall_under_pressure)
{
  Walls                  walls;
  constexpr unsigned int n  = 12;
  const auto             at = [](const unsigned int i) {
    const double angle = -2. * numbers::PI * i / n; // material outside
    return Point<2>(std::cos(angle), std::sin(angle));
  };
  for (unsigned int i = 0; i < n; ++i)
    walls.add("insert",
              at(i),
              at((i + 1) % n),
              1,
              linear(at(i), outward(at(i), at((i + 1) % n)), 5e3, 0., 0.2));
  for (unsigned int i = 0; i < n; ++i)
    walls.give_all_to_last(at(i));
  EXPECT_NEAR(walls.largest_error(), 0., 1e-12);
}



namespace
{
  /// The roof of an insert whose tip is on the axis.
  struct RoofOnAxis : Walls
  {
    RoofOnAxis()
    {
      const Point<2> tip(0., 0.8), foot(0.2, 0.45);
      normal = outward(tip, foot);
      add("roof", tip, foot, 6, linear(tip, normal, 9e3, -2e3, 0.3));
      mesh.faces.push_back({{{add_vertex(tip), add_vertex(Point<2>(0., 1.))}},
                            BoundaryRole::axis});
      at_tip = records_at(tip).at(0);
    }

    Tensor<1, 2> normal; ///< out of the material
    unsigned int at_tip; ///< record
  };
} // namespace



// The other half of a symmetric insert pushes back through the axis, across
// which a wall's record has nothing.
TEST(CornerShares, tip_of_an_insert_on_the_axis)
{
  for (const double normal_on_axis : {0., 1.})
    {
      RoofOnAxis         walls;
      const unsigned int at_tip = walls.at_tip;
      walls.forces[at_tip][0]   = 0.;
      if (normal_on_axis > 0.) // as at rest, where it acts along the axis only
        walls.records[at_tip].normal = Tensor<1, 3>({0., -1., 0.});
      EXPECT_NEAR(walls.largest_error(), 0., 1e-12);
      EXPECT_NEAR(
        (CornerShares(walls.mesh, walls.walls, walls.records).normal(at_tip) -
         walls.normal)
          .norm(),
        0.,
        1e-12);
    }
}



// There only one component of the force is known: friction stays in proportion.
TEST(CornerShares, friction_at_the_tip_of_an_insert)
{
  RoofOnAxis    walls;
  Tensor<1, 3> &at_tip      = walls.forces[walls.at_tip];
  at_tip                    = Tensor<1, 3>({0., 2. * at_tip[1], 0.});
  const auto         found  = walls.shared();
  const Tensor<1, 2> normal = walls.normal;
  for (const auto &force : found)
    {
      const Tensor<1, 2> in_plane({force[0], force[1]});
      const double       pressure = -(in_plane * normal);
      EXPECT_NEAR((in_plane + pressure * normal).norm() / pressure, 0.3, 1e-12);
    }
  EXPECT_NEAR(sum(found)[1], sum(walls.forces)[1], 1e-9);
}



// A wall below the outlet has no record at the lip, where another wall's ends.
TEST(CornerShares, edges_that_hold_no_material)
{
  Walls          walls;
  const Point<2> lip(0.2, 0.), top(0.8, 1.);
  walls.add("hopper", lip, top, 5, linear(lip, outward(lip, top), 1e4, 0., 0.));
  walls.mesh.faces.push_back(
    {{{walls.add_vertex(lip), walls.add_vertex(Point<2>(0.2, -1.))}},
     BoundaryRole::hopper,
     0});
  EXPECT_NEAR(walls.largest_error(), 0., 1e-12);
}
