#include <deal.II/base/numbers.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/feed_cells.h>
#include <sandglass/scene/fill_surface.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/section_surface_nodes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Where material is in a mesh that it fills to the top.
    template <int dim>
    SiloExtent
    extent_of_material(const Mesh<dim> &mesh)
    {
      double left  = std::numeric_limits<double>::max();
      double right = std::numeric_limits<double>::lowest();
      double top   = std::numeric_limits<double>::lowest();
      for (const auto &cell : mesh.cells)
        if (cell.is_filled)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            {
              const auto &vertex = mesh.vertices[cell.vertices[v]];
              left               = std::min(left, vertex[0]);
              right              = std::max(right, vertex[0]);
              top                = std::max(top, vertex[1]);
            }
      const bool has_axis =
        std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const auto &face) {
          return face.role == BoundaryRole::axis;
        });
      const double middle = has_axis ? 0. : (left + right) / 2.;
      return {middle, right - middle, top};
    }



    /// The faces between cells that are filled and cells that are so no longer.
    template <int dim>
    std::vector<FaceKey<dim>>
    surface_faces(const Mesh<dim>         &mesh,
                  const CellsAtFaces<dim> &cells_at,
                  const std::vector<bool> &was_filled)
    {
      std::vector<FaceKey<dim>> faces;
      for (const auto &[face, cells] : cells_at)
        if (cells.size() == 2 && was_filled[cells[0]] && was_filled[cells[1]] &&
            mesh.cells[cells[0]].is_filled != mesh.cells[cells[1]].is_filled)
          faces.push_back(face);
      return faces;
    }



    template <int dim>
    std::set<unsigned int>
    nodes_of(const Mesh<dim> &mesh, const std::vector<FaceKey<dim>> &faces)
    {
      std::set<unsigned int> nodes;
      for (const FaceKey<dim> &face : faces)
        nodes.insert(face.begin(), face.begin() + mesh.vertices_per_face());
      return nodes;
    }



    /// Empty filled cells, and fill empty ones, that have no other nodes than
    /// the surface's; returns whether there were any.
    template <int dim>
    bool
    cut_teeth(Mesh<dim>                    &mesh,
              const std::vector<bool>      &was_filled,
              const std::set<unsigned int> &nodes)
    {
      bool has_cut = false;
      for (unsigned int i = 0; i < mesh.cells.size(); ++i)
        {
          auto &cell = mesh.cells[i];
          if (was_filled[i] &&
              std::all_of(cell.vertices.begin(),
                          cell.vertices.begin() + mesh.vertices_per_cell(),
                          [&nodes](const unsigned int vertex) {
                            return nodes.count(vertex) > 0;
                          }))
            {
              cell.is_filled = !cell.is_filled;
              has_cut        = true;
            }
        }
      return has_cut;
    }
  } // namespace



  bool
  is_full(const SceneParameters &parameters)
  {
    return !parameters.fill_height && parameters.surface_slope == 0.;
  }



  void
  refuse_fill_height(const SceneParameters &parameters,
                     const std::string     &allowed)
  {
    throw InputError("Scene",
                     "Fill height",
                     parameters.fill_height ?
                       number_text(*parameters.fill_height) :
                       "full",
                     allowed);
  }



  template <int dim>
  FillSurface<dim>::FillSurface(const SiloExtent      &silo,
                                const SceneParameters &parameters)
    : middle(silo.middle)
    , slope(std::tan(parameters.surface_slope * dealii::numbers::PI / 180.))
  {
    // Of a line, or of a circle
    const double mean_distance =
      silo.mean_distance > 0. ? silo.mean_distance :
      dim == 3 || parameters.formulation == Formulation::axisymmetric ?
                                2. / 3. * silo.width :
                                silo.width / 2.;
    apex = parameters.fill_height.value_or(silo.top) + slope * mean_distance;

    constexpr double rounding = 1e-9;
    if (apex > silo.top + rounding * silo.width)
      {
        std::ostringstream allowed;
        allowed << "the surface must lie below the silo's top at " << silo.top
                << " m: allowed are at most "
                << silo.top - slope * mean_distance << " m";
        if (slope > 0.)
          allowed << " with this Surface slope, whose apex is "
                  << slope * mean_distance << " m above the Fill height";
        refuse_fill_height(parameters, allowed.str());
      }
  }



  template <int dim>
  double
  FillSurface<dim>::distance(const dealii::Point<dim> &place) const
  {
    double square = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      if (d != 1)
        square += (place[d] - (d == 0 ? middle : 0.)) *
                  (place[d] - (d == 0 ? middle : 0.));
    return std::sqrt(square);
  }



  template <int dim>
  double
  FillSurface<dim>::height(const dealii::Point<dim> &place) const
  {
    return apex - slope * distance(place);
  }



  template <int dim>
  void
  fill_to_surface(Mesh<dim> &mesh, const SceneParameters &parameters)
  {
    if (is_full(parameters) || parameters.shape == SceneParameters::Shape::silo)
      return;
    const FillSurface<dim> surface(extent_of_material(mesh), parameters);
    bool                   has_material = false;
    std::vector<bool>      was_filled;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        bool &is_filled = mesh.cells[cell].is_filled;
        was_filled.push_back(is_filled);
        const auto place = middle_of_cell(mesh, cell);
        is_filled        = is_filled && place[1] < surface.height(place);
        has_material     = has_material || is_filled;
      }
    if (!has_material)
      refuse_fill_height(
        parameters,
        "no cell lies below the surface: allowed is a level in the "
        "silo, above its outlet");

    // A triangle between surface nodes alone could only be made flat.
    constexpr unsigned int  most_rounds = 10;
    const CellsAtFaces<dim> cells_at    = cells_at_faces(mesh);
    auto                    faces = surface_faces(mesh, cells_at, was_filled);
    for (unsigned int round = 0;
         is_simplex(mesh.cell_type) && round < most_rounds;
         ++round)
      {
        const std::set<unsigned int> nodes = nodes_of(mesh, faces);
        if (!cut_teeth(mesh, was_filled, nodes))
          break;
        faces = surface_faces(mesh, cells_at, was_filled);
      }
    for (const FaceKey<dim> &face : faces)
      mesh.faces.push_back({face, BoundaryRole::top});
    const std::set<unsigned int> nodes = nodes_of(mesh, faces);
    if constexpr (dim == 2)
      move_surface_nodes(mesh, nodes, [&surface](const double x) {
        return surface.height({x, 0.});
      });
  }



#define INSTANTIATE(dim)           \
  template class FillSurface<dim>; \
  template void fill_to_surface<dim>(Mesh<dim> &, const SceneParameters &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
