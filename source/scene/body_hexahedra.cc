#include <sandglass/scene/body_hexahedra.h>
#include <sandglass/scene/body_plan.h>
#include <sandglass/scene/body_plan_steps.h>

#include <algorithm>
#include <vector>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// Heights between layers, from the bottom of the fall region upwards.
    std::vector<double>
    layer_heights(const SiloBody &body, const Resolution &resolution)
    {
      const double        at_lip = resolution.smallest_size();
      const double        size   = resolution.element_size;
      std::vector<double> heights;
      const double        depth = body.fall_region_depth;
      const auto          below = graded_steps(depth, at_lip, size);
      for (auto share = below.rbegin(); share != below.rend(); ++share)
        heights.push_back(-*share * depth);
      const auto add =
        [&](const double bottom, const double top, const double first) {
          for (const double share : graded_steps(top - bottom, first, size))
            if (share > 0.)
              heights.push_back(bottom + share * (top - bottom));
        };
      if (body.has_hopper())
        add(0., body.hopper_height, at_lip);
      if (body.silo_height > body.hopper_height)
        add(body.hopper_height,
            body.silo_height,
            body.has_hopper() ? size : at_lip);
      return heights;
    }
  } // namespace



  Mesh<3>
  mesh_body_by_hexahedra(const SiloBody &body, const Resolution &resolution)
  {
    const BodyPlan            plan    = make_body_plan(body, resolution);
    const std::vector<double> heights = layer_heights(body, resolution);
    const unsigned int        n       = plan.at_wall.size();

    Mesh<3> mesh;
    mesh.cell_type = CellType::hexahedron;
    for (const double y : heights)
      for (unsigned int v = 0; v < n; ++v)
        {
          const double share =
            body.has_hopper() ? std::clamp(y / body.hopper_height, 0., 1.) : 1.;
          const Point<2> place =
            plan.at_outlet[v] + share * (plan.at_wall[v] - plan.at_outlet[v]);
          mesh.vertices.emplace_back(place[0], y, place[1]);
        }
    for (unsigned int layer = 0; layer + 1 < heights.size(); ++layer)
      for (unsigned int c = 0; c < plan.cells.size(); ++c)
        {
          const bool is_filled = heights[layer + 1] > body.rounding();
          if (!is_filled && !plan.is_over_outlet[c])
            continue;
          Mesh<3>::Cell cell{{}, is_filled};
          // Around the plan's cell x turns towards z, which is left-handed
          // about y: so the upper ring comes first.
          for (unsigned int v = 0; v < 4; ++v)
            {
              cell.vertices[v]     = (layer + 1) * n + plan.cells[c][v];
              cell.vertices[v + 4] = layer * n + plan.cells[c][v];
            }
          mesh.cells.push_back(cell);
        }
    return mesh;
  }
} // namespace Sandglass
