#ifndef sandglass_flow_particle_in_cell_critical_time_step_h
#define sandglass_flow_particle_in_cell_critical_time_step_h

#include <deal.II/base/mpi.h>

#include <sandglass/flow/particle_in_cell/cell_stiffness.h>
#include <sandglass/flow/particle_in_cell/contact.h>
#include <sandglass/flow/particle_in_cell/mass_matrix.h>
#include <sandglass/flow/particle_in_cell/random_nodal_field.h>
#include <sandglass/scene/scene.h>

#include <Eigen/Eigenvalues>

namespace Sandglass
{
  /**
   * The largest stable time step for the particles' present positions. It is
   * for the whole grid what the paper's eq. 17 is for one element in one
   * dimension.
   *
   * One step takes the nodal velocity from v to v + dt G f with
   * G = M^-1 M_c M^-1, where M is the mass matrix M_alpha and M_c = S^T M_d S
   * the consistent one, which the velocity map of eq. 18 brings in, and f = -K
   * u with the elastic stiffness K. It is stable for dt^2 lambda <= 4, where
   * lambda is the largest eigenvalue of G K. With the lumped matrix a node that
   * loses its mass does not make lambda grow without bound, as it does without
   * the velocity map.
   *
   * Lanczos' method finds lambda: G K is symmetric in the inner product x^T K
   * y, and the largest eigenvalue of the tridiagonal matrix of a few iterations
   * is close to lambda, never above it. It starts afresh each time, since the
   * stiffest spot moves and a restarted run has to find the same step. It
   * starts from random numbers, each times a measure of the node by its own
   * entries of G and K: a plain random vector would miss a single stiff node.
   *
   * Nodes on the axis and in fixed corners are held. On the axis of
   * axisymmetric scenes a particle's hoop strain would otherwise grow without
   * bound as it nears the axis.
   */
  template <typename Setting>
  class CriticalTimeStep
  {
  public:
    static constexpr int dim = Setting::dim;

    using Law      = LawInterface<Setting>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;
    using NodalSum = Sandglass::NodalSum<dim>;

    /// All have to live as long as this object.
    CriticalTimeStep(const Law                              &law,
                     const CellGeometry<Setting::cell_type> &geometry,
                     const Scene<dim>                       &scene)
      : stiffness(law, geometry)
      , scene(scene)
      , random_direction(*scene.nodes)
      , direction(*scene.nodes)
      , last_direction(*scene.nodes)
      , force(*scene.nodes)
      , mapped(*scene.nodes)
    {
      fill_with_random_numbers<dim>(random_direction, scene);
    }

    /// Take the stiffness from the particles' positions and states.
    void
    assemble(const Blocks &blocks, const NodalSums<Setting> &cells)
    {
      stiffness.assemble(blocks, cells);
    }

    CellStiffness<Setting> &
    cell_stiffness()
    {
      return stiffness;
    }

    /**
     * Needs assemble() for the same positions.
     *
     * @param mass_matrix  assembled for the particles' present positions.
     * @param contact      walls may let a node go, the axis and corners don't.
     * @param sums         of these positions, with stiffness.
     * @return the critical step in s, infinity if nothing is stiff. Collective.
     */
    double
    compute(const Blocks             &blocks,
            const NodalSums<Setting> &cells,
            MassMatrix<Setting>      &mass_matrix,
            const Contact<dim>       &contact,
            const NodalSumField<dim> &sums,
            const unsigned int        n_iterations)
    {
      AssertIndexRange(n_iterations, max_iterations + 1);
      set_first_direction(sums);
      contact.release_always_held(direction);
      last_direction.start_sum();

      Diagonal     diagonal(n_iterations), beside(n_iterations);
      unsigned int n = 0;
      for (; n < n_iterations; ++n)
        {
          const double norm = multiply_by_stiffness(blocks, cells);
          // Nothing is stiff, or all that is stiff has been found.
          if (!(norm > (n == 0 ? 0. : 1e-10 * diagonal[0])))
            break;
          if (n > 0)
            beside[n - 1] = norm;
          diagonal[n] =
            accelerate_force(blocks, cells, mass_matrix, contact, sums);
          orthogonalize(diagonal[n], n > 0 ? norm : 0.);
        }
      return n == 0 ? std::numeric_limits<double>::infinity() :
                      2. / std::sqrt(largest_eigenvalue(diagonal.head(n),
                                                        beside.head(n - 1)));
    }

    /**
     * The largest of the nodes' own eigenvalues, what lambda would be if only
     * that node moved, in 1/s^2: cheap enough to be looked at in each step.
     * Collective.
     */
    double
    local_eigenvalue(const NodalSumField<dim> &sums) const
    {
      double largest = 0.;
      for (unsigned int node = 0; node < scene.nodes->locally_owned_size();
           ++node)
        largest = std::max(largest, own_eigenvalue(sums.at(node)));
      return Utilities::MPI::max(largest, scene.communicator);
    }

    /// The most iterations that compute() can do.
    static constexpr unsigned int max_iterations = 64;

  private:
    using Diagonal =
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_iterations, 1>;
    using Matrix = Eigen::Matrix<double,
                                 Eigen::Dynamic,
                                 Eigen::Dynamic,
                                 0,
                                 max_iterations,
                                 max_iterations>;

    static double
    own_eigenvalue(const double *sums)
    {
      const double mass = sums[NodalSum::mass];
      return mass > 0. ? sums[NodalSum::own_mass] / mass *
                           (sums[NodalSum::stiffness] / mass) :
                         0.;
    }

    void
    set_first_direction(const NodalSumField<dim> &sums)
    {
      for (unsigned int node = 0; node < scene.nodes->locally_owned_size();
           ++node)
        {
          const double weight = own_eigenvalue(sums.at(node));
          for (unsigned int d = 0; d < dim; ++d)
            direction.at(node)[d] = weight * random_direction.at(node)[d];
        }
    }

    /**
     * force = K direction, and both scaled so that direction^T K direction = 1.
     *
     * @return the norm of the direction before.
     */
    double
    multiply_by_stiffness(const Blocks &blocks, const NodalSums<Setting> &cells)
    {
      direction.update_ghosts();
      force.start_sum();
      const double energy =
        Utilities::MPI::sum(stiffness.multiply(blocks, cells, direction, force),
                            scene.communicator);
      force.finish_sum();
      if (!(energy > 0.))
        return 0.;
      const double norm = std::sqrt(energy);
      direction.vector() *= 1. / norm;
      force.vector() *= 1. / norm;
      return norm;
    }

    /// mapped = G force; returns force^T G force.
    double
    accelerate_force(const Blocks             &blocks,
                     const NodalSums<Setting> &cells,
                     MassMatrix<Setting>      &mass_matrix,
                     const Contact<dim>       &contact,
                     const NodalSumField<dim> &sums)
    {
      accelerate(mass_matrix, contact, sums, force);
      mapped.start_sum();
      const double energy =
        Utilities::MPI::sum(cells.multiply_by_mass(blocks, force, mapped),
                            scene.communicator);
      mapped.finish_sum();
      accelerate(mass_matrix, contact, sums, mapped);
      return energy;
    }

    /// The next direction: mapped without its parts along the last two.
    void
    orthogonalize(const double along_direction, const double along_last)
    {
      mapped.vector().add(-along_direction,
                          direction.vector(),
                          -along_last,
                          last_direction.vector());
      std::swap(last_direction, direction);
      std::swap(direction, mapped);
    }

    static double
    largest_eigenvalue(const Diagonal &diagonal, const Diagonal &beside)
    {
      Eigen::SelfAdjointEigenSolver<Matrix> solver;
      solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
      return solver.eigenvalues().maxCoeff();
    }

    /// field = M^-1 field where nodes may move, ghosts updated.
    void
    accelerate(MassMatrix<Setting>      &mass_matrix,
               const Contact<dim>       &contact,
               const NodalSumField<dim> &sums,
               NodalField<dim>          &field) const
    {
      const auto release = [&contact](NodalField<dim> &values) {
        contact.release_always_held(values);
      };
      release(field);
      mass_matrix.solve_lumped(sums, field);
      if (!mass_matrix.is_lumped())
        mass_matrix.solve_held(sums, release, field);
      field.update_ghosts();
    }

    CellStiffness<Setting> stiffness;
    const Scene<dim>      &scene;

    NodalField<dim> random_direction;
    NodalField<dim> direction;      ///< u
    NodalField<dim> last_direction; ///< u of the iteration before
    NodalField<dim> force;          ///< K u, then M^-1 K u
    NodalField<dim> mapped;         ///< G K u
  };
} // namespace Sandglass

#endif
