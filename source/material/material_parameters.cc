#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/choices/choose_law.h>
#include <sandglass/material/material_parameters.h>

#include <set>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// What `text(TypeTag<Law>())` says of each name of a law once.
    template <typename... Laws, typename Text>
    std::string
    join_by_name(TypeList<Laws...>,
                 const std::string &separator,
                 const Text        &text)
    {
      std::string           all;
      std::set<std::string> names;
      const auto            add = [&](const auto law) {
        const std::string one = text(law);
        if (names.insert(decltype(law)::Type::name).second && !one.empty())
          all += (all.empty() ? "" : separator) + one;
      };
      (add(TypeTag<Laws>()), ...);
      return all;
    }



    template <typename Law>
    std::string
    constants_of(const TypeTag<Law>)
    {
      std::ostringstream text;
      for (const LawConstant &constant : Law::law_constants)
        text << (text.tellp() > 0 ? ", " : std::string(Law::name) + ": ")
             << constant.name << " (" << constant.meaning << "; "
             << constant.unit << "; " << constant.default_value << ")";
      return text.str();
    }



    /// Throws InputError unless the law has these constants within their
    /// bounds.
    template <typename Law>
    void
    check_constants(const NamedNumbers &given)
    {
      std::string names;
      for (const LawConstant &constant : Law::law_constants)
        names += (names.empty() ? "" : ", ") + std::string(constant.name);
      for (const auto &one : given)
        {
          const LawConstant *found = nullptr;
          for (const LawConstant &constant : Law::law_constants)
            if (one.first == constant.name)
              found = &constant;
          if (found == nullptr)
            throw InputError("Material",
                             "Law constants",
                             to_text(one),
                             "the law '" + std::string(Law::name) + "' has " +
                               (names.empty() ? "no constants of its own" :
                                                "the constants " + names));
          if (!(one.second[0] >= found->smallest &&
                one.second[0] <= found->largest))
            throw InputError("Material",
                             "Law constants",
                             to_text(one),
                             "allowed is a number from " +
                               number_text(found->smallest) + " to " +
                               number_text(found->largest) + " (" +
                               found->unit + ")");
        }
    }



    class Declaration
    {
    public:
      explicit Declaration(MaterialParameters &section)
        : section(section)
      {}

      void
      add_all()
      {
        add_laws();
        add_elasticity_and_friction();
        add_law_constants();
        add_umat();
      }

    private:
      using Bounds = BoundedNumber;

      void
      add_laws()
      {
        const auto name = [](const auto law) -> std::string {
          return decltype(law)::Type::name;
        };
        const auto description = [](const auto law) -> std::string {
          return decltype(law)::Type::description;
        };
        add_text(section,
                 "Model",
                 section.model,
                 Patterns::Selection(join_by_name(AllLaws(), "|", name)),
                 "Constitutive law: " +
                   join_by_name(AllLaws(), "; ", description) + ".");
      }

      void
      add_elasticity_and_friction()
      {
        add_number(section,
                   "Density",
                   section.density,
                   Bounds::greater_than(0.),
                   "kg/m^3",
                   "Bulk density of the unstressed material.");
        add_number(section,
                   "Young modulus",
                   section.young_modulus,
                   Bounds::greater_than(0.),
                   "Pa",
                   "Elastic stiffness; the time step goes with its inverse "
                   "root.");
        add_number(section,
                   "Poisson ratio",
                   section.poisson_ratio,
                   Bounds::at_least_below(0., 0.5),
                   "1",
                   "Poisson ratio.");
        add_number(section,
                   "Internal friction angle",
                   section.internal_friction_angle,
                   Bounds::at_least_below(0., 90.),
                   "degrees",
                   "Angle phi of internal friction; what it means is said by "
                   "Yield cone.");
        add_selection<YieldCone>(
          section,
          "Yield cone",
          section.yield_cone,
          {{"Matsuoka-Nakai", YieldCone::matsuoka_nakai},
           {"plane strain", YieldCone::plane_strain},
           {"compression", YieldCone::compression},
           {"paper", YieldCone::paper}},
          "Where the friction angle acts as it is typed: in triaxial "
          "compression and extension (Matsuoka-Nakai); in plane flow (plane "
          "strain, slope sqrt(3) sin(phi)); in triaxial compression "
          "(compression, slope 6 sin(phi) / (3 - sin(phi))); nowhere (paper, "
          "slope 18 sin(phi) / (9 - sin(phi)^2)). Of the law Drucker-Prager.");
        add_number(section,
                   "Cohesion",
                   section.cohesion,
                   Bounds::at_least(0.),
                   "Pa",
                   "Shear strength c without pressure; tension is cut off at a "
                   "pressure of -c cot(phi), at most -2 c.");
      }

      void
      add_law_constants()
      {
        add_number(section,
                   "Void ratio",
                   section.void_ratio,
                   Bounds::greater_than(0.),
                   "1",
                   "Volume of the voids over that of the grains in the "
                   "unstressed material, of laws that have one.");
        const auto constants = [](const auto law) { return constants_of(law); };
        add_named_numbers(section,
                          "Law constants",
                          section.given_law_constants,
                          NamedNumbersPattern(Bounds::any()),
                          "as said",
                          "Constants by name, for example \"phi_2: 33, d: "
                          "0.002\"; those left out keep their defaults. " +
                            join_by_name(AllLaws(), ". ", constants) + ".");
        add_selection<StressRate>(section,
                                  "Stress rate",
                                  section.stress_rate,
                                  {{"Jaumann", StressRate::jaumann},
                                   {"Green-Naghdi", StressRate::green_naghdi}},
                                  "Objective stress rate. Green-Naghdi's, of "
                                  "the law Drucker-Prager, costs four more "
                                  "numbers a particle; in large elastic shear "
                                  "stress does not oscillate with it.");
      }

      void
      add_umat()
      {
        add_text(section,
                 "UMAT library",
                 section.umat_library,
                 Patterns::Anything(),
                 "Shared library with the user-material subroutine of the law "
                 "UMAT.");
        section.add_parameter("UMAT constants",
                              section.umat_constants,
                              "Numbers that the subroutine gets (PROPS), in "
                              "its order, with commas between.",
                              section.prm,
                              Patterns::List(Patterns::Double(), 0, 1000));
        add_integer(section,
                    "UMAT state variables",
                    section.n_umat_state_variables,
                    0,
                    Umat::max_state_variables,
                    "How many numbers the subroutine keeps (STATEV).");
      }

      MaterialParameters &section;
    };
  } // namespace



  MaterialParameters::MaterialParameters()
    : ParameterAcceptor("Material")
  {
    Declaration(*this).add_all();
  }



  void
  MaterialParameters::check()
  {
    law_constants.clear();
    for (const auto &[name, numbers] : given_law_constants)
      law_constants[name] = numbers[0];
    const bool is_offered = choose_law(*this, [this](const auto law) {
      using Law = typename decltype(law)::Type;
      check_constants<Law>(given_law_constants);
      if (cohesion > 0. && !Law::has_cohesion)
        throw InputError("Material",
                         "Cohesion",
                         number_text(cohesion),
                         "the law '" + model + "' has none; allowed is 0");
      // The law's own complaints come before anything is written.
      Law(static_cast<const MaterialConstants &>(*this));
    });
    if (!is_offered)
      throw InputError("Material",
                       "Stress rate",
                       "Green-Naghdi",
                       "the law '" + model + "' is offered with Jaumann only");
  }



  double
  MaterialParameters::wave_speed() const
  {
    double result = 0.;
    choose_law(*this, [&](const auto law) {
      using Law = typename decltype(law)::Type;
      if constexpr (Law::has_constant_stiffness)
        result = Law(static_cast<const MaterialConstants &>(*this))
                   .stiffness_bound()
                   .wave_speed(density);
    });
    return result;
  }
} // namespace Sandglass
