#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/silo_section.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

namespace Sandglass
{
  namespace
  {
    using Elements = std::vector<GmshMesh::Element>;

    /// Where an element's centre is.
    std::string
    place_of(const GmshMesh &mesh, const GmshMesh::Element &element)
    {
      dealii::Point<3> center;
      for (const unsigned int node : element.corners)
        center += mesh.nodes[node] / double(element.corners.size());
      return center[2] == 0. ? place(dealii::Point<2>(center[0], center[1])) :
                               place(center);
    }



    std::string
    name_of_cells(const unsigned int dimension, const std::size_t n_corners)
    {
      return dimension == 2 && n_corners == 3 ? "triangles" :
             dimension == 2 && n_corners == 4 ? "quadrilaterals" :
             dimension == 3 && n_corners == 4 ? "tetrahedra" :
             dimension == 3 && n_corners == 8 ? "hexahedra" :
                                                "cells of " +
                                                  std::to_string(n_corners) +
                                                  " corners";
    }



    /// The groups that there are, for messages about one that is missing.
    std::string
    groups_there(const GmshMesh &mesh, const unsigned int dim)
    {
      return std::string("its physical ") +
             (dim == 2 ? "surfaces: " : "volumes: ") +
             list_of(mesh.groups[dim]) + "; its physical " +
             (dim == 2 ? "lines: " : "surfaces: ") +
             list_of(mesh.groups[dim - 1]);
    }



    void
    check_that_there_is_material(const GmshMesh &mesh, const unsigned int dim)
    {
      const Elements &cells       = mesh.elements[dim];
      const auto      is_material = [](const GmshMesh::Element &cell) {
        return cell.groups.count(material_group) > 0;
      };
      if (cells.empty())
        throw InputError("there are no cells in it; allowed is a mesh, as "
                         "gmsh -" +
                         std::to_string(dim) +
                         " makes it of a .geo file, with the physical groups "
                         "'material' and, below an open outlet, 'fall_region'");
      if (std::none_of(cells.begin(), cells.end(), is_material))
        throw InputError("the mesh has no cells in a physical group named "
                         "'material' (" +
                         groups_there(mesh, dim) +
                         "); allowed are meshes whose cells belong to "
                         "'material' and, below an open outlet, "
                         "'fall_region'");
    }



    /// Refuse a mesh of other cells, and one with other cells among its own.
    void
    check_types(const GmshMesh    &mesh,
                const unsigned int dim,
                const CellType     cell_type)
    {
      const std::string wanted =
        name_of_cells(dim, vertices_per_cell(cell_type));
      std::map<std::string, std::vector<const GmshMesh::Element *>> others;
      std::size_t                                                   n_others{};
      for (const auto &cell : mesh.elements[dim])
        if (cell.corners.size() != vertices_per_cell(cell_type))
          {
            others[name_of_cells(dim, cell.corners.size())].push_back(&cell);
            ++n_others;
          }
      if (others.empty())
        return;
      const auto &[name, cells] = *others.begin();
      if (n_others == mesh.elements[dim].size() && others.size() == 1)
        throw InputError("the mesh is of " + name + " (" + cells[0]->type +
                         " in Gmsh's words), but Scene/Cell type asks for " +
                         wanted +
                         "; allowed is a mesh of the one type that "
                         "Cell type names");
      throw InputError(
        "the mesh has cells of several types: beside " + wanted +
        " there are " + std::to_string(cells.size()) + ' ' + name +
        ", in the group " + list_of(cells[0]->groups) + ", the first at " +
        place_of(mesh, *cells[0]) +
        "; allowed is a mesh of the one type that Scene/Cell type names "
        "(recombine all surfaces or none)");
    }



    /// Refuse cells whose group doesn't tell whether they are filled.
    void
    check_groups(const GmshMesh &mesh, const GmshMesh::Element &cell)
    {
      std::set<std::string> found;
      for (const char *group : {material_group, fall_region_group, space_group})
        if (cell.groups.count(group) > 0)
          found.insert(group);
      if (found.size() == 1)
        return;
      throw InputError(
        "the cell at " + place_of(mesh, cell) +
        (found.size() > 1 ? " belongs to both '" + *found.begin() + "' and '" +
                              *std::next(found.begin()) + "'" :
         cell.groups.empty() ? " belongs to no physical group" :
                               " belongs to the physical group " +
                                 list_of(cell.groups)) +
        "; allowed are cells that belong to one of 'material', 'fall_region' "
        "and, above the material, 'space' (what is none of them, as the inside "
        "of an insert, must not be meshed)");
    }



    /// Refuse nodes of cells that are out of the mesh's space.
    void
    check_space(const GmshMesh &mesh, const unsigned int dim)
    {
      dealii::Point<3> lower, upper;
      bool             is_first = true;
      for (const auto &cell : mesh.elements[dim])
        for (const unsigned int corner : cell.corners)
          {
            const dealii::Point<3> &node = mesh.nodes[corner];
            for (unsigned int d = 0; d < 3; ++d)
              {
                if (!std::isfinite(node[d]))
                  throw InputError("a vertex is at " + place(node) +
                                   "; allowed are finite coordinates");
                lower[d] = is_first ? node[d] : std::min(lower[d], node[d]);
                upper[d] = is_first ? node[d] : std::max(upper[d], node[d]);
              }
            is_first = false;
          }
      if (dim == 3)
        return;
      const double rounding = 1e-9 * (upper - lower).norm();
      if (upper[2] - lower[2] <= rounding)
        return;
      std::ostringstream message;
      message << "the mesh is not in a plane z = constant: it reaches from "
              << place(lower) << " to " << place(upper)
              << "; allowed is a section in the x-y plane, y upwards";
      throw InputError(message.str());
    }
  } // namespace



  std::string
  list_of(const std::set<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
  }



  template <int dim>
  std::string
  place(const dealii::Point<dim> &point)
  {
    std::ostringstream text;
    text << '(';
    for (unsigned int d = 0; d < dim; ++d)
      text << (d > 0 ? ", " : "") << point[d];
    text << ") m";
    return text.str();
  }



  template <int dim>
  Mesh<dim>
  take_cells(const GmshMesh &gmsh_mesh, const CellType cell_type)
  {
    for (unsigned int dimension = dim + 1; dimension <= 3; ++dimension)
      if (!gmsh_mesh.elements[dimension].empty())
        throw InputError(
          "the mesh has cells of " + std::to_string(dimension) +
          " dimensions (" + gmsh_mesh.elements[dimension][0].type +
          "); allowed with this Scene/Formulation are " + std::to_string(dim));
    check_that_there_is_material(gmsh_mesh, dim);
    check_types(gmsh_mesh, dim, cell_type);
    check_space(gmsh_mesh, dim);

    Mesh<dim> mesh;
    mesh.cell_type = cell_type;
    for (const auto &node : gmsh_mesh.nodes)
      {
        dealii::Point<dim> vertex;
        for (unsigned int d = 0; d < dim; ++d)
          vertex[d] = node[d];
        mesh.vertices.push_back(vertex);
      }
    for (const auto &element : gmsh_mesh.elements[dim])
      {
        check_groups(gmsh_mesh, element);
        typename Mesh<dim>::Cell cell{{},
                                      element.groups.count(material_group) > 0};
        std::copy(element.corners.begin(),
                  element.corners.end(),
                  cell.vertices.begin());
        mesh.cells.push_back(cell);
      }
    return mesh;
  }



  template <int dim>
  void
  leave_out_fall_region(Mesh<dim> &mesh)
  {
    mesh.cells.erase(std::remove_if(mesh.cells.begin(),
                                    mesh.cells.end(),
                                    [](const auto &cell) {
                                      return !cell.is_filled;
                                    }),
                     mesh.cells.end());
  }



  template <int dim>
  void
  leave_out_fall_region(Mesh<dim> &mesh, const GmshMesh &gmsh_mesh)
  {
    std::vector<typename Mesh<dim>::Cell> remaining;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      if (gmsh_mesh.elements[dim][cell].groups.count(fall_region_group) == 0)
        remaining.push_back(mesh.cells[cell]);
    mesh.cells = std::move(remaining);
  }



#define INSTANTIATE(dim)                                                  \
  template Mesh<dim>   take_cells<dim>(const GmshMesh &, const CellType); \
  template std::string place<dim>(const dealii::Point<dim> &);            \
  template void        leave_out_fall_region<dim>(Mesh<dim> &);           \
  template void leave_out_fall_region<dim>(Mesh<dim> &, const GmshMesh &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
