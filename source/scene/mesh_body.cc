#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_hexahedra.h>
#include <sandglass/scene/body_surface.h>
#include <sandglass/scene/body_tetrahedra.h>
#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/gmsh_options.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/name_body_faces.h>

#include <gmsh.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    Mesh<3>
    mesh_by_gmsh(const SceneParameters &parameters, const SiloBody &body)
    {
      GmshSession session;
      try
        {
          call_gmsh([&parameters]() { set_gmsh_options(parameters); });
          return mesh_body_by_tetrahedra(body, parameters.resolution());
        }
      catch (const std::exception &error)
        {
          throw InputError("Gmsh can't mesh the silo (" +
                             std::string(error.what()) +
                             "); try another Element size, Mesh algorithm or "
                             "Mesh seed",
                           "Scene",
                           "Element size");
        }
    }

    /// Those of cells that have been left out.
    void
    leave_out_faces_without_cell(Mesh<3> &mesh)
    {
      const CellsAtFaces<3> cells_at = cells_at_faces(mesh);
      const unsigned int    n        = mesh.vertices_per_face();
      mesh.faces.erase(std::remove_if(mesh.faces.begin(),
                                      mesh.faces.end(),
                                      [&](const Mesh<3>::Face &face) {
                                        return cells_at.count(
                                                 key_of<3>(face.vertices, n)) ==
                                               0;
                                      }),
                       mesh.faces.end());
    }
  } // namespace



  template <>
  double
  space_above<3>(const SceneParameters &parameters)
  {
    return parameters.shape == SceneParameters::Shape::silo ?
             parameters.silo_height() -
               parameters.fill_height.value_or(parameters.silo_height()) :
             0.;
  }



  template <>
  Mesh<3>
  mesh_silo<3>(const SceneParameters &parameters)
  {
    const SiloBody body = filled_part(SiloBody(parameters), parameters);
    Mesh<3>        mesh = parameters.cell_type == CellType::tetrahedron ?
                            mesh_by_gmsh(parameters, body) :
                            mesh_body_by_hexahedra(body, parameters.resolution());
    orient_cells(mesh);
    name_body_faces(mesh, body);
    if (!parameters.outlet_is_open)
      {
        leave_out_fall_region(mesh);
        leave_out_faces_without_cell(mesh);
      }
    move_to_surface(mesh, body, parameters);
    return mesh;
  }
} // namespace Sandglass
