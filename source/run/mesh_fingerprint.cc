#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/run/mesh_fingerprint.h>

#include <boost/functional/hash.hpp>

#include <map>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    std::size_t
    hash_cells(const Mesh<dim> &mesh)
    {
      std::size_t seed = 0;
      boost::hash_combine(seed, static_cast<unsigned int>(mesh.cell_type));
      for (const auto &vertex : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          boost::hash_combine(seed, vertex[d]);
      for (const auto &cell : mesh.cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          boost::hash_combine(seed, cell.vertices[v]);
      return seed;
    }



    template <int dim>
    std::size_t
    hash_filling(const Mesh<dim> &mesh)
    {
      std::size_t seed = 0;
      for (const auto &cell : mesh.cells)
        boost::hash_combine(seed, cell.is_filled);
      return seed;
    }



    template <int dim>
    std::size_t
    hash_boundary(const Mesh<dim> &mesh)
    {
      std::size_t seed = 0;
      for (const auto &face : mesh.faces)
        {
          for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
            boost::hash_combine(seed, face.vertices[v]);
          boost::hash_combine(seed, mesh.name_of(face));
        }
      return seed;
    }



    std::string
    describe(const MeshFingerprint &mesh)
    {
      std::ostringstream text;
      text << mesh.n_cells << " cells, " << mesh.n_vertices
           << " nodes, fingerprint " << std::hex << mesh.cells;
      return text.str();
    }



    /// The names of the boundary's parts, each with its number of edges.
    template <int dim>
    std::string
    count_faces_by_name(const Mesh<dim> &mesh)
    {
      std::map<std::string, unsigned int> count;
      for (const auto &face : mesh.faces)
        ++count[mesh.name_of(face)];
      std::ostringstream text;
      for (const auto &[name, n] : count)
        text << (text.tellp() > 0 ? ", " : "") << name << ' ' << n;
      text << " edges";
      return text.str();
    }



    [[noreturn]] void
    refuse(const std::string &filename,
           const std::string &written,
           const std::string &now)
    {
      throw InputError("--restart: '" + filename + "' was written with " +
                         written + ", and now it is " + now +
                         "; allowed is the mesh of the checkpoint",
                       "Scene",
                       "Mesh file");
    }
  } // namespace



  template <int dim>
  MeshFingerprint::MeshFingerprint(const Mesh<dim> &mesh)
    : n_cells(mesh.cells.size())
    , n_vertices(mesh.vertices.size())
    , cells(hash_cells(mesh))
    , filling(hash_filling(mesh))
    , boundary(hash_boundary(mesh))
    , boundary_names(count_faces_by_name(mesh))
  {}



  void
  refuse_changes(const MeshFingerprint &written,
                 const MeshFingerprint &now,
                 const std::string     &filename)
  {
    if (written.cells != now.cells)
      refuse(filename, "Scene/mesh = " + describe(written), describe(now));
    if (written.filling != now.filling)
      refuse(filename,
             "the cells of Scene/mesh filled in another way",
             "others belong to the group material");
    if (written.boundary != now.boundary)
      refuse(filename,
             "the boundary of Scene/mesh = " + written.boundary_names,
             written.boundary_names == now.boundary_names ?
               "as many edges elsewhere" :
               now.boundary_names);
  }



#define INSTANTIATE(dim) \
  template MeshFingerprint::MeshFingerprint(const Mesh<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
