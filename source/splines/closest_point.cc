#include <asperity/splines/closest_point.h>
#include <asperity/splines/curve_pieces.h>
#include <asperity/splines/distance_certificate.h>
#include <asperity/splines/distance_minimizer.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace asperity
{
  using dealii::BoundingBox;
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    using IndexedBox   = std::pair<BoundingBox<2>, unsigned int>;
    using IndexedPoint = std::pair<Point<2>, unsigned int>;

    // A projection that would have to look at more turns than this is of a
    // point so far away that its closest point is of no use.
    constexpr double max_turns = 1e4;



    /** What the R-tree writes its finds to: each piece is examined at once. */
    struct Examiner
    {
      using iterator_category = std::output_iterator_tag;
      using value_type        = void;
      using difference_type   = void;
      using pointer           = void;
      using reference         = void;

      Examiner &
      operator=(const IndexedBox &found)
      {
        certificate->examine(found.second, turn);
        return *this;
      }

      Examiner &
      operator*()
      {
        return *this;
      }

      Examiner &
      operator++()
      {
        return *this;
      }

      Examiner
      operator++(int)
      {
        return *this;
      }

      DistanceCertificate *certificate;
      int                  turn;
    };
  } // namespace



  struct ClosestPoint::Implementation
  {
    Implementation(const SplineCurve &curve, const CurveSide free_side);

    CurveLocation
    seed(const Point<2> &point) const;

    Projection
    certified(const Point<2>          &point,
              const DistanceMinimizer &minimizer,
              const CurveLocation     &start) const;

    SplineCurve                 curve;
    CurvePieces                 pieces;
    CurveSide                   side;
    dealii::RTree<IndexedBox>   boxes;
    dealii::RTree<IndexedPoint> seeds;
    std::vector<CurveLocation>  seed_locations;

    double far = 0.; ///< a good guess would be closer [m]

    // Along the period: unit vector, its length, and the reach of one turn.
    Tensor<1, 2> direction;
    double       period = 0., reach_low = 0., reach_high = 0.;
  };



  ClosestPoint::Implementation::Implementation(const SplineCurve &curve,
                                               const CurveSide    free_side)
    : curve(curve)
    , pieces(curve)
    , side(free_side)
  {
    period = curve.period().norm();
    if (period > 0.)
      direction = curve.period() / period;
    reach_low  = std::numeric_limits<double>::max();
    reach_high = -reach_low;

    std::vector<IndexedBox>   all_boxes;
    std::vector<IndexedPoint> all_seeds;
    const unsigned int        n_seeds = std::max(4u, curve.degree() + 1);
    const auto                bezier  = curve.bezier_pieces();
    for (unsigned int i = 0; i < bezier.size(); ++i)
      {
        std::pair<Point<2>, Point<2>> corners(bezier[i].points[0],
                                              bezier[i].points[0]);
        for (const Point<2> &point : bezier[i].points)
          {
            for (unsigned int d = 0; d < 2; ++d)
              {
                corners.first[d]  = std::min(corners.first[d], point[d]);
                corners.second[d] = std::max(corners.second[d], point[d]);
              }
            reach_low  = std::min(reach_low, point * direction);
            reach_high = std::max(reach_high, point * direction);
          }
        all_boxes.emplace_back(BoundingBox<2>(corners), i);
        for (unsigned int k = 0; k < n_seeds; ++k)
          {
            CurveLocation location;
            location.piece = i;
            location.s     = -1. + (2. * k + 1.) / n_seeds;
            all_seeds.emplace_back(curve.value(pieces.parameter(location)),
                                   seed_locations.size());
            seed_locations.push_back(location);
          }
      }
    far   = pieces.extent() / 4.;
    boxes = dealii::pack_rtree(all_boxes);
    seeds = dealii::pack_rtree(all_seeds);
  }



  CurveLocation
  ClosestPoint::Implementation::seed(const Point<2> &point) const
  {
    // The curve of turn k near the point: look at the three most likely ones.
    const double middle_turn =
      period > 0. ?
        std::round((point * direction - (reach_low + reach_high) / 2.) /
                   period) :
        0.;
    CurveLocation best;
    double        best_distance = std::numeric_limits<double>::max();
    for (int offset = (period > 0. ? -1 : 0); offset <= (period > 0. ? 1 : 0);
         ++offset)
      {
        const double        turn    = middle_turn + offset;
        const Point<2>      shifted = point - turn * curve.period();
        const IndexedPoint &nearest =
          *seeds.qbegin(boost::geometry::index::nearest(shifted, 1));
        const double distance = (nearest.first - shifted).norm_square();
        if (distance < best_distance)
          {
            best_distance = distance;
            best          = seed_locations[nearest.second];
            best.turn     = int(turn);
          }
      }
    return best;
  }



  Projection
  ClosestPoint::Implementation::certified(const Point<2>          &point,
                                          const DistanceMinimizer &minimizer,
                                          const CurveLocation     &start) const
  {
    DistanceMinimizer::Result known = minimizer.minimize(start);
    // The certificate costs the more the farther the point found: do not pay
    // for a bad guess.
    if (known.jet.squared_distance() > far * far)
      {
        const auto other = minimizer.minimize(seed(point));
        if (other.jet.squared_distance() < known.jet.squared_distance())
          known = other;
      }
    DistanceCertificate certificate(
      pieces, point[0], point[1], minimizer, known);

    const double reach =
      std::sqrt(known.jet.squared_distance()) + minimizer.position_noise();
    double first = 0., last = 0.;
    if (period > 0.)
      {
        first = std::ceil((point * direction - reach - reach_high) / period);
        last  = std::floor((point * direction + reach - reach_low) / period);
      }
    const bool all_turns = (last - first < max_turns) && std::isfinite(reach);
    if (all_turns)
      for (double turn = first; turn <= last; ++turn)
        {
          const Point<2> shifted = point - turn * curve.period();
          const Point<2> margin(reach, reach);
          Examiner       examiner;
          examiner.certificate = &certificate;
          examiner.turn        = int(turn);
          boxes.query(boost::geometry::index::intersects(BoundingBox<2>(
                        std::make_pair(Point<2>(shifted - margin),
                                       Point<2>(shifted + margin)))),
                      examiner);
        }
    Projection projection = minimizer.describe(certificate.best(), side);
    projection.iterations = known.iterations;
    projection.certified  = all_turns;
    if (all_turns && projection.method == Projection::Method::none)
      {
        // The search of all pieces found nothing better either.
        projection.method    = Projection::Method::subdivision;
        projection.converged = true;
      }
    return projection;
  }



  ClosestPoint::ClosestPoint(const SplineCurve &curve,
                             const CurveSide    free_side)
    : implementation(std::make_unique<const Implementation>(curve, free_side))
  {}



  ClosestPoint::~ClosestPoint() = default;



  const SplineCurve &
  ClosestPoint::curve() const
  {
    return implementation->curve;
  }



  Projection
  ClosestPoint::project(const Point<2> &point) const
  {
    const DistanceMinimizer minimizer(implementation->pieces,
                                      point[0],
                                      point[1]);
    return implementation->certified(point,
                                     minimizer,
                                     implementation->seed(point));
  }



  Projection
  ClosestPoint::project(const Point<2> &point, const double guess) const
  {
    const DistanceMinimizer minimizer(implementation->pieces,
                                      point[0],
                                      point[1]);
    CurveLocation           start = implementation->pieces.locate(guess);
    if (implementation->period > 0.)
      {
        // the turn of the guess may be any
        const DistanceJet jet =
          implementation->pieces.jet(start, point[0], point[1]);
        const Tensor<1, 2> way = Point<2>(-jet.rx, -jet.ry);
        start.turn += int(std::lround(way * implementation->direction /
                                      implementation->period));
      }
    return implementation->certified(point, minimizer, start);
  }

} // namespace asperity
