// What contact records of its forces, for observers and checkpoints.

#include <deal.II/base/mpi.h>

#include <sandglass/particle_stage/contact.h>

#include <algorithm>
#include <array>
#include <map>

namespace Sandglass
{
  namespace
  {
    void
    record_impulse(WallForce &record, const Tensor<1, dim> &impulse)
    {
      record.normal_force -= impulse * record.normal;
      record.tangential_force += impulse * wall_tangent(record.normal);
    }



    /// Which of a node's supports has the normal nearest to a face's.
    unsigned int
    facing_support(const BoundaryNode &node, const Tensor<1, dim> &normal)
    {
      const auto &supports = node.supports;
      return supports.size() == 2 &&
             supports[1].normal * normal > supports[0].normal * normal;
    }
  } // namespace



  void
  Contact::start_from(const std::vector<WallForce> &wall_forces)
  {
    // The static stage divides nodes between the ranks in its own way.
    using Record = std::array<double, 4>; // x, y, role, force
    std::vector<Record> own_records;
    for (const WallForce &force : wall_forces)
      own_records.push_back({{force.position[0],
                              force.position[1],
                              static_cast<double>(boundary_id(force.role)),
                              force.tangential_force}});
    std::map<std::array<double, 3>, double> force_at;
    for (const auto &records :
         Utilities::MPI::all_gather(communicator, own_records))
      for (const auto &[x, y, role, force] : records)
        force_at[{{x, y, role}}] = force;

    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].boundary.supports.size(); ++s)
        {
          const BoundaryNode &node  = nodes[n].boundary;
          const auto          found = force_at.find(
            {{node.position[0],
                       node.position[1],
                       static_cast<double>(boundary_id(node.supports[s].role))}});
          if (found != force_at.end())
            memories[n][s] = {found->second, false};
        }
  }



  void
  Contact::record_normal_impulses(Node                 &node,
                                  const Tensor<1, dim> &impulse) const
  {
    auto &records = node.impulse;
    if (node.boundary.supports.size() == 1)
      {
        record_impulse(records[0], impulse);
        return;
      }
    // impulse = -(a n_0 + b n_1)
    const Tensor<1, dim> &n0 = records[0].normal, &n1 = records[1].normal;
    const double          determinant = n0[0] * n1[1] - n0[1] * n1[0];
    records[0].normal_force -=
      (impulse[0] * n1[1] - impulse[1] * n1[0]) / determinant;
    records[1].normal_force -=
      (n0[0] * impulse[1] - n0[1] * impulse[0]) / determinant;
  }



  void
  Contact::add_forces(const NodalField<dim> &forces, const double time_step)
  {
    for (Node &node : nodes)
      if (node.holding != 0)
        {
          const double        *values = forces.at(node.index);
          const Tensor<1, dim> impulse(
            {time_step * values[0], time_step * values[1]});
          if (node.holding == 3 || node.boundary.is_fixed)
            record_normal_impulses(node, impulse);
          else
            for (const unsigned int s : {0u, 1u})
              if (node.holding == 1u << s)
                node.impulse[s].normal_force -=
                  impulse * node.boundary.supports[s].normal;
        }
  }



  void
  Contact::add_impulses(const std::vector<WallImpulse> &impulses)
  {
    for (const WallImpulse &at_wall : impulses)
      {
        const auto          &ends = at_wall.ends;
        const Tensor<1, dim> area = ends[0].distance(ends[1]) * at_wall.normal;
        for (const unsigned int e : {0u, 1u})
          impulses_on_particles[{{ends[e][0], ends[e][1], area[0], area[1]}}] +=
            (e == 0 ? 1. - at_wall.place : at_wall.place) * at_wall.impulse;
        dissipation -= at_wall.impulse * at_wall.velocity;
      }
  }



  void
  Contact::collect_impulses_on_particles()
  {
    const auto of_ranks =
      Utilities::MPI::all_gather(communicator, impulses_on_particles);
    impulses_on_particles.clear();
    for (const auto &impulses : of_ranks)
      for (const auto &[place, impulse] : impulses)
        {
          const Point<dim>     end(place[0], place[1]);
          const Tensor<1, dim> area({place[2], place[3]});
          // Each cell rounds its vertices in its own way.
          const double rounding = 1e-9 * area.norm();
          const auto   node =
            std::find_if(nodes.begin(), nodes.end(), [&](const Node &n) {
              return n.boundary.position.distance(end) < rounding;
            });
          if (node != nodes.end())
            record_impulse(node->impulse[facing_support(node->boundary, area)],
                           impulse);
        }
  }



  std::vector<WallForce>
  Contact::take_mean_forces()
  {
    collect_impulses_on_particles();
    std::vector<WallForce> forces;
    for (auto &node : nodes)
      for (unsigned int s = 0; s < node.boundary.supports.size(); ++s)
        {
          WallForce &impulse = node.impulse[s];
          forces.push_back(impulse);
          if (summed_time > 0.)
            {
              forces.back().normal_force /= summed_time;
              forces.back().tangential_force /= summed_time;
            }
          impulse.normal_force     = 0.;
          impulse.tangential_force = 0.;
        }
    summed_time = 0.;
    return forces;
  }



  Contact::Sums
  Contact::sums()
  {
    collect_impulses_on_particles();
    Sums sums{dissipation, summed_time, {}};
    for (const auto &node : nodes)
      sums.impulses.push_back({{node.impulse[0].normal_force,
                                node.impulse[0].tangential_force,
                                node.impulse[1].normal_force,
                                node.impulse[1].tangential_force}});
    return sums;
  }



  void
  Contact::set_sums(const Sums &sums)
  {
    AssertDimension(sums.impulses.size(), nodes.size());
    dissipation = sums.dissipation;
    summed_time = sums.time;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (const unsigned int s : {0u, 1u})
        {
          nodes[n].impulse[s].normal_force     = sums.impulses[n][2 * s];
          nodes[n].impulse[s].tangential_force = sums.impulses[n][2 * s + 1];
        }
  }
} // namespace Sandglass
