#include "supernodal_panels.h"

#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::supernodal
{
  namespace
  {
    using neighbours::at;
    using neighbours::Pack;

    /** Panels have as many columns at a time; tiles of products are two packs
     *  high. */
    constexpr unsigned int lanes = neighbours::width;

    /** Of each lane, the larger absolute value. */
    inline Pack
    largest(const Pack &a, const Pack &b)
    {
      const Pack c = b < 0. ? -b : b;
      return a > c ? a : c;
    }

    inline double
    largest(const Pack &a)
    {
      return std::max(std::max(a[0], a[1]), std::max(a[2], a[3]));
    }



    /** sum_c = sum over t of rows times the c-th number of columns. */
    template <unsigned int n_packs>
    inline void
    multiply(const double      *rows,
             const double      *columns,
             const unsigned int stride,
             const unsigned int width,
             Pack (&sum)[lanes][n_packs])
    {
      for (unsigned int c = 0; c < lanes; ++c)
        for (unsigned int k = 0; k < n_packs; ++k)
          sum[c][k] = Pack{};
      for (unsigned int t = 0; t < width; ++t)
        {
          Pack row[n_packs];
          for (unsigned int k = 0; k < n_packs; ++k)
            row[k] = at(rows + std::size_t(t) * stride + lanes * k);
          for (unsigned int c = 0; c < lanes; ++c)
            {
              const double factor = columns[std::size_t(t) * stride + c];
              for (unsigned int k = 0; k < n_packs; ++k)
                sum[c][k] += factor * row[k];
            }
        }
    }



    /** Subtracts a tile of a product where its rows stand in the target. */
    template <unsigned int n_packs>
    inline void
    scatter(const Pack (&sum)[lanes][n_packs],
            const unsigned int *row_places,
            const unsigned int  n_rows,
            const unsigned int *column_places,
            const unsigned int  n_columns,
            double             *target,
            const unsigned int  stride)
    {
      for (unsigned int k = 0; k < n_packs && lanes * k < n_rows; ++k)
        {
          const unsigned int *const place = row_places + lanes * k;
          const unsigned int        n     = std::min(lanes, n_rows - lanes * k);
          const bool                together =
            n == lanes && place[lanes - 1] - place[0] == lanes - 1;
          for (unsigned int c = 0; c < n_columns; ++c)
            {
              double *const column =
                target + std::size_t(column_places[c]) * stride;
              if (together)
                at(column + place[0]) = at(column + place[0]) - sum[c][k];
              else
                for (unsigned int i = 0; i < n; ++i)
                  column[place[i]] -= sum[c][k][i];
            }
        }
    }



    /** Rows from i on and columns from j on of an update, a tile of them. */
    template <unsigned int n_packs>
    inline void
    subtract_tile(const Update       &u,
                  const double       *rows,
                  const double       *columns,
                  const unsigned int  i,
                  const unsigned int  j,
                  const unsigned int *places,
                  double             *target,
                  const unsigned int  stride)
    {
      Pack sum[lanes][n_packs];
      multiply<n_packs>(rows + i, columns + j, u.stride, u.width, sum);
      scatter<n_packs>(sum,
                       places + i,
                       u.n_rows - i,
                       places + j,
                       std::min(lanes, u.n_columns - j),
                       target,
                       stride);
    }



    /** Subtracts the lower triangle and what is below it of the product of a
     *  panel's rows with the transposed ones of another one, in Cholesky's
     *  factorisation of the same. */
    inline void
    subtract(const Update       &u,
             const double       *rows,
             const double       *columns,
             const unsigned int *places,
             double             *target,
             const unsigned int  stride)
    {
      rows += u.values;
      columns += u.values;
      for (unsigned int j = 0; j < u.n_columns; j += lanes)
        for (unsigned int i = j; i < u.n_rows; i += 2 * lanes)
          if (u.n_rows - i > lanes)
            subtract_tile<2>(u, rows, columns, i, j, places, target, stride);
          else
            subtract_tile<1>(u, rows, columns, i, j, places, target, stride);
    }



    /** Subtracts from some columns of a panel what those before them make with
     *  the transposed ones of another one, in Cholesky's factorisation the
     *  same. */
    template <unsigned int n_packs>
    inline void
    subtract_before(double            *panel,
                    const double      *transposed,
                    const unsigned int stride,
                    const unsigned int row,
                    const unsigned int column,
                    const unsigned int n_columns)
    {
      Pack sum[lanes][n_packs];
      multiply<n_packs>(panel + row, transposed + column, stride, column, sum);
      for (unsigned int c = 0; c < n_columns; ++c)
        for (unsigned int k = 0; k < n_packs; ++k)
          {
            Pack &target =
              at(panel + std::size_t(column + c) * stride + row + lanes * k);
            target -= sum[c][k];
          }
    }



    /** The same for all rows from that of the first of the columns on. */
    inline void
    subtract_before(double            *panel,
                    const double      *transposed,
                    const unsigned int stride,
                    const unsigned int column,
                    const unsigned int n_columns)
    {
      if (column == 0)
        return;
      for (unsigned int row = column; row < stride; row += 2 * lanes)
        if (row + lanes < stride)
          subtract_before<2>(panel, transposed, stride, row, column, n_columns);
        else
          subtract_before<1>(panel, transposed, stride, row, column, n_columns);
    }



    /** Columns of a panel that only depend on each other any more.
     *  @return false if a pivot is not positive or not finite */
    template <unsigned int n>
    inline bool
    finish_columns(double            *panel,
                   const unsigned int stride,
                   const unsigned int column)
    {
      double *columns[n];
      double  L[n][n], inverse[n];
      for (unsigned int c = 0; c < n; ++c)
        columns[c] = panel + std::size_t(column + c) * stride;
      for (unsigned int c = 0; c < n; ++c)
        for (unsigned int r = c; r < n; ++r)
          {
            L[r][c] = columns[c][column + r];
            for (unsigned int e = 0; e < c; ++e)
              L[r][c] -= L[r][e] * L[c][e];
            if (r == c)
              {
                if (!(L[c][c] > 0. && std::isfinite(L[c][c])))
                  return false;
                inverse[c] = 1. / std::sqrt(L[c][c]);
              }
            L[r][c] *= inverse[c];
          }
      for (unsigned int row = column; row < stride; row += lanes)
        {
          Pack x[n];
          for (unsigned int c = 0; c < n; ++c)
            {
              x[c] = at(columns[c] + row);
              for (unsigned int e = 0; e < c; ++e)
                x[c] -= L[c][e] * x[e];
              x[c] *= inverse[c];
              at(columns[c] + row) = x[c];
            }
        }
      return true;
    }



    bool
    factorize_panel(double *panel, const Panel &p)
    {
      for (unsigned int column = 0; column < p.width; column += lanes)
        {
          const unsigned int n = std::min(lanes, p.width - column);
          subtract_before(panel, panel, p.stride, column, n);
          const bool positive =
            n == 4 ? finish_columns<4>(panel, p.stride, column) :
            n == 3 ? finish_columns<3>(panel, p.stride, column) :
            n == 2 ? finish_columns<2>(panel, p.stride, column) :
                     finish_columns<1>(panel, p.stride, column);
          if (!positive)
            return false;
        }
      return true;
    }



    /** Columns of both factors' panels that only depend on each other any
     *  more.
     *  @return the largest |L_ij U_jk| of them, infinite if a pivot is zero or
     *   not finite */
    template <unsigned int n>
    inline double
    finish_columns(double            *lower,
                   double            *upper,
                   const unsigned int stride,
                   const unsigned int column)
    {
      double *l_column[n], *u_column[n];
      double  L[n][n], U[n][n], inverse[n];
      Pack    l_max[n] = {}, u_max[n] = {};
      for (unsigned int c = 0; c < n; ++c)
        {
          l_column[c] = lower + std::size_t(column + c) * stride;
          u_column[c] = upper + std::size_t(column + c) * stride;
          for (unsigned int r = c; r < n; ++r)
            {
              L[r][c] = l_column[c][column + r];
              U[r][c] = u_column[c][column + r];
              for (unsigned int e = 0; e < c; ++e)
                {
                  L[r][c] -= L[r][e] * U[c][e];
                  U[r][c] -= U[r][e] * L[c][e];
                }
            }
          inverse[c] = 1. / L[c][c];
          if (!std::isfinite(inverse[c]) || inverse[c] == 0.)
            return std::numeric_limits<double>::infinity();
          for (unsigned int r = c; r < n; ++r)
            U[r][c] *= inverse[c];
        }
      for (unsigned int row = column; row < stride; row += lanes)
        {
          Pack l[n], u[n];
          for (unsigned int c = 0; c < n; ++c)
            {
              l[c] = at(l_column[c] + row);
              u[c] = at(u_column[c] + row);
              for (unsigned int e = 0; e < c; ++e)
                {
                  l[c] -= U[c][e] * l[e];
                  u[c] -= L[c][e] * u[e];
                }
              u[c] *= inverse[c];
              at(l_column[c] + row) = l[c];
              at(u_column[c] + row) = u[c];
              l_max[c]              = largest(l_max[c], l[c]);
              u_max[c]              = largest(u_max[c], u[c]);
            }
        }
      double product = 0.;
      for (unsigned int c = 0; c < n; ++c)
        {
          u_column[c][column + c] = 1.;
          product =
            std::max(product,
                     largest(l_max[c]) * std::max(1., largest(u_max[c])));
        }
      return product;
    }



    inline double
    factorize_panel(double *lower, double *upper, const Panel &p)
    {
      double product = 0.;
      for (unsigned int column = 0; column < p.width; column += lanes)
        {
          const unsigned int n = std::min(lanes, p.width - column);
          subtract_before(lower, upper, p.stride, column, n);
          subtract_before(upper, lower, p.stride, column, n);
          product = std::max(
            product,
            n == 4 ? finish_columns<4>(lower, upper, p.stride, column) :
            n == 3 ? finish_columns<3>(lower, upper, p.stride, column) :
            n == 2 ? finish_columns<2>(lower, upper, p.stride, column) :
                     finish_columns<1>(lower, upper, p.stride, column));
        }
      return product;
    }
  } // namespace



  ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL bool
  factorize(const std::vector<Panel>  &panels,
            const std::vector<Update> &updates,
            const unsigned int        *relative,
            double                    *values)
  {
    std::size_t u = 0;
    for (const Panel &panel : panels)
      {
        for (; u < panel.updates; ++u)
          subtract(updates[u],
                   values,
                   values,
                   relative + updates[u].relative,
                   values + panel.values,
                   panel.stride);
        if (!factorize_panel(values + panel.values, panel))
          return false;
      }
    return true;
  }



  ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL double
  factorize(const std::vector<Panel>  &panels,
            const std::vector<Update> &updates,
            const unsigned int        *relative,
            double                    *lower,
            double                    *upper)
  {
    std::size_t u       = 0;
    double      product = 0.;
    for (const Panel &panel : panels)
      {
        double *const l = lower + panel.values, *const v = upper + panel.values;
        for (; u < panel.updates; ++u)
          {
            const unsigned int *const places = relative + updates[u].relative;
            subtract(updates[u], lower, upper, places, l, panel.stride);
            subtract(updates[u], upper, lower, places, v, panel.stride);
          }
        product = std::max(product, factorize_panel(l, v, panel));
        if (!std::isfinite(product))
          break;
      }
    return product;
  }
} // namespace asperity::supernodal
