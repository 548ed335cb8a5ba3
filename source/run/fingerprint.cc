#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/run/declared_parameters.h>
#include <sandglass/run/fingerprint.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    struct FreeParameter
    {
      const char *section, *name;
    };

    /**
     * The parameters that may change on a restart, since what has been computed
     * stays right: what is written, how far and with which steps the run goes
     * on, who computes it, and what isn't a run's at all. A parameter that is
     * not listed may not.
     *
     * Stagnant displacement is not: it says what a column of history.csv means,
     * and whether there is one. Nor are Residence and Gauges, whose files have
     * to be there from the start.
     */
    constexpr FreeParameter free_parameters[] = {
      {"Scene", "Partitioner"},
      {"Scene", "Mesh file"}, // the mesh has a fingerprint
      {"Particle stage", "End time"},
      {"Particle stage", "Time step"},
      {"Particle stage", "Time step safety"},
      {"Particle stage", "Time step interval"},
      {"Particle stage", "On lost particle"},
      {"Particle stage", "Largest speed"},
      {"Updated Lagrangian stage", "Time step"},
      {"Stop", "When empty"},
      {"Stop", "Discharged mass"},
      {"Stop", "Steady within"},
      {"Stop", "Steady time"},
      {"Element test", "Kind"},
      {"Element test", "Initial stress"},
      {"Element test", "Axial strain"},
      {"Element test", "Largest axial stress"},
      {"Element test", "Steps"},
      {"Element test", "Strain rate"},
      {"Output", "Directory"},
      {"Output", "Interval"},
      {"Output", "History interval"},
      {"Output", "Flow rate window"},
      {"Output", "Particles"},
      {"Output", "Grid"},
      {"Output", "Walls"},
      {"Output", "Janssen lateral pressure ratio"},
      {"Output", "Patch load factor"},
      {"Output", "Progress interval"},
      {"Output", "Checkpoint interval"}};



    /// Its words, numbers among them in one way of writing them.
    std::vector<std::string>
    words_of(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ' ');
      std::istringstream       stream(text);
      std::vector<std::string> words;
      for (std::string word; stream >> word;)
        {
          char        *end    = nullptr;
          const double number = std::strtod(word.c_str(), &end);
          if (*end == '\0')
            {
              std::ostringstream same_number;
              same_number << std::hexfloat << number;
              word = same_number.str();
            }
          words.push_back(word);
        }
      return words;
    }



    [[noreturn]] void
    refuse_setting(const std::string          &filename,
                   const Fingerprint::Setting &now,
                   const std::string          &written_value,
                   const std::string          &present_value)
    {
      throw InputError("--restart: '" + filename + "' was written with " +
                         now.section + '/' + now.name + " = " + written_value +
                         ", and now it is " + present_value +
                         "; allowed are the settings of the checkpoint, apart "
                         "from times and output",
                       now.section,
                       now.name);
    }



    /// Refuse the first of some settings that others lack, or have with another
    /// value.
    template <typename Refuse>
    void
    refuse_first(const std::vector<Fingerprint::Setting> &settings,
                 const std::vector<Fingerprint::Setting> &others,
                 const Refuse                            &refuse)
    {
      for (const Fingerprint::Setting &setting : settings)
        {
          if (is_free_on_restart(setting.section, setting.name))
            continue;
          const auto other =
            std::find_if(others.begin(),
                         others.end(),
                         [&setting](const Fingerprint::Setting &candidate) {
                           return candidate.section == setting.section &&
                                  candidate.name == setting.name;
                         });
          if (other == others.end())
            refuse(setting, "none, by another version of Sandglass");
          else if (words_of(other->value) != words_of(setting.value))
            refuse(setting, other->value);
        }
    }
  } // namespace



  template <int dim>
  Fingerprint::Fingerprint(const dealii::ParameterHandler &prm,
                           const Mesh<dim>                &mesh)
    : mesh(mesh)
  {
    for (const DeclaredParameter &parameter : declared_parameters(prm))
      settings.push_back({parameter.section, parameter.name, parameter.value});
  }



  bool
  is_free_on_restart(const std::string &section, const std::string &name)
  {
    return std::any_of(std::begin(free_parameters),
                       std::end(free_parameters),
                       [&](const FreeParameter &parameter) {
                         return section == parameter.section &&
                                name == parameter.name;
                       });
  }



  void
  refuse_changes(const Fingerprint &written,
                 const Fingerprint &now,
                 const std::string &filename)
  {
    refuse_first(now.settings,
                 written.settings,
                 [&](const auto &setting, const std::string &written_value) {
                   refuse_setting(filename,
                                  setting,
                                  written_value,
                                  setting.value);
                 });
    // What is left are parameters that exist no longer.
    refuse_first(written.settings,
                 now.settings,
                 [&](const auto &setting, const std::string &present_value) {
                   refuse_setting(filename,
                                  setting,
                                  setting.value,
                                  present_value);
                 });
    refuse_changes(written.mesh, now.mesh, filename);
  }



#define INSTANTIATE(dim)                                              \
  template Fingerprint::Fingerprint(const dealii::ParameterHandler &, \
                                    const Mesh<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
