#include <asperity/base/text.h>
#include <asperity/postprocess/surface_picture.h>

#include <algorithm>
#include <type_traits>

#include "lagrange_values.h"
#include "vtu_patches.h"

namespace asperity
{
  void
  write_surface(std::ostream         &out,
                const SurfacePicture &surface,
                const double          time,
                const unsigned int    step)
  {
    const unsigned int     n_side = surface.points_a_side, n = n_side * n_side;
    internal::PatchRows<3> rows;
    for (const auto &[name, values] : surface.vectors)
      {
        internal::check_size("surface",
                             name,
                             values.size(),
                             surface.points.size());
        rows.add_vector(name);
      }
    for (const auto &[name, values] : surface.scalars)
      {
        internal::check_size("surface",
                             name,
                             values.size(),
                             surface.points.size());
        rows.add_scalar(name);
      }

    std::vector<dealii::DataOutBase::Patch<2, 3>> patches;
    for (std::size_t first = 0; first < surface.points.size(); first += n)
      {
        auto         patch = rows.make_patch<2>(n_side - 1, n);
        unsigned int row   = 0;
        for (const auto &field : surface.vectors)
          for (unsigned int c = 0; c < 3; ++c, ++row)
            for (unsigned int i = 0; i < n; ++i)
              patch.data(row, i) = field.second[first + i][c];
        for (const auto &field : surface.scalars)
          {
            for (unsigned int i = 0; i < n; ++i)
              patch.data(row, i) = field.second[first + i];
            ++row;
          }
        for (unsigned int c = 0; c < 3; ++c, ++row)
          for (unsigned int i = 0; i < n; ++i)
            patch.data(row, i) = surface.points[first + i][c];
        patches.push_back(patch);
      }
    rows.write<2>(patches, time, step, out);
  }



  template <typename Value>
  std::vector<Value>
  from_gauss_points(const std::vector<Value> &values,
                    const unsigned int        n,
                    const bool                limited)
  {
    const std::vector<double> lagrange = internal::lagrange_values(n - 1, n);
    std::vector<Value>        result;
    for (std::size_t first = 0; first < values.size(); first += n * n)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            Value value{};
            for (unsigned int h = 0; h < n; ++h)
              for (unsigned int g = 0; g < n; ++g)
                value += lagrange[i * n + g] * lagrange[j * n + h] *
                         values[first + h * n + g];
            if constexpr (std::is_arithmetic_v<Value>)
              if (limited)
                {
                  const auto [low, high] =
                    std::minmax_element(values.begin() + first,
                                        values.begin() + first + n * n);
                  value = std::clamp(value, *low, *high);
                }
            result.push_back(value);
          }
    return result;
  }



  template std::vector<double>
  from_gauss_points(const std::vector<double> &,
                    const unsigned int,
                    const bool);
  template std::vector<dealii::Tensor<1, 3>>
  from_gauss_points(const std::vector<dealii::Tensor<1, 3>> &,
                    const unsigned int,
                    const bool);
  template std::vector<dealii::Point<3>>
  from_gauss_points(const std::vector<dealii::Point<3>> &,
                    const unsigned int,
                    const bool);
} // namespace asperity
