#include <asperity/base/text.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/postprocess/chip_output.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lagrange_values.h"
#include "vtu_patches.h"

namespace asperity
{
  namespace
  {
    /** n + 1 equidistant points in each direction with the edges, x fastest. */
    template <int dim>
    dealii::Quadrature<dim>
    picture_points(const unsigned int n_subdivisions)
    {
      const unsigned int              n        = n_subdivisions + 1;
      const unsigned int              n_points = std::lround(std::pow(n, dim));
      std::vector<dealii::Point<dim>> points(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
          points[i][d] = static_cast<double>(rest % n) / n_subdivisions;
      return dealii::Quadrature<dim>(points,
                                     std::vector<double>(n_points,
                                                         1. / n_points));
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



  template <int dim>
  ChipOutput<dim>::ChipOutput(const SplineSpace<dim>   &space,
                              const PatchGeometry<dim> &geometry,
                              const unsigned int        n_subdivisions,
                              const unsigned int        n_gauss_points,
                              const CellShare          &share)
    : n_subdivisions(n_subdivisions)
    , n_gauss_points(n_gauss_points)
    , n_functions(space.n_functions())
    , share(share)
    , period(0.)
    , table(tabulate_cells(space,
                           geometry,
                           picture_points<dim>(n_subdivisions),
                           [&share](const unsigned int cell) {
                             return share.is_own(cell);
                           }))
    , lagrange(internal::lagrange_values(n_subdivisions, n_gauss_points))
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



  template <int dim>
  void
  ChipOutput<dim>::check_sizes(const ChipFields &fields) const
  {
    check_size("displacement [m]",
               fields.displacement.size(),
               dim * n_functions);
    for (const auto &[name, values] : fields.spline_vectors)
      check_size(name, values.size(), dim * n_functions);
    for (const auto &[name, values] : fields.spline_scalars)
      check_size(name, values.size(), n_functions);
    for (const auto &[name, values] : fields.quadrature_scalars)
      check_size(name,
                 values.size(),
                 table.elements.size() * n_gauss_of_cell());
  }



  template <int dim>
  double
  ChipOutput<dim>::spline_value(
    const typename BasisTable<dim>::Element &element,
    const unsigned int                       point,
    const dealii::Vector<double>            &coefficients,
    const unsigned int                       n_components,
    const unsigned int                       component) const
  {
    const std::size_t n     = element.functions.size();
    double            value = 0.;
    for (std::size_t a = 0; a < n; ++a)
      value += element.values[point * n + a] *
               coefficients[n_components * element.functions[a] + component];
    return value;
  }



  template <int dim>
  void
  ChipOutput<dim>::fill_from_gauss_points(const double            *values,
                                          const unsigned int       row,
                                          dealii::Table<2, float> &data) const
  {
    const unsigned int n = n_subdivisions + 1, m = n_gauss_points;
    const auto [low, high] =
      std::minmax_element(values, values + n_gauss_of_cell());
    for (unsigned int i = 0; i < table.points_per_element; ++i)
      {
        double value = 0.;
        for (unsigned int g = 0; g < n_gauss_of_cell(); ++g)
          {
            double weight = 1.;
            for (unsigned int d = 0, at = i, from = g; d < dim;
                 ++d, at /= n, from /= m)
              weight *= lagrange[at % n * m + from % m];
            value += weight * values[g];
          }
        // No comparison with a NaN holds: it comes through and is refused.
        data(row, i) = std::clamp(value, *low, *high);
      }
  }



  template <int dim>
  void
  ChipOutput<dim>::fill_cell(const unsigned int       e,
                             const ChipFields        &fields,
                             dealii::Table<2, float> &data) const
  {
    const typename BasisTable<dim>::Element &element = table.elements[e];
    const unsigned int n_points                      = table.points_per_element;
    unsigned int       row                           = 0;

    const auto add_vector = [&](const dealii::Vector<double> &coefficients) {
      for (unsigned int c = 0; c < dim; ++c, ++row)
        for (unsigned int i = 0; i < n_points; ++i)
          data(row, i) = spline_value(element, i, coefficients, dim, c);
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
    for (const auto &field : fields.quadrature_scalars)
      fill_from_gauss_points(&field.second[e * n_gauss_of_cell()], row++, data);
    // The first rows are those of the displacement.
    for (unsigned int c = 0; c < dim; ++c, ++row)
      for (unsigned int i = 0; i < n_points; ++i)
        data(row, i) = table.position[element.first_point + i][c] + data(c, i);
  }



  template <int dim>
  void
  ChipOutput<dim>::write(std::ostream      &out,
                         const ChipFields  &fields,
                         const double       time,
                         const unsigned int step,
                         const unsigned int n_periods) const
  {
    std::ostringstream piece;
    write_piece(piece, fields, time, step, n_periods);
    write(out, {piece.str()});
  }



  template <int dim>
  std::vector<std::string>
  ChipOutput<dim>::pieces(const ChipFields  &fields,
                          const double       time,
                          const unsigned int step) const
  {
    std::ostringstream piece;
    std::string        problem;
    try
      {
        write_piece(piece, fields, time, step, 1);
      }
    catch (const ComputationError &error)
      {
        problem = error.what();
      }
    if (share.ranks.all(problem.empty()))
      return share.ranks.gather(piece.str());
    for (const std::string &found : share.ranks.gather(problem))
      if (!found.empty())
        throw SharedError(found);
    throw SharedError("Another rank cannot draw its part of the chip.");
  }



  template <int dim>
  void
  ChipOutput<dim>::write(std::ostream                   &out,
                         const std::vector<std::string> &pieces)
  {
    dealii::DataOutBase::write_vtu_header(out, internal::vtu_flags());
    for (const std::string &piece : pieces)
      out << piece;
    dealii::DataOutBase::write_vtu_footer(out);
  }



  template <int dim>
  void
  ChipOutput<dim>::write_piece(std::ostream      &out,
                               const ChipFields  &fields,
                               const double       time,
                               const unsigned int step,
                               const unsigned int n_periods) const
  {
    check_sizes(fields);
    if (n_periods > 1 && period == 0.)
      throw ComputationError("A chip that is not periodic cannot be drawn " +
                             std::to_string(n_periods) + " times.");

    internal::PatchRows<dim> rows;
    rows.add_vector("displacement [m]");
    for (const auto &field : fields.spline_vectors)
      rows.add_vector(field.first);
    for (const auto &field : fields.spline_scalars)
      rows.add_scalar(field.first);
    for (const auto &field : fields.quadrature_scalars)
      rows.add_scalar(field.first);

    std::vector<dealii::DataOutBase::Patch<dim, dim>> patches;
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      {
        if (!share.is_own(table.elements[e].cell))
          continue;
        auto patch = rows.template make_patch<dim>(n_subdivisions,
                                                   table.points_per_element);
        fill_cell(e, fields, patch.data);
        for (unsigned int k = 0; k < n_periods; ++k)
          {
            patches.push_back(patch);
            for (unsigned int i = 0; i < table.points_per_element; ++i)
              patches.back().data(rows.n_fields(), i) += k * period;
          }
      }
    rows.template write_piece<dim>(patches, time, step, out);
  }



  template <int dim>
  unsigned int
  ChipOutput<dim>::n_gauss_of_cell() const
  {
    return std::lround(std::pow(n_gauss_points, dim));
  }



  template class ChipOutput<2>;
  template class ChipOutput<3>;
} // namespace asperity
