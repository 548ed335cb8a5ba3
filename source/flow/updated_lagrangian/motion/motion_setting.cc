#include <sandglass/base/exceptions.h>
#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/flow/updated_lagrangian/motion/motion_setting.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Edge of an equilateral triangle of the filled cells' mean area.
    double
    mean_size(const Mesh<2> &mesh)
    {
      double       area = 0.;
      unsigned int n    = 0;
      for (const auto &cell : mesh.cells)
        if (cell.is_filled)
          {
            const Tensor<1, 2> a =
              mesh.vertices[cell.vertices[1]] - mesh.vertices[cell.vertices[0]];
            const Tensor<1, 2> b =
              mesh.vertices[cell.vertices[2]] - mesh.vertices[cell.vertices[0]];
            area += std::abs(a[0] * b[1] - a[1] * b[0]) / 2.;
            ++n;
          }
      return std::sqrt(4. / std::sqrt(3.) * area / std::max(n, 1u));
    }



    void
    refuse(const std::string &section,
           const std::string &name,
           const std::string &value,
           const std::string &allowed)
    {
      throw InputError(section,
                       name,
                       value,
                       "allowed with Flow/Method = updated Lagrangian is " +
                         allowed);
    }
  } // namespace



  MotionSetting::MotionSetting(const Scene<2>                    &scene,
                               const MaterialParameters          &material,
                               const WallParameters              &walls,
                               const UpdatedLagrangianParameters &parameters,
                               const StaticStageParameters &static_parameters)
    : scene(scene)
    , material(material)
    , wall_parameters(walls)
    , parameters(parameters)
    , static_parameters(static_parameters)
    , walls(find_rigid_walls(scene))
    , depth([formulation = scene.formulation](const Point<2> &p) {
      return measure<2>(formulation, p);
    })
    , element_size(mean_size(scene.mesh))
    , lowest_level(scene.fill_bottom)
  {
    if (scene.mesh.cell_type != CellType::triangle)
      refuse("Scene", "Cell type", "quadrilateral", "triangle");
    if (walls.box_depth > 0.)
      refuse("Walls", "Box depth", std::to_string(walls.box_depth), "0");
    for (const Wall<2> &wall : scene.walls)
      if (wall.velocity.norm() > 0.)
        refuse("Walls", "Velocities", wall.name, "none: walls are at rest");
    for (const Point<2> &vertex : scene.mesh.vertices)
      lowest_level = std::min(lowest_level, vertex[1]);
  }
} // namespace Sandglass
