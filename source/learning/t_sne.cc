#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learning/t_sne.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    /** Normal probabilities of neighbours from squared distances.
     *  @return entropy */
    double
    normal_probabilities(const std::vector<double> &squares,
                         const std::size_t          own,
                         const double               precision,
                         std::vector<double>       &probabilities)
    {
      double least = INFINITY;
      for (std::size_t j = 0; j < squares.size(); ++j)
        if (j != own)
          least = std::min(least, squares[j]);
      double sum = 0., mean = 0.;
      for (std::size_t j = 0; j < squares.size(); ++j)
        {
          const double x   = precision * (squares[j] - least);
          probabilities[j] = j == own ? 0. : std::exp(-x);
          sum += probabilities[j];
          mean += x * probabilities[j];
        }
      for (double &p : probabilities)
        p /= sum;
      return std::log(sum) + mean / sum;
    }



    /** The same with the precision for which the entropy is as given. */
    void
    fit_probabilities(const std::vector<double> &squares,
                      const std::size_t          own,
                      const double               entropy,
                      std::vector<double>       &probabilities)
    {
      const double largest = *std::max_element(squares.begin(), squares.end());
      double       low = 0., up = INFINITY;
      double       precision = largest > 0. ? 1. / largest : 1.;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double found =
            normal_probabilities(squares, own, precision, probabilities);
          if (std::abs(found - entropy) < 1e-10)
            break;
          (found > entropy ? low : up) = precision;
          precision = std::isinf(up) ? 2. * precision : 0.5 * (low + up);
        }
    }
  } // namespace



  std::vector<double>
  neighbour_probabilities(const std::vector<double> &points,
                          const unsigned int         n_coordinates,
                          const double               perplexity)
  {
    const std::size_t n = points.size() / n_coordinates;
    if (!(perplexity >= 1.) || n <= 3. * perplexity)
      throw InputError("A picture of " + std::to_string(n) +
                       " codes needs a perplexity from 1 to less than a third "
                       "of their number.");
    std::vector<double> result(n * n, 0.), squares(n), probabilities(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
          {
            squares[j] = 0.;
            for (unsigned int c = 0; c < n_coordinates; ++c)
              squares[j] += std::pow(points[i * n_coordinates + c] -
                                       points[j * n_coordinates + c],
                                     2);
          }
        fit_probabilities(squares, i, std::log(perplexity), probabilities);
        for (std::size_t j = 0; j < n; ++j)
          {
            result[i * n + j] += 0.5 / n * probabilities[j];
            result[j * n + i] += 0.5 / n * probabilities[j];
          }
      }
    return result;
  }



  double
  embedding_divergence(const std::vector<double> &probabilities,
                       const std::vector<double> &places,
                       std::vector<double>       *gradient)
  {
    const std::size_t   n = places.size() / 2;
    std::vector<double> weights(n * n);
    double              sum = 0.;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        {
          const double dx    = places[2 * i] - places[2 * j];
          const double dy    = places[2 * i + 1] - places[2 * j + 1];
          const double w     = 1. / (1. + dx * dx + dy * dy);
          weights[i * n + j] = w;
          sum += w;
        }
    sum -= static_cast<double>(n); // of a point with itself
    double result = 0.;
    if (gradient == nullptr)
      {
        for (std::size_t i = 0; i < n * n; ++i)
          if (probabilities[i] > 0.)
            result +=
              probabilities[i] * std::log(probabilities[i] * sum / weights[i]);
        return result;
      }
    gradient->assign(2 * n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      {
        double gx = 0., gy = 0.;
        for (std::size_t j = 0; j < n; ++j)
          {
            const double w = weights[i * n + j];
            const double f = (probabilities[i * n + j] - w / sum) * w;
            gx += f * (places[2 * i] - places[2 * j]);
            gy += f * (places[2 * i + 1] - places[2 * j + 1]);
          }
        (*gradient)[2 * i]     = 4. * gx;
        (*gradient)[2 * i + 1] = 4. * gy;
      }
    return result;
  }



  std::vector<double>
  embed_in_plane(const std::vector<double> &points,
                 const unsigned int         n_coordinates,
                 const EmbeddingOptions    &options)
  {
    std::vector<double> probabilities =
      neighbour_probabilities(points, n_coordinates, options.perplexity);
    const std::size_t   n = points.size() / n_coordinates;
    RandomNumbers       random(options.seed);
    std::vector<double> places(2 * n), step(2 * n, 0.), gains(2 * n, 1.),
      gradient;
    for (double &y : places)
      y = 1e-2 * random.normal();
    for (double &p : probabilities)
      p *= options.exaggeration;
    for (unsigned int t = 0; t < options.n_steps; ++t)
      {
        if (t == options.n_exaggerated)
          for (double &p : probabilities)
            p /= options.exaggeration;
        embedding_divergence(probabilities, places, &gradient);
        const double momentum = t < 250 ? 0.5 : 0.8;
        for (std::size_t i = 0; i < 2 * n; ++i)
          {
            // a rate of its own for each coordinate, larger while it goes on
            const bool goes_on = gradient[i] * step[i] < 0.;
            gains[i] =
              goes_on ? gains[i] + 0.2 : std::max(0.01, 0.8 * gains[i]);
            step[i] =
              momentum * step[i] - options.rate * gains[i] * gradient[i];
            places[i] += step[i];
          }
      }
    return places;
  }
} // namespace asperity
