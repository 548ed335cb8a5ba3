#include <sandglass/choices.h>
#include <sandglass/flow/updated_lagrangian/dynamic_relaxation.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  template <int dim>
  DynamicRelaxation<dim>::DynamicRelaxation(const FilledGrid<dim> &grid,
                                            Equilibrium<dim>      &equilibrium,
                                            WallContact<dim>      &contact)
    : grid(grid)
    , out_of_balance(grid, equilibrium, contact)
    , masses(grid.make_vector())
    , velocity(grid.make_vector())
    , residual_before(grid.make_vector())
    , work(grid.make_vector())
  {}



  template <int dim>
  void
  DynamicRelaxation<dim>::find_masses()
  {
    // By Gershgorin's circles no frequency is above the largest that steps of
    // length one are stable with, 2; the rest is in reserve.
    constexpr double reserve = 1.2;

    TangentMatrix<dim> tangent(grid, TangentStorage::rows);
    out_of_balance.assemble_tangent(1., tangent);
    for (const auto row : grid.owned_dofs)
      {
        double      sum    = 0.;
        const auto &matrix = tangent.stored_matrix();
        for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
          sum += std::abs(entry->value());
        masses[row] = 0.25 * reserve * sum;
      }
    velocity = 0.;
  }



  template <int dim>
  double
  DynamicRelaxation<dim>::damping()
  {
    work.equ(1., velocity);
    work.scale(masses);
    const double kinetic = work * velocity;
    if (kinetic == 0.)
      return 0.;
    work.equ(1., out_of_balance.residual());
    work.add(-1., residual_before);
    const double squared_frequency = (work * velocity) / kinetic;
    return 2. * std::sqrt(std::clamp(squared_frequency, 0., 0.8));
  }



  template <int dim>
  void
  DynamicRelaxation<dim>::step(Vector &increment)
  {
    const double c = damping();
    residual_before.equ(1., out_of_balance.residual());
    work.equ(1., residual_before);
    for (unsigned int i = 0; i < grid.n_owned_dofs(); ++i)
      work.local_element(i) /= masses.local_element(i);
    velocity.sadd((2. - c) / (2. + c), -2. / (2. + c), work);
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
    // Contact that changes more often starts to flutter.
    constexpr unsigned int between_contact_updates = 100;

    double norm = out_of_balance.evaluate(increment);
    find_masses();
    for (unsigned int i = 0;; ++i)
      {
        const bool is_at_rest = norm < largest_residual;
        if (is_at_rest || (i + 1) % between_contact_updates == 0)
          {
            if (out_of_balance.update_contact() > 0)
              {
                norm = out_of_balance.evaluate(increment);
                find_masses();
              }
            else if (is_at_rest)
              return {true, i, norm};
          }
        if (i >= most_steps || !std::isfinite(norm))
          return {false, i, norm};
        step(increment);
        norm = out_of_balance.evaluate(increment);
      }
  }



#define INSTANTIATE(dim) template class DynamicRelaxation<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
