#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/hanging_vertex.h>
#include <sandglass/scene/make_walls.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/name_faces.h>

#include <algorithm>
#include <map>
#include <set>

namespace Sandglass
{
  namespace
  {
    /// What a name stands for; insert unless it is that of a standard part.
    BoundaryRole
    role_of(const std::string &name)
    {
      const auto begin = boundary_role_names.begin();
      const auto end   = boundary_role_names.end();
      const auto part  = std::find(begin, end, name);
      return part == end ? BoundaryRole::insert :
                           static_cast<BoundaryRole>(part - begin + 1);
    }



    constexpr char allowed_names[] =
      "physical groups that together cover the boundary, each face "
      "once: axis, wall, floor, hopper, outlet, fall_side, fall_bottom, top, "
      "or further walls that Walls/Friction angles names";



    template <int dim>
    class FaceNamer
    {
    public:
      FaceNamer(Mesh<dim>                &mesh,
                const bool                outlet_is_open,
                std::vector<std::string> &warnings)
        : mesh(mesh)
        , outlet_is_open(outlet_is_open)
        , warnings(warnings)
        , cells_at(cells_at_faces(mesh))
        , has_fall_region(
            std::any_of(mesh.cells.begin(),
                        mesh.cells.end(),
                        [](const auto &cell) { return !cell.is_filled; }))
      {}

      void
      name(const std::vector<GmshMesh::Element> &lines)
      {
        Names names_at;
        for (const auto &line : lines)
          if (line.corners.size() == mesh.vertices_per_face())
            {
              Key face{};
              std::copy(line.corners.begin(), line.corners.end(), face.begin());
              face = key_of<dim>(face, mesh.vertices_per_face());
              for (const std::string &group : line.groups)
                if (!is_nameless(group))
                  {
                    names_at[face].insert(group);
                    all_names.insert(group);
                  }
            }
        check_cells();
        for (const auto &[face, names] : names_at)
          sort_in(face, names);
        refuse_sorted_out();
        check_that_all_have_names();
        if (outlet_is_open && !has_fall_region)
          warnings.push_back("The mesh has no cells in a physical group named "
                             "'fall_region': nothing can leave the silo.");
        for (const std::string &name : names_inside)
          warnings.push_back("The physical group '" + name +
                             "' lies inside the mesh, where it does nothing.");
      }

    private:
      using Key   = FaceKey<dim>;
      using Faces = std::vector<Key>;
      using Names = std::map<Key, std::set<std::string>>;

      /// What messages call faces.
      const std::string kind = dim == 2 ? "edges" : "faces";

      /// Throw an error about faces: how many, and where the first is.
      [[noreturn]] void
      refuse(const std::string &what,
             const Faces       &faces,
             const std::string &allowed) const
      {
        std::string vertices;
        for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
          vertices += (v > 0 ? " to " : "") + place(mesh.vertices[faces[0][v]]);
        throw InputError(what + " (" + std::to_string(faces.size()) + ' ' +
                         kind + ", one from " + vertices + "); allowed are " +
                         allowed);
      }

      bool
      is_filled(const unsigned int cell) const
      {
        return mesh.cells[cell].is_filled;
      }

      /// Whether a face lies between material and fall region.
      bool
      is_between(const Key &face) const
      {
        const auto &cells = cells_at.at(face);
        return cells.size() == 2 && is_filled(cells[0]) != is_filled(cells[1]);
      }

      void
      check_cells() const
      {
        for (const auto &[face, cells] : cells_at)
          if (cells.size() > 2)
            refuse("more than two cells share a face",
                   {face},
                   "cells that don't overlap");
      }

      /// Add a face, or put it where refuse_sorted_out() finds it.
      void
      sort_in(const Key &face, const std::set<std::string> &names)
      {
        std::set<std::string> parts;
        for (const std::string &name : names)
          if (role_of(name) != BoundaryRole::insert)
            parts.insert(name);
        const auto cells = cells_at.find(face);
        if (cells == cells_at.end())
          {
            if (!parts.empty())
              without_cell[list_of(parts)].push_back(face);
            return;
          }
        const bool is_inside = cells->second.size() == 2;
        if (is_inside && parts.empty())
          {
            names_inside.insert(names.begin(), names.end());
            return;
          }
        const auto &candidates = parts.empty() ? names : parts;
        if (candidates.size() > 1)
          {
            of_several_names[list_of(candidates)].push_back(face);
            return;
          }

        const std::string &name = *candidates.begin();
        const BoundaryRole role = role_of(name);
        // Without a fall region material may lie below the outlet as well.
        const bool may_be_inside =
          role == BoundaryRole::outlet ?
            is_between(face) || !has_fall_region :
            role == BoundaryRole::top && is_between(face);
        if (is_inside && !may_be_inside)
          inside[name].push_back(face);
        else if (role == BoundaryRole::outlet && outlet_is_open && !is_inside &&
                 has_fall_region)
          cut_outlet.push_back(face);
        else
          add(face, name, role);
      }

      void
      add(const Key &vertices, const std::string &name, const BoundaryRole role)
      {
        typename Mesh<dim>::Face face{vertices, role};
        if (role == BoundaryRole::insert)
          {
            auto      &walls = mesh.named_walls;
            const auto known = std::find(walls.begin(), walls.end(), name);
            face.named_wall  = known - walls.begin();
            if (known == walls.end())
              walls.push_back(name);
          }
        mesh.faces.push_back(face);
        named.insert(vertices);
      }

      void
      refuse_sorted_out() const
      {
        // With a closed outlet the fall region has been left out.
        if (outlet_is_open)
          for (const auto &[name, faces] : without_cell)
            refuse((has_fall_region ? "" :
                                      "the mesh has no cells in a physical "
                                      "group named 'fall_region', and so ") +
                     ("the physical group '" + name + "' has " + kind +
                      " of no cell"),
                   faces,
                   kind + " of the cells of 'material' and 'fall_region' "
                          "(without the latter Scene/Outlet must be closed)");
        for (const auto &[names, faces] : of_several_names)
          refuse("the same " + kind +
                   " belong to several physical groups: " + names,
                 faces,
                 allowed_names);
        for (const auto &[name, faces] : inside)
          refuse("the physical group '" + name +
                   "' has cells on both its sides",
                 faces,
                 name == name_of(BoundaryRole::outlet) ?
                   "outlets with 'material' on one side and 'fall_region' on "
                   "the other" :
                   kind + " of the mesh's boundary (a wall inside the silo "
                          "needs a thickness, and an axis ends the section)");
        if (!cut_outlet.empty())
          refuse("the physical group 'outlet' has no cells of 'fall_region' on "
                 "its other side",
                 cut_outlet,
                 "an outlet whose nodes belong to cells of both 'material' and "
                 "'fall_region'");
      }

      void
      check_that_all_have_names() const
      {
        Faces of_boundary, between;
        for (const auto &[face, cells] : cells_at)
          if (named.count(face) == 0)
            {
              if (cells.size() == 1)
                of_boundary.push_back(face);
              else if (is_between(face))
                between.push_back(face);
            }
        if (!between.empty())
          refuse("the border between 'material' and 'fall_region' has no name",
                 between,
                 "the names outlet and, with empty cells above the material, "
                 "top; the mesh's names are " +
                   list_of(all_names));
        if (!of_boundary.empty())
          refuse("the mesh's boundary has no name" +
                   hanging_vertex(mesh, of_boundary),
                 of_boundary,
                 allowed_names +
                   ("; the mesh's names are " + list_of(all_names)));
      }

      Mesh<dim>                &mesh;
      const bool                outlet_is_open;
      std::vector<std::string> &warnings;
      const CellsAtFaces<dim>   cells_at;
      const bool                has_fall_region;
      std::set<Key>             named;
      std::set<std::string>     all_names, names_inside;
      // What must be refused, by name.
      std::map<std::string, Faces> without_cell, of_several_names, inside;
      Faces                        cut_outlet;
    };
  } // namespace



  template <int dim>
  void
  name_faces(Mesh<dim>                &mesh,
             const GmshMesh           &gmsh_mesh,
             const bool                outlet_is_open,
             std::vector<std::string> &warnings)
  {
    FaceNamer<dim>(mesh, outlet_is_open, warnings)
      .name(gmsh_mesh.elements[dim - 1]);
    settle_named_walls(mesh);
  }



#define INSTANTIATE(dim)                          \
  template void name_faces<dim>(Mesh<dim> &,      \
                                const GmshMesh &, \
                                const bool,       \
                                std::vector<std::string> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
