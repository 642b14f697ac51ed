#include <asperity/base/quantity.h>
#include <asperity/tool_design/texture_space.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** The smallest box around points of n numbers each. */
    SearchBox
    box_around(const std::vector<std::vector<double>> &points,
               const std::string                      &name)
    {
      SearchBox box;
      box.lower = box.upper = points.front();
      for (std::size_t i = 0; i < box.lower.size(); ++i)
        {
          box.names.push_back(name + std::to_string(i + 1));
          for (const std::vector<double> &point : points)
            {
              box.lower[i] = std::min(box.lower[i], point[i]);
              box.upper[i] = std::max(box.upper[i], point[i]);
            }
        }
      return box;
    }
  } // namespace



  unsigned int
  n_texture_coordinates(const unsigned int n_waves)
  {
    unsigned int n = 0;
    for (unsigned int m = 1; m == 1 || 2 * m <= n_waves; m *= 2)
      n += 2;
    return n;
  }



  std::vector<double>
  texture_positions(const std::size_t n, const unsigned int n_waves)
  {
    std::vector<double> positions;
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int m = 1; m == 1 || 2 * m <= n_waves; m *= 2)
        {
          const double angle = 2. * M_PI * m * i / n;
          positions.push_back(std::cos(angle));
          positions.push_back(std::sin(angle));
        }
    return positions;
  }



  LatentTextures::LatentTextures(const AutoDecoder &network,
                                 const std::size_t  n_places,
                                 const unsigned int n_waves)
    : network(network)
    , positions(texture_positions(n_places, n_waves))
  {}



  SearchBox
  LatentTextures::box() const
  {
    std::vector<std::vector<double>> codes;
    for (std::size_t i = 0; i < network.n_codes(); ++i)
      {
        const std::vector<float> code = network.code(i);
        codes.emplace_back(code.begin(), code.end());
      }
    return box_around(codes, "z");
  }



  std::vector<double>
  LatentTextures::heights(const std::vector<double> &code) const
  {
    return normalized(
      network.evaluate(std::vector<float>(code.begin(), code.end()),
                       positions));
  }



  std::string
  LatentTextures::description() const
  {
    return "latent codes, " + network.description;
  }



  namespace
  {
    std::vector<double>
    all_heights(const std::vector<ToolTexture> &textures)
    {
      std::vector<double> heights;
      for (const ToolTexture &texture : textures)
        heights.insert(heights.end(),
                       texture.heights.begin(),
                       texture.heights.end());
      return heights;
    }
  } // namespace



  ModalTextures::ModalTextures(const std::vector<ToolTexture> &textures,
                               const unsigned int              n)
    : modes_(all_heights(textures), textures.size())
    , n(n)
  {
    std::vector<std::vector<double>> coefficients;
    for (const ToolTexture &texture : textures)
      coefficients.push_back(modes_.project(texture.heights, n));
    box_ = box_around(coefficients, "c");
  }



  SearchBox
  ModalTextures::box() const
  {
    return box_;
  }



  std::vector<double>
  ModalTextures::heights(const std::vector<double> &coefficients) const
  {
    return normalized(modes_.reconstruct(coefficients));
  }



  std::string
  ModalTextures::description() const
  {
    return std::to_string(n) + " modes of " +
           format_number(modes_.singular_values().front());
  }



  FreeFormTextures::FreeFormTextures(const std::vector<double> &base,
                                     const unsigned int         n_columns,
                                     const double               largest_move)
    : base(normalized(base))
    , columns(KnotVector::uniform_periodic(3, n_columns, 0., 1.))
    , largest_move(largest_move)
  {}



  SearchBox
  FreeFormTextures::box() const
  {
    SearchBox box;
    for (const char *const row : {"lower", "upper"})
      for (unsigned int j = 0; j < columns.n_basis(); ++j)
        {
          box.names.push_back(row + std::to_string(j + 1));
          box.lower.push_back(-largest_move);
          box.upper.push_back(largest_move);
        }
    return box;
  }



  std::vector<double>
  FreeFormTextures::heights(const std::vector<double> &moves) const
  {
    const auto [lowest, highest] =
      std::minmax_element(base.begin(), base.end());
    const unsigned int  n      = columns.n_basis();
    std::vector<double> result = base;
    for (std::size_t i = 0; i < base.size(); ++i)
      {
        const double       x         = static_cast<double>(i) / base.size();
        const unsigned int span      = columns.find_span(x);
        const auto         functions = columns.span_functions(span);
        const auto         values    = columns.evaluate(span, x)[0];
        const double       s = (base[i] - *lowest) / (*highest - *lowest);
        for (std::size_t j = 0; j < functions.size(); ++j)
          result[i] += values[j] * ((1. - s) * moves[functions[j]] +
                                    s * moves[n + functions[j]]);
      }
    return normalized(result);
  }



  std::string
  FreeFormTextures::description() const
  {
    return "free-form deformation of the base profile by " +
           std::to_string(columns.n_basis()) + " columns";
  }
} // namespace asperity
