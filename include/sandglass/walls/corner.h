#ifndef sandglass_walls_corner_h
#define sandglass_walls_corner_h

#include <sandglass/walls/support.h>

#include <array>

namespace Sandglass
{
  /**
   * @file
   * The rule for corners, the same for the state at rest and for nodes in
   * motion: a node that several supports hold keeps what velocity its normals
   * leave it, and the supports share its force along their normals.
   */

  /// Some of a node's supports: bit k for support k.
  using SupportSet = unsigned int;

  constexpr SupportSet
  all_supports(const unsigned int n)
  {
    return (1u << n) - 1;
  }

  constexpr bool
  contains(const SupportSet set, const unsigned int support)
  {
    return (set >> support & 1u) != 0;
  }

  /// How many supports a set has.
  constexpr unsigned int
  n_supports(SupportSet set)
  {
    unsigned int n = 0;
    for (; set != 0; set &= set - 1)
      ++n;
    return n;
  }

  /// The directions in which a set of supports holds a node.
  template <int dim>
  class HeldDirections
  {
  public:
    HeldDirections(const Supports<dim> &supports, const SupportSet set)
    {
      for (unsigned int k = 0; k < supports.size(); ++k)
        if (contains(set, k))
          add(supports[k].normal, k);
    }

    /// What is left of a vector where the held directions take theirs.
    Tensor<1, dim>
    left_of(const Tensor<1, dim> &vector) const
    {
      if (n == dim)
        return {};
      Tensor<1, dim> left = vector;
      for (unsigned int i = 0; i < n; ++i)
        left -= (vector * basis[i]) * basis[i];
      return left;
    }

    /**
     * Coefficient of each support's normal in a sum that makes up the held part
     * of a vector; zero for supports that are not in the set.
     */
    std::array<double, dim>
    split(const Tensor<1, dim> &vector) const
    {
      std::array<double, dim> coefficients{};
      // The last normal alone has a part along the last direction.
      for (unsigned int i = n; i-- > 0;)
        {
          double rest = vector * basis[i];
          for (unsigned int j = i + 1; j < n; ++j)
            rest -= (normals[j] * basis[i]) * coefficients[support[j]];
          coefficients[support[i]] = rest / (normals[i] * basis[i]);
        }
      return coefficients;
    }

  private:
    void
    add(const Tensor<1, dim> &normal, const unsigned int k)
    {
      normals[n] = basis[n] = normal;
      support[n]            = k;
      for (unsigned int i = 0; i < n; ++i)
        basis[n] -= (normal * basis[i]) * basis[i];
      if (n > 0)
        {
          const double norm = basis[n].norm();
          Assert(norm > 1e-8, ExcMessage("Supports have the same direction."));
          basis[n] /= norm;
        }
      ++n;
    }

    unsigned int n = 0; ///< how many directions are held
    /// Of the supports in the set, and an orthonormal basis of them.
    std::array<Tensor<1, dim>, dim> normals, basis;
    std::array<unsigned int, dim>   support{};
  };

  /// holding_supports() of a node with several supports.
  template <int dim>
  SupportSet
  holding_in_corner(const Supports<dim>  &supports,
                    const Tensor<1, dim> &velocity)
  {
    const auto all_hold = [&](const SupportSet               set,
                              const std::array<double, dim> &pressures) {
      for (unsigned int k = 0; k < supports.size(); ++k)
        if (contains(set, k) && !supports[k].is_axis && pressures[k] <= 0.)
          return false;
      return true;
    };
    const auto others_let_pass = [&](const SupportSet      set,
                                     const Tensor<1, dim> &left) {
      for (unsigned int k = 0; k < supports.size(); ++k)
        if (!contains(set, k) &&
            (supports[k].is_axis || left * supports[k].normal > 0.))
          return false;
      return true;
    };

    const SupportSet all = all_supports(supports.size());
    for (unsigned int n = 0; n < supports.size(); ++n)
      for (SupportSet set = 0; set < all; ++set)
        if (n_supports(set) == n)
          {
            const HeldDirections<dim> held(supports, set);
            if (all_hold(set, held.split(velocity)) &&
                others_let_pass(set, held.left_of(velocity)))
              return set;
          }
    return all;
  }



  /**
   * The supports that hold a node with this velocity: the smallest set that
   * leaves nothing that another support would have to stop, and none of which
   * would have to pull. The axis always holds.
   */
  template <int dim>
  inline SupportSet
  holding_supports(const Supports<dim>  &supports,
                   const Tensor<1, dim> &velocity)
  {
    if (supports.size() == 1) // as nearly all nodes have
      return supports[0].is_axis || velocity * supports[0].normal > 0. ? 1 : 0;
    return holding_in_corner<dim>(supports, velocity);
  }
} // namespace Sandglass

#endif
