#include <sandglass/flow/in_space.h>
#include <sandglass/output/section_wall_tractions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "output_silo.h"

using namespace Sandglass;

namespace
{
  WallId
  wall_of(const Scene<2> &scene, const BoundaryRole role)
  {
    WallId wall = 0;
    while (scene.walls.at(wall).role != role)
      ++wall;
    return wall;
  }



  TEST(WallLines, lengths_of_half_a_silo)
  {
    SmallSilo       silo;
    const SmallRun  run(silo);
    const WallLines lines(run.scene.mesh,
                          run.scene.walls,
                          SiloMeasures<2>(run.scene).bottom_centre);
    const auto      arc_length =
      [&](const BoundaryRole role, const double x, const double y) {
        unsigned int vertex = 0;
        while (run.scene.mesh.vertices[vertex].distance(Point<2>(x, y)) > 1e-9)
          ++vertex;
        return lines.find(wall_of(run.scene, role), vertex).arc_length;
      };
    EXPECT_NEAR(arc_length(BoundaryRole::floor, 0.2, 0.), 0.0, 1e-12);
    EXPECT_NEAR(arc_length(BoundaryRole::floor, 0.4, 0.), 0.2, 1e-12);
    EXPECT_NEAR(arc_length(BoundaryRole::wall, 0.4, 0.), 0.0, 1e-12);
    EXPECT_NEAR(arc_length(BoundaryRole::wall, 0.4, 0.8), 0.8, 1e-12);
    EXPECT_NEAR(arc_length(BoundaryRole::outlet, 0., 0.), 0.0, 1e-12);
    EXPECT_NEAR(arc_length(BoundaryRole::outlet, 0.2, 0.), 0.2, 1e-12);
  }



  TEST(WallLines, both_sides_of_a_whole_silo)
  {
    // A hopper with a bend on each side of an outlet from x = -1 to 1.
    Mesh<2> mesh;
    mesh.vertices = {{-1., 0.}, {1., 0.}, {-2., 2.}, {-3., 2.}, {4., 4.}};
    mesh.faces    = {{{{3, 2}}, BoundaryRole::hopper},
                     {{{2, 0}}, BoundaryRole::hopper},
                     {{{4, 1}}, BoundaryRole::hopper}};
    const WallId    hopper = 0;
    const WallLines lines(
      mesh,
      {{"hopper", BoundaryRole::hopper, boundary_id(BoundaryRole::hopper)}},
      Point<2>(0.1, 0.));
    const auto &left_end = lines.find(hopper, 3);
    EXPECT_NEAR(left_end.arc_length, std::sqrt(5.) + 1., 1e-12);
    const auto &right_end = lines.find(hopper, 4);
    EXPECT_NEAR(right_end.arc_length, 5., 1e-12);
    EXPECT_EQ(right_end.line, 0);
    EXPECT_EQ(left_end.line, 1);
  }



  TEST(SiloMeasures, widths_of_the_whole_silo)
  {
    SmallSilo             silo;
    const SmallRun        run(silo);
    const SiloMeasures<2> measures(run.scene);
    EXPECT_TRUE(measures.has_open_outlet);
    EXPECT_NEAR(measures.outlet_width, 0.4, 1e-12);
  }



  /// Records of the given tractions, in Pa, at all nodes of walls.
  WallRecords
  make_records(const SmallRun &run,
               const double    normal,
               const double    tangential)
  {
    WallRecords records = run.view().wall_records();
    records.time        = 1.;
    for (auto &record : records.records)
      {
        // Up along the wall, which is at the right, or to the right.
        const Tensor<1, 3> &n = record.normal;
        const Tensor<1, 3>  tangent({std::abs(n[1]), std::abs(n[0]), 0.});
        record.impulse = record.area * (tangential * tangent - normal * n);
      }
    return records;
  }



  TEST(WallTractions, force_over_tributary_area_in_order_along_walls)
  {
    SmallSilo              silo;
    SmallRun               run(silo);
    const WallTractions<2> observer(silo.output, run.scene, silo.material);
    const auto tractions = observer.at_rest(make_records(run, 1000., -50.));

    // 9 nodes on the wall, 3 on the floor; none on axis and open outlet
    ASSERT_EQ(tractions.size(), 12);
    for (unsigned int i = 0; i < tractions.size(); ++i)
      {
        EXPECT_EQ(tractions[i].role,
                  i < 9 ? BoundaryRole::wall : BoundaryRole::floor);
        EXPECT_NEAR(tractions[i].place.arc_length,
                    0.1 * (i < 9 ? i : i - 9),
                    1e-9);
        EXPECT_NEAR(tractions[i].normal(), 1000., 1e-9);
        EXPECT_NEAR(tractions[i].tangential(), -50., 1e-9);
      }
  }



  TEST(WallTractions, a_bend_within_one_wall)
  {
    // An insert whose faces have three directions, in material.
    const Mesh<2> mesh = []() {
      Mesh<2> result;
      result.cell_type = CellType::quadrilateral;
      // Around the square hole from (1, 1) to (2, 2).
      for (unsigned int i = 0; i < 16; ++i)
        result.vertices.emplace_back(i % 4, i / 4);
      for (unsigned int i = 0; i < 11; ++i)
        if (i % 4 != 3 && i != 5)
          result.cells.push_back({{{i, i + 1, i + 5, i + 4}}, true});
      result.named_walls = {"insert"};
      result.faces       = {{{{5, 6}}, BoundaryRole::insert, 0},
                            {{{10, 6}}, BoundaryRole::insert, 0},
                            {{{10, 9}}, BoundaryRole::insert, 0},
                            {{{5, 9}}, BoundaryRole::insert, 0}};
      for (unsigned int i = 0; i < 3; ++i)
        for (const auto &[start, step] :
             {std::make_pair(0u, 1u), {12u, 1u}, {0u, 4u}, {3u, 4u}})
          result.faces.push_back(
            {{{start + i * step, start + (i + 1) * step}}, BoundaryRole::top});
      return result;
    }();
    SmallSilo silo;
    silo.walls.friction_angles["insert"] = {20.};
    const Scene<2>         scene(mesh,
                         silo.walls,
                         Formulation::plane_strain,
                         4,
                         Tensor<1, 2>({0., -9.81}),
                         MPI_COMM_SELF);
    const WallTractions<2> observer(silo.output, scene, silo.material);
    // In the wrong order at each node.
    WallRecords records;
    records.time = 1.;
    for (const unsigned int vertex : {5, 6, 9, 10})
      for (const unsigned int d : {0, 1})
        {
          const Point<2> &point = mesh.vertices[vertex];
          WallRecord      record{0, vertex, in_space(point), {}, 0.5, {}};
          record.normal[d] = point[d] > 1.5 ? -1. : 1.;
          record.impulse   = -500. * record.normal;
          records.records.push_back(record);
        }
    const auto tractions = observer.at_rest(records);
    ASSERT_EQ(tractions.size(), 8);
    unsigned int n_lines = 0;
    for (unsigned int i = 0; i + 1 < tractions.size(); ++i)
      {
        const WallRecord &a = tractions[i].record, &b = tractions[i + 1].record;
        EXPECT_NEAR(tractions[i].normal(), 1000., 1e-9);
        if (a.vertex == b.vertex)
          continue;
        ++n_lines;
        EXPECT_NEAR(a.normal * (b.position - a.position), 0., 1e-12);
        EXPECT_NEAR(b.normal * (b.position - a.position), 0., 1e-12);
      }
    EXPECT_EQ(n_lines, 3); // the line is not closed
    EXPECT_EQ(wall_fields(tractions).cells.size(), 2 * n_lines);
  }



  TEST(WallTractions, mean_over_the_time_since_the_last)
  {
    SmallSilo        silo;
    SmallRun         run(silo);
    WallTractions<2> observer(silo.output, run.scene, silo.material);
    WallRecords      records = make_records(run, 1000., 20.);
    records.time             = 0.5;
    for (const auto &traction : observer.since_last(0.5, records))
      EXPECT_NEAR(traction.normal(), 1000. / 0.5, 1e-9);

    // Now 300 and 10 more within a quarter of a second.
    records      = make_records(run, 1300., 30.);
    records.time = 0.75;
    for (const auto &traction : observer.since_last(0.75, records))
      {
        EXPECT_NEAR(traction.normal(), 300. / 0.25, 1e-9);
        EXPECT_NEAR(traction.tangential(), 10. / 0.25, 1e-9);
        EXPECT_EQ(traction.time, 0.75);
      }
  }



  TEST(WallTractions, janssen_beside_them)
  {
    SmallSilo silo;
    silo.output.lateral_pressure_ratio = 0.5;
    SmallRun               run(silo);
    const WallTractions<2> observer(silo.output, run.scene, silo.material);
    const auto   tractions = observer.at_rest(make_records(run, 1., 0.));
    const double gamma     = 1500. * 9.81;
    const double mu        = std::tan(20. * numbers::PI / 180.);
    const double z0        = 0.8 / (2. * 0.5 * mu);
    for (const auto &traction : tractions)
      {
        const double z  = 0.8 - traction.record.position[1];
        const double ph = gamma * 0.5 * z0 * (1. - std::exp(-z / z0));
        EXPECT_NEAR(traction.janssen_normal,
                    traction.role == BoundaryRole::wall ? ph : ph / 0.5,
                    1e-6);
      }
  }



  TEST(WallTractions, no_janssen_in_the_hopper)
  {
    SmallSilo silo;
    silo.scene.hopper_height  = 0.2;
    silo.scene.outlet_is_open = false;
    SmallRun               run(silo);
    const WallTractions<2> observer(silo.output, run.scene, silo.material);
    const auto tractions = observer.at_rest(make_records(run, 1., 0.));
    EXPECT_TRUE(std::any_of(tractions.begin(),
                            tractions.end(),
                            [](const WallTraction &traction) {
                              return traction.role == BoundaryRole::outlet;
                            }));
    for (const auto &traction : tractions)
      EXPECT_EQ(std::isnan(traction.janssen_normal),
                traction.role != BoundaryRole::wall);
  }



  TEST(WallTractions, eurocode_beside_them)
  {
    // A slender silo with a steep hopper, the same on both sides or not.
    SmallSilo silo;
    silo.scene.wall_height             = 1.7;
    silo.scene.hopper_height           = 0.4;
    silo.output.lateral_pressure_ratio = 0.5;
    silo.walls.hopper_friction_angle   = 15.;
    const auto mu                      = [](const double angle) {
      return std::tan(angle * numbers::PI / 180.);
    };
    const Janssen           janssen{1500. * 9.81, 0.4, 0.5, mu(20.)};
    const EurocodePressures expected(
      {Formulation::plane_strain, 0.8, 1.7, 0., 0.5, 25., mu(15.)}, janssen);
    for (const double eccentricity : {0., 0.1})
      {
        silo.scene.is_symmetric        = eccentricity == 0.;
        silo.scene.outlet_eccentricity = eccentricity;
        SmallRun               run(silo);
        const WallTractions<2> observer(silo.output, run.scene, silo.material);
        for (const auto &traction : observer.at_rest(make_records(run, 1., 0.)))
          {
            const double depth     = 2.1 - traction.record.position[1];
            const bool   is_hopper = traction.role == BoundaryRole::hopper;
            for (const auto &[found, load] :
                 {std::make_pair(traction.eurocode_filling,
                                 EurocodePressures::Load::filling),
                  std::make_pair(traction.eurocode_discharge,
                                 EurocodePressures::Load::discharge)})
              if (is_hopper && eccentricity > 0.)
                {
                  EXPECT_TRUE(std::isnan(found.normal));
                }
              else
                {
                  const WallPressure pressure =
                    is_hopper ? expected.on_hopper(load, depth) :
                                expected.on_wall(load, depth);
                  EXPECT_NEAR(found.normal, pressure.normal, 1e-6);
                  EXPECT_NEAR(found.tangential, pressure.tangential, 1e-6);
                }
          }
      }
  }



  TEST(WallTractions, nothing_of_the_eurocode_in_retaining_silos_and_on_floors)
  {
    SmallSilo silo;
    for (const double wall_height : {0.3, 0.8, 1.7})
      {
        silo.scene.wall_height = wall_height;
        SmallRun               run(silo);
        const WallTractions<2> observer(silo.output, run.scene, silo.material);
        for (const auto &traction : observer.at_rest(make_records(run, 1., 0.)))
          EXPECT_EQ(std::isnan(traction.eurocode_filling.normal),
                    wall_height < 0.4 || traction.role == BoundaryRole::floor);
      }
  }



  TEST(WallTractions, picture_has_a_line_for_each_wall)
  {
    SmallSilo              silo;
    SmallRun               run(silo);
    const WallTractions<2> observer(silo.output, run.scene, silo.material);
    const VtuPiece         piece =
      wall_fields(observer.at_rest(make_records(run, 1000., 50.)));
    EXPECT_EQ(piece.points.size(), 3 * 12);
    EXPECT_EQ(piece.cells.size(), 2 * (8 + 2));

    const auto &on_material = piece.point_fields.at(2);
    ASSERT_EQ(on_material.name, "traction on material");
    ASSERT_EQ(piece.point_fields.at(4).name, "side");
    EXPECT_EQ(std::get<std::vector<float>>(piece.point_fields[4].values),
              std::vector<float>(12, 1.)); // half a silo: all on the right
    const auto &values = std::get<std::vector<float>>(on_material.values);
    // The wall at the right pushes to the left, the floor up.
    EXPECT_FLOAT_EQ(values[0], -1000.);
    EXPECT_FLOAT_EQ(values[1], 50.);
    EXPECT_FLOAT_EQ(values[3 * 11], 50.);
    EXPECT_FLOAT_EQ(values[3 * 11 + 1], 1000.);
  }
} // namespace
