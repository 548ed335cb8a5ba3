#include <sandglass/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "mesh_file.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// What is done to a mesh file, and what its refusal says.
  struct Fault
  {
    std::string                     name;
    std::function<void(MeshFile &)> make;
    std::vector<std::string>        message;
    Formulation                     formulation = Formulation::plane_strain;
    CellType                        cell_type   = CellType::triangle;
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
  ClearedParameters cleared;
  SceneParameters   scene;
  scene.formulation = fault.formulation;
  scene.cell_type   = fault.cell_type;
  try
    {
      file.read(scene);
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
