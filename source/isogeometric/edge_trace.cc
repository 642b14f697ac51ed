#include <asperity/isogeometric/edge_trace.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/splines/bezier_extraction.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Knots of the trace: the ends of the edge's cells, once, or as often as
     *  in the level-0 knots. */
    KnotVector
    merged_knots(const SplineHierarchy<2>        &hierarchy,
                 const std::vector<unsigned int> &cells,
                 const unsigned int               along)
    {
      const KnotVector   &coarse = hierarchy.knots(0, along);
      std::vector<double> ends(1, coarse.front());
      for (const unsigned int cell : cells)
        ends.push_back(hierarchy.cell_box(cell).second[along]);
      // Periodic knots are always simple.
      if (coarse.is_periodic())
        return KnotVector(coarse.degree(), ends, true);
      std::vector<double> knots;
      for (const double end : ends)
        {
          // Breakpoints of level 0 are handed down bit by bit.
          const auto multiplicity =
            std::count(coarse.knots().begin(), coarse.knots().end(), end);
          knots.insert(knots.end(), std::max<long>(multiplicity, 1), end);
        }
      return KnotVector::from_knots(coarse.degree(), knots);
    }
  } // namespace



  EdgeTrace::EdgeTrace(const SplineHierarchy<2> &hierarchy, const Edge edge)
    : edge(edge)
  {
    const unsigned int along  = directions_along<2>(edge)[0];
    const KnotVector  &normal = hierarchy.knots(0, normal_direction<2>(edge));
    fixed_parameter = is_at_end(edge) ? normal.back() : normal.front();

    const auto cells = edge_cells(hierarchy, edge);
    trace_knots      = merged_knots(hierarchy, cells, along);

    // The span of each function that holds most of it.
    const auto                extraction = bezier_extraction(trace_knots);
    const unsigned int        n          = trace_knots.degree() + 1;
    std::vector<double>       share(trace_knots.n_basis(), -1.);
    std::vector<unsigned int> home(trace_knots.n_basis());
    std::vector<unsigned int> place(trace_knots.n_basis());
    for (unsigned int span = 0; span < trace_knots.n_spans(); ++span)
      {
        const double width =
          trace_knots.breakpoints()[span + 1] - trace_knots.breakpoints()[span];
        const auto functions = trace_knots.span_functions(span);
        for (unsigned int a = 0; a < n; ++a)
          {
            double integral = 0.;
            for (unsigned int b = 0; b < n; ++b)
              integral += extraction[span](a, b) * width;
            if (integral > share[functions[a]])
              {
                share[functions[a]] = integral;
                home[functions[a]]  = span;
                place[functions[a]] = a;
              }
          }
      }

    const auto on_edge = edge_bernstein<2>(hierarchy.degree(), edge);
    trace_weights.resize(trace_knots.n_basis());
    for (unsigned int i = 0; i < trace_knots.n_basis(); ++i)
      {
        dealii::FullMatrix<double> inverse(n, n);
        inverse.invert(extraction[home[i]]);
        const unsigned int cell      = cells[home[i]];
        const auto        &functions = hierarchy.cell_functions(cell);
        for (const unsigned int a : trace_rows(hierarchy, cell, edge))
          {
            double weight = 0.;
            for (unsigned int b = 0; b < n; ++b)
              weight += hierarchy.cell_extraction(cell)(a, on_edge[b]) *
                        inverse(b, place[i]);
            // Weights are of size one; smaller ones are rounding.
            if (std::abs(weight) > 1e-15)
              trace_weights[i].emplace_back(functions[a], weight);
          }
      }
  }



  const KnotVector &
  EdgeTrace::knots() const
  {
    return trace_knots;
  }



  const std::vector<std::vector<std::pair<unsigned int, double>>> &
  EdgeTrace::weights() const
  {
    return trace_weights;
  }



  std::vector<double>
  EdgeTrace::apply(const std::vector<double> &coefficients) const
  {
    std::vector<double> result(trace_weights.size(), 0.);
    for (unsigned int i = 0; i < result.size(); ++i)
      for (const auto &[function, weight] : trace_weights[i])
        result[i] += weight * coefficients[function];
    return result;
  }



  SplineCurve
  EdgeTrace::curve(const std::vector<dealii::Tensor<1, 2>> &offset) const
  {
    const unsigned int            along    = directions_along<2>(edge)[0];
    const auto                    greville = trace_knots.greville();
    std::vector<dealii::Point<2>> points(greville.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        points[i][along]     = greville[i];
        points[i][1 - along] = fixed_parameter;
        if (!offset.empty())
          for (const auto &[function, weight] : trace_weights[i])
            points[i] += weight * offset[function];
      }
    dealii::Tensor<1, 2> period;
    if (trace_knots.is_periodic())
      period[along] = trace_knots.back() - trace_knots.front();
    return SplineCurve(trace_knots, points, {}, period);
  }
} // namespace asperity
