#ifndef sandglass_tests_field_errors_h
#define sandglass_tests_field_errors_h

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/flow/updated_lagrangian/element_grid.h>

#include <cmath>
#include <vector>

/**
 * Errors of fields on an ElementGrid, root mean squares over the body's volume,
 * relative to those of what they are errors of. The body is where it is before
 * any displacement.
 */
class FieldErrors
{
public:
  FieldErrors(const Sandglass::ElementGrid<2> &grid,
              const Sandglass::Formulation     formulation)
    : grid(grid)
    , formulation(formulation)
  {}

  struct Displacement
  {
    double value, gradient;
  };

  /// @param value,gradient  the exact ones, functions of a point.
  template <typename Value, typename Gradient>
  Displacement
  displacement(const Sandglass::DisplacementVector &displacement,
               const Value                         &value,
               const Gradient                      &gradient) const
  {
    using namespace dealii;
    // Exact enough to add no error of its own
    const Quadrature<2> quadrature =
      grid.triangulation.all_reference_cells_are_simplex() ?
        Quadrature<2>(QGaussSimplex<2>(4)) :
        Quadrature<2>(QGauss<2>(4));
    Displacement                         error{0., 0.}, scale{0., 0.};
    std::vector<types::global_dof_index> dofs(
      grid.finite_element.n_dofs_per_cell());
    for_each_point(
      quadrature,
      [&](const auto &cell, const auto &fe_values, const unsigned int q) {
        cell->get_dof_indices(dofs);
        const dealii::Point<2> point = fe_values.quadrature_point(q);
        const Tensor<1, 2>     u     = value(point);
        const Tensor<2, 2>     H     = gradient(point);
        Tensor<1, 2>           u_error(-u);
        Tensor<2, 2>           H_error(-H);
        for (const unsigned int i : fe_values.dof_indices())
          {
            const unsigned int c       = grid.component(i);
            const double       at_node = displacement[dofs[i]];
            u_error[c] += at_node * fe_values.shape_value(i, q);
            H_error[c] += at_node * fe_values.shape_grad(i, q);
          }
        const double dV = volume(fe_values, q);
        error.value += u_error.norm_square() * dV;
        error.gradient += H_error.norm_square() * dV;
        scale.value += u.norm_square() * dV;
        scale.gradient += H.norm_square() * dV;
      });
    return {std::sqrt(error.value / scale.value),
            std::sqrt(error.gradient / scale.gradient)};
  }

  /// At the stresses' own quadrature points.
  /// @param computed  stress by the point's index.
  /// @param exact     function of a point.
  template <typename Computed, typename Exact>
  double
  stress(const Computed &computed, const Exact &exact) const
  {
    double error = 0., scale = 0.;
    for_each_point(
      grid.quadrature,
      [&](const auto &cell, const auto &fe_values, const unsigned int q) {
        const Sandglass::SymmetricComponents<4> value =
          exact(fe_values.quadrature_point(q));
        const Sandglass::SymmetricComponents<4> difference =
          computed(grid.point_index(*cell, q)) - value;
        error += Sandglass::double_contraction(difference, difference) *
                 volume(fe_values, q);
        scale +=
          Sandglass::double_contraction(value, value) * volume(fe_values, q);
      });
    return std::sqrt(error / scale);
  }

private:
  /// Call `function(cell, fe_values, q)`.
  template <typename Function>
  void
  for_each_point(const dealii::Quadrature<2> &quadrature,
                 const Function              &function) const
  {
    using namespace dealii;
    FEValues<2> fe_values(grid.mapping,
                          grid.finite_element,
                          quadrature,
                          update_values | update_gradients |
                            update_quadrature_points | update_JxW_values);
    for (const auto &cell : grid.dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          function(cell, fe_values, q);
      }
  }

  double
  volume(const dealii::FEValues<2> &fe_values, const unsigned int q) const
  {
    return fe_values.JxW(q) *
           (formulation == Sandglass::Formulation::axisymmetric ?
              fe_values.quadrature_point(q)[0] :
              1.);
  }

  const Sandglass::ElementGrid<2> &grid;
  const Sandglass::Formulation     formulation;
};

#endif
