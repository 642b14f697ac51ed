#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    /** Points of cells inside a region (a cell of the coarser mesh), in the
     * unit square of the region, with weights that sum to one. */
    struct Points
    {
      std::vector<dealii::Point<2>> position;
      std::vector<double>           weight;
      std::vector<std::size_t>      number; ///< cell * n_q + q
    };



    void
    collect(const SplineHierarchy       &hierarchy,
            const CellIndex             &region,
            const unsigned int           node_number,
            const dealii::Quadrature<2> &quadrature,
            Points                      &points)
    {
      const auto &node = hierarchy.nodes()[node_number];
      if (node.cell < 0)
        {
          for (const int child : node.children)
            collect(hierarchy, region, child, quadrature, points);
          return;
        }
      const unsigned int levels = node.index.level - region.level;
      const double       width  = 1. / (1u << levels);
      const double       x      = (node.index.i - (region.i << levels)) * width;
      const double       y      = (node.index.j - (region.j << levels)) * width;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          points.position.emplace_back(x + width * quadrature.point(q)[0],
                                       y + width * quadrature.point(q)[1]);
          points.weight.push_back(width * width * quadrature.weight(q));
          points.number.push_back(std::size_t(node.cell) * quadrature.size() +
                                  q);
        }
    }



    /** Tensor-product Legendre polynomials of the unit square, normalised. */
    std::vector<double>
    legendre(const unsigned int degree, const dealii::Point<2> &point)
    {
      std::vector<std::vector<double>> P(2);
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double t = 2. * point[d] - 1.;
          P[d].assign(degree + 1, 1.);
          if (degree > 0)
            P[d][1] = t;
          for (unsigned int k = 2; k <= degree; ++k)
            P[d][k] =
              ((2. * k - 1.) * t * P[d][k - 1] - (k - 1.) * P[d][k - 2]) / k;
          for (unsigned int k = 0; k <= degree; ++k)
            P[d][k] *= std::sqrt(2. * k + 1.);
        }
      std::vector<double> values;
      for (const double y : P[1])
        for (const double x : P[0])
          values.push_back(x * y);
      return values;
    }



    /** Weight of each source value in the fit at each target point. */
    dealii::FullMatrix<double>
    fit_operator(const unsigned int degree,
                 const Points      &sources,
                 const Points      &targets)
    {
      const unsigned int n   = (degree + 1) * (degree + 1);
      const unsigned int n_s = sources.position.size();
      const unsigned int n_t = targets.position.size();

      dealii::FullMatrix<double> moments(n, n_s), normal(n, n), inverse(n, n);
      for (unsigned int s = 0; s < n_s; ++s)
        {
          const auto L = legendre(degree, sources.position[s]);
          for (unsigned int k = 0; k < n; ++k)
            {
              moments(k, s) = L[k] * sources.weight[s];
              for (unsigned int l = 0; l < n; ++l)
                normal(k, l) += L[k] * L[l] * sources.weight[s];
            }
        }
      // The identity for a Gauss quadrature, but others are allowed.
      inverse.invert(normal);
      dealii::FullMatrix<double> basis(n_t, n), projected(n_t, n);
      for (unsigned int t = 0; t < n_t; ++t)
        {
          const auto L = legendre(degree, targets.position[t]);
          for (unsigned int k = 0; k < n; ++k)
            basis(t, k) = L[k];
        }
      basis.mmult(projected, inverse);
      dealii::FullMatrix<double> result(n_t, n_s);
      projected.mmult(result, moments);
      return result;
    }



    /** Fits, limits and writes the values of one region. */
    void
    transfer_region(const unsigned int         degree,
                    const Points              &sources,
                    const Points              &targets,
                    const std::vector<double> &old_values,
                    const unsigned int         n_components,
                    std::vector<double>       &new_values)
    {
      const auto          fit = fit_operator(degree, sources, targets);
      std::vector<double> fitted(targets.position.size());
      for (unsigned int c = 0; c < n_components; ++c)
        {
          double low  = std::numeric_limits<double>::max();
          double high = std::numeric_limits<double>::lowest();
          double mean = 0., measure = 0.;
          std::fill(fitted.begin(), fitted.end(), 0.);
          for (unsigned int s = 0; s < sources.position.size(); ++s)
            {
              const double value =
                old_values[sources.number[s] * n_components + c];
              low  = std::min(low, value);
              high = std::max(high, value);
              mean += sources.weight[s] * value;
              measure += sources.weight[s];
              for (unsigned int t = 0; t < fitted.size(); ++t)
                fitted[t] += fit(t, s) * value;
            }
          mean = std::min(std::max(mean / measure, low), high);

          const auto [least, most] =
            std::minmax_element(fitted.begin(), fitted.end());
          double theta = 1.;
          if (*most > high)
            theta = std::min(theta, (high - mean) / (*most - mean));
          if (*least < low)
            theta = std::min(theta, (mean - low) / (mean - *least));
          // The clamp removes what rounding left.
          for (unsigned int t = 0; t < fitted.size(); ++t)
            new_values[targets.number[t] * n_components + c] =
              std::min(std::max(mean + theta * (fitted[t] - mean), low), high);
        }
    }
  } // namespace



  std::vector<double>
  transfer_history(const SplineHierarchy       &from,
                   const SplineHierarchy       &to,
                   const dealii::Quadrature<2> &quadrature,
                   const std::vector<double>   &values,
                   const unsigned int           n_components,
                   const unsigned int           fit_degree)
  {
    const std::size_t block = std::size_t(quadrature.size()) * n_components;
    AssertThrow(values.size() == from.n_cells() * block,
                dealii::ExcDimensionMismatch(values.size(),
                                             from.n_cells() * block));
    unsigned int degree = 0;
    while (degree < fit_degree &&
           (degree + 2) * (degree + 2) <= quadrature.size())
      ++degree;

    std::vector<double> result(to.n_cells() * block);
    for (unsigned int cell = 0; cell < to.n_cells(); ++cell)
      {
        const CellIndex   &index = to.cell_index(cell);
        const unsigned int node  = from.find_node(index);
        const int          old   = from.nodes()[node].cell;
        if (old < 0) // coarsened: the region is the new cell
          {
            Points sources, targets;
            collect(from, index, node, quadrature, sources);
            collect(to, index, to.find_node(index), quadrature, targets);
            transfer_region(
              degree, sources, targets, values, n_components, result);
          }
        else if (from.cell_index(old) == index)
          std::copy(values.begin() + old * block,
                    values.begin() + (old + 1) * block,
                    result.begin() + cell * block);
      }
    for (unsigned int cell = 0; cell < from.n_cells(); ++cell)
      {
        const CellIndex   &index = from.cell_index(cell);
        const unsigned int node  = to.find_node(index);
        if (to.nodes()[node].cell < 0) // refined: the region is the old cell
          {
            Points sources, targets;
            collect(from, index, from.find_node(index), quadrature, sources);
            collect(to, index, node, quadrature, targets);
            transfer_region(
              degree, sources, targets, values, n_components, result);
          }
      }
    return result;
  }
} // namespace asperity
