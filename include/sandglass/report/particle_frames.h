#ifndef sandglass_report_particle_frames_h
#define sandglass_report_particle_frames_h

#include <sandglass/report/field_files.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    /**
     * The particles at the times of their files, in so few bytes that a page
     * can hold them: places as multiples of a length, speed and pressure as
     * one byte each, all as differences from the frame before.
     *
     * Frames and particles are left out, evenly, where there would be more
     * than `largest_count` of their products.
     */
    class ParticleFrames
    {
    public:
      static constexpr unsigned long largest_count = 2'500'000;

      /// What particles are: of a metre of depth, rings round x = 0, or pieces
      /// of a body, of which those are shown that lie next to the plane z = 0
      /// at the start.
      enum class Space
      {
        plane,
        round,
        body
      };

      /**
       * @param files  of particles.pvd; may be none.
       *
       * Throws InputError where a file is missing or damaged.
       */
      ParticleFrames(const std::vector<FieldFile> &files, Space space);

      /**
       * What the bytes mean, in JSON: `particles` and `times`, numbers
       * `of_particles` and `of_frames` of the run, `in_cut` of its particles
       * those that a cut leaves, the `origin` (m) and the
       * `step` (m) of places, the `speed` (m/s) and `pressure` (Pa) of code
       * 255, the `speed_decades` below it that codes of speed divide
       * evenly, and the `size` (m) of code 128, of which 64 are a factor of 2.
       */
      std::string
      description() const;

      /**
       * In this order: of each particle the layer (counted from 1), the first
       * frame and the one after the last in which it exists; then of each
       * frame x, y, speed, pressure and size of each particle, each field for
       * all frames before the next, as the difference from the frame before,
       * and 0 where it doesn't exist. Numbers of two bytes stand as all lower,
       * then all upper bytes.
       */
      std::vector<std::uint8_t>
      bytes() const;

    private:
      struct Particle
      {
        std::int64_t id;
        float        x, y, speed, pressure, size;
        int          layer;
      };
      using Frame = std::vector<Particle>;

      void
      choose_frames(std::size_t n_particles);
      void
      choose_scales();
      template <typename Code>
      void
      append_differences(std::vector<std::uint8_t> &bytes, Code code) const;

      std::vector<FieldFile> files;
      std::size_t        n_frames_of_run, n_particles_of_run, n_particles_shown;
      std::vector<Frame> frames;
      std::map<std::int64_t, std::uint32_t> slots; // of each id
      double x_0 = 0, y_0 = 0, step = 1, speed = 1, pressure = 1, size = 1;
    };
  } // namespace Report
} // namespace Sandglass

#endif
