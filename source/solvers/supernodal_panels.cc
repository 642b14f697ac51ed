#include "supernodal_panels.h"

#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>

#include <algorithm>
#include <cmath>

namespace asperity::supernodal
{
  namespace
  {
    using neighbours::at;
    using neighbours::Pack;

    /** Panels have as many columns at a time; tiles of products are two packs
     *  high. */
    constexpr unsigned int lanes = neighbours::width;

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
                  const double       *from,
                  const unsigned int  i,
                  const unsigned int  j,
                  const unsigned int *places,
                  double             *target,
                  const unsigned int  stride)
    {
      Pack sum[lanes][n_packs];
      multiply<n_packs>(from + i, from + j, u.stride, u.width, sum);
      scatter<n_packs>(sum,
                       places + i,
                       u.n_rows - i,
                       places + j,
                       std::min(lanes, u.n_columns - j),
                       target,
                       stride);
    }



    void
    subtract(const Update       &u,
             const double       *values,
             const unsigned int *places,
             double             *target,
             const unsigned int  stride)
    {
      const double *const from = values + u.values;
      for (unsigned int j = 0; j < u.n_columns; j += lanes)
        for (unsigned int i = j; i < u.n_rows; i += 2 * lanes)
          if (u.n_rows - i > lanes)
            subtract_tile<2>(u, from, i, j, places, target, stride);
          else
            subtract_tile<1>(u, from, i, j, places, target, stride);
    }



    /** Subtracts from some columns of a panel what those before them make. */
    template <unsigned int n_packs>
    inline void
    subtract_before(double            *panel,
                    const unsigned int stride,
                    const unsigned int row,
                    const unsigned int column,
                    const unsigned int n_columns)
    {
      Pack sum[lanes][n_packs];
      multiply<n_packs>(panel + row, panel + column, stride, column, sum);
      for (unsigned int c = 0; c < n_columns; ++c)
        for (unsigned int k = 0; k < n_packs; ++k)
          {
            Pack &target =
              at(panel + std::size_t(column + c) * stride + row + lanes * k);
            target -= sum[c][k];
          }
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
          const unsigned int n   = std::min(lanes, p.width - column);
          unsigned int       row = column;
          for (; column > 0 && row < p.stride; row += 2 * lanes)
            if (row + lanes < p.stride)
              subtract_before<2>(panel, p.stride, row, column, n);
            else
              subtract_before<1>(panel, p.stride, row, column, n);
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
                   relative + updates[u].relative,
                   values + panel.values,
                   panel.stride);
        if (!factorize_panel(values + panel.values, panel))
          return false;
      }
    return true;
  }



  ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
  substitute_forward(const std::vector<Panel> &panels,
                     const unsigned int       *rows,
                     const double             *values,
                     double                   *work,
                     double                   *x)
  {
    for (const Panel &panel : panels)
      {
        const double *const L = values + panel.values;
        std::copy_n(x + panel.first, panel.width, work);
        std::fill(work + panel.width, work + panel.stride, 0.);
        for (unsigned int c = 0; c < panel.width; ++c)
          {
            const double *const column = L + std::size_t(c) * panel.stride;
            const double        x_c    = work[c] / column[c];
            x[panel.first + c]         = x_c;
            // What this makes of the rows above is not read any more.
            for (unsigned int k = c / lanes * lanes; k < panel.stride;
                 k += lanes)
              at(work + k) = at(work + k) - x_c * at(column + k);
          }
        for (unsigned int i = panel.width; i < panel.n_rows; ++i)
          x[rows[panel.rows + i]] += work[i];
      }
  }



  ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
  substitute_backward(const std::vector<Panel> &panels,
                      const unsigned int       *rows,
                      const double             *values,
                      double                   *work,
                      double                   *x)
  {
    for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel)
      {
        std::fill_n(work, panel->stride, 0.);
        for (unsigned int i = panel->width; i < panel->n_rows; ++i)
          work[i] = x[rows[panel->rows + i]];
        for (unsigned int c = panel->width; c-- > 0;)
          {
            const double *const column =
              values + panel->values + std::size_t(c) * panel->stride;
            Pack sum = {};
            for (unsigned int k = c / lanes * lanes; k < panel->stride;
                 k += lanes)
              sum += at(work + k) * at(column + k);
            double &x_c = x[panel->first + c];
            x_c     = (x_c - (sum[0] + sum[1] + sum[2] + sum[3])) / column[c];
            work[c] = x_c;
          }
      }
  }
} // namespace asperity::supernodal
