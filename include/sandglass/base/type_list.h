#ifndef sandglass_base_type_list_h
#define sandglass_base_type_list_h

#include <string>
#include <utility>

namespace Sandglass
{
  /// Types among which a run chooses one.
  template <typename... Types>
  struct TypeList
  {};

  /// Stands for a type as an argument of a function.
  template <typename T>
  struct TypeTag
  {
    using Type = T;
  };

  /**
   * Call `function(TypeTag<T>())` for the first type T of the list for which
   * `is_chosen(TypeTag<T>())` holds.
   *
   * @return whether there was one.
   */
  template <typename... Types, typename IsChosen, typename Function>
  bool
  choose(TypeList<Types...>, const IsChosen &is_chosen, const Function &function)
  {
    return ((is_chosen(TypeTag<Types>()) &&
             (function(TypeTag<Types>()), true)) ||
            ...);
  }

  /// The types' names, with | between them, as a pattern of values asks for.
  template <typename... Types>
  std::string
  names_of(TypeList<Types...>)
  {
    std::string names;
    ((names += (names.empty() ? "" : "|") + std::string(Types::name)), ...);
    return names;
  }
} // namespace Sandglass

#endif
