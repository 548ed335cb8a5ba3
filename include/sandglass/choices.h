#ifndef sandglass_choices_h
#define sandglass_choices_h

#include <sandglass/choices_table.h>
#include <sandglass/continuum/formulation.h>
#include <sandglass/material/material_constants.h>

#include <string>

/**
 * @file
 * The choice among what cmake/choices.cmake lists, the one table of
 * compile-time choices.
 */

namespace Sandglass
{
  /// Call `function(TypeTag<Kinematics>())` for the kinematics of a formulation
  /// in this dimension.
  template <int dim, typename Function>
  void
  choose_kinematics(const Formulation formulation, const Function &function)
  {
    choose(
      AllKinematics(),
      [formulation](const auto kinematics) {
        return decltype(kinematics)::Type::formulation == formulation;
      },
      [&function](const auto kinematics) {
        if constexpr (decltype(kinematics)::Type::dim == dim)
          function(kinematics);
      });
  }

  /// Call `function(TypeTag<CellTypeTag<…>>())` for a cell type of this
  /// dimension.
  template <int dim, typename Function>
  void
  choose_cell_type(const CellType cell_type, const Function &function)
  {
    choose(
      AllCellTypes(),
      [cell_type](const auto cells) {
        return decltype(cells)::Type::value == cell_type;
      },
      [&function](const auto cells) {
        if constexpr (decltype(cells)::Type::dim == dim)
          function(cells);
      });
  }

  /// The objective rate by which a law's stress turns; Jaumann's, unless the
  /// law says another one.
  template <typename Law>
  constexpr StressRate stress_rate_of = StressRate::jaumann;

  template <typename Law>
  constexpr StressRate stress_rate_of<GreenNaghdi<Law>> =
    StressRate::green_naghdi;

  /// Whether a law is for grids of this dimension; Green and Naghdi's rate is
  /// for the plane only.
  template <int dim, typename Law>
  constexpr bool is_law_in =
    dim == 2 || stress_rate_of<Law> == StressRate::jaumann;

  /// Call `function(TypeTag<Law>())` for the law that the constants ask for.
  /// @return whether there is one.
  template <typename Function>
  bool
  choose_law(const MaterialConstants &constants, const Function &function)
  {
    return choose(
      AllLaws(),
      [&constants](const auto law) {
        using Law = typename decltype(law)::Type;
        return Law::is_meant(constants) &&
               stress_rate_of<Law> == constants.stress_rate;
      },
      function);
  }

  /// The same for a law in this dimension.
  template <int dim, typename Function>
  bool
  choose_law_in(const MaterialConstants &constants, const Function &function)
  {
    bool is_found = false;
    choose_law(constants, [&](const auto law) {
      if constexpr (is_law_in<dim, typename decltype(law)::Type>)
        {
          function(law);
          is_found = true;
        }
    });
    return is_found;
  }

  /// Volume that a unit of the grid stands for at a position, for who knows the
  /// formulation at run time only; see the kinematics' own measure().
  template <int dim, typename Position>
  double
  measure(const Formulation formulation, const Position &position)
  {
    double result = 0.;
    choose_kinematics<dim>(formulation, [&](const auto kinematics) {
      result = decltype(kinematics)::Type::measure(position);
    });
    return result;
  }
} // namespace Sandglass

#endif
