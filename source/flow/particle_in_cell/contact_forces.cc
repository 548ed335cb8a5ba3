// What contact records of its forces, for observers and checkpoints.

#include <deal.II/base/mpi.h>

#include <sandglass/choices.h>
#include <sandglass/flow/particle_in_cell/contact.h>

#include <algorithm>
#include <array>
#include <map>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    void
    record_impulse(WallForce<dim> &record, const Tensor<1, dim> &impulse)
    {
      record.normal_force -= impulse * record.normal;
      record.tangential_force += impulse * wall_tangent(record.normal);
    }



    /// Which of a node's supports has the normal nearest to a face's.
    template <int dim>
    unsigned int
    facing_support(const BoundaryNode<dim> &node, const Tensor<1, dim> &normal)
    {
      const auto &supports = node.supports;
      return supports.size() == 2 &&
             supports[1].normal * normal > supports[0].normal * normal;
    }
  } // namespace



  template <int dim>
  void
  Contact<dim>::start_from(const std::vector<WallForce<dim>> &wall_forces)
  {
    // The static stage divides nodes between the ranks in its own way.
    using Record = std::array<double, 4>; // x, y, role, force
    std::vector<Record> own_records;
    for (const WallForce<dim> &force : wall_forces)
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
          const BoundaryNode<dim> &node  = nodes[n].boundary;
          const auto          found = force_at.find(
            {{node.position[0],
                       node.position[1],
                       static_cast<double>(boundary_id(node.supports[s].role))}});
          if (found != force_at.end())
            memories[n][s] = {found->second, false};
        }
  }



  template <int dim>
  void
  Contact<dim>::record_normal_impulses(Node                 &node,
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



  template <int dim>
  void
  Contact<dim>::add_forces(const NodalField<dim> &forces, const double time_step)
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



  template <int dim>
  void
  Contact<dim>::add_impulses(const std::vector<WallImpulse<dim>> &impulses)
  {
    for (const WallImpulse<dim> &at_wall : impulses)
      {
        const auto          &ends = at_wall.ends;
        const Tensor<1, dim> area = ends[0].distance(ends[1]) * at_wall.normal;
        for (const unsigned int e : {0u, 1u})
          impulses_on_particles[{{ends[e][0], ends[e][1], area[0], area[1]}}] +=
            (e == 0 ? 1. - at_wall.place : at_wall.place) * at_wall.impulse;
        dissipation -= at_wall.impulse * at_wall.velocity;
      }
  }



  template <int dim>
  typename Contact<dim>::Impulses
  Contact<dim>::impulses() const
  {
    Impulses result;
    for (const Node &node : nodes)
      result.push_back(node.impulse);
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator, impulses_on_particles))
      for (const auto &[place, impulse] : of_rank)
        {
          const Point<dim>     end(place[0], place[1]);
          const Tensor<1, dim> area({place[2], place[3]});
          // Each cell rounds its vertices in its own way.
          const double rounding = 1e-9 * area.norm();
          for (unsigned int n = 0; n < nodes.size(); ++n)
            if (nodes[n].boundary.position.distance(end) < rounding)
              {
                record_impulse(
                  result[n][facing_support(nodes[n].boundary, area)], impulse);
                break;
              }
        }
    return result;
  }



  template <int dim>
  WallRecords
  Contact<dim>::records() const
  {
    WallRecords result;
    result.time       = summed_time;
    const auto forces = impulses();
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int s = 0; s < nodes[n].boundary.supports.size(); ++s)
        {
          const WallForce<dim> &force = forces[n][s];
          const Tensor<1, dim>  impulse =
            -force.normal_force * force.normal +
            force.tangential_force * wall_tangent(force.normal);
          WallRecord record{};
          record.wall = static_cast<WallId>(force.role);
          record.area = force.tributary_area;
          for (unsigned int d = 0; d < dim; ++d)
            {
              record.position[d] = force.position[d];
              record.normal[d]   = force.normal[d];
              record.impulse[d]  = impulse[d];
            }
          result.records.push_back(record);
        }
    return result;
  }



  template <int dim>
  void
  Contact<dim>::set_energies(const double friction_dissipation, const double)
  {
    dissipation = friction_dissipation;
  }



#define INSTANTIATE(dim) \
  template class Contact<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
