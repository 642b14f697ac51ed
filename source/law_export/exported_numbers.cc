#include "exported_numbers.h"

#include <asperity/base/quantity.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    double
    on_scale(const Scale scale, const double x)
    {
      return scale == Scale::logarithmic ? std::log(x) : x;
    }

    ExportedNumbers::Coordinate
    make_coordinate(const LawInput    &input,
                    const unsigned int index,
                    const double       length)
    {
      ExportedNumbers::Coordinate c;
      c.index       = index;
      c.lower       = input.lower;
      c.margin      = FrictionLaw::edge_tolerance * (input.upper - input.lower);
      c.upper       = input.upper;
      c.logarithmic = input.scale == Scale::logarithmic;
      c.origin      = on_scale(input.scale, input.lower);
      c.span        = on_scale(input.scale, input.upper) - c.origin;
      c.length      = length;
      return c;
    }
  } // namespace



  ExportedNumbers::ExportedNumbers(const ContactPointLaw &law,
                                   const bool             with_deviation)
    : kernel(law.law().process().kernel())
    , output_scale(law.law().description().output_scale)
    , sum_of_weights(law.law().process().sum_of_weights())
    , signal_variance(law.law().process().hyperparameters().signal_variance)
    , offset(law.law().offset())
    , factor(law.law().factor())
    , largest_trusted_deviation(
        law.law().description().largest_trusted_deviation)
    , shear_limit(law.law().description().shear_limit)
  {
    const GaussianProcess       &process = law.law().process();
    const std::vector<double>   &x       = process.data().x;
    const std::vector<LawInput> &inputs  = law.law().description().inputs;
    const std::size_t            n       = process.data().y.size();
    for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        Coordinate c =
          make_coordinate(inputs[i],
                          law.coordinates()[i],
                          process.hyperparameters().length_scales[i]);
        for (std::size_t j = 0; j < n; ++j)
          c.points.push_back(x[j * inputs.size() + i] / c.length);
        if (c.index < ContactPointLaw::n_coordinates)
          {
            coordinates.push_back(c);
            continue;
          }
        const double s =
          (on_scale(inputs[i].scale, law.fixed_values()[i]) - c.origin) /
          c.span / c.length;
        rest.resize(n, 0.);
        for (std::size_t j = 0; j < n; ++j)
          rest[j] += (c.points[j] - s) * (c.points[j] - s);
      }
    for (const double alpha : process.alpha())
      weights.push_back(signal_variance * alpha);
    if (with_deviation)
      for (const double entry : process.inverse_factor())
        B.push_back(std::sqrt(signal_variance) * entry);
  }



  std::vector<double>
  taylor_coefficients()
  {
    std::vector<double> result;
    double              factorial = 1.;
    for (unsigned int i = 2; i <= 14; ++i)
      {
        factorial *= i;
        result.insert(result.begin(), 1. / factorial);
      }
    return result;
  }



  std::string
  c_number(const double value)
  {
    const std::string text = format_number(value);
    return text.find_first_of(".e") == std::string::npos ? text + "." : text;
  }



  std::string
  fortran_number(const double value)
  {
    std::string       text     = format_number(value);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos)
      return text + "D0";
    text[exponent] = 'D';
    return text;
  }



  std::vector<std::string>
  number_lines(const std::vector<std::string> &numbers,
               const std::size_t               width,
               const std::string              &end)
  {
    std::vector<std::string> lines(1);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        const std::string entry =
          numbers[i] + (i + 1 < numbers.size() ? "," : end);
        if (!lines.back().empty() && lines.back().size() + entry.size() > width)
          lines.emplace_back();
        lines.back() += entry;
      }
    return lines;
  }
} // namespace asperity
