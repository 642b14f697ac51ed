#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>

#include <algorithm>

#include "supernodal_panels.h"

namespace asperity::supernodal
{
  using neighbours::at;
  using neighbours::Pack;

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
            for (unsigned int k = c / neighbours::width * neighbours::width;
                 k < panel.stride;
                 k += neighbours::width)
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
            for (unsigned int k = c / neighbours::width * neighbours::width;
                 k < panel->stride;
                 k += neighbours::width)
              sum += at(work + k) * at(column + k);
            double &x_c = x[panel->first + c];
            x_c     = (x_c - (sum[0] + sum[1] + sum[2] + sum[3])) / column[c];
            work[c] = x_c;
          }
      }
  }
} // namespace asperity::supernodal
