// The walls' records of all ranks, in the order in which results show them.

#include <deal.II/base/mpi.h>

#include <sandglass/output/section_wall_tractions.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace Sandglass
{
  namespace
  {
    /// What one rank tells another about a record.
    using PackedRecord = std::array<double, 12>;

    PackedRecord
    pack(const WallRecord &record)
    {
      const auto &x = record.position;
      const auto &n = record.normal;
      const auto &i = record.impulse;
      return {{static_cast<double>(record.wall),
               static_cast<double>(record.vertex),
               x[0],
               x[1],
               x[2],
               n[0],
               n[1],
               n[2],
               record.area,
               i[0],
               i[1],
               i[2]}};
    }



    WallRecord
    unpack(const PackedRecord &parcel)
    {
      WallRecord record{};
      record.wall   = static_cast<WallId>(parcel[0]);
      record.vertex = static_cast<unsigned int>(parcel[1]);
      record.area   = parcel[8];
      for (unsigned int d = 0; d < 3; ++d)
        {
          record.position[d] = parcel[2 + d];
          record.normal[d]   = parcel[5 + d];
          record.impulse[d]  = parcel[9 + d];
        }
      return record;
    }
  } // namespace



  std::vector<WallTractions<2>::PlacedRecord>
  WallTractions<2>::collect(const WallRecords &records) const
  {
    std::vector<PackedRecord> parcels;
    for (const WallRecord &record : records.records)
      parcels.push_back(pack(record));

    std::vector<PlacedRecord> result;
    for (const auto &of_rank :
         Utilities::MPI::gather(scene.communicator, parcels))
      for (const PackedRecord &parcel : of_rank)
        {
          const WallRecord record = unpack(parcel);
          result.push_back({record, lines.find(record.wall, record.vertex)});
        }

    give_outlet_ends_to_floor(result);

    const auto key = [this](const PlacedRecord &placed) {
      const WallRecord &record = placed.record;
      // Where a wall has a bend, a node has two records.
      return std::make_tuple(scene.walls[record.wall].role,
                             record.wall,
                             placed.place.line,
                             placed.place.arc_length,
                             record.normal[0],
                             record.normal[1]);
    };
    std::sort(result.begin(),
              result.end(),
              [&key](const auto &a, const auto &b) { return key(a) < key(b); });
    return result;
  }



  void
  WallTractions<2>::give_outlet_ends_to_floor(
    std::vector<PlacedRecord> &records) const
  {
    constexpr double          rounding = 1e-9;
    std::vector<PlacedRecord> of_outlet, result;
    for (const PlacedRecord &placed : records)
      (scene.walls[placed.record.wall].role == BoundaryRole::outlet ?
         of_outlet :
         result)
        .push_back(placed);

    std::vector<PlacedRecord> left;
    for (const PlacedRecord &outlet : of_outlet)
      {
        const auto beside = std::find_if(
          result.begin(), result.end(), [&](const PlacedRecord &other) {
            return other.record.vertex == outlet.record.vertex &&
                   (other.record.normal - outlet.record.normal).norm() <
                     rounding;
          });
        if (beside == result.end())
          left.push_back(outlet);
        else
          {
            beside->record.area += outlet.record.area;
            beside->record.impulse += outlet.record.impulse;
          }
      }
    result.insert(result.end(), left.begin(), left.end());
    records = result;
  }
} // namespace Sandglass
