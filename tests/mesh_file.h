#ifndef sandglass_tests_mesh_file_h
#define sandglass_tests_mesh_file_h

#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/**
 * Half a silo with a flat bottom as a mesh in Gmsh's format 2.2, for tests to
 * change before they write and read it: 0.8 m wide, 1.6 m high, with an outlet
 * of 0.4 m and a fall region of 0.4 m below.
 */
struct MeshFile
{
  struct Element
  {
    int                       type; ///< Gmsh's number of the type
    std::string               group;
    std::vector<unsigned int> nodes; ///< indices
  };

  static constexpr int line = 1, triangle = 2, square = 3;

  std::vector<std::array<double, 3>> nodes;
  std::vector<Element>               elements;

  explicit MeshFile(const double size = 0.2)
    : size(size)
  {
    const int nx = std::lround(0.8 / size), ny = std::lround(1.6 / size),
              n = std::lround(0.4 / size);
    for (int i = 0; i < nx; ++i)
      for (int j = i < n ? -n : 0; j < ny; ++j)
        {
          const unsigned int a = node(i, j), b = node(i + 1, j),
                             c = node(i + 1, j + 1), d = node(i, j + 1);
          const std::string group = j < 0 ? "fall_region" : "material";
          elements.push_back({triangle, group, {a, b, c}});
          elements.push_back({triangle, group, {a, c, d}});
        }
    for (int i = 0; i < nx; ++i)
      {
        add_line(i < n ? "outlet" : "floor", i, 0, i + 1, 0);
        add_line("top", i, ny, i + 1, ny);
        if (i < n)
          add_line("fall_bottom", i, -n, i + 1, -n);
      }
    for (int j = -n; j < ny; ++j)
      {
        add_line("axis", 0, j, 0, j + 1);
        if (j < 0)
          add_line("fall_side", n, j, n, j + 1);
        else
          add_line("wall", nx, j, nx, j + 1);
      }
  }

  /// The node at (i, j) times the size of the cells.
  unsigned int
  node(const int i, const int j)
  {
    const auto [known, is_new] =
      node_at.emplace(std::make_pair(i, j), nodes.size());
    if (is_new)
      nodes.push_back({{i * size, j * size, 0.}});
    return known->second;
  }

  void
  add_line(const std::string &group,
           const int          i,
           const int          j,
           const int          k,
           const int          l)
  {
    elements.push_back({line, group, {node(i, j), node(k, l)}});
  }

  /// Give the elements of one group another one, or none.
  void
  rename(const std::string &group, const std::string &name)
  {
    for (Element &element : elements)
      if (element.group == group)
        element.group = name;
  }

  void
  erase(const std::string &group)
  {
    std::vector<Element> kept;
    for (const Element &element : elements)
      if (element.group != group)
        kept.push_back(element);
    elements = kept;
  }

  /// Let a function change the coordinates of each node.
  template <typename Function>
  void
  move(const Function &function)
  {
    for (auto &coordinates : nodes)
      function(coordinates);
  }

  std::string
  text() const
  {
    std::map<std::string, int> number;
    std::ostringstream         names, lines;
    for (const Element &element : elements)
      {
        const int dimension = element.type == line || element.type == 8 ? 1 : 2;
        if (!element.group.empty() &&
            number.emplace(element.group, number.size() + 1).second)
          names << dimension << ' ' << number[element.group] << " \""
                << element.group << "\"\n";
      }
    for (std::size_t i = 0; i < elements.size(); ++i)
      {
        const auto group = number.find(elements[i].group);
        const int  tag   = group == number.end() ? 0 : group->second;
        lines << i + 1 << ' ' << elements[i].type << " 2 " << tag << ' '
              << (tag == 0 ? 99 : tag);
        for (const unsigned int v : elements[i].nodes)
          lines << ' ' << v + 1;
        lines << '\n';
      }
    std::ostringstream text;
    text.precision(17);
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
         << number.size() << '\n'
         << names.str() << "$EndPhysicalNames\n$Nodes\n"
         << nodes.size() << '\n';
    for (std::size_t i = 0; i < nodes.size(); ++i)
      text << i + 1 << ' ' << nodes[i][0] << ' ' << nodes[i][1] << ' '
           << nodes[i][2] << '\n';
    text << "$EndNodes\n$Elements\n"
         << elements.size() << '\n'
         << lines.str() << "$EndElements\n";
    return text.str();
  }

  /// Write a file that no other test uses at the same time.
  std::string
  write() const
  {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test->name();
    for (char &character : name)
      if (character == '/')
        character = '_';
    const std::string path = testing::TempDir() + "sandglass_" + name +
                             std::to_string(getpid()) + ".msh";
    std::ofstream(path) << text();
    return path;
  }

  /// The mesh that a scene has with this file.
  Sandglass::Mesh<2>
  read(Sandglass::SceneParameters &scene,
       std::vector<std::string>   *warnings = nullptr) const
  {
    scene.shape     = Sandglass::SceneParameters::Shape::mesh_file;
    scene.mesh_file = write();
    try
      {
        const auto mesh =
          Sandglass::make_mesh<2>(scene, MPI_COMM_SELF, warnings);
        std::filesystem::remove(scene.mesh_file);
        return mesh;
      }
    catch (...)
      {
        std::filesystem::remove(scene.mesh_file);
        throw;
      }
  }

private:
  double                                      size;
  std::map<std::pair<int, int>, unsigned int> node_at;
};

#endif
