#include "supernodal_cholesky.h"

#include <asperity/base/neighbours.h>

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <numeric>

namespace asperity
{
  namespace
  {
    /** Lower triangle of a pattern in compressed columns, rows sorted. */
    struct LowerTriangle
    {
      LowerTriangle(const std::vector<unsigned int>        &order,
                    const std::vector<std::pair<int, int>> &entries)
        : column_start(order.size() + 1, 0)
      {
        std::vector<int> place(order.size());
        for (unsigned int i = 0; i < order.size(); ++i)
          place[order[i]] = i;
        std::vector<std::vector<int>> columns(order.size());
        for (const auto &[i, j] : entries)
          if (i <= j)
            {
              const auto ends = std::minmax(place[i], place[j]);
              columns[ends.first].push_back(ends.second);
            }
        for (unsigned int j = 0; j < columns.size(); ++j)
          {
            std::sort(columns[j].begin(), columns[j].end());
            row.insert(row.end(), columns[j].begin(), columns[j].end());
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
  SupernodalCholesky::clear()
  {
    panels.clear();
  }



  bool
  SupernodalCholesky::analyze(const unsigned int                      n_rows,
                              const std::vector<std::pair<int, int>> &entries)
  {
    clear();
    order.resize(n_rows);
    std::iota(order.begin(), order.end(), 0);
    cholmod_common common;
    cholmod_start(&common);
    common.supernodal    = CHOLMOD_SUPERNODAL;
    common.print         = 0;
    common.error_handler = nullptr;
    LowerTriangle   triangle(order, entries);
    cholmod_sparse  view   = triangle.view();
    cholmod_factor *factor = cholmod_analyze(&view, &common);
    if (factor != nullptr)
      {
        std::copy_n(static_cast<int *>(factor->Perm), n_rows, order.begin());
        build_panels(factor);
        list_updates();
        find_slots(entries);
      }
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
    return is_analyzed();
  }



  void
  SupernodalCholesky::build_panels(const void *symbolic_factor)
  {
    const auto &factor = *static_cast<const cholmod_factor *>(symbolic_factor);
    const auto *const first  = static_cast<const int *>(factor.super);
    const auto *const row_of = static_cast<const int *>(factor.pi);
    const auto *const row    = static_cast<const int *>(factor.s);
    rows.assign(row, row + row_of[factor.nsuper]);
    panel_of.resize(factor.n);
    std::size_t size = 0, longest = 0;
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
    // Tiles may read beyond the last row.
    values.assign(size + 2 * neighbours::width, 0.);
    work.resize(longest);
    ordered.resize(factor.n);
  }



  void
  SupernodalCholesky::list_updates()
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



  void
  SupernodalCholesky::find_slots(
    const std::vector<std::pair<int, int>> &entries)
  {
    std::vector<unsigned int> place(order.size());
    for (unsigned int i = 0; i < order.size(); ++i)
      place[order[i]] = i;
    source.clear();
    slot.clear();
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (entries[k].first <= entries[k].second)
        {
          const auto ends =
            std::minmax(place[entries[k].first], place[entries[k].second]);
          const supernodal::Panel  &panel = panels[panel_of[ends.first]];
          const unsigned int *const from  = &rows[panel.rows];
          source.push_back(k);
          slot.push_back(
            panel.values +
            std::size_t(ends.first - panel.first) * panel.stride +
            (std::lower_bound(from, from + panel.n_rows, ends.second) - from));
        }
  }



  bool
  SupernodalCholesky::factorize(const double *entries)
  {
    std::fill(values.begin(), values.end(), 0.);
    for (std::size_t k = 0; k < slot.size(); ++k)
      values[slot[k]] = entries[source[k]];
    return supernodal::factorize(panels,
                                 updates,
                                 relative.data(),
                                 values.data());
  }



  void
  SupernodalCholesky::solve(double *b) const
  {
    for (unsigned int i = 0; i < order.size(); ++i)
      ordered[i] = b[order[i]];
    supernodal::substitute_forward(
      panels, rows.data(), values.data(), work.data(), ordered.data());
    supernodal::substitute_backward(
      panels, rows.data(), values.data(), work.data(), ordered.data());
    for (unsigned int i = 0; i < order.size(); ++i)
      b[order[i]] = ordered[i];
  }
} // namespace asperity
