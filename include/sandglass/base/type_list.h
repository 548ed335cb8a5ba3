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
  choose(TypeList<Types...>,
         const IsChosen &is_chosen,
         const Function &function)
  {
    return (
      (is_chosen(TypeTag<Types>()) && (function(TypeTag<Types>()), true)) ||
      ...);
  }

  /// What `text(TypeTag<T>())` says of each type T, with `separator` between.
  template <typename... Types, typename Text>
  std::string
  join(TypeList<Types...>, const std::string &separator, const Text &text)
  {
    std::string all;
    ((all += (all.empty() ? "" : separator) + text(TypeTag<Types>())), ...);
    return all;
  }
} // namespace Sandglass

#endif
