#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/patch_search.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace asperity
{
  using dealii::BoundingBox;
  using dealii::Point;
  using dealii::Tensor;

  struct PatchSearch::Implementation
  {
    using IndexedBox = std::pair<BoundingBox<2>, unsigned int>;

    explicit Implementation(const SplinePatch &patch);

    /** Newton's method, kept on one element. */
    Result
    solve(const unsigned int element, const Point<2> &point) const;

    /** Turns of a direction in which the patch can hold the point. */
    std::pair<int, int>
    turns(const unsigned int direction, const Point<2> &point) const;

    SplinePatch               patch;
    dealii::RTree<IndexedBox> boxes;
    double                    extent = 0.; ///< diagonal of all [m]

    /** Along the period of each direction: reach of all control points [m]. */
    std::array<std::pair<double, double>, 2> reach;
  };



  namespace
  {
    BoundingBox<2>
    element_box(const SplinePatch                               &patch,
                const std::array<dealii::FullMatrix<double>, 2> &operators,
                const std::array<unsigned int, 2>               &spans)
    {
      const dealii::FullMatrix<double> C =
        tensor_product(operators[0], operators[1]);
      const auto fx = patch.knot_vector(0).span_functions(spans[0]);
      const auto fy = patch.knot_vector(1).span_functions(spans[1]);
      std::pair<Point<2>, Point<2>> corners;
      for (unsigned int b = 0; b < C.n(); ++b)
        {
          Tensor<1, 2> point;
          double       weight = 0.;
          for (unsigned int j = 0; j < fy.size(); ++j)
            for (unsigned int i = 0; i < fx.size(); ++i)
              {
                const unsigned int k =
                  fy[j] * patch.knot_vector(0).n_basis() + fx[i];
                Tensor<1, 2> control = patch.control_points()[k];
                if (patch.knot_vector(0).is_wrapped(spans[0], i))
                  control += patch.period(0);
                if (patch.knot_vector(1).is_wrapped(spans[1], j))
                  control += patch.period(1);
                const double w =
                  C(j * fx.size() + i, b) *
                  (patch.is_rational() ? patch.weights()[k] : 1.);
                point += w * control;
                weight += w;
              }
          for (unsigned int d = 0; d < 2; ++d)
            {
              const double x    = point[d] / weight;
              corners.first[d]  = (b == 0 ? x : std::min(corners.first[d], x));
              corners.second[d] = (b == 0 ? x : std::max(corners.second[d], x));
            }
        }
      return BoundingBox<2>(corners);
    }
  } // namespace



  PatchSearch::Implementation::Implementation(const SplinePatch &patch)
    : patch(patch)
  {
    const std::array<std::vector<dealii::FullMatrix<double>>, 2> operators = {
      {bezier_extraction(patch.knot_vector(0)),
       bezier_extraction(patch.knot_vector(1))}};
    std::vector<IndexedBox> all;
    for (unsigned int j = 0; j < operators[1].size(); ++j)
      for (unsigned int i = 0; i < operators[0].size(); ++i)
        all.emplace_back(element_box(patch,
                                     {{operators[0][i], operators[1][j]}},
                                     {{i, j}}),
                         all.size());

    BoundingBox<2> whole = all[0].first;
    for (const IndexedBox &box : all)
      whole.merge_with(box.first);
    extent = whole.get_boundary_points().first.distance(
      whole.get_boundary_points().second);
    // Points on the outline must not be lost to round-off.
    for (IndexedBox &box : all)
      box.first.extend(1e-12 * extent);
    boxes = dealii::pack_rtree(all);

    for (unsigned int d = 0; d < 2; ++d)
      {
        reach[d] = {std::numeric_limits<double>::max(),
                    -std::numeric_limits<double>::max()};
        for (unsigned int vertex = 0; vertex < 4; ++vertex)
          {
            const double along = whole.vertex(vertex) * patch.period(d);
            reach[d].first     = std::min(reach[d].first, along);
            reach[d].second    = std::max(reach[d].second, along);
          }
      }
  }



  std::pair<int, int>
  PatchSearch::Implementation::turns(const unsigned int direction,
                                     const Point<2>    &point) const
  {
    const double period2 = patch.period(direction).norm_square();
    if (!(period2 > 0.))
      return {0, 0};
    const double along = point * patch.period(direction);
    return {int(std::floor((along - reach[direction].second) / period2)),
            int(std::ceil((along - reach[direction].first) / period2))};
  }



  PatchSearch::Result
  PatchSearch::Implementation::solve(const unsigned int element,
                                     const Point<2>    &point) const
  {
    const unsigned int n_xi = patch.knot_vector(0).n_spans();
    const auto        &xi   = patch.knot_vector(0).breakpoints();
    const auto        &eta  = patch.knot_vector(1).breakpoints();
    const Point<2>     low(xi[element % n_xi], eta[element / n_xi]);
    const Point<2>     high(xi[element % n_xi + 1], eta[element / n_xi + 1]);

    Result result;
    result.parameter = low + (high - low) / 2.;
    auto   S = patch.derivatives(result.parameter[0], result.parameter[1], 1);
    double distance = (point - S[0][0]).norm();
    while (result.report.iterations < 50 && distance > 1e-15 * extent)
      {
        const Tensor<1, 2> gap   = point - S[0][0];
        const Tensor<1, 2> by_xi = S[1][0], by_eta = S[0][1];
        const double       det = by_xi[0] * by_eta[1] - by_xi[1] * by_eta[0];
        if (det == 0.)
          break;
        Tensor<1, 2> step;
        step[0] = (gap[0] * by_eta[1] - gap[1] * by_eta[0]) / det;
        step[1] = (by_xi[0] * gap[1] - by_xi[1] * gap[0]) / det;

        bool closer = false;
        for (unsigned int halving = 0; halving < 12 && !closer; ++halving)
          {
            Point<2> next = result.parameter + step;
            for (unsigned int d = 0; d < 2; ++d)
              next[d] = std::max(low[d], std::min(high[d], next[d]));
            const auto   there    = patch.derivatives(next[0], next[1], 1);
            const double residual = (point - there[0][0]).norm();
            closer                = residual < distance;
            if (closer)
              {
                result.parameter = next;
                S                = there;
                distance         = residual;
              }
            step /= 2.;
          }
        ++result.report.iterations;
        if (!closer)
          break;
      }
    result.report.residual  = distance;
    result.report.converged = distance <= 1e-12 * extent;
    result.inside           = result.report.converged;
    if (!result.inside)
      result.report.reason = "the point lies in no element of the patch";
    return result;
  }



  PatchSearch::PatchSearch(const SplinePatch &patch)
    : implementation(std::make_unique<const Implementation>(patch))
  {}



  PatchSearch::~PatchSearch() = default;



  PatchSearch::Result
  PatchSearch::find(const Point<2> &point) const
  {
    const SplinePatch &patch = implementation->patch;
    Result             best;
    best.report.residual = std::numeric_limits<double>::max();
    best.report.reason   = "the point lies in no element of the patch";

    const auto turns_xi  = implementation->turns(0, point);
    const auto turns_eta = implementation->turns(1, point);
    for (int j = turns_eta.first; j <= turns_eta.second; ++j)
      for (int i = turns_xi.first; i <= turns_xi.second; ++i)
        {
          const Point<2> shifted =
            point - i * patch.period(0) - j * patch.period(1);
          std::vector<Implementation::IndexedBox> candidates;
          implementation->boxes.query(boost::geometry::index::intersects(
                                        shifted),
                                      std::back_inserter(candidates));
          for (const auto &candidate : candidates)
            {
              Result result = implementation->solve(candidate.second, shifted);
              result.parameter[0] += i * (patch.knot_vector(0).back() -
                                          patch.knot_vector(0).front());
              result.parameter[1] += j * (patch.knot_vector(1).back() -
                                          patch.knot_vector(1).front());
              if (result.inside)
                return result;
              if (result.report.residual < best.report.residual)
                best = result;
            }
        }
    return best;
  }
} // namespace asperity
