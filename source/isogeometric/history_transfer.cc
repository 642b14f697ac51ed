#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace asperity
{
  namespace
  {
    /** Points of cells inside a region (a cell of the coarser mesh), in the
     * unit cell of the region, with weights that sum to one. */
    template <int dim>
    struct Points
    {
      std::vector<dealii::Point<dim>> position;
      std::vector<double>             weight;
      std::vector<std::size_t>        number; ///< cell * n_q + q
    };



    template <int dim>
    void
    collect(const SplineHierarchy<dim>    &hierarchy,
            const CellIndex<dim>          &region,
            const unsigned int             node_number,
            const dealii::Quadrature<dim> &quadrature,
            Points<dim>                   &points)
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
      dealii::Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = (node.index.spans[d] - (region.spans[d] << levels)) * width;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          points.position.push_back(corner + width * quadrature.point(q));
          points.weight.push_back(std::pow(width, dim) * quadrature.weight(q));
          points.number.push_back(std::size_t(node.cell) * quadrature.size() +
                                  q);
        }
    }



    /** Tensor-product Legendre polynomials of the unit cell, normalised. */
    template <int dim>
    std::vector<double>
    legendre(const unsigned int degree, const dealii::Point<dim> &point)
    {
      std::vector<double> values(1, 1.);
      std::vector<double> P(degree + 1);
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double t = 2. * point[d] - 1.;
          P.assign(degree + 1, 1.);
          if (degree > 0)
            P[1] = t;
          for (unsigned int k = 2; k <= degree; ++k)
            P[k] = ((2. * k - 1.) * t * P[k - 1] - (k - 1.) * P[k - 2]) / k;
          for (unsigned int k = 0; k <= degree; ++k)
            P[k] *= std::sqrt(2. * k + 1.);
          std::vector<double> products;
          for (const double slow : P)
            for (const double fast : values)
              products.push_back(fast * slow);
          values.swap(products);
        }
      return values;
    }



    /** Weight of each source value in the fit at each target point. */
    template <int dim>
    dealii::FullMatrix<double>
    fit_operator(const unsigned int degree,
                 const Points<dim> &sources,
                 const Points<dim> &targets)
    {
      const unsigned int n   = tensor_size<dim>(degree + 1);
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



    /** The least and the largest value of each component. */
    using Ranges = std::vector<std::pair<double, double>>;

    /** Empty if each cell has a range of its own. */
    Ranges
    ranges_of(const std::vector<double> &values,
              const unsigned int         n_components,
              const HistoryRange         range)
    {
      using Limits = std::numeric_limits<double>;
      if (range == HistoryRange::cell)
        return {};
      if (range == HistoryRange::none)
        return Ranges(n_components, {Limits::lowest(), Limits::max()});
      Ranges ranges(n_components, {Limits::max(), Limits::lowest()});
      for (std::size_t i = 0; i < values.size(); ++i)
        {
          auto &[low, high] = ranges[i % n_components];
          low               = std::min(low, values[i]);
          high              = std::max(high, values[i]);
        }
      return ranges;
    }



    /** The wanted degree of polynomials in each direction, or the largest that
     *  the points of a quadrature determine. */
    template <int dim>
    unsigned int
    degree_of_fit(const dealii::Quadrature<dim> &quadrature,
                  const unsigned int             wanted)
    {
      unsigned int degree = 0;
      while (degree < wanted &&
             tensor_size<dim>(degree + 2) <= quadrature.size())
        ++degree;
      return degree;
    }



    /** Fits, limits and writes the values of one region. */
    template <int dim>
    void
    transfer_region(const unsigned int         degree,
                    const Points<dim>         &sources,
                    const Points<dim>         &targets,
                    const std::vector<double> &old_values,
                    const unsigned int         n_components,
                    const Ranges              &ranges,
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
          if (!ranges.empty())
            std::tie(low, high) = ranges[c];

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



  template <int dim>
  std::vector<double>
  transfer_history(const SplineHierarchy<dim>    &from,
                   const SplineHierarchy<dim>    &to,
                   const dealii::Quadrature<dim> &quadrature,
                   const std::vector<double>     &values,
                   const unsigned int             n_components,
                   const unsigned int             fit_degree,
                   const HistoryRange             range)
  {
    const std::size_t block = std::size_t(quadrature.size()) * n_components;
    AssertThrow(values.size() == from.n_cells() * block,
                dealii::ExcDimensionMismatch(values.size(),
                                             from.n_cells() * block));
    const unsigned int  degree = degree_of_fit(quadrature, fit_degree);
    const Ranges        ranges = ranges_of(values, n_components, range);
    std::vector<double> result(to.n_cells() * block);
    for (unsigned int cell = 0; cell < to.n_cells(); ++cell)
      {
        const CellIndex<dim> &index = to.cell_index(cell);
        const unsigned int    node  = from.find_node(index);
        const int             old   = from.nodes()[node].cell;
        if (old < 0) // coarsened: the region is the new cell
          {
            Points<dim> sources, targets;
            collect(from, index, node, quadrature, sources);
            collect(to, index, to.find_node(index), quadrature, targets);
            transfer_region(
              degree, sources, targets, values, n_components, ranges, result);
          }
        else if (from.cell_index(old) == index)
          std::copy(values.begin() + old * block,
                    values.begin() + (old + 1) * block,
                    result.begin() + cell * block);
      }
    for (unsigned int cell = 0; cell < from.n_cells(); ++cell)
      {
        const CellIndex<dim> &index = from.cell_index(cell);
        const unsigned int    node  = to.find_node(index);
        if (to.nodes()[node].cell < 0) // refined: the region is the old cell
          {
            Points<dim> sources, targets;
            collect(from, index, from.find_node(index), quadrature, sources);
            collect(to, index, node, quadrature, targets);
            transfer_region(
              degree, sources, targets, values, n_components, ranges, result);
          }
      }
    return result;
  }



  template <int dim>
  std::vector<double>
  coarsening_loss(const SplineHierarchy<dim>    &hierarchy,
                  const dealii::Quadrature<dim> &quadrature,
                  const std::vector<double>     &values,
                  const unsigned int             fit_degree)
  {
    const unsigned int  degree = degree_of_fit(quadrature, fit_degree);
    std::vector<double> loss(hierarchy.n_cells(), 0.);
    for (unsigned int n = 0; n < hierarchy.nodes().size(); ++n)
      {
        const auto &node      = hierarchy.nodes()[n];
        const auto  is_active = [&](const int child) {
          return child >= 0 && hierarchy.nodes()[child].cell >= 0;
        };
        if (node.cell >= 0 ||
            !std::all_of(node.children.begin(), node.children.end(), is_active))
          continue;
        Points<dim> points;
        collect(hierarchy, node.index, n, quadrature, points);
        const auto fit     = fit_operator(degree, points, points);
        double     squares = 0.;
        for (unsigned int t = 0; t < points.number.size(); ++t)
          {
            double rest = values[points.number[t]];
            for (unsigned int s = 0; s < points.number.size(); ++s)
              rest -= fit(t, s) * values[points.number[s]];
            squares += points.weight[t] * rest * rest;
          }
        for (const int child : node.children)
          loss[hierarchy.nodes()[child].cell] = std::sqrt(squares);
      }
    return loss;
  }



  template std::vector<double>
  transfer_history(const SplineHierarchy<1> &,
                   const SplineHierarchy<1> &,
                   const dealii::Quadrature<1> &,
                   const std::vector<double> &,
                   const unsigned int,
                   const unsigned int,
                   const HistoryRange);
  template std::vector<double>
  transfer_history(const SplineHierarchy<2> &,
                   const SplineHierarchy<2> &,
                   const dealii::Quadrature<2> &,
                   const std::vector<double> &,
                   const unsigned int,
                   const unsigned int,
                   const HistoryRange);
  template std::vector<double>
  transfer_history(const SplineHierarchy<3> &,
                   const SplineHierarchy<3> &,
                   const dealii::Quadrature<3> &,
                   const std::vector<double> &,
                   const unsigned int,
                   const unsigned int,
                   const HistoryRange);
  template std::vector<double>
  coarsening_loss(const SplineHierarchy<2> &,
                  const dealii::Quadrature<2> &,
                  const std::vector<double> &,
                  const unsigned int);
  template std::vector<double>
  coarsening_loss(const SplineHierarchy<3> &,
                  const dealii::Quadrature<3> &,
                  const std::vector<double> &,
                  const unsigned int);
} // namespace asperity
