#ifndef sandglass_run_mesh_fingerprint_h
#define sandglass_run_mesh_fingerprint_h

#include <sandglass/scene/mesh.h>

#include <boost/serialization/string.hpp>

#include <cstddef>
#include <string>

namespace Sandglass
{
  /// What tells one mesh from another.
  struct MeshFingerprint
  {
    /// None.
    MeshFingerprint() = default;

    template <int dim>
    explicit MeshFingerprint(const Mesh<dim> &mesh);

    std::size_t n_cells = 0, n_vertices = 0;
    /// Numbers that differ where coordinates or cells do; where it does which
    /// cells are filled; and where it does which faces have a name, and which.
    std::size_t cells = 0, filling = 0, boundary = 0;
    /// These names, each with its number of faces.
    std::string boundary_names;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_cells &n_vertices &cells &filling &boundary &boundary_names;
    }
  };

  /**
   * Throws InputError, which says what of the mesh differs, unless the two are
   * of the same mesh.
   *
   * @param filename  of the checkpoint, for the message.
   */
  void
  refuse_changes(const MeshFingerprint &written,
                 const MeshFingerprint &now,
                 const std::string     &filename);
} // namespace Sandglass

#endif
