#include <deal.II/base/quadrature_lib.h>

#include <sandglass/flow/updated_lagrangian/motion/moving_body.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// Of a node in one step, over the size of elements.
    constexpr double longest_way = 0.75;

    std::unique_ptr<Equilibrium<2>>
    make_moving_equilibrium(const MotionSetting &setting,
                            const MovingGrid    &grid,
                            const MaterialState &state)
    {
      auto equilibrium = make_equilibrium(grid.elements,
                                          setting.scene.formulation,
                                          setting.material,
                                          setting.scene.gravity);
      equilibrium->set_large_steps();
      equilibrium->move_reference(grid.bulge());
      equilibrium->set_weight(
        weight_of(grid, state.point_masses, setting.scene.gravity));
      const MeshField &fields = state.at.point_fields;
      for (unsigned int i = 0; i < state.at.density.size(); ++i)
        {
          const double              *values = fields.at(i);
          Equilibrium<2>::PointState point;
          std::copy_n(values, 4, point.stress.begin());
          point.volume_ratio = setting.material.density / state.at.density[i];
          point.law_state.assign(values + 4, values + fields.n_components);
          equilibrium->set_point_state(i, point);
        }
      // A step in which nothing moves: the law takes away what it doesn't
      // admit.
      DisplacementVector forces = grid.elements.make_vector();
      equilibrium->evaluate_forces(grid.elements.make_vector(), 1., forces);
      equilibrium->start_step();
      return equilibrium;
    }



    Quadrature<2>
    mass_quadrature(const unsigned int order)
    {
      return QGaussSimplex<2>(order == 2 ? 3 : 1);
    }



    /// The linear function of three values at a quadratic triangle's stress
    /// points, or the one value of a linear triangle.
    double
    extended(const double      *values,
             const unsigned int order,
             const Point<2>    &reference_point)
    {
      if (order == 1)
        return values[0];
      const double x = (reference_point[0] - 1. / 6.) * 2.;
      const double y = (reference_point[1] - 1. / 6.) * 2.;
      return values[0] + x * (values[1] - values[0]) +
             y * (values[2] - values[0]);
    }
  } // namespace



  MovingBody::MovingBody(const MotionSetting &setting,
                         const MaterialState &state,
                         const double         time,
                         const double         first_step)
    : setting(setting)
    , grid(state.at.mesh)
    , equilibrium(make_moving_equilibrium(setting, grid, state))
    , point_masses(state.point_masses)
    , consistent_mass(grid.elements, point_masses)
    , contact(grid,
              setting.walls,
              equilibrium->confined_modulus(),
              setting.wall_parameters.tangential_penalty,
              setting.depth)
    , motion(grid.elements,
             *equilibrium,
             consistent_mass,
             contact,
             {setting.parameters.time_step,
              setting.parameters.newmark,
              longest_way * setting.element_size},
             setting.static_parameters,
             setting.parameters.relative_residual)
  {
    // What Newton's method leaves of the forces where it asks for contact.
    constexpr double share = 1e-5;
    contact.smallest_pull  = share * equilibrium->weight().l2_norm();

    const unsigned int n            = state.at.mesh.nodes.size();
    MeshField          acceleration = MeshField::zero(2, n);
    displacement_before             = MeshField::zero(2, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double *values = state.at.nodal_fields.at(i);
        std::copy_n(values, 2, acceleration.at(i));
        std::copy_n(values + 2, 2, displacement_before.at(i));
      }
    motion.go_on(time,
                 first_step,
                 grid.bulge(),
                 grid.vector_of(state.at.velocity),
                 grid.vector_of(acceleration));
    motion.damp_next_step();
  }



  MaterialState
  MovingBody::state() const
  {
    MaterialState result;
    result.point_masses             = point_masses;
    result.at.mesh                  = mesh();
    result.at.velocity              = grid.field_of(motion.velocity());
    const MeshField    acceleration = grid.field_of(motion.acceleration());
    const unsigned int n            = grid.mesh.nodes.size();
    result.at.nodal_fields          = MeshField::zero(4, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        double *values = result.at.nodal_fields.at(i);
        std::copy_n(acceleration.at(i), 2, values);
        for (unsigned int d = 0; d < 2; ++d)
          values[2 + d] = displacement_before.at(i)[d] +
                          result.at.mesh.nodes[i][d] - grid.mesh.nodes[i][d];
      }
    const unsigned int n_points = grid.mesh.cells.size() * n_points_per_cell();
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const auto point = equilibrium->point_state(i);
        if (i == 0)
          result.at.point_fields =
            MeshField::zero(4 + point.law_state.size(), n_points);
        double *values = result.at.point_fields.at(i);
        std::copy_n(point.stress.begin(), 4, values);
        std::copy(point.law_state.begin(), point.law_state.end(), values + 4);
        result.at.density.push_back(setting.material.density /
                                    point.volume_ratio);
      }
    return result;
  }



  std::vector<double>
  MovingBody::cell_masses() const
  {
    return sums_by_cell(point_masses, grid.mesh.cells.size());
  }



  void
  MovingBody::save(boost::archive::binary_oarchive &archive) const
  {
    for (const auto *vector :
         {&motion.displacement(), &motion.velocity(), &motion.acceleration()})
      {
        const std::vector<double> values(vector->begin(), vector->end());
        archive << values;
      }
    const double time = motion.time(), next = motion.next_time_step();
    const bool   is_damped = motion.damps_next_step();
    archive << time << next << is_damped << displacement_before.values;
    equilibrium->save(archive);
    archive << contact;
  }



  void
  MovingBody::load(boost::archive::binary_iarchive &archive)
  {
    std::array<DisplacementVector, 3> vectors;
    for (DisplacementVector &vector : vectors)
      {
        std::vector<double> values;
        archive >> values;
        vector = grid.elements.make_vector();
        vector.zero_out_ghost_values();
        std::copy(values.begin(), values.end(), vector.begin());
        vector.update_ghost_values();
      }
    double time, next;
    bool   is_damped;
    archive >> time >> next >> is_damped >> displacement_before.values;
    equilibrium->load(archive);
    archive >> contact;
    motion.go_on(time, next, vectors[0], vectors[1], vectors[2]);
    motion.damp_next_step(is_damped);
  }



  std::vector<double>
  sums_by_cell(const std::vector<double> &of_points, const unsigned int n_cells)
  {
    const unsigned int  n = of_points.size() / n_cells;
    std::vector<double> sums(n_cells, 0.);
    for (unsigned int i = 0; i < of_points.size(); ++i)
      sums[i / n] += of_points[i];
    return sums;
  }



  std::vector<double>
  even_point_masses(const TriangleMesh &mesh,
                    const Depth        &depth,
                    const double        density)
  {
    auto masses = quadrature_volumes(mesh, mass_quadrature(mesh.order), depth);
    for (double &mass : masses)
      mass *= density;
    return masses;
  }



  std::vector<double>
  point_masses_of(const TriangleMesh        &mesh,
                  const Depth               &depth,
                  const std::vector<double> &density,
                  const std::vector<double> &body_masses)
  {
    const Quadrature<2> quadrature = mass_quadrature(mesh.order);
    const unsigned int  n_density  = density.size() / mesh.cells.size();
    auto                masses = quadrature_volumes(mesh, quadrature, depth);
    std::vector<double> sums(body_masses.size(), 0.);
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int cell   = i / quadrature.size();
        const double      *values = &density[cell * n_density];
        // Extended from the points inside it could become negative.
        const double smallest =
          0.5 * *std::min_element(values, values + n_density);
        masses[i] *=
          std::max(smallest,
                   extended(values,
                            mesh.order,
                            quadrature.point(i % quadrature.size())));
        sums[mesh.bodies[cell]] += masses[i];
      }
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const unsigned int body = mesh.bodies[i / quadrature.size()];
        masses[i] *= body_masses[body] / sums[body];
      }
    return masses;
  }



  DisplacementVector
  weight_of(const MovingGrid          &grid,
            const std::vector<double> &point_masses,
            const Tensor<1, 2>        &gravity)
  {
    const Quadrature<2> &quadrature = grid.elements.mass_quadrature;
    const auto          &element = grid.elements.finite_element.base_element(0);
    DisplacementVector   weight  = grid.elements.make_vector();
    weight.zero_out_ghost_values();
    for (unsigned int c = 0; c < grid.elements.local_cells.size(); ++c)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          for (unsigned int d = 0; d < 2; ++d)
            weight.local_element(
              grid.elements.local_cells[c].dofs[2 * i + d]) +=
              point_masses[c * quadrature.size() + q] *
              element.shape_value(i, quadrature.point(q)) * gravity[d];
    weight.update_ghost_values();
    return weight;
  }
} // namespace Sandglass
