#include <sandglass/flow/in_space.h>
#include <sandglass/output/reference_pressures.h>
#include <sandglass/scene/make_walls.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  /// A section of squares, with an outline along their edges and of their
  /// size, that the cells may then be moved to.
  class Section
  {
  public:
    ClearedParameters  cleared;
    WallParameters     walls;
    MaterialParameters material;
    OutputParameters   output;
    Formulation        formulation = Formulation::plane_strain;
    Tensor<1, 2>       gravity{{0., -9.81}};

    /// In squares.
    int width = 4, height = 12;
    /// Whether material fills a square, of its indices.
    std::function<bool(int, int)> is_filled = [](int, int) { return true; };
    /// The boundary's name at the middle of an edge, on the squares.
    std::function<std::string(const Point<2> &)> name =
      [this](const Point<2> &middle) { return usual_name(middle); };
    /// Where a vertex goes.
    std::function<Point<2>(const Point<2> &)> moved =
      [](const Point<2> &point) { return point; };

    /// Flat bottom with a closed outlet two squares wide, axis at the left.
    std::string
    usual_name(const Point<2> &middle) const
    {
      return middle[0] == 0.     ? "axis" :
             middle[1] == height ? "top" :
             middle[0] == width  ? "wall" :
             middle[1] > 0.      ? "insert" :
             middle[0] < 2.      ? "outlet" :
                                   "floor";
    }

    const Scene<2> &
    scene()
    {
      if (!made)
        made = std::make_unique<Scene<2>>(
          mesh(), walls, formulation, 4, gravity, MPI_COMM_SELF);
      return *made;
    }

    /// What the formulas say where a wall with this outward normal has a point.
    double
    janssen(const Point<2> &point, const Tensor<1, 2> &normal)
    {
      return pressures().janssen_normal(record(point, normal));
    }

    WallPressure
    eurocode(
      const Point<2>               &point,
      const Tensor<1, 2>           &normal,
      const EurocodePressures::Load load = EurocodePressures::Load::filling)
    {
      return pressures().eurocode(load, record(point, normal));
    }

    bool
    says_nothing(const Point<2> &point, const Tensor<1, 2> &normal)
    {
      return std::isnan(janssen(point, normal)) &&
             std::isnan(eurocode(point, normal).normal);
    }

  private:
    ReferencePressures<2>
    pressures()
    {
      return {output, scene(), material};
    }

    static WallRecord
    record(const Point<2> &point, const Tensor<1, 2> &normal)
    {
      return {0, 0, in_space(point), in_space(normal / normal.norm()), 1., {}};
    }

    Mesh<2>
    mesh() const
    {
      Mesh<2> result;
      result.cell_type    = CellType::quadrilateral;
      const auto has_cell = [this](const int i, const int j) {
        return i >= 0 && i < width && j >= 0 && j < height && is_filled(i, j);
      };
      std::map<std::pair<int, int>, std::size_t> vertex_at;
      const auto vertex = [&](const int i, const int j) {
        const auto [entry, is_new] =
          vertex_at.insert({{i, j}, result.vertices.size()});
        if (is_new)
          result.vertices.push_back(moved(Point<2>(i, j)));
        return static_cast<unsigned int>(entry->second);
      };
      const auto add_edge =
        [&](const int i, const int j, const int k, const int l) {
          const Point<2>    middle((i + k) / 2., (j + l) / 2.);
          const std::string name = this->name(middle);
          Mesh<2>::Face     edge{{{vertex(i, j), vertex(k, l)}},
                             BoundaryRole::insert};
          for (unsigned int r = 1; r <= boundary_role_names.size(); ++r)
            if (name == boundary_role_names[r - 1])
              edge.role = static_cast<BoundaryRole>(r);
          if (edge.role == BoundaryRole::insert)
            {
              auto &names = result.named_walls;
              edge.named_wall =
                std::find(names.begin(), names.end(), name) - names.begin();
              if (edge.named_wall == names.size())
                names.push_back(name);
            }
          result.faces.push_back(edge);
        };
      for (int i = 0; i < width; ++i)
        for (int j = 0; j < height; ++j)
          {
            if (!has_cell(i, j))
              continue;
            result.cells.push_back({{{vertex(i, j),
                                      vertex(i + 1, j),
                                      vertex(i + 1, j + 1),
                                      vertex(i, j + 1)}},
                                    true});
            if (!has_cell(i - 1, j))
              add_edge(i, j, i, j + 1);
            if (!has_cell(i + 1, j))
              add_edge(i + 1, j, i + 1, j + 1);
            if (!has_cell(i, j - 1))
              add_edge(i, j, i + 1, j);
            if (!has_cell(i, j + 1))
              add_edge(i, j + 1, i + 1, j + 1);
          }
      settle_named_walls(result);
      return result;
    }

    std::unique_ptr<Scene<2>> made;
  };

  const Tensor<1, 2> right({1., 0.}), left({-1., 0.}), down({0., -1.});
} // namespace



TEST(ReferencePressures, slender_silo)
{
  Section silo;
  EXPECT_GT(silo.janssen({4., 5.}, right), 0.);
  EXPECT_GT(silo.janssen({3., 0.}, down), silo.janssen({4., 0.}, right));
  EXPECT_GT(silo.eurocode({4., 5.}, right).normal, 0.);
  EXPECT_TRUE(std::isnan(silo.eurocode({3., 0.}, down).normal));
}



// The material on a wall rougher than itself slips in itself.
TEST(ReferencePressures, rough_walls)
{
  const auto at = [](const double wall_angle) {
    Section silo;
    silo.material.internal_friction_angle = 25.;
    silo.walls.friction_angle             = wall_angle;
    return std::make_tuple(silo.janssen({4., 5.}, right),
                           silo.eurocode({4., 5.}, right).normal,
                           silo.eurocode({4., 5.}, right).tangential);
  };
  EXPECT_LT(std::get<0>(at(25.)), std::get<0>(at(20.)));
  EXPECT_EQ(at(80.), at(25.));
}



TEST(ReferencePressures, rough_hopper)
{
  const auto at = [](const double hopper_angle) {
    Section silo;
    silo.material.internal_friction_angle = 25.;
    silo.walls.friction_angle             = 15.;
    silo.walls.hopper_friction_angle      = hopper_angle;
    // From x = 4 at y = 3 to x = 3 at y = 0.
    silo.moved = [](const Point<2> &point) {
      return Point<2>(point[0] * std::min(1., 0.75 + point[1] / 12.), point[1]);
    };
    silo.name = [&silo](const Point<2> &middle) -> std::string {
      return middle[0] == 4. && middle[1] < 3. ? "hopper" :
             middle[1] == 0. && middle[0] > 0. ? "outlet" :
                                                 silo.usual_name(middle);
    };
    return silo.eurocode({3.5, 1.5}, Tensor<1, 2>({3., -1.})).normal;
  };
  EXPECT_GT(at(20.), 0.);
  EXPECT_EQ(at(25.), at(40.));
}



TEST(ReferencePressures, nothing_where_gravity_does_not_point_down)
{
  for (const Tensor<1, 2> &gravity : {Tensor<1, 2>({0., 9.81}),
                                      Tensor<1, 2>({1., -9.7}),
                                      Tensor<1, 2>({9.81, 0.}),
                                      Tensor<1, 2>({0., 0.})})
    {
      Section silo;
      silo.gravity = gravity;
      EXPECT_TRUE(silo.says_nothing({4., 5.}, right));
      EXPECT_TRUE(silo.says_nothing({3., 0.}, down));
    }
}



TEST(ReferencePressures, inclined_walls_are_hoppers_or_nothing)
{
  // All of the wall, or its lower half.
  for (const double height : {12., 6.})
    {
      Section silo;
      silo.moved = [height](const Point<2> &point) {
        return Point<2>(point[0] *
                          (1. - 0.02 * std::max(0., height - point[1])),
                        point[1]);
      };
      const double       x = 4. * (1. - 0.02 * (height - 3.));
      const Tensor<1, 2> outwards({1., -0.08});
      EXPECT_TRUE(std::isnan(silo.janssen({x, 3.}, outwards)));
      // Below a vertical part the standard takes it for a steep hopper.
      EXPECT_EQ(std::isnan(silo.eurocode({x, 3.}, outwards).normal),
                height > 6.);
      EXPECT_TRUE(silo.says_nothing({3., 0.}, down));
      EXPECT_EQ(std::isnan(silo.janssen({4., 9.}, right)), height > 6.);
    }
}



TEST(ReferencePressures, walls_that_are_vertical_to_rounding)
{
  Section exact, rounded;
  rounded.moved = [](const Point<2> &point) {
    return Point<2>(point[0] + 2e-4 * std::sin(20. * point[1]), point[1]);
  };
  const Point<2> point(4.0001, 5.);
  EXPECT_NEAR(rounded.janssen(point, Tensor<1, 2>({1., 1e-4})),
              exact.janssen({4., 5.}, right),
              1e-3 * exact.janssen({4., 5.}, right));
  EXPECT_NEAR(rounded.eurocode(point, right).normal,
              exact.eurocode({4., 5.}, right).normal,
              1e-3 * exact.eurocode({4., 5.}, right).normal);
}



TEST(ReferencePressures, axis_elsewhere_and_material_on_either_side)
{
  Section usual;
  for (const double sign : {1., -1.})
    {
      Section silo;
      silo.moved = [sign](const Point<2> &point) {
        return Point<2>(30. + sign * point[0], point[1]);
      };
      EXPECT_EQ(silo.janssen({30. + 4. * sign, 5.}, sign * right),
                usual.janssen({4., 5.}, right));
      EXPECT_EQ(silo
                  .eurocode({30. + 4. * sign, 5.},
                            sign * right,
                            EurocodePressures::Load::discharge)
                  .normal,
                usual
                  .eurocode({4., 5.}, right, EurocodePressures::Load::discharge)
                  .normal);
    }
}



TEST(ReferencePressures, nothing_where_the_width_changes)
{
  // Narrower above y = 6 on the right.
  Section silo;
  silo.is_filled = [](const int i, const int j) { return i < 3 || j < 6; };
  silo.name      = [&silo](const Point<2> &middle) -> std::string {
    return middle[0] == 3. || (middle[1] == 6. && middle[0] > 3.) ?
                  "wall" :
                  silo.usual_name(middle);
  };
  EXPECT_GT(silo.janssen({3., 9.}, right), 0.);
  EXPECT_TRUE(silo.says_nothing({4., 3.}, right));
  EXPECT_TRUE(silo.says_nothing({3., 0.}, down));

  Section narrow;
  narrow.width = 3;
  EXPECT_EQ(silo.janssen({3., 9.}, right), narrow.janssen({3., 9.}, right));
  // The standard's silo has one width.
  EXPECT_TRUE(std::isnan(silo.eurocode({3., 9.}, right).normal));
}



// Janssen's slices go from wall to wall.
TEST(ReferencePressures, nothing_beside_an_insert)
{
  for (const int column : {0, 1})
    {
      Section silo;
      silo.is_filled = [column](const int i, const int j) {
        return i != column || j < 4 || j > 5;
      };
      silo.name = [&silo](const Point<2> &middle) -> std::string {
        // Where the insert is on the axis, this is not.
        return middle[0] < 2. && middle[0] > 0. && middle[1] > 0. &&
                   middle[1] < 12. ?
                 "insert" :
                 silo.usual_name(middle);
      };
      silo.walls.friction_angles["insert"] = {20.};
      EXPECT_GT(silo.janssen({4., 9.}, right), 0.);
      EXPECT_TRUE(silo.says_nothing({4., 5.}, right));
      EXPECT_TRUE(silo.says_nothing({4., 2.}, right));
      EXPECT_TRUE(silo.says_nothing({column + 1., 5.}, left));
      EXPECT_TRUE(silo.says_nothing({3., 0.}, down));
      EXPECT_TRUE(std::isnan(silo.eurocode({4., 9.}, right).normal));
    }
}



TEST(ReferencePressures, nothing_where_walls_differ_or_move)
{
  for (const bool moves : {false, true})
    {
      Section silo;
      silo.name = [&silo](const Point<2> &middle) -> std::string {
        return middle[0] == 4. && middle[1] < 3. ? "lining" :
                                                   silo.usual_name(middle);
      };
      silo.walls.friction_angles["lining"] = {moves ? 20. : 12.};
      if (moves)
        silo.walls.velocities["lining"] = {0., 1.};
      EXPECT_TRUE(silo.says_nothing({4., 9.}, right));
      EXPECT_TRUE(silo.says_nothing({4., 2.}, right));
    }
}



TEST(ReferencePressures, walls_of_any_name)
{
  Section silo, usual;
  silo.name = [&silo](const Point<2> &middle) -> std::string {
    const std::string name = silo.usual_name(middle);
    return name == "wall" || name == "floor" ? "steel" : name;
  };
  silo.walls.friction_angles["steel"] = {20.};
  EXPECT_EQ(silo.janssen({4., 5.}, right), usual.janssen({4., 5.}, right));
  EXPECT_EQ(silo.janssen({3., 0.}, down), usual.janssen({3., 0.}, down));
}



TEST(ReferencePressures, several_outlets_are_not_central)
{
  // Beside the axis, so that the whole silo has two of them.
  Section silo;
  silo.name = [&silo](const Point<2> &middle) -> std::string {
    return middle[1] > 0. ? silo.usual_name(middle) :
           middle[0] < 1. ? "floor" :
                            "outlet";
  };
  EXPECT_GT(silo.eurocode({4., 5.}, right).normal, 0.);
  EXPECT_TRUE(std::isnan(
    silo.eurocode({4., 5.}, right, EurocodePressures::Load::discharge).normal));
}



TEST(ReferencePressures, surface_that_is_not_level)
{
  Section silo;
  silo.moved = [](const Point<2> &point) {
    return Point<2>(point[0], point[1] * (1. + 0.01 * point[0]));
  };
  EXPECT_TRUE(silo.says_nothing({4., 5.}, right));
}



// Round a core there is less wall than material.
TEST(ReferencePressures, ring)
{
  Section silo;
  silo.formulation = Formulation::axisymmetric;
  silo.moved       = [](const Point<2> &point) {
    return Point<2>(point[0] + 6., point[1]);
  };
  silo.name = [&silo](const Point<2> &middle) -> std::string {
    return middle[0] == 0. ? "wall" : silo.usual_name(middle);
  };
  Section whole; // plane, likewise with a hydraulic radius of half of its width
  whole.name = silo.name;
  EXPECT_NEAR(silo.janssen({10., 5.}, right),
              whole.janssen({4., 5.}, right),
              1e-9 * whole.janssen({4., 5.}, right));
  EXPECT_NEAR(silo.janssen({6., 5.}, left),
              whole.janssen({0., 5.}, left),
              1e-9 * whole.janssen({0., 5.}, left));
  EXPECT_TRUE(std::isnan(silo.eurocode({10., 5.}, right).normal));
}
