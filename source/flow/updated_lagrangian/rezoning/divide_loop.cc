#include <sandglass/flow/updated_lagrangian/rezoning/divide_loop.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Height of a piece's middle over its chord's length.
    constexpr double largest_bulge = 0.125;

    /// How often a piece may be halved.
    constexpr unsigned int most_halvings = 3;



    /// A sequence of old pieces between two corners, with the number of wanted
    /// edges from its start to each of its points.
    class Chain
    {
    public:
      Chain(std::vector<BoundaryPiece> pieces, const SizeField &size)
        : pieces(std::move(pieces))
        , n_edges(1, 0.)
      {
        for (const BoundaryPiece &piece : this->pieces)
          for (unsigned int i = 0; i < n_samples; ++i)
            {
              const double   t = (i + 0.5) / n_samples;
              const Point<2> p = position_on_curve(piece.curve, t);
              n_edges.push_back(n_edges.back() +
                                derivative_on_curve(piece.curve, t).norm() /
                                  n_samples / size.at(p));
            }
      }

      double
      length_in_edges() const
      {
        return n_edges.back();
      }

      /// The old piece and its parameter, as their sum, up to which there are
      /// so many edges.
      double
      place_after(const double edges) const
      {
        const auto above =
          std::lower_bound(n_edges.begin() + 1, n_edges.end() - 1, edges);
        const double low   = *(above - 1);
        const double share = (edges - low) / (*above - low);
        return (above - 1 - n_edges.begin() +
                std::min(std::max(share, 0.), 1.)) /
               n_samples;
      }

      Point<2>
      position(const double place) const
      {
        const unsigned int i = index(place);
        return position_on_curve(pieces[i].curve, place - i);
      }

      /// Area between the old boundary and a chord of it.
      double
      area_beyond_chord(const double first, const double last) const
      {
        const Point<2> origin = position(first);
        double         area   = 0.;
        for (unsigned int i = index(first); i < pieces.size() && i < last; ++i)
          area += swept_area(part_of_curve(pieces[i].curve,
                                           std::max(first - i, 0.),
                                           std::min(last - i, 1.)),
                             origin);
        return area;
      }

      unsigned int
      mark() const
      {
        return pieces.front().mark;
      }

    private:
      unsigned int
      index(const double place) const
      {
        return std::min<std::size_t>(place, pieces.size() - 1);
      }

      static constexpr unsigned int n_samples = 8; ///< of an old piece

      const std::vector<BoundaryPiece> pieces;
      std::vector<double>              n_edges;
    };



    /// Divides one chain.
    class ChainDivider
    {
    public:
      ChainDivider(const Chain       &chain,
                   const unsigned int order,
                   BoundaryLoop      &result)
        : chain(chain)
        , order(order)
        , result(result)
      {}

      void
      divide(const unsigned int fewest)
      {
        const double       length = chain.length_in_edges();
        const unsigned int n =
          std::max<unsigned int>(fewest, std::round(length));
        const std::size_t first = result.size();
        for (unsigned int i = 0; i < n; ++i)
          add(length * (1. * i / n), length * ((i + 1.) / n), most_halvings);
        result[first].starts_at_corner = true;
      }

    private:
      void
      add(const double first, const double last, const unsigned int halvings)
      {
        const double   start_place = chain.place_after(first);
        const double   end_place   = chain.place_after(last);
        const Point<2> start       = chain.position(start_place);
        const Point<2> end         = chain.position(end_place);

        const Tensor<1, 2> chord = end - start;
        // A quadratic piece bulges by two thirds of chord times height.
        const double bulge = 1.5 *
                             chain.area_beyond_chord(start_place, end_place) /
                             chord.norm_square();
        if (!(std::abs(bulge) <= largest_bulge) && halvings > 0)
          {
            const double middle = (first + last) / 2.;
            add(first, middle, halvings - 1);
            add(middle, last, halvings - 1);
            return;
          }
        Point<2> middle = start + chord / 2.;
        if (order == 2 && chord.norm_square() > 0.)
          middle += std::min(std::max(bulge, -largest_bulge), largest_bulge) *
                    Tensor<1, 2>({chord[1], -chord[0]});
        result.push_back({{{start, end, middle}}, chain.mark(), false});
      }

      const Chain       &chain;
      const unsigned int order;
      BoundaryLoop      &result;
    };
  } // namespace



  BoundaryLoop
  divide_loop(const BoundaryLoop &loop,
              const SizeField    &size,
              const unsigned int  order)
  {
    const auto is_corner = [](const BoundaryPiece &piece) {
      return piece.starts_at_corner;
    };
    const auto first_corner = std::find_if(loop.begin(), loop.end(), is_corner);
    BoundaryLoop old        = loop;
    if (first_corner != loop.end())
      std::rotate(old.begin(),
                  old.begin() + (first_corner - loop.begin()),
                  old.end());
    const unsigned int n_corners =
      std::count_if(loop.begin(), loop.end(), is_corner);
    // A closed loop of quadratic pieces needs three.
    const unsigned int fewest = n_corners < 2 ? 3 : n_corners == 2 ? 2 : 1;

    BoundaryLoop result;
    for (auto start = old.begin(); start != old.end();)
      {
        const auto  end = std::find_if(start + 1, old.end(), is_corner);
        const Chain chain({start, end}, size);
        ChainDivider(chain, order, result).divide(fewest);
        start = end;
      }
    if (n_corners == 0)
      result.front().starts_at_corner = false;
    return result;
  }
} // namespace Sandglass
