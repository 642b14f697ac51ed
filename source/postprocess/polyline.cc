#include <asperity/base/text.h>
#include <asperity/postprocess/polyline.h>

#include "vtu_patches.h"

namespace asperity
{
  namespace
  {
    template <typename Value>
    void
    check_size(const std::string        &name,
               const std::vector<Value> &values,
               const std::size_t         expected)
    {
      if (values.size() != expected)
        throw ComputationError(
          "The field " + quoted_name(name) + " of a line has " +
          std::to_string(values.size()) + " values, but the line has " +
          std::to_string(expected) + " points.");
    }
  } // namespace



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
        check_size(name, values, n);
        rows.add_vector(name);
      }
    for (const auto &[name, values] : line.scalars)
      {
        check_size(name, values, n);
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
