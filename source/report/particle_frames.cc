#include <sandglass/report/packing.h>
#include <sandglass/report/particle_frames.h>

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

namespace Sandglass
{
  namespace Report
  {
    namespace
    {
      /// Places are so fine that a view can be enlarged some five times.
      constexpr unsigned int n_steps = 8191;

      /// A flow of fewer does not play.
      constexpr std::size_t least_frames = 26;

      constexpr double pi            = 3.14159265358979323846;
      constexpr double speed_decades = 3;



      /// The value below which a `share` of `values` is; 1 where that is 0.
      double
      quantile(std::vector<float> &values, const double share)
      {
        if (values.empty())
          return 1;
        const auto place = values.begin() + (values.size() - 1) * share;
        std::nth_element(values.begin(), place, values.end());
        return *place > 0 ? *place : 1;
      }



      double
      median(vtkDataArray &field)
      {
        std::vector<float> values(field.GetNumberOfTuples());
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = field.GetComponent(i, 0);
        return quantile(values, 0.5);
      }



      /// Thickness of the cut in spacings of the particles.
      constexpr double spacings_in_cut = 1.5;



      /// A body's particles next to the middle plane z = 0.
      struct Cut
      {
        double                 thickness = 0;
        std::set<std::int64_t> ids;

        Cut(vtkUnstructuredGrid &grid, const std::string &file)
        {
          auto              &id      = point_field(grid, "id", 1, file);
          auto              &mass    = point_field(grid, "mass", 1, file);
          auto              &density = point_field(grid, "density", 1, file);
          const auto         n       = grid.GetNumberOfPoints();
          std::vector<float> spacings;
          double             least_z = 0;
          for (vtkIdType i = 0; i < n; ++i)
            {
              spacings.push_back(std::cbrt(mass.GetComponent(i, 0) /
                                           density.GetComponent(i, 0)));
              least_z = std::min(least_z, grid.GetPoint(i)[2]);
            }
          thickness = spacings_in_cut * quantile(spacings, 0.5);
          // To one side where a symmetry plane ends the grid there.
          const double begin = least_z < -thickness ? -thickness / 2 : 0;
          for (vtkIdType i = 0; i < n; ++i)
            if (const double z = grid.GetPoint(i)[2] - begin;
                z >= 0 && z < thickness)
              ids.insert(id.GetComponent(i, 0));
        }
      };



      unsigned int
      clamped(const double code, const unsigned int largest)
      {
        return std::lround(std::clamp(code, 0., double(largest)));
      }



      void
      append_planes(std::vector<std::uint8_t>        &bytes,
                    const std::vector<std::uint16_t> &values)
      {
        for (const auto value : values)
          bytes.push_back(value & 0xff);
        for (const auto value : values)
          bytes.push_back(value >> 8);
      }
    } // namespace



    ParticleFrames::ParticleFrames(const std::vector<FieldFile> &all_files,
                                   const Space                   space)
      : files(all_files)
      , n_frames_of_run(files.size())
      , n_particles_of_run(0)
      , n_particles_shown(0)
    {
      if (files.empty())
        return;
      const auto         first = read_fields(files.front().file);
      std::optional<Cut> cut;
      if (space == Space::body)
        cut.emplace(*first, files.front().file);
      n_particles_of_run = first->GetNumberOfPoints();
      n_particles_shown  = cut ? cut->ids.size() : n_particles_of_run;
      // Of so many particles every second, third … only.
      const std::int64_t every =
        1 + n_particles_shown * least_frames / largest_count;
      choose_frames(n_particles_shown / every);

      double filled_density = 1;
      for (const auto &[time, file] : files)
        {
          const auto grid     = read_fields(file);
          auto      &id       = point_field(*grid, "id", 1, file);
          auto      &velocity = point_field(*grid, "velocity", 3, file);
          auto      &p        = point_field(*grid, "pressure", 1, file);
          auto      &layer    = point_field(*grid, "layer", 1, file);
          auto      &mass     = point_field(*grid, "mass", 1, file);
          auto      &density  = point_field(*grid, "density", 1, file);
          Frame     &frame    = frames.emplace_back();
          if (frames.size() == 1)
            filled_density = median(density);
          const auto n = grid->GetNumberOfPoints();
          for (vtkIdType i = 0; i < n; ++i)
            {
              const auto number = std::int64_t(id.GetComponent(i, 0));
              if (number % every != 0 || (cut && cut->ids.count(number) == 0))
                continue;
              const double *const x = grid->GetPoint(i);
              // Not that of loose material in its fall.
              double area = mass.GetComponent(i, 0) / filled_density * every;
              if (space == Space::round)
                area /= 2 * pi * std::max(std::abs(x[0]), 1e-9);
              else if (cut)
                area /= cut->thickness;
              frame.push_back({number,
                               float(x[0]),
                               float(x[1]),
                               float(std::hypot(velocity.GetComponent(i, 0),
                                                velocity.GetComponent(i, 1),
                                                velocity.GetComponent(i, 2))),
                               float(p.GetComponent(i, 0)),
                               float(std::sqrt(area)),
                               int(layer.GetComponent(i, 0))});
              slots.emplace(number, 0);
            }
        }
      std::uint32_t slot = 0;
      for (auto &entry : slots)
        entry.second = slot++;
      choose_scales();
    }



    void
    ParticleFrames::choose_frames(const std::size_t n_particles)
    {
      const std::size_t n_largest = std::max<std::size_t>(
        least_frames, largest_count / std::max<std::size_t>(1, n_particles));
      if (files.size() <= n_largest)
        return;
      std::vector<FieldFile> chosen;
      for (std::size_t i = 0; i < n_largest; ++i)
        chosen.push_back(files[i * (files.size() - 1) / (n_largest - 1)]);
      files = chosen;
    }



    void
    ParticleFrames::choose_scales()
    {
      std::vector<float> speeds, pressures, sizes;
      double             x_1 = -1e300, y_1 = -1e300;
      x_0 = y_0 = 1e300;
      for (const Frame &frame : frames)
        for (const Particle &particle : frame)
          {
            x_0 = std::min<double>(x_0, particle.x);
            x_1 = std::max<double>(x_1, particle.x);
            y_0 = std::min<double>(y_0, particle.y);
            y_1 = std::max<double>(y_1, particle.y);
            speeds.push_back(particle.speed);
            pressures.push_back(particle.pressure);
            sizes.push_back(particle.size);
          }
      if (sizes.empty())
        x_0 = y_0 = x_1 = y_1 = 0;
      step     = std::max({x_1 - x_0, y_1 - y_0, 1e-9}) / n_steps;
      speed    = quantile(speeds, 0.999);
      pressure = quantile(pressures, 0.999);
      size     = quantile(sizes, 0.5);
    }



    std::string
    ParticleFrames::description() const
    {
      std::ostringstream json;
      json.precision(9);
      json << "{\"particles\": " << slots.size()
           << ", \"of_particles\": " << n_particles_of_run
           << ", \"in_cut\": " << n_particles_shown
           << ", \"of_frames\": " << n_frames_of_run << ", \"times\": [";
      for (std::size_t f = 0; f < files.size(); ++f)
        json << (f == 0 ? "" : ", ") << files[f].time;
      json << "], \"origin\": [" << x_0 << ", " << y_0
           << "], \"step\": " << step << ", \"speed\": " << speed
           << ", \"speed_decades\": " << speed_decades
           << ", \"pressure\": " << pressure << ", \"size\": " << size << '}';
      return json.str();
    }



    template <typename Code>
    void
    ParticleFrames::append_differences(std::vector<std::uint8_t> &bytes,
                                       const Code                 code) const
    {
      std::vector<std::uint16_t> last(slots.size(), 0);
      for (const Frame &frame : frames)
        {
          std::vector<std::uint16_t> difference(slots.size(), 0);
          for (const Particle &particle : frame)
            {
              const auto          slot  = slots.at(particle.id);
              const std::uint16_t value = code(particle);
              difference[slot]          = value - last[slot];
              last[slot]                = value;
            }
          append_planes(bytes, difference);
        }
    }



    std::vector<std::uint8_t>
    ParticleFrames::bytes() const
    {
      std::vector<std::uint8_t>  bytes(slots.size());
      std::vector<std::uint16_t> first(slots.size(), 0xffff),
        end(slots.size(), 0);
      for (std::size_t f = 0; f < frames.size(); ++f)
        for (const Particle &particle : frames[f])
          {
            const auto slot = slots.at(particle.id);
            bytes[slot]     = clamped(particle.layer, 255);
            first[slot]     = std::min<std::uint16_t>(first[slot], f);
            end[slot]       = f + 1;
          }
      append_planes(bytes, first);
      append_planes(bytes, end);
      append_differences(bytes, [this](const Particle &p) {
        return clamped((p.x - x_0) / step, n_steps);
      });
      append_differences(bytes, [this](const Particle &p) {
        return clamped((p.y - y_0) / step, n_steps);
      });
      append_differences(bytes, [this](const Particle &p) {
        return clamped(255 * (1 + std::log10(p.speed / speed) / speed_decades),
                       255);
      });
      append_differences(bytes, [this](const Particle &p) {
        return clamped(255 * p.pressure / pressure, 255);
      });
      append_differences(bytes, [this](const Particle &p) {
        return clamped(128 + 64 * std::log2(p.size / size), 255);
      });
      return bytes;
    }
  } // namespace Report
} // namespace Sandglass
