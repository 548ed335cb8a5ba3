#ifndef sandglass_run_fingerprint_h
#define sandglass_run_fingerprint_h

#include <deal.II/base/parameter_handler.h>

#include <sandglass/run/mesh_fingerprint.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Sandglass
{
  /// All that a run's results depend on.
  struct Fingerprint
  {
    /// A parameter as text.
    struct Setting
    {
      std::string section, name, value;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &section &name &value;
      }
    };

    /// Nothing.
    Fingerprint() = default;

    /// @param prm  all its parameters, with the values that are used.
    template <int dim>
    Fingerprint(const dealii::ParameterHandler &prm, const Mesh<dim> &mesh);

    std::vector<Setting> settings;
    MeshFingerprint      mesh;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &settings &mesh;
    }
  };

  /// Whether a parameter may change on a restart.
  bool
  is_free_on_restart(const std::string &section, const std::string &name);

  /**
   * Throws InputError, which names the parameter or the part of the mesh,
   * unless the results with `now` can go on those with `written`: all
   * parameters are equal but those that are free to change on a restart.
   *
   * @param filename  of the checkpoint, for the message.
   */
  void
  refuse_changes(const Fingerprint &written,
                 const Fingerprint &now,
                 const std::string &filename);
} // namespace Sandglass

#endif
