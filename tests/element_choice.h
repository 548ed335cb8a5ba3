#ifndef sandglass_tests_element_choice_h
#define sandglass_tests_element_choice_h

#include <sandglass/flow/updated_lagrangian/element_grid.h>

#include <gtest/gtest.h>

#include <array>
#include <string>

/// The finite elements that an ElementGrid can have.
struct ElementChoice
{
  Sandglass::CellType cell_type;
  unsigned int        order;
};

inline const std::array<ElementChoice, 3> all_elements = {
  {{Sandglass::CellType::triangle, 1},
   {Sandglass::CellType::quadrilateral, 1},
   {Sandglass::CellType::triangle, 2}}};

inline std::string
name_of(const ElementChoice &element)
{
  return std::string(element.order == 2 ? "quadratic_" : "linear_") +
         (element.cell_type == Sandglass::CellType::triangle ?
            "triangles" :
            "quadrilaterals");
}

/// For tests' names.
inline std::string
element_name(const testing::TestParamInfo<ElementChoice> &info)
{
  return name_of(info.param);
}

/// Call `function(position, {degrees of freedom of x and y})` for the nodes of
/// all cells, for most more than once; before any displacement.
template <typename Function>
void
for_each_node(const Sandglass::ElementGrid<2> &grid, const Function &function)
{
  using namespace dealii;
  std::vector<types::global_dof_index> dofs(
    grid.finite_element.n_dofs_per_cell());
  for (const auto &cell : grid.dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); i += 2)
        function(grid.mapping.transform_unit_to_real_cell(
                   cell, grid.finite_element.unit_support_point(i)),
                 std::array<types::global_dof_index, 2>{
                   {dofs[i], dofs[i + 1]}});
    }
}

/// A field by its values at the nodes.
template <typename Field>
Sandglass::DisplacementVector
nodal_field(const Sandglass::ElementGrid<2> &grid, const Field &field)
{
  Sandglass::DisplacementVector result = grid.make_vector();
  result.zero_out_ghost_values();
  for_each_node(grid, [&](const dealii::Point<2> &point, const auto &dofs) {
    const dealii::Tensor<1, 2> value(field(point));
    for (unsigned int d = 0; d < 2; ++d)
      result[dofs[d]] = value[d];
  });
  result.update_ghost_values();
  return result;
}

#endif
