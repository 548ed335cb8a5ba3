#include "mesh_file.h"

#include <sandglass/output/section_vertical_part.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/walls/boundary_nodes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A scene's parameters, which are added to a cleared global list.
  struct Parameters
  {
    ClearedParameters cleared;
    SceneParameters   scene;
    WallParameters    walls;
  };

  Mesh<2>
  read(const MeshFile           &file,
       const bool                outlet_is_open = true,
       std::vector<std::string> *warnings       = nullptr,
       const Formulation         formulation    = Formulation::plane_strain)
  {
    Parameters parameters;
    parameters.scene.outlet_is_open = outlet_is_open;
    parameters.scene.formulation    = formulation;
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
      ASSERT_EQ(warnings.size(), 2u); // the other one: a coarse outlet
      EXPECT_NE(warnings[0].find("has been moved by ("), std::string::npos);
    }
}



TEST(MeshFiles, LeftHalvesMeasureAsRightOnes)
{
  MeshFile file;
  file.move([](auto &node) { node[0] = 2. - node[0]; });
  const Scene<2>        left_scene  = scene_of(read(file));
  const Scene<2>        right_scene = scene_of(read(MeshFile()));
  const SiloMeasures<2> left(left_scene), right(right_scene);
  EXPECT_NEAR(left.outlet_width, right.outlet_width, 1e-12);
  const VerticalPart left_part(left_scene), right_part(right_scene);
  EXPECT_NEAR(left_part.width, right_part.width, 1e-12);
  EXPECT_NEAR(left_part.foot, right_part.foot, 1e-12);
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
  ASSERT_EQ(warnings.size(), 2u); // the other one: a coarse outlet
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
      ASSERT_EQ(warnings.size(), 2u); // the other one: a coarse outlet
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



// Who fills the fall region as well has nothing discharged by mistake.
TEST(MeshFiles, MaterialBelowTheOutletIsDoubtedWhereAllIsFilled)
{
  MeshFile file;
  file.rename("fall_region", "material");
  std::vector<std::string> warnings;
  const Mesh<2>            mesh = read(file, true, &warnings);
  EXPECT_EQ(count(mesh, BoundaryRole::outlet), 2u);
  EXPECT_TRUE(std::any_of(
    warnings.begin(), warnings.end(), [](const std::string &warning) {
      return warning.find("below the outlet") != std::string::npos;
    }));
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
      ASSERT_EQ(warnings.size(), 2u); // the other one: a coarse outlet
      EXPECT_NE(warnings[0].find("lengths are in metres"), std::string::npos);
    }
}
