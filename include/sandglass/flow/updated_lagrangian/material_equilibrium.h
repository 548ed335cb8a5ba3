#ifndef sandglass_flow_updated_lagrangian_material_equilibrium_h
#define sandglass_flow_updated_lagrangian_material_equilibrium_h

#include <deal.II/fe/fe_values.h>

#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/material/state_variable.h>

#include <boost/serialization/array_wrapper.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace Sandglass
{
  /// Equilibrium of material of one law with one kinematics.
  template <typename Kinematics, typename Law>
  class MaterialEquilibrium : public Equilibrium<Kinematics::dim>
  {
  public:
    static constexpr int dim = Kinematics::dim;

    using Base       = Equilibrium<dim>;
    using Vector     = typename Base::Vector;
    using BodyForce  = typename Base::BodyForce;
    using PointState = typename Base::PointState;
    using Stress     = typename Kinematics::template Stress<>;
    using Gradient   = typename Kinematics::Response::Gradient;

    /// State at a quadrature point; "before" is the start of the load step.
    struct MaterialPoint
    {
      Stress                stress_before = Stress::Zero();   ///< in Pa
      Stress                stress        = Stress::Zero();   ///< in Pa
      Gradient              gradient      = Gradient::Zero(); ///< H
      LawState<Law, double> law_state_before, law_state;
      /// Current over unloaded volume.
      double volume_ratio_before = 1., volume_ratio = 1.;
      /// Plastic work since the unloaded state, per unloaded volume, in J/m^3.
      double dissipation_before = 0., dissipation = 0.;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        for (auto *tensor : {&stress_before, &stress})
          archive &boost::serialization::make_array(tensor->data(),
                                                    tensor->size());
        archive &boost::serialization::make_array(gradient.data(),
                                                  gradient.size());
        for (auto *numbers : {&law_state_before, &law_state})
          archive &boost::serialization::make_array(numbers->data(),
                                                    numbers->size());
        archive &volume_ratio_before &volume_ratio;
        archive &dissipation_before  &dissipation;
      }
    };

    /// @param density  of the unloaded material, in kg/m^3.
    MaterialEquilibrium(const ElementGrid<dim> &grid,
                        const Law              &law,
                        const double            density,
                        const Tensor<1, dim>   &gravity);

    /// For a body force that varies in space, as in manufactured solutions.
    MaterialEquilibrium(const ElementGrid<dim> &grid,
                        const Law              &law,
                        const double            density,
                        const BodyForce        &body_force);

    void
    start_step() override;

    void
    evaluate_forces(const Vector &increment,
                    const double  load_share,
                    Vector       &forces) override;

    void
    assemble_tangent(const NodeConstraints<dim> &constraints,
                     const double                elastic_share,
                     TangentMatrix<dim>         &matrix) const override;

    double
    smallest_volume_ratio() const override;

    typename Base::Energies
    energies() const override;

    PointState
    point_state(const unsigned int index) const override
    {
      const MaterialPoint &point = points[index];
      return {point.stress,
              point.volume_ratio,
              {point.law_state.begin(), point.law_state.end()}};
    }

    void
    set_point_state(const unsigned int index, const PointState &state) override
    {
      MaterialPoint &point = points[index];
      point                = MaterialPoint();
      point.stress_before = point.stress = state.stress;
      point.volume_ratio_before = point.volume_ratio = state.volume_ratio;
      std::copy_n(state.law_state.begin(),
                  point.law_state.size(),
                  point.law_state.begin());
      point.law_state_before = point.law_state;
    }

    void
    move_reference(const Vector &displacement) override;

    void
    save(boost::archive::binary_oarchive &archive) const override;

    void
    load(boost::archive::binary_iarchive &archive) override;

    double
    confined_modulus() const override
    {
      return law.stiffness_bound().confined_modulus();
    }

    bool
    has_constant_stiffness() const override
    {
      return Law::has_constant_stiffness;
    }

    /// Quadrature point q of active cell i has the index i * n_points + q. Only
    /// those of ElementGrid::local_cells mean anything.
    const std::vector<MaterialPoint> &
    material_points() const
    {
      return points;
    }

  private:
    using LocalCell        = typename ElementGrid<dim>::LocalCell;
    using GradientOperator = typename Kinematics::GradientOperator;

    /// All that is known at one quadrature point.
    struct SavedPoint
    {
      unsigned int     index;
      MaterialPoint    point;
      GradientOperator gradient_operator;
      double           volume;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &index &point &gradient_operator &volume;
      }
    };

    /// Add to the values at those of the cell's nodes that this rank owns.
    void
    add_to(const LocalCell                        &local_cell,
           const Eigen::Ref<const Eigen::VectorXd> values,
           Vector                                 &vector) const;

    /// The unloaded configuration.
    void
    set_up_points();

    void
    set_up_weight(const double density, const BodyForce &body_force);

    void
    set_up_point(const FEValues<dim> &fe_values,
                 const unsigned int   q,
                 const unsigned int   index);

    /// Make the deformed configuration the reference of one point.
    void
    start_step(const unsigned int index);

    template <int n_dofs>
    void
    update_stress(const Eigen::Matrix<double, n_dofs, 1> &increment,
                  const unsigned int                      index);

    /// Strain and rotation of a point's gradient, as the law is to see them.
    auto
    increment_of(const MaterialPoint &point) const
    {
      return Kinematics::Response::increment(point.gradient, integration());
    }

    StressIntegration
    integration() const
    {
      return this->has_large_steps ? StressIntegration::middle_of_step :
                                     StressIntegration::start_of_step;
    }

    /// Above this ratio of volumes a point bears no stress.
    double
    largest_stressed_volume_ratio() const
    {
      return this->has_large_steps && !Law::knows_density ?
               1. / law.loosest_density_share() :
               std::numeric_limits<double>::infinity();
    }

    /**
     * Where material was separated at the step's start, take away the strain
     * that only brings its grains together; what is left starts from no stress.
     *
     * @return whether they come together at all.
     */
    template <typename Increment>
    bool
    close_gap(const MaterialPoint &point, Increment &step) const;

    /// @tparam n_dofs  per cell; known to the compiler, it saves a fifth of the
    ///                 time.
    template <int n_dofs>
    void
    add_internal_forces(const Vector &increment, Vector &forces);

    /// Of the last evaluate_forces().
    MaterialTangent<Kinematics::n_components>
    tangent_of_law(const MaterialPoint &point, const double elastic_share) const
    {
      auto step = increment_of(point);
      if (point.volume_ratio_before > largest_stressed_volume_ratio() &&
          !close_gap(point, step))
        return separated_tangent(elastic_share);
      return law.tangent(rotate(point.stress_before, step.rotation),
                         point.law_state_before,
                         step,
                         elastic_share);
    }

    /// Of material that bears no stress: what Newton's method mixes in.
    MaterialTangent<Kinematics::n_components>
    separated_tangent(const double elastic_share) const
    {
      using Matrix = ComponentMatrix<Kinematics::n_components>;
      if constexpr (Law::has_constant_stiffness)
        return {elastic_share * Matrix::Identity(),
                elastic_share *
                  law.stiffness_bound()
                    .template stiffness<Kinematics::n_components>()};
      else
        return {Matrix::Zero(), Matrix::Zero()};
    }

    template <int n_dofs>
    Eigen::Matrix<double, n_dofs, n_dofs>
    cell_tangent(const LocalCell            &local_cell,
                 const NodeConstraints<dim> &constraints,
                 const double                elastic_share) const;

    template <int n_dofs>
    void
    add_cell_tangents(const NodeConstraints<dim> &constraints,
                      const double                elastic_share,
                      TangentMatrix<dim>         &matrix) const;

    /// Call `function(n)` with the number of a cell's degrees of freedom as a
    /// constant that the compiler knows.
    template <typename Function>
    void
    with_n_dofs(const Function &function) const
    {
      using Grid           = ElementGrid<dim>;
      const unsigned int n = grid.finite_element.n_dofs_per_cell();
      if (n == Grid::n_simplex_dofs)
        function(std::integral_constant<int, Grid::n_simplex_dofs>());
      else if (n == Grid::n_cube_dofs)
        function(std::integral_constant<int, Grid::n_cube_dofs>());
      else if constexpr (dim == 2)
        function(std::integral_constant<int, Grid::n_quadratic_dofs>());
    }

    const ElementGrid<dim> &grid;
    const Law               law;

    std::vector<MaterialPoint>    points;
    std::vector<GradientOperator> gradient_operators;
    /// The points' volumes in the reference configuration, in m^3 (plane
    /// strain: per m of depth).
    std::vector<double> volumes;
  };
} // namespace Sandglass

#include <sandglass/flow/updated_lagrangian/equilibrium_checkpoint.templates.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.templates.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium_set_up.templates.h>

#endif
