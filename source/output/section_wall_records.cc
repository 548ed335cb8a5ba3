// The walls' records of all ranks, in the order in which results show them.

#include <deal.II/base/mpi.h>

#include <sandglass/output/section_wall_tractions.h>

#include <algorithm>
#include <tuple>

namespace Sandglass
{
  std::vector<WallTractions<2>::PlacedRecord>
  WallTractions<2>::collect(const WallRecords &records) const
  {
    std::vector<PlacedRecord> result;
    for (const auto &of_rank :
         Utilities::MPI::gather(scene.communicator, records.records))
      for (const WallRecord &record : of_rank)
        if (record.wall != no_wall)
          result.push_back({record, lines.find(record.wall, record.vertex)});

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
} // namespace Sandglass
