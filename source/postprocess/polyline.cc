#include <asperity/base/text.h>
#include <asperity/postprocess/polyline.h>

#include "vtu_patches.h"

namespace asperity
{
  void
  write_polyline(std::ostream      &out,
                 const Polyline    &line,
                 const double       time,
                 const unsigned int step)
  {
    const unsigned int n = line.points.size();
    if (n < 2)
      throw ComputationError("A line of " + std::to_string(n) +
                             " points cannot be drawn; at least two are "
                             "expected.");
    internal::PatchRows<2> rows;
    for (const auto &[name, values] : line.vectors)
      {
        internal::check_size("line", name, values.size(), n);
        rows.add_vector(name);
      }
    for (const auto &[name, values] : line.scalars)
      {
        internal::check_size("line", name, values.size(), n);
        rows.add_scalar(name);
      }

    // One patch for the whole line: its subdivisions are the segments.
    auto         patch = rows.make_patch<1>(n - 1, n);
    unsigned int row   = 0;
    for (const auto &field : line.vectors)
      for (unsigned int c = 0; c < 2; ++c, ++row)
        for (unsigned int i = 0; i < n; ++i)
          patch.data(row, i) = field.second[i][c];
    for (const auto &field : line.scalars)
      {
        for (unsigned int i = 0; i < n; ++i)
          patch.data(row, i) = field.second[i];
        ++row;
      }
    for (unsigned int c = 0; c < 2; ++c, ++row)
      for (unsigned int i = 0; i < n; ++i)
        patch.data(row, i) = line.points[i][c];

    rows.write<1>({patch}, time, step, out);
  }
} // namespace asperity
