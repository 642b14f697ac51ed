#include <asperity/base/text.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/postprocess/chip_output.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "vtu_patches.h"

namespace asperity
{
  namespace
  {
    /** (n+1) x (n+1) equidistant points with the edges, x fastest. */
    dealii::Quadrature<2>
    picture_points(const unsigned int n_subdivisions)
    {
      const unsigned int            n = n_subdivisions + 1;
      std::vector<dealii::Point<2>> points;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          points.emplace_back(static_cast<double>(i) / n_subdivisions,
                              static_cast<double>(j) / n_subdivisions);
      return dealii::Quadrature<2>(points,
                                   std::vector<double>(n * n, 1. / (n * n)));
    }

    /** Lagrange polynomials through the Gauss points at the picture points. */
    std::vector<double>
    lagrange_values(const unsigned int n_subdivisions,
                    const unsigned int n_gauss_points)
    {
      const dealii::QGauss<1> gauss(n_gauss_points);
      std::vector<double>     values;
      for (unsigned int i = 0; i <= n_subdivisions; ++i)
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          {
            const double x     = static_cast<double>(i) / n_subdivisions;
            double       value = 1.;
            for (unsigned int h = 0; h < n_gauss_points; ++h)
              if (h != g)
                value *= (x - gauss.point(h)[0]) /
                         (gauss.point(g)[0] - gauss.point(h)[0]);
            values.push_back(value);
          }
      return values;
    }

    void
    check_size(const std::string &name,
               const std::size_t  found,
               const std::size_t  expected)
    {
      if (found != expected)
        throw ComputationError("The field " + quoted_name(name) +
                               " of the chip has " + std::to_string(found) +
                               " numbers, but " + std::to_string(expected) +
                               " are expected.");
    }
  } // namespace



  ChipOutput::ChipOutput(const SplineSpace<2>   &space,
                         const PatchGeometry<2> &geometry,
                         const unsigned int      n_subdivisions,
                         const unsigned int      n_gauss_points)
    : n_subdivisions(n_subdivisions)
    , n_gauss_points(n_gauss_points)
    , n_functions(space.n_functions())
    , period(0.)
    , table(tabulate_cells(space, geometry, picture_points(n_subdivisions)))
    , lagrange(lagrange_values(n_subdivisions, n_gauss_points))
  {
    // The geometry is the identity plus a periodic offset, so the period in
    // space is that of the parameter.
    if (space.is_periodic(0))
      {
        double left = space.cell_box(0).first[0], right = left;
        for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
          {
            left  = std::min(left, space.cell_box(cell).first[0]);
            right = std::max(right, space.cell_box(cell).second[0]);
          }
        period = right - left;
      }
  }



  void
  ChipOutput::check_sizes(const ChipFields &fields) const
  {
    check_size("displacement [m]", fields.displacement.size(), 2 * n_functions);
    for (const auto &[name, values] : fields.spline_vectors)
      check_size(name, values.size(), 2 * n_functions);
    for (const auto &[name, values] : fields.spline_scalars)
      check_size(name, values.size(), n_functions);
    for (const auto &[name, values] : fields.quadrature_scalars)
      check_size(name,
                 values.size(),
                 table.elements.size() * n_gauss_points * n_gauss_points);
  }



  double
  ChipOutput::spline_value(const BasisTable<2>::Element &element,
                           const unsigned int            point,
                           const dealii::Vector<double> &coefficients,
                           const unsigned int            n_components,
                           const unsigned int            component) const
  {
    const std::size_t n     = element.functions.size();
    double            value = 0.;
    for (std::size_t a = 0; a < n; ++a)
      value += element.values[point * n + a] *
               coefficients[n_components * element.functions[a] + component];
    return value;
  }



  void
  ChipOutput::fill_from_gauss_points(const double            *values,
                                     const unsigned int       row,
                                     dealii::Table<2, float> &data) const
  {
    const unsigned int n = n_subdivisions + 1, m = n_gauss_points;
    const auto [low, high] = std::minmax_element(values, values + m * m);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          double value = 0.;
          for (unsigned int h = 0; h < m; ++h)
            for (unsigned int g = 0; g < m; ++g)
              value +=
                lagrange[i * m + g] * lagrange[j * m + h] * values[h * m + g];
          // No comparison with a NaN holds: it comes through and is refused.
          data(row, j * n + i) = std::clamp(value, *low, *high);
        }
  }



  void
  ChipOutput::fill_cell(const unsigned int       e,
                        const ChipFields        &fields,
                        dealii::Table<2, float> &data) const
  {
    const BasisTable<2>::Element &element  = table.elements[e];
    const unsigned int            n_points = table.points_per_element;
    unsigned int                  row      = 0;

    const auto add_vector = [&](const dealii::Vector<double> &coefficients) {
      for (unsigned int c = 0; c < 2; ++c, ++row)
        for (unsigned int i = 0; i < n_points; ++i)
          data(row, i) = spline_value(element, i, coefficients, 2, c);
    };
    add_vector(fields.displacement);
    for (const auto &field : fields.spline_vectors)
      add_vector(field.second);
    for (const auto &field : fields.spline_scalars)
      {
        for (unsigned int i = 0; i < n_points; ++i)
          data(row, i) = spline_value(element, i, field.second, 1, 0);
        ++row;
      }
    const unsigned int n_gauss = n_gauss_points * n_gauss_points;
    for (const auto &field : fields.quadrature_scalars)
      fill_from_gauss_points(&field.second[e * n_gauss], row++, data);
    for (unsigned int c = 0; c < 2; ++c, ++row)
      for (unsigned int i = 0; i < n_points; ++i)
        data(row, i) = table.position[element.first_point + i][c] +
                       spline_value(element, i, fields.displacement, 2, c);
  }



  void
  ChipOutput::write(std::ostream      &out,
                    const ChipFields  &fields,
                    const double       time,
                    const unsigned int step,
                    const unsigned int n_periods) const
  {
    check_sizes(fields);
    if (n_periods > 1 && period == 0.)
      throw ComputationError("A chip that is not periodic cannot be drawn " +
                             std::to_string(n_periods) + " times.");

    internal::PatchRows rows;
    rows.add_vector("displacement [m]");
    for (const auto &field : fields.spline_vectors)
      rows.add_vector(field.first);
    for (const auto &field : fields.spline_scalars)
      rows.add_scalar(field.first);
    for (const auto &field : fields.quadrature_scalars)
      rows.add_scalar(field.first);

    std::vector<dealii::DataOutBase::Patch<2, 2>> patches;
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      {
        auto patch =
          rows.make_patch<2>(n_subdivisions, table.points_per_element);
        fill_cell(e, fields, patch.data);
        for (unsigned int k = 0; k < n_periods; ++k)
          {
            patches.push_back(patch);
            for (unsigned int i = 0; i < table.points_per_element; ++i)
              patches.back().data(rows.n_fields(), i) += k * period;
          }
      }
    rows.write<2>(patches, time, step, out);
  }
} // namespace asperity
