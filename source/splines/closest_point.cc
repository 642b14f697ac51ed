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



    double
    cross(const double ax, const double ay, const double bx, const double by)
    {
      return ax * by - ay * bx;
    }
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

    Projection
    describe(const DistanceMinimizer::Result &result,
             const DistanceMinimizer         &minimizer,
             const Point<2>                  &point) const;

    void
    describe_piece_end(const DistanceMinimizer::Result &result,
                       const DistanceMinimizer         &minimizer,
                       const Point<2>                  &point,
                       Projection                      &projection) const;

    SplineCurve                 curve;
    CurvePieces                 pieces;
    double                      side; ///< 1 if the left side is free, else -1
    dealii::RTree<IndexedBox>   boxes;
    dealii::RTree<IndexedPoint> seeds;
    std::vector<CurveLocation>  seed_locations;

    // Along the period: unit vector, its length, and the reach of one turn.
    Tensor<1, 2> direction;
    double       period = 0., reach_low = 0., reach_high = 0.;
  };



  ClosestPoint::Implementation::Implementation(const SplineCurve &curve,
                                               const CurveSide    free_side)
    : curve(curve)
    , pieces(curve)
    , side(free_side == CurveSide::left ? 1. : -1.)
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
    const DistanceMinimizer::Result known = minimizer.minimize(start);
    DistanceCertificate             certificate(
      pieces, point[0], point[1], minimizer, known);

    const double reach =
      std::sqrt(known.jet.squared_distance()) + minimizer.position_noise();
    double first = 0., last = 0.;
    if (period > 0.)
      {
        first = std::ceil((point * direction - reach - reach_high) / period);
        last  = std::floor((point * direction + reach - reach_low) / period);
      }
    const bool all_turns = (last - first < max_turns);
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
    Projection projection = describe(certificate.best(), minimizer, point);
    projection.iterations = known.iterations;
    projection.certified  = all_turns;
    projection.converged  = projection.converged || all_turns;
    return projection;
  }



  Projection
  ClosestPoint::Implementation::describe(
    const DistanceMinimizer::Result &result,
    const DistanceMinimizer         &minimizer,
    const Point<2>                  &point) const
  {
    const DistanceJet &jet = result.jet;
    Projection         projection;
    projection.parameter  = pieces.parameter(result.location);
    projection.point      = Point<2>(point[0] + jet.rx, point[1] + jet.ry);
    projection.method     = result.method;
    projection.iterations = result.iterations;
    projection.converged  = (result.method != Projection::Method::none);

    const double speed = std::sqrt(jet.squared_speed());
    // Where the curve stops for a moment its direction is that of the second
    // derivative.
    double tx = jet.x1, ty = jet.y1, norm = speed;
    if (!(speed > 0.))
      {
        tx   = -result.location.s * jet.x2;
        ty   = -result.location.s * jet.y2;
        norm = std::hypot(tx, ty);
      }
    if (norm > 0.)
      {
        projection.tangent[0] = tx / norm;
        projection.tangent[1] = ty / norm;
      }
    projection.speed = speed / pieces.parameter_scale(result.location.piece);
    projection.normal[0] = -side * projection.tangent[1];
    projection.normal[1] = side * projection.tangent[0];
    if (speed > 0.)
      projection.curvature =
        side * cross(jet.x1, jet.y1, jet.x2, jet.y2) / (speed * speed * speed);
    projection.distance =
      -(jet.rx * projection.normal[0] + jet.ry * projection.normal[1]);

    if (std::abs(result.location.s) == 1.)
      describe_piece_end(result, minimizer, point, projection);
    return projection;
  }



  void
  ClosestPoint::Implementation::describe_piece_end(
    const DistanceMinimizer::Result &result,
    const DistanceMinimizer         &minimizer,
    const Point<2>                  &point,
    Projection                      &projection) const
  {
    const DistanceJet &jet      = result.jet;
    const double       distance = std::sqrt(jet.squared_distance());
    const double       slip =
      std::abs(jet.rx * projection.tangent[0] + jet.ry * projection.tangent[1]);
    const bool normal_here =
      slip <= 1e-10 * distance + 4. * minimizer.position_noise();

    Tensor<1, 2>  mean_normal = projection.normal;
    CurveLocation other       = result.location;
    const int     sense       = (result.location.s > 0. ? 1 : -1);
    const bool    end         = !pieces.step_over(other, sense);
    if (!end)
      {
        const DistanceJet neighbor = pieces.jet(other, point[0], point[1]);
        const double      speed    = std::sqrt(neighbor.squared_speed());
        if (!(speed > 0.))
          return;
        const Tensor<1, 2> normal =
          Point<2>(-side * neighbor.y1 / speed, side * neighbor.x1 / speed);
        if (normal * projection.normal > 1. - 1e-12)
          return; // no kink
        mean_normal += normal;
        if (sense > 0) // the right side is the neighbour's
          {
            projection.tangent[0] = neighbor.x1 / speed;
            projection.tangent[1] = neighbor.y1 / speed;
          }
      }
    else if (normal_here)
      return;

    projection.place = (end ? Projection::Place::end : Projection::Place::kink);
    const Tensor<1, 2> to_point = Point<2>(-jet.rx, -jet.ry);
    projection.distance = (to_point * mean_normal < 0. ? -distance : distance);
    if (distance > 0.)
      projection.normal = to_point / projection.distance;
    else if (mean_normal.norm() > 0.)
      projection.normal = mean_normal / mean_normal.norm();
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
    return implementation->certified(point,
                                     minimizer,
                                     implementation->pieces.locate(guess));
  }



  Projection
  ClosestPoint::project_locally(const Point<2> &point, const double guess) const
  {
    const DistanceMinimizer minimizer(implementation->pieces,
                                      point[0],
                                      point[1]);
    return implementation->describe(minimizer.minimize(
                                      implementation->pieces.locate(guess)),
                                    minimizer,
                                    point);
  }
} // namespace asperity
