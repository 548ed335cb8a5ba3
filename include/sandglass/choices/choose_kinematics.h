#ifndef sandglass_choices_choose_kinematics_h
#define sandglass_choices_choose_kinematics_h

#include <sandglass/choices/all_kinematics.h>
#include <sandglass/continuum/formulation.h>

/**
 * @file
 * The choice among what cmake/choices.cmake lists, the one table of
 * compile-time choices: kinematics and cells.
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
