#include <sandglass/base/exceptions.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_cells.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  using Silo = SceneParameters;

  /// A quarter of a box silo, which tests change before they write and read it
  /// in Gmsh's format 2.2.
  struct BodyFile
  {
    Mesh<3>                  mesh;
    std::vector<std::string> names_of_faces, names_of_cells;

    explicit BodyFile(const CellType cell_type)
    {
      ClearedParameters cleared;
      Silo              silo;
      silo.formulation       = Formulation::three_dimensions;
      silo.cell_type         = cell_type;
      silo.outlet_shape      = Silo::OutletShape::rectangle;
      silo.half_width        = 0.8;
      silo.wall_height       = 1.2;
      silo.outlet_half_width = 0.4;
      silo.fall_region_depth = 0.4;
      silo.element_size      = 0.4;
      mesh                   = mesh_silo<3>(silo);
      sort_along_curve(mesh);
      for (const auto &face : mesh.faces)
        names_of_faces.push_back(mesh.name_of(face));
      for (const auto &cell : mesh.cells)
        names_of_cells.push_back(cell.is_filled ? "material" : "fall_region");
    }

    std::string
    text() const
    {
      std::map<std::string, int> number;
      std::ostringstream         names, elements;
      int                        n_elements = 0;
      const auto                 add        = [&](const int           type,
                           const int           dimension,
                           const std::string  &name,
                           const unsigned int *vertices,
                           const unsigned int  n) {
        if (!name.empty() && number.emplace(name, number.size() + 1).second)
          names << dimension << ' ' << number[name] << " \"" << name << "\"\n";
        const int tag = name.empty() ? 0 : number[name];
        elements << ++n_elements << ' ' << type << " 2 " << tag << ' '
                 << (tag == 0 ? 99 : tag);
        for (unsigned int v = 0; v < n; ++v)
          elements << ' ' << vertices[v] + 1;
        elements << '\n';
      };
      const bool has_simplices = is_simplex(mesh.cell_type);
      for (unsigned int i = 0; i < mesh.faces.size(); ++i)
        add(has_simplices ? 2 : 3,
            2,
            names_of_faces[i],
            mesh.faces[i].vertices.data(),
            mesh.vertices_per_face());
      for (unsigned int i = 0; i < mesh.cells.size(); ++i)
        add(has_simplices ? 4 : 5,
            3,
            names_of_cells[i],
            mesh.cells[i].vertices.data(),
            mesh.vertices_per_cell());
      std::ostringstream text;
      text.precision(17);
      text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
           << number.size() << '\n'
           << names.str() << "$EndPhysicalNames\n$Nodes\n"
           << mesh.vertices.size() << '\n';
      for (unsigned int i = 0; i < mesh.vertices.size(); ++i)
        text << i + 1 << ' ' << mesh.vertices[i] << '\n';
      text << "$EndNodes\n$Elements\n"
           << n_elements << '\n'
           << elements.str() << "$EndElements\n";
      return text.str();
    }

    Mesh<3>
    read(std::vector<std::string> *warnings = nullptr) const
    {
      ClearedParameters cleared;
      Silo              scene;
      scene.formulation = Formulation::three_dimensions;
      scene.cell_type   = mesh.cell_type;
      scene.shape       = Silo::Shape::mesh_file;
      scene.mesh_file   = testing::TempDir() + "sandglass_body" +
                        std::to_string(getpid()) + ".msh";
      std::ofstream(scene.mesh_file) << text();
      struct Removal
      {
        std::string path;
        ~Removal()
        {
          std::filesystem::remove(path);
        }
      } removal{scene.mesh_file};
      return make_mesh<3>(scene, MPI_COMM_SELF, warnings);
    }
  };

  class BodyMeshFile : public testing::TestWithParam<CellType>
  {};

  std::map<std::string, unsigned int>
  count_names(const Mesh<3> &mesh)
  {
    std::map<std::string, unsigned int> counts;
    for (const auto &face : mesh.faces)
      ++counts[mesh.name_of(face)];
    return counts;
  }

  void
  expect_refused(const BodyFile &file, const std::vector<std::string> &texts)
  {
    try
      {
        file.read();
        ADD_FAILURE() << "not refused";
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(error.name, "Mesh file");
        for (const std::string &text : texts)
          EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
            << text << "\nin: " << error.what();
      }
  }
} // namespace



TEST_P(BodyMeshFile, IsReadAsItIs)
{
  const BodyFile           file(GetParam());
  std::vector<std::string> warnings;
  const Mesh<3>            mesh = file.read(&warnings);
  EXPECT_EQ(mesh.cells.size(), file.mesh.cells.size());
  EXPECT_EQ(count_names(mesh), count_names(file.mesh));
  check_overlap(mesh);
}



TEST_P(BodyMeshFile, IsTurnedAndMoved)
{
  BodyFile file(GetParam());
  for (auto &vertex : file.mesh.vertices)
    vertex += Tensor<1, 3>({1., 2., -3.});
  auto &cell = file.mesh.cells[5].vertices;
  if (is_simplex(GetParam()))
    std::swap(cell[0], cell[1]);
  else
    std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4);
  std::vector<std::string> warnings;
  const Mesh<3>            mesh = file.read(&warnings);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("has been moved by (-1, -2, 3) m"),
            std::string::npos)
    << warnings[0];
  check_overlap(mesh);
  for (const auto &vertex : mesh.vertices)
    {
      EXPECT_GT(vertex[0], -1e-9);
      EXPECT_GT(vertex[2], -1e-9);
      EXPECT_GT(vertex[1], -0.4 - 1e-9);
    }
}



TEST_P(BodyMeshFile, IsRefusedByNameAndPlace)
{
  const BodyFile good(GetParam());
  BodyFile       file = good;
  for (auto &name : file.names_of_faces)
    if (name == "wall")
      name = "";
  expect_refused(file, {"boundary has no name", "faces, one from ("});

  file = good;
  for (auto &name : file.names_of_cells)
    name = name == "material" ? "filled" : name;
  expect_refused(file, {"'material'", "its physical volumes: ", "surfaces: "});

  file = good;
  for (auto &name : file.names_of_faces)
    if (name == "floor")
      name = "axis";
  expect_refused(file, {"'axis'", "in no symmetry plane"});

  file = good;
  for (auto &name : file.names_of_faces)
    if (name == "outlet")
      name = "";
  expect_refused(file, {"between 'material' and 'fall_region' has no name"});

  file = good;
  for (unsigned int v = 0; v < 4; ++v)
    file.mesh.vertices[file.mesh.cells[0].vertices[v]][1] = 0.3;
  if (is_simplex(GetParam()))
    {
      expect_refused(file, {"the cell at (", "has no volume"});
    }
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         BodyMeshFile,
                         testing::Values(CellType::tetrahedron,
                                         CellType::hexahedron),
                         [](const auto &info) {
                           return info.param == CellType::tetrahedron ?
                                    "Tetrahedra" :
                                    "Hexahedra";
                         });
