#include <sandglass/base/exceptions.h>
#include <sandglass/output/checkpoint.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/replace_file.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/functional/hash.hpp>

#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// To be raised whenever what serialize() writes changes.
    const Checkpoint::Setting format = {"", "checkpoint format", "5"};



    /// A number that differs when any coordinate, cell or edge does.
    std::size_t
    fingerprint(const Mesh &mesh)
    {
      std::size_t seed = 0;
      for (const auto &vertex : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          boost::hash_combine(seed, vertex[d]);
      for (const auto &cell : mesh.cells)
        boost::hash_range(seed, cell.vertices.begin(), cell.vertices.end());
      return seed;
    }



    std::string
    describe(const Mesh &mesh)
    {
      std::ostringstream text;
      text << mesh.cells.size() << " cells, " << mesh.vertices.size()
           << " nodes, fingerprint " << std::hex << fingerprint(mesh);
      return text.str();
    }



    [[noreturn]] void
    refuse(const std::string         &filename,
           const Checkpoint::Setting &written,
           const Checkpoint::Setting &now)
    {
      const std::string name =
        (now.section.empty() ? "" : now.section + '/') + now.name;
      throw InputError("--restart: '" + filename + "' was written with " +
                         name + " = " + written.value + ", and now it is " +
                         now.value +
                         "; allowed are the settings of the checkpoint, apart "
                         "from times and output",
                       now.section,
                       now.name);
    }
  } // namespace



  std::vector<Checkpoint::Setting>
  checkpoint_settings(const Scene                   &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &particle_stage)
  {
    const auto flag = [](const bool value) {
      return std::string(value ? "true" : "false");
    };
    const auto choice = [](const std::vector<std::string> &names,
                           const auto                      value) {
      const auto index = static_cast<unsigned int>(value);
      return index < names.size() ? names[index] :
                                    "choice " + std::to_string(index);
    };
    return {
      format,
      {"Scene",
       "Formulation",
       choice({"plane strain", "axisymmetric"}, scene.formulation)},
      {"Scene",
       "Cell type",
       choice({"triangle", "quadrilateral"}, scene.mesh.cell_type)},
      {"Scene", "mesh", describe(scene.mesh)},
      {"Scene", "Particles per cell", std::to_string(scene.particles_per_cell)},
      {"Scene",
       "Gravity",
       to_text(scene.gravity[0]) + ", " + to_text(scene.gravity[1])},
      {"Material", "Model", choice({"Drucker-Prager"}, material.model)},
      {"Material", "Density", to_text(material.density)},
      {"Material", "Young modulus", to_text(material.young_modulus)},
      {"Material", "Poisson ratio", to_text(material.poisson_ratio)},
      {"Material",
       "Internal friction angle",
       to_text(material.internal_friction_angle)},
      {"Material", "Stress rate", choice({"Jaumann"}, material.stress_rate)},
      {"Walls", "Friction angle", to_text(walls.friction_angle)},
      {"Walls", "Tangential penalty", to_text(walls.tangential_penalty)},
      {"Walls", "Penalty limit", to_text(walls.penalty_limit)},
      {"Walls",
       "Normal condition",
       choice({"velocity", "acceleration"}, walls.normal_condition)},
      {"Walls",
       "Friction update",
       choice({"return mapping", "velocity sign"}, walls.friction_update)},
      {"Walls", "Fix bottom corner", flag(walls.fix_bottom_corner)},
      {"Walls", "Outlet lip", choice({"floor", "free"}, walls.outlet_lip)},
      {"Particle stage",
       "Consistent mass share",
       to_text(particle_stage.consistent_mass_share)},
      {"Particle stage",
       "Stress integration",
       choice({"start of step", "middle of step"},
              particle_stage.stress_integration)},
      {"Particle stage",
       "Volumetric strain",
       choice({"element", "averaged"}, particle_stage.volumetric_strain)},
      {"Particle stage",
       "Density update",
       choice({"paper", "constant", "floor", "separation"},
              particle_stage.density_update)},
      {"Particle stage",
       "Force integration",
       choice({"particles", "cell"}, particle_stage.force_integration)},
      {"Particle stage",
       "Split particles",
       choice({"never", "where needed", "always"},
              particle_stage.split_particles)}};
  }



  std::string
  checkpoint_file(const std::string &directory)
  {
    return directory + "/checkpoint.bin";
  }



  void
  write_checkpoint(const std::string                      &directory,
                   const std::vector<Checkpoint::Setting> &settings,
                   const Checkpoint                       &checkpoint)
  {
    std::ostringstream content;
    {
      boost::archive::binary_oarchive archive(content);
      archive << settings << checkpoint;
    }
    replace_file(checkpoint_file(directory), content.str());
  }



  Checkpoint
  read_checkpoint(const std::string                      &directory,
                  const std::vector<Checkpoint::Setting> &settings)
  {
    const std::string filename = checkpoint_file(directory);
    std::ifstream     file(filename, std::ios::binary);
    if (!file)
      throw InputError("--restart: there is no '" + filename +
                         "'; allowed is the output directory of a run with a "
                         "Checkpoint interval greater than 0",
                       "Output",
                       "Directory");
    std::vector<Checkpoint::Setting> written;
    Checkpoint                       checkpoint;
    try
      {
        boost::archive::binary_iarchive archive(file);
        archive >> written;
        for (unsigned int i = 0; i < settings.size(); ++i)
          if (i >= written.size() || written[i].name != settings[i].name)
            throw InputError("--restart: '" + filename +
                             "' is of another version of Sandglass");
          else if (written[i].value != settings[i].value)
            refuse(filename, written[i], settings[i]);
        archive >> checkpoint;
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::exception &error)
      {
        throw InputError("--restart: '" + filename + "' can't be read (" +
                           error.what() + "); run again without --restart",
                         "Output",
                         "Directory");
      }
    return checkpoint;
  }
} // namespace Sandglass
