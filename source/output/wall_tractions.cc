#include <deal.II/base/mpi.h>

#include <sandglass/output/wall_tractions.h>

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

namespace Sandglass
{
  namespace
  {
    const std::vector<std::string> columns = {
      "time_s",
      "wall",
      "arc_length_m",
      "x_m",
      "y_m",
      "normal_Pa",
      "tangential_Pa",
      "janssen_normal_Pa",
      "side",
      "en_1991_4_filling_normal_Pa",
      "en_1991_4_filling_tangential_Pa",
      "en_1991_4_discharge_normal_Pa",
      "en_1991_4_discharge_tangential_Pa"};



    Janssen
    make_janssen(const OutputParameters   &parameters,
                 const Scene              &scene,
                 const MaterialParameters &material,
                 const WallParameters     &walls,
                 const SiloMeasures       &measures)
    {
      const double parts_of_width =
        scene.formulation == Formulation::plane_strain ? 2. : 4.;
      return {material.density * scene.gravity.norm(),
              measures.wall_width / parts_of_width,
              parameters.lateral_pressure_ratio > 0. ?
                parameters.lateral_pressure_ratio :
                Janssen::standard_lateral_pressure_ratio(
                  material.internal_friction_angle),
              walls.friction_coefficient()};
    }



    /// What one rank tells another about a force.
    using Parcel = std::array<double, 8>;

    Parcel
    pack(const WallForce &force)
    {
      return {{force.position[0],
               force.position[1],
               static_cast<double>(force.role),
               force.normal[0],
               force.normal[1],
               force.tributary_area,
               force.normal_force,
               force.tangential_force}};
    }



    WallForce
    unpack(const Parcel &parcel)
    {
      return {Point<dim>(parcel[0], parcel[1]),
              static_cast<BoundaryRole>(parcel[2]),
              Tensor<1, dim>({parcel[3], parcel[4]}),
              parcel[5],
              parcel[6],
              parcel[7]};
    }



    bool
    comes_before(const WallTraction &a, const WallTraction &b)
    {
      const auto rank = [](const WallTraction &traction) {
        return std::make_tuple(traction.force.role,
                               traction.place.line,
                               traction.place.arc_length);
      };
      return rank(a) < rank(b);
    }
  } // namespace



  WallTractions::WallTractions(const OutputParameters   &parameters,
                               const Scene              &scene,
                               const MaterialParameters &material,
                               const WallParameters     &walls)
    : communicator(scene.communicator)
    , is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , fill_top(scene.fill_top)
    , measures(scene)
    , janssen(make_janssen(parameters, scene, material, walls, measures))
    , eurocode({scene.formulation,
                measures.wall_width,
                fill_top - measures.wall_foot,
                measures.outlet_eccentricity,
                measures.hopper_slope,
                material.internal_friction_angle},
               janssen)
    , lines(scene.mesh, measures.bottom_centre)
    , table(parameters.directory + "/wall_traction.csv", columns)
    , series(parameters.directory, "walls", MPI_COMM_SELF)
  {}



  void
  WallTractions::open()
  {
    if (!is_writer)
      return;
    table.open();
    series.open();
  }



  std::vector<WallTraction>
  WallTractions::collect(const std::vector<WallForce> &forces) const
  {
    std::vector<Parcel> parcels;
    for (const auto &force : forces)
      if (is_wall(force.role))
        parcels.push_back(pack(force));

    std::vector<WallTraction> tractions;
    for (const auto &of_rank : Utilities::MPI::gather(communicator, parcels))
      for (const auto &parcel : of_rank)
        {
          const WallForce force = unpack(parcel);
          tractions.push_back(
            {force,
             lines.find(force.role, force.position),
             force.normal_force / force.tributary_area,
             force.tangential_force / force.tributary_area,
             janssen_pressure(force),
             eurocode_pressure(EurocodePressures::Load::filling, force),
             eurocode_pressure(EurocodePressures::Load::discharge, force)});
        }
    std::sort(tractions.begin(), tractions.end(), comes_before);
    return tractions;
  }



  double
  WallTractions::janssen_pressure(const WallForce &force) const
  {
    const double depth = fill_top - force.position[1];
    if (force.role == BoundaryRole::wall)
      return janssen.horizontal_pressure(depth);
    // The bottom of the vertical part, not that below a hopper.
    const bool is_bottom =
      force.role != BoundaryRole::hopper &&
      force.position[1] > measures.wall_foot - 1e-6 * depth;
    return is_bottom ? janssen.vertical_pressure(depth) :
                       std::numeric_limits<double>::quiet_NaN();
  }



  WallPressure
  WallTractions::eurocode_pressure(const EurocodePressures::Load load,
                                   const WallForce              &force) const
  {
    const double depth = fill_top - force.position[1];
    return force.role == BoundaryRole::wall ? eurocode.on_wall(load, depth) :
           force.role == BoundaryRole::hopper ?
                                              eurocode.on_hopper(load, depth) :
                                              WallPressure();
  }



  void
  WallTractions::write(const double                     time,
                       const std::vector<WallTraction> &tractions)
  {
    if (!is_writer)
      return;
    for (const auto &traction : tractions)
      table.add_row(time,
                    name_of(traction.force.role),
                    traction.place.arc_length,
                    traction.force.position[0],
                    traction.force.position[1],
                    traction.normal,
                    traction.tangential,
                    traction.janssen_normal,
                    name_of(traction.place.side),
                    traction.eurocode_filling.normal,
                    traction.eurocode_filling.tangential,
                    traction.eurocode_discharge.normal,
                    traction.eurocode_discharge.tangential);
    table.flush();
    series.write(time, wall_fields(tractions));
  }

} // namespace Sandglass
