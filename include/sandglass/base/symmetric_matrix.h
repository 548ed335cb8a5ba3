#ifndef sandglass_base_symmetric_matrix_h
#define sandglass_base_symmetric_matrix_h

#include <sandglass/base/lanes.h>

#include <algorithm>
#include <array>

namespace Sandglass
{
  /**
   * A symmetric matrix of which little more than half is stored: square tiles
   * as wide as Lanes, those on the diagonal and above it. Zeros fill the last
   * ones up.
   */
  template <unsigned int n>
  class SymmetricMatrix
  {
  public:
    /// Set an entry on the diagonal or above it, and the one that mirrors it.
    void
    set(const unsigned int row, const unsigned int column, const double value)
    {
      entries[place(row, column)] = value;
      if (row / width == column / width)
        entries[place(column, row)] = value;
    }

    /// product = matrix times vector, both of n numbers.
    void
    multiply(const double *vector, double *product) const
    {
      alignas(Lanes) std::array<double, width * n_tiles> x;
      std::copy_n(vector, n, x.begin());
      std::fill(x.begin() + n, x.end(), 0.);
      std::array<Lanes, n_tiles> y;
      y.fill(Lanes(0.));
      const double *row = entries.data();
      for (unsigned int i = 0; i < n_tiles; ++i)
        {
          std::array<Lanes, width> along; // the rows' products, not summed yet
          along.fill(Lanes(0.));
          for (unsigned int j = i; j < n_tiles; ++j)
            for (unsigned int k = 0; k < width; ++k, row += width)
              {
                along[k] += lanes(row) * lanes(&x[width * j]);
                if (i != j)
                  y[j] += lanes(row) * Lanes(x[width * i + k]);
              }
          y[i] += sums_of_four(along[0], along[1], along[2], along[3]);
        }
      std::copy_n(reinterpret_cast<const double *>(y.data()), n, product);
    }

  private:
    static constexpr unsigned int width   = Lanes::n;
    static constexpr unsigned int n_tiles = (n + width - 1) / width;

    /// Where an entry is stored, in a tile that is not below the diagonal.
    static constexpr unsigned int
    place(const unsigned int row, const unsigned int column)
    {
      const unsigned int i = row / width, j = column / width;
      const unsigned int tile = i * n_tiles - i * (i + 1) / 2 + j;
      return width * (width * tile + row % width) + column % width;
    }

    /// Numbers side by side, where they are: a copy would pass through memory.
    static const Lanes &
    lanes(const double *numbers)
    {
      return *reinterpret_cast<const Lanes *>(numbers);
    }

    alignas(Lanes)
      std::array<double, width * width * n_tiles *(n_tiles + 1) / 2> entries{};
  };
} // namespace Sandglass

#endif
