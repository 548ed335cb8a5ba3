#ifndef sandglass_flow_updated_lagrangian_rezoning_field_h
#define sandglass_flow_updated_lagrangian_rezoning_field_h

#include <algorithm>
#include <vector>

namespace Sandglass
{
  /// Values at nodes, or at quadrature points, cell by cell: the components of
  /// the first, then those of the next.
  struct MeshField
  {
    unsigned int        n_components = 0;
    std::vector<double> values       = {};

    /// Zero at so many nodes or points.
    static MeshField
    zero(const unsigned int n_components, const std::size_t n)
    {
      return {n_components, std::vector<double>(n_components * n, 0.)};
    }

    double *
    at(const std::size_t i)
    {
      return values.data() + n_components * i;
    }

    const double *
    at(const std::size_t i) const
    {
      return values.data() + n_components * i;
    }

    /// The values at blocks of nodes or points that lie one after the other:
    /// those of a cell are a block of as many as it has quadrature points.
    MeshField
    at_blocks(const std::vector<unsigned int> &blocks,
              const unsigned int               block_size = 1) const
    {
      MeshField    result = zero(n_components, blocks.size() * block_size);
      const size_t n      = n_components * block_size;
      for (std::size_t i = 0; i < blocks.size(); ++i)
        std::copy_n(values.begin() + n * blocks[i],
                    n,
                    result.values.begin() + n * i);
      return result;
    }
  };
} // namespace Sandglass

#endif
