#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/dynamic_relaxation.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  template <int dim>
  DynamicRelaxation<dim>::DynamicRelaxation(const ElementGrid<dim> &grid,
                                            Equilibrium<dim>       &equilibrium,
                                            NodeConstraints<dim>   &contact,
                                            const TangentStorage    storage)
    : grid(grid)
    , storage(storage)
    , out_of_balance(grid, equilibrium, contact)
    , velocity(grid.make_vector())
    , momentum(grid.make_vector())
    , residual_before(grid.make_vector())
    , work(grid.make_vector())
  {}



  template <int dim>
  bool
  DynamicRelaxation<dim>::find_inertia()
  {
    if (!stiffness)
      {
        stiffness         = std::make_unique<TangentMatrix<dim>>(grid, storage);
        inverse_stiffness = make_preconditioner(grid, *stiffness);
      }
    velocity = 0.;
    momentum = 0.;
    out_of_balance.assemble_tangent(1., *stiffness);
    return inverse_stiffness->update();
  }



  template <int dim>
  double
  DynamicRelaxation<dim>::squared_frequency()
  {
    const double kinetic = momentum * velocity;
    if (kinetic == 0.)
      return 0.;
    work.equ(1., out_of_balance.residual());
    work.add(-1., residual_before);
    return std::max(0., (work * velocity) / kinetic);
  }



  template <int dim>
  void
  DynamicRelaxation<dim>::step(Vector &increment)
  {
    // Steps of length one are stable up to a squared frequency of 4. Where
    // material or contact is stiffer than the elasticity that inertia is taken
    // from, inertia grows.
    constexpr double largest = 3., growth = 1.5;
    // Beyond this share of critical damping steps would no longer be stable.
    constexpr double largest_for_damping = 0.8;

    const double frequency = squared_frequency();
    if (frequency > largest)
      inertia_factor *= growth;
    const double c = 2. * std::sqrt(std::min(frequency, largest_for_damping));
    residual_before.equ(1., out_of_balance.residual());
    momentum.sadd((2. - c) / (2. + c), -2. / (2. + c), residual_before);
    inverse_stiffness->vmult(velocity, momentum);
    velocity /= inertia_factor;
    increment.zero_out_ghost_values();
    increment.add(1., velocity);
    increment.update_ghost_values();
  }



  template <int dim>
  void
  DynamicRelaxation<dim>::start_step(const Vector &displacement_before,
                                     const double  load_share)
  {
    out_of_balance.start_step(displacement_before, load_share);
  }



  template <int dim>
  RelaxationResult
  DynamicRelaxation<dim>::relax(const double       largest_residual,
                                const unsigned int most_steps,
                                Vector            &increment)
  {
    // Material that has passed a wall for long is thrown back.
    constexpr unsigned int between_contact_updates = 10;

    inertia_factor     = 1.;
    double norm        = out_of_balance.evaluate(increment);
    bool   has_inertia = find_inertia();
    for (unsigned int i = 0;; ++i)
      {
        const bool is_at_rest = norm < largest_residual;
        if (is_at_rest || (i + 1) % between_contact_updates == 0)
          {
            if (out_of_balance.update_contact() > 0)
              {
                norm        = out_of_balance.evaluate(increment);
                has_inertia = find_inertia();
              }
            else if (is_at_rest)
              return {true, i, norm};
          }
        if (i >= most_steps || !std::isfinite(norm) || !has_inertia)
          return {false, i, norm};
        step(increment);
        norm = out_of_balance.evaluate(increment);
      }
  }



#define INSTANTIATE(dim) template class DynamicRelaxation<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
