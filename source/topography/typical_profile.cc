#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/missing_data.h>
#include <asperity/topography/periodic_continuation.h>
#include <asperity/topography/roughness.h>
#include <asperity/topography/typical_profile.h>

#include <algorithm>
#include <utility>

namespace asperity
{
  namespace
  {
    /** More lines or pieces of a line say nothing new. */
    constexpr unsigned int max_lines       = 256;
    constexpr unsigned int pieces_a_length = 4;

    /** How much a jump of one Rq at the seam counts against a factor e in Rq
     *  or Rdq. */
    constexpr double weight_of_jump = 0.1;

    /** Pieces that are tried as periodic profiles. */
    constexpr unsigned int max_trials = 30;

    struct Piece
    {
      TypicalProfile place;
      Profile        profile;
      double         jump     = 0.; ///< of its ends about its line, over Rq
      double         distance = 0.; ///< from the medians
    };

    bool
    is_along_y(const HeightMap &map, const double direction)
    {
      return map.ny > 1 && std::abs(std::sin(direction)) > std::sqrt(0.5);
    }

    ProfileLine
    line_through(const HeightMap &map, const double direction, const double n)
    {
      ProfileLine line;
      line.angle = direction;
      line.x     = 0.5 * (map.nx - 1) * map.dx;
      line.y     = 0.5 * (map.ny - 1) * map.dy;
      if (is_along_y(map, direction))
        line.x = n * map.dx;
      else
        line.y = n * map.dy;
      return line;
    }

    /** Rq and Rdq of the valid heights about their least-squares line. */
    void
    measure(Piece &piece)
    {
      std::vector<double> heights = piece.profile.heights;
      double              sum_x = 0., sum_z = 0., xx = 0., xz = 0.;
      std::size_t         n = 0;
      for (std::size_t i = 0; i < heights.size(); ++i)
        if (!std::isnan(heights[i]))
          {
            sum_x += i;
            sum_z += heights[i];
            ++n;
          }
      piece.place.n_missing = heights.size() - n;
      for (std::size_t i = 0; i < heights.size(); ++i)
        if (!std::isnan(heights[i]))
          {
            xx += (i - sum_x / n) * (i - sum_x / n);
            xz += (i - sum_x / n) * (heights[i] - sum_z / n);
          }
      for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] -= xx > 0. ? xz / xx * i : 0.;
      const ProfileRoughness roughness =
        profile_roughness(heights, piece.profile.spacing);
      piece.place.Rq    = roughness.Rq;
      piece.place.Rdq   = roughness.Rdq;
      const double jump = std::abs(heights.back() - heights.front());
      piece.jump =
        roughness.Rq > 0. && !std::isnan(jump) ? jump / roughness.Rq : 0.;
    }

    /** The pieces of one line that keep the margin. */
    void
    collect(const Profile        &profile,
            const TypicalProfile &place,
            const double          length,
            const double          margin,
            std::vector<Piece>   &pieces)
    {
      const std::size_t n = profile.heights.size();
      const std::size_t n_piece =
        std::min<std::size_t>(n, std::lround(length / profile.spacing) + 1);
      const std::size_t room = n - n_piece;
      const std::size_t edge =
        std::min<std::size_t>(room / 2, std::ceil(margin / profile.spacing));
      const std::size_t step =
        std::max<std::size_t>(1, n_piece / pieces_a_length);
      for (std::size_t first = edge; first <= room - edge; first += step)
        {
          Piece piece;
          piece.place        = place;
          piece.place.start  = first * profile.spacing;
          piece.place.length = n_piece * profile.spacing;
          const auto begin   = profile.heights.begin() + first;
          piece.profile      = {{begin, begin + n_piece}, profile.spacing};
          measure(piece);
          if (piece.place.n_missing < n_piece)
            pieces.push_back(piece);
        }
    }

    /** Of the values that are numbers; zero if there are none. */
    double
    median(std::vector<double> values)
    {
      values.erase(std::remove_if(values.begin(),
                                  values.end(),
                                  [](const double v) { return std::isnan(v); }),
                   values.end());
      if (values.empty())
        return 0.;
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    }

    /** In the logarithm; what has no logarithm is far from what has one. */
    double
    distance(const double value, const double reference)
    {
      if (!(value > 0.) || !(reference > 0.))
        return value > 0. || reference > 0. ? 100. : 0.;
      return std::abs(std::log(value / reference));
    }

    std::vector<Piece>
    all_pieces(const HeightMap &map,
               const double     direction,
               const double     length,
               const double     margin)
    {
      TypicalProfile place;
      place.along_y              = is_along_y(map, direction);
      const unsigned int n_lines = place.along_y ? map.nx : map.ny;
      const double       spacing = place.along_y ? map.dx : map.dy;
      const unsigned int edge =
        std::min<double>((n_lines - 1) / 2, std::ceil(margin / spacing));
      const unsigned int step = std::max(1u, (n_lines - 2 * edge) / max_lines);
      std::vector<Piece> pieces;
      for (place.line = edge; place.line < n_lines - edge; place.line += step)
        try
          {
            collect(extract_profile(map,
                                    line_through(map, direction, place.line)),
                    place,
                    length,
                    margin,
                    pieces);
          }
        catch (const InputError &)
          {} // a slanting line that only cuts a corner of the map
      return pieces;
    }
    /** Of the first pieces of the list the one that is nearest to the medians
     *  when its ends have been joined. */
    const Piece &
    best_when_periodic(const std::vector<Piece> &pieces,
                       const double              median_Rq,
                       const double              median_Rdq)
    {
      const Piece *best          = &pieces.front();
      double       best_distance = std::numeric_limits<double>::infinity();
      for (const Piece &piece : pieces)
        {
          if (&piece - pieces.data() >= max_trials ||
              piece.place.n_missing > pieces.front().place.n_missing)
            break;
          Profile profile = piece.profile;
          fill_gaps(profile.heights);
          ContinuationReport report;
          profile = make_periodic(profile,
                                  Continuation::wrapped_spline,
                                  WrappedSplineOptions(),
                                  report);
          const ProfileRoughness roughness =
            profile_roughness(profile.heights, profile.spacing);
          const double d = distance(roughness.Rq, median_Rq) +
                           distance(roughness.Rdq, median_Rdq) +
                           distance(report.Rq_after, report.Rq_before);
          if (d < best_distance)
            {
              best          = &piece;
              best_distance = d;
            }
        }
      return *best;
    }
  } // namespace



  double
  length_through_middle(const HeightMap &map, const double direction)
  {
    const double n =
      is_along_y(map, direction) ? (map.nx - 1) / 2 : (map.ny - 1) / 2;
    return extract_profile(map, line_through(map, direction, n), 2).length();
  }



  TypicalProfile
  find_typical_profile(const HeightMap &map,
                       const double     direction,
                       const double     length,
                       const double     margin)
  {
    std::vector<Piece> pieces = all_pieces(map, direction, length, margin);
    if (pieces.empty())
      throw InputError("No profile of " + quoted_name(map.provenance.file) +
                       " in the direction that was chosen has ten samples.");
    double longest = 0.;
    for (const Piece &piece : pieces)
      longest = std::max(longest, piece.place.length);
    pieces.erase(std::remove_if(pieces.begin(),
                                pieces.end(),
                                [&](const Piece &piece) {
                                  return piece.place.length < 0.999 * longest;
                                }),
                 pieces.end());
    std::vector<double> Rq, Rdq;
    for (const Piece &piece : pieces)
      {
        Rq.push_back(piece.place.Rq);
        Rdq.push_back(piece.place.Rdq);
      }
    const double median_Rq = median(Rq), median_Rdq = median(Rdq);

    for (Piece &piece : pieces)
      piece.distance = distance(piece.place.Rq, median_Rq) +
                       distance(piece.place.Rdq, median_Rdq) +
                       weight_of_jump * piece.jump;
    std::stable_sort(pieces.begin(),
                     pieces.end(),
                     [](const Piece &a, const Piece &b) {
                       return std::pair(a.place.n_missing, a.distance) <
                              std::pair(b.place.n_missing, b.distance);
                     });
    TypicalProfile result =
      best_when_periodic(pieces, median_Rq, median_Rdq).place;
    result.median_Rq  = median_Rq;
    result.median_Rdq = median_Rdq;
    result.n_pieces   = pieces.size();
    return result;
  }
} // namespace asperity
