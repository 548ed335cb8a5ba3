#include "mesh_file.h"

#include <sandglass/base/exceptions.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/walls/boundary_nodes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A scene's parameters, which are added to a cleared global list.
  struct Parameters
  {
    StageFixture::ClearedParameters cleared;
    SceneParameters                 scene;
    WallParameters                  walls;
  };

  Mesh<2>
  read(const MeshFile           &file,
       const bool                outlet_is_open = true,
       std::vector<std::string> *warnings       = nullptr,
       const Formulation         formulation    = Formulation::plane_strain,
       const CellType            cell_type      = CellType::triangle)
  {
    Parameters parameters;
    parameters.scene.outlet_is_open = outlet_is_open;
    parameters.scene.formulation    = formulation;
    parameters.scene.cell_type      = cell_type;
    return file.read(parameters.scene, warnings);
  }

  /// What is the same in equal meshes: of each cell its fill and centre, of
  /// each face its role and centre.
  std::vector<std::string>
  contents(const Mesh<2> &mesh)
  {
    std::vector<std::string> result;
    const auto               add = [&](const std::string              &what,
                         const std::vector<unsigned int> vertices) {
      Point<2> center;
      for (const unsigned int vertex : vertices)
        center += mesh.vertices[vertex] / double(vertices.size());
      std::ostringstream text;
      text << what << std::lround(center[0] * 1e6) << ' '
           << std::lround(center[1] * 1e6);
      result.push_back(text.str());
    };
    for (const auto &cell : mesh.cells)
      {
        std::vector<unsigned int> vertices(cell.vertices.begin(),
                                           cell.vertices.begin() +
                                             mesh.vertices_per_cell());
        add(cell.is_filled ? "filled " : "empty ", vertices);
      }
    for (const auto &face : mesh.faces)
      add(mesh.name_of(face) + ' ', {face.vertices[0], face.vertices[1]});
    std::sort(result.begin(), result.end());
    return result;
  }

  unsigned int
  count(const Mesh<2> &mesh, const BoundaryRole role)
  {
    return std::count_if(mesh.faces.begin(),
                         mesh.faces.end(),
                         [role](const auto &face) {
                           return face.role == role;
                         });
  }

  Scene<2>
  scene_of(const Mesh<2> &mesh)
  {
    Parameters parameters;
    return Scene<2>(mesh,
                    parameters.walls,
                    Formulation::plane_strain,
                    1,
                    Tensor<1, 2>({0., -9.81}),
                    MPI_COMM_SELF);
  }

  std::vector<Point<2>>
  lips(const Mesh<2> &mesh)
  {
    Parameters            parameters;
    const Scene<2>        scene = scene_of(mesh);
    std::vector<Point<2>> result;
    for (const auto &node : find_boundary_nodes(
           scene.dof_handler, scene.formulation, scene.walls, parameters.walls))
      if (node.is_free)
        result.push_back(node.position);
    return result;
  }
} // namespace



TEST(MeshFiles, AMovedSiloIsTheSameWithAWarning)
{
  const auto unmoved = contents(read(MeshFile()));
  for (const auto &[x, y] : {std::make_pair(1., 0.),
                             std::make_pair(0., 5.),
                             std::make_pair(-3., -0.7)})
    {
      MeshFile file;
      file.move([x = x, y = y](auto &node) {
        node[0] += x;
        node[1] += y;
        node[2] += 2.;
      });
      std::vector<std::string> warnings;
      EXPECT_EQ(contents(read(file, true, &warnings)), unmoved);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find("has been moved by ("), std::string::npos);
    }
}



TEST(MeshFiles, LeftHalvesMeasureAsRightOnes)
{
  MeshFile file;
  file.move([](auto &node) { node[0] = 2. - node[0]; });
  const Mesh<2>         mesh = read(file);
  const SiloMeasures<2> left(scene_of(mesh)), right(scene_of(read(MeshFile())));
  EXPECT_NEAR(left.wall_width, right.wall_width, 1e-12);
  EXPECT_NEAR(left.outlet_width, right.outlet_width, 1e-12);
  EXPECT_NEAR(left.wall_foot, right.wall_foot, 1e-12);
}



TEST(MeshFiles, AnAxisymmetricLeftHalfIsMirrored)
{
  MeshFile   file;
  const auto right =
    contents(read(file, true, nullptr, Formulation::axisymmetric));
  file.move([](auto &node) { node[0] = 2. - node[0]; });
  EXPECT_EQ(contents(read(file, true, nullptr, Formulation::axisymmetric)),
            right);
}



TEST(MeshFiles, AnyOrderOfVerticesIsRead)
{
  MeshFile   file;
  const auto regular = contents(read(file));
  for (std::size_t i = 0; i < file.elements.size(); i += 3)
    std::swap(file.elements[i].nodes[0], file.elements[i].nodes[1]);
  const Mesh<2> mesh = read(file);
  EXPECT_EQ(contents(mesh), regular);
  EXPECT_NO_THROW(scene_of(mesh));
}



TEST(MeshFiles, OfHigherOrderCornersAreTaken)
{
  MeshFile   file;
  const auto linear = contents(read(file));
  for (auto &element : file.elements)
    {
      const std::size_t n = element.nodes.size();
      for (std::size_t v = 0; v < (n == 2 ? 1 : n); ++v)
        {
          const auto a = file.nodes[element.nodes[v]];
          const auto b = file.nodes[element.nodes[(v + 1) % n]];
          element.nodes.push_back(file.nodes.size());
          file.nodes.push_back({{(a[0] + b[0]) / 2., (a[1] + b[1]) / 2., 0.}});
        }
      element.type = n == 2 ? 8 : 9;
    }
  std::vector<std::string> warnings;
  EXPECT_EQ(contents(read(file, true, &warnings)), linear);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("higher order"), std::string::npos);
}



TEST(MeshFiles, SurfacesThatDontShareTheirNodesAreJoined)
{
  for (const bool outlet_is_below : {false, true})
    {
      MeshFile   file;
      const auto joined = contents(read(file));
      // The fall region, and perhaps the outlet, get nodes of their own.
      const auto copy = file.nodes;
      const auto n    = static_cast<unsigned int>(copy.size());
      file.nodes.insert(file.nodes.end(), copy.begin(), copy.end());
      for (auto &element : file.elements)
        if (element.group == "fall_region" || element.group == "fall_side" ||
            (outlet_is_below && element.group == "outlet"))
          for (unsigned int &vertex : element.nodes)
            vertex += n;
      std::vector<std::string> warnings;
      EXPECT_EQ(contents(read(file, true, &warnings)), joined);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find("nodes have been merged"), std::string::npos);
    }
}



TEST(MeshFiles, NodesOfNoCellAreLeftOut)
{
  MeshFile   file;
  const auto regular = contents(read(file));
  file.nodes.push_back({{1e10, 5., 3.}});
  EXPECT_EQ(contents(read(file)), regular);
}



TEST(MeshFiles, AClosedOutletLeavesOutTheFallRegion)
{
  const Mesh<2> mesh = read(MeshFile(), false);
  EXPECT_TRUE(std::all_of(mesh.cells.begin(),
                          mesh.cells.end(),
                          [](const auto &cell) { return cell.is_filled; }));
  EXPECT_EQ(count(mesh, BoundaryRole::outlet), 2u);
  EXPECT_EQ(count(mesh, BoundaryRole::axis), 8u);
  EXPECT_EQ(count(mesh, BoundaryRole::fall_side), 0u);
  const Scene<2> scene = scene_of(mesh);
  EXPECT_FALSE(SiloMeasures<2>(scene).has_open_outlet);
  EXPECT_TRUE(
    std::any_of(scene.walls.begin(), scene.walls.end(), [](const auto &wall) {
      return wall.name == "outlet";
    }));
}



// Whatever the border of the fall region is called.
TEST(MeshFiles, TheLipIsWhereTheWallEnds)
{
  for (const std::string name : {"fall_side", "fall_bottom"})
    {
      MeshFile file;
      file.rename("fall_side", name);
      file.rename("fall_bottom", name);
      for (auto &element : file.elements)
        if (element.group == "axis" && file.nodes[element.nodes[0]][1] < 0.)
          element.group = name;
      const Mesh<2> mesh = read(file);
      EXPECT_EQ(count(mesh, BoundaryRole::axis), 10u) << name;
      const auto found = lips(mesh);
      ASSERT_EQ(found.size(), 1u) << name;
      EXPECT_LT(found[0].distance(Point<2>(0.4, 0.)), 1e-12) << name;
    }
}



// A pipe below the outlet: its wall goes on.
TEST(MeshFiles, AWallThatGoesOnBelowTheOutletHasNoLipThere)
{
  MeshFile file;
  file.rename("fall_side", "wall");
  const auto found = lips(read(file));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].distance(Point<2>(0.4, -0.4)), 1e-12);
}



TEST(MeshFiles, AHopperNeedsNoWall)
{
  MeshFile file;
  file.rename("wall", "hopper");
  EXPECT_EQ(count(read(file), BoundaryRole::hopper), 8u);
}



TEST(MeshFiles, UnlikelyLengthsAreDoubted)
{
  for (const double scale : {1000., 1e-3})
    {
      MeshFile file;
      file.move([scale](auto &node) {
        node[0] *= scale;
        node[1] *= scale;
      });
      std::vector<std::string> warnings;
      read(file, true, &warnings);
      ASSERT_EQ(warnings.size(), 1u);
      EXPECT_NE(warnings[0].find("lengths are in metres"), std::string::npos);
    }
}



namespace
{
  /// What is done to a mesh file, and what its refusal says.
  struct Fault
  {
    std::string                     name;
    std::function<void(MeshFile &)> make;
    std::vector<std::string>        message;
    Formulation                     formulation    = Formulation::plane_strain;
    CellType                        cell_type      = CellType::triangle;
    bool                            outlet_is_open = true;
  };

  void
  PrintTo(const Fault &fault, std::ostream *out)
  {
    *out << fault.name;
  }

  /// Join each pair of triangles of a group to a square.
  void
  recombine(MeshFile &file, const std::string &group)
  {
    std::vector<MeshFile::Element> elements;
    for (auto &element : file.elements)
      if (element.group != group)
        elements.push_back(element);
      else if (!elements.empty() && elements.back().group == group &&
               elements.back().type == MeshFile::triangle)
        {
          elements.back().type = MeshFile::square;
          elements.back().nodes.push_back(element.nodes[2]);
        }
      else
        elements.push_back(element);
    file.elements = elements;
  }

  class MeshFileFaults : public testing::TestWithParam<Fault>
  {};
} // namespace



TEST_P(MeshFileFaults, AreRefusedByNameAndPlace)
{
  const Fault &fault = GetParam();
  MeshFile     file;
  fault.make(file);
  try
    {
      read(file,
           fault.outlet_is_open,
           nullptr,
           fault.formulation,
           fault.cell_type);
      ADD_FAILURE() << "not refused";
    }
  catch (const InputError &error)
    {
      EXPECT_EQ(error.name, "Mesh file");
      for (const std::string &text : fault.message)
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
          << text << "\nin: " << error.what();
    }
}



INSTANTIATE_TEST_SUITE_P(
  Kinds,
  MeshFileFaults,
  testing::Values(
    Fault{"MixedCells",
          [](MeshFile &file) { recombine(file, "fall_region"); },
          {"several types", "4 quadrilaterals", "fall_region", " at ("}},
    Fault{"OtherCells",
          [](MeshFile &) {},
          {"the mesh is of triangles", "quadrilaterals"},
          Formulation::plane_strain,
          CellType::quadrilateral},
    Fault{"NoMaterial",
          [](MeshFile &file) { file.erase("material"); },
          {"'material'", "its physical surfaces: fall_region;", "axis, "}},
    Fault{"NoFallRegion",
          [](MeshFile &file) { file.erase("fall_region"); },
          {"'fall_region'", "edges of no cell", "one from ("}},
    Fault{"NoNames",
          [](MeshFile &file) {
            for (auto &element : file.elements)
              element.group = "";
          },
          {"'material'", "its physical surfaces: none"}},
    Fault{"CellsOfNoGroup",
          [](MeshFile &file) { file.elements[3].group = ""; },
          {"the cell at (", "belongs to no physical group"}},
    Fault{"CellsOfAnotherGroup",
          [](MeshFile &file) { file.elements[3].group = "steel"; },
          {"the cell at (", "belongs to the physical group steel"}},
    Fault{"CellsOfTwoGroups",
          [](MeshFile &file) {
            file.elements.push_back(file.elements[0]);
            file.elements.back().group = "material";
          },
          {"the cell at (", "belongs to both"}},
    Fault{"NoTop",
          [](MeshFile &file) { file.erase("top"); },
          {"boundary has no name", "4 edges, one from ("}},
    Fault{"NoOutlet",
          [](MeshFile &file) { file.erase("outlet"); },
          {"between 'material' and 'fall_region' has no name", "one from ("}},
    Fault{"EdgesOfTwoGroups",
          [](MeshFile &file) { file.add_line("wall", 2, 0, 3, 0); },
          {"several physical groups: floor, wall", "one from (0.4, 0) m"}},
    Fault{"AWallInside",
          [](MeshFile &file) { file.add_line("wall", 2, 3, 3, 3); },
          {"'wall' has cells on both its sides", "from (0.4, 0.6) m"}},
    Fault{"AnAxisInside",
          [](MeshFile &file) { file.add_line("axis", 1, 3, 1, 4); },
          {"'axis' has cells on both its sides", "from (0.2, 0.6) m"}},
    Fault{"AnOutletInside",
          [](MeshFile &file) { file.add_line("outlet", 2, 3, 3, 3); },
          {"'outlet' has cells on both its sides", "from (0.4, 0.6) m"}},
    Fault{"AHangingOutlet",
          [](MeshFile &file) {
            // The lower side's middle node lies elsewhere.
            file.nodes.push_back({{0.3, 0., 0.}});
            for (auto &element : file.elements)
              if (element.group == "fall_region")
                std::replace(element.nodes.begin(),
                             element.nodes.end(),
                             file.node(1, 0),
                             unsigned(file.nodes.size() - 1));
          },
          {"'outlet' has no cells of 'fall_region'", "one from ("}},
    Fault{
      "AHangingNode",
      [](MeshFile &file) {
        // One of two triangles at an edge is cut in two.
        const unsigned int middle = file.nodes.size();
        const auto         nodes  = file.elements[40].nodes;
        const auto         a = file.nodes[nodes[0]], b = file.nodes[nodes[2]];
        file.nodes.push_back({{(a[0] + b[0]) / 2., (a[1] + b[1]) / 2., 0.}});
        file.elements[40].nodes[2] = middle;
        file.elements.push_back(
          {MeshFile::triangle, "material", {middle, nodes[1], nodes[2]}});
      },
      {"hangs on the edge of another cell"}},
    Fault{"ACellWithoutArea",
          [](MeshFile &file) {
            file.elements.push_back(
              {MeshFile::triangle,
               "material",
               {file.node(0, 0), file.node(0, 1), file.node(0, 2)}});
          },
          {"the cell at (0, 0.2) m has no area"}},
    Fault{"AFoldedMesh",
          [](MeshFile &file) { file.nodes[file.node(2, 3)][0] = 0.7; },
          {"overlap"}},
    Fault{"AHollowSquare",
          [](MeshFile &file) {
            recombine(file, "fall_region");
            recombine(file, "material");
            file.nodes[file.node(2, 3)] = {{0.59, 0.79, 0.}};
          },
          {"the cell at (", "is not convex"},
          Formulation::plane_strain,
          CellType::quadrilateral},
    Fault{"ACellTwice",
          [](MeshFile &file) {
            file.nodes.push_back({{0.9, 0.9, 0.}});
            auto cell     = file.elements[20];
            cell.nodes[2] = file.nodes.size() - 1;
            file.elements.push_back(cell);
          },
          {"overlap"}},
    Fault{"InAnotherPlane",
          [](MeshFile &file) {
            file.move([](auto &node) { std::swap(node[1], node[2]); });
          },
          {"not in a plane z = constant", "(0.8, 0, 1.6) m"}},
    Fault{"NotANumber",
          [](MeshFile &file) { file.nodes[7][0] = std::nan(""); },
          {"a vertex is at (nan, "}},
    Fault{"AnInclinedAxis",
          [](MeshFile &file) {
            file.move([](auto &node) { node[0] += 0.1 * node[1]; });
          },
          {"'axis' is not one vertical line"}},
    Fault{"TwoAxes",
          [](MeshFile &file) { file.rename("wall", "axis"); },
          {"'axis' is not one vertical line", "a wall without friction"}},
    Fault{"MaterialBelowTheOutlet",
          [](MeshFile &file) {
            file.rename("floor", "wall");
            file.move([](auto &node) {
              if (node[0] > 0.5 && node[1] == 0.)
                node[1] = -0.1;
            });
          },
          {"material lies below the outlet", "y = -0.1 m"}},
    Fault{"AxisymmetricOnBothSides",
          [](MeshFile &file) {
            file.rename("axis", "wall");
            file.move([](auto &node) { node[0] -= 0.4; });
          },
          {"both sides of x = 0"},
          Formulation::axisymmetric}),
  [](const auto &info) { return info.param.name; });
