#include "supernodal_structure.h"

#include <asperity/base/neighbours.h>

#include <suitesparse/cholmod.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Lower triangle of a pattern in compressed columns, rows sorted. */
    struct LowerTriangle
    {
      LowerTriangle(const unsigned int                      n_rows,
                    const std::vector<std::pair<int, int>> &entries)
        : column_start(n_rows + 1, 0)
      {
        std::vector<std::vector<int>> columns(n_rows);
        for (const auto &[i, j] : entries)
          columns[std::min(i, j)].push_back(std::max(i, j));
        for (unsigned int j = 0; j < n_rows; ++j)
          {
            std::sort(columns[j].begin(), columns[j].end());
            row.insert(row.end(),
                       columns[j].begin(),
                       std::unique(columns[j].begin(), columns[j].end()));
            column_start[j + 1] = row.size();
          }
      }

      cholmod_sparse
      view()
      {
        cholmod_sparse view{};
        view.nrow = view.ncol = column_start.size() - 1;
        view.nzmax            = row.size();
        view.p                = column_start.data();
        view.i                = row.data();
        view.stype            = -1;
        view.itype            = CHOLMOD_INT;
        view.xtype            = CHOLMOD_PATTERN;
        view.dtype            = CHOLMOD_DOUBLE;
        view.sorted           = 1;
        view.packed           = 1;
        return view;
      }

      std::vector<int> column_start, row;
    };
  } // namespace



  void
  SupernodalStructure::clear()
  {
    panels.clear();
  }



  bool
  SupernodalStructure::analyze(const unsigned int                      n_rows,
                               const std::vector<std::pair<int, int>> &entries,
                               const bool dissect_too)
  {
    clear();
    cholmod_common common;
    cholmod_start(&common);
    common.supernodal    = CHOLMOD_SUPERNODAL;
    common.print         = 0;
    common.error_handler = nullptr;
    if (dissect_too)
      {
        common.nmethods           = 2;
        common.method[0].ordering = CHOLMOD_AMD;
        common.method[1].ordering = CHOLMOD_NESDIS;
      }
    LowerTriangle   triangle(n_rows, entries);
    cholmod_sparse  view   = triangle.view();
    cholmod_factor *factor = cholmod_analyze(&view, &common);
    if (factor != nullptr)
      {
        const int *const perm = static_cast<int *>(factor->Perm);
        order.assign(perm, perm + n_rows);
        build_panels(factor);
        sort_panels();
        list_updates();
      }
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
    return is_analyzed();
  }



  void
  SupernodalStructure::build_panels(const void *symbolic_factor)
  {
    const auto &factor = *static_cast<const cholmod_factor *>(symbolic_factor);
    const auto *const first  = static_cast<const int *>(factor.super);
    const auto *const row_of = static_cast<const int *>(factor.pi);
    const auto *const row    = static_cast<const int *>(factor.s);
    rows.assign(row, row + row_of[factor.nsuper]);
    panel_of.resize(factor.n);
    std::size_t longest = 0;
    size                = 0;
    for (std::size_t s = 0; s < factor.nsuper; ++s)
      {
        supernodal::Panel panel;
        panel.first  = first[s];
        panel.width  = first[s + 1] - first[s];
        panel.n_rows = row_of[s + 1] - row_of[s];
        panel.stride = neighbours::padded(panel.n_rows);
        panel.values = size;
        panel.rows   = row_of[s];
        std::fill_n(&panel_of[panel.first], panel.width, s);
        size += std::size_t(panel.width) * panel.stride;
        longest = std::max<std::size_t>(longest, panel.stride);
        panels.push_back(panel);
      }
    work.resize(longest);
    ordered.resize(factor.n);
  }



  void
  SupernodalStructure::sort_panels()
  {
    const std::vector<unsigned int> old_order = order;
    for (const supernodal::Panel &panel : panels)
      std::sort(order.begin() + panel.first,
                order.begin() + panel.first + panel.width);
    const std::vector<unsigned int> place = places();
    for (unsigned int &row : rows)
      row = place[old_order[row]];
    for (const supernodal::Panel &panel : panels)
      std::sort(rows.begin() + panel.rows,
                rows.begin() + panel.rows + panel.n_rows);
  }



  void
  SupernodalStructure::list_updates()
  {
    std::vector<std::vector<std::pair<std::size_t, unsigned int>>> sources(
      panels.size()); // panel and the first of its rows
    for (std::size_t s = 0; s < panels.size(); ++s)
      for (unsigned int i = panels[s].width; i < panels[s].n_rows;)
        {
          const unsigned int target = panel_of[rows[panels[s].rows + i]];
          sources[target].emplace_back(s, i);
          while (i < panels[s].n_rows &&
                 panel_of[rows[panels[s].rows + i]] == target)
            ++i;
        }
    updates.clear();
    relative.clear();
    for (std::size_t target = 0; target < panels.size(); ++target)
      {
        const unsigned int *const from = &rows[panels[target].rows],
                                  *to  = from + panels[target].n_rows;
        for (const auto &[s, i] : sources[target])
          {
            supernodal::Update update;
            update.values   = panels[s].values + i;
            update.stride   = panels[s].stride;
            update.width    = panels[s].width;
            update.n_rows   = panels[s].n_rows - i;
            update.relative = relative.size();
            for (unsigned int r = i; r < panels[s].n_rows; ++r)
              {
                const unsigned int row = rows[panels[s].rows + r];
                update.n_columns += (panel_of[row] == target);
                relative.push_back(std::lower_bound(from, to, row) - from);
              }
            updates.push_back(update);
          }
        panels[target].updates = updates.size();
      }
  }



  std::size_t
  SupernodalStructure::slot(const unsigned int column,
                            const unsigned int row) const
  {
    const supernodal::Panel  &panel = panels[panel_of[column]];
    const unsigned int *const from  = &rows[panel.rows];
    return panel.values + std::size_t(column - panel.first) * panel.stride +
           (std::lower_bound(from, from + panel.n_rows, row) - from);
  }



  std::vector<unsigned int>
  SupernodalStructure::places() const
  {
    std::vector<unsigned int> place(order.size());
    for (unsigned int i = 0; i < order.size(); ++i)
      place[order[i]] = i;
    return place;
  }



  std::size_t
  SupernodalStructure::n_values() const
  {
    // Tiles may read beyond the last row.
    return size + 2 * neighbours::width;
  }



  bool
  SupernodalStructure::factorize(double *L) const
  {
    return supernodal::factorize(panels, updates, relative.data(), L);
  }



  double
  SupernodalStructure::factorize(double *L, double *U_transposed) const
  {
    return supernodal::factorize(
      panels, updates, relative.data(), L, U_transposed);
  }



  void
  SupernodalStructure::solve(const double *L,
                             const double *U_transposed,
                             double       *b) const
  {
    for (unsigned int i = 0; i < order.size(); ++i)
      ordered[i] = b[order[i]];
    supernodal::substitute_forward(
      panels, rows.data(), L, work.data(), ordered.data());
    supernodal::substitute_backward(
      panels, rows.data(), U_transposed, work.data(), ordered.data());
    for (unsigned int i = 0; i < order.size(); ++i)
      b[order[i]] = ordered[i];
  }
} // namespace asperity
