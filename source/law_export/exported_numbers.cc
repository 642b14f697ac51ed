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
                    const unsigned int place,
                    const double       length)
    {
      ExportedNumbers::Coordinate c;
      c.place       = place;
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
    const std::vector<LawInput> &inputs  = law.law().description().inputs;
    const std::vector<double>   &lengths =
      process.hyperparameters().length_scales;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        unsigned int place = law.coordinates()[i];
        if (place == ContactPointLaw::n_coordinates)
          {
            place += static_cast<unsigned int>(further.size());
            further.push_back(
              {inputs[i].name,
               accepted_units(dimension_of(inputs[i].unit)).front(),
               law.fixed_values()[i]});
          }
        coordinates.push_back(make_coordinate(inputs[i], place, lengths[i]));
      }
    points = process.data().x;
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] /= lengths[k % inputs.size()];
    for (const double alpha : process.alpha())
      weights.push_back(signal_variance * alpha);
    if (with_deviation)
      for (const double entry : process.inverse_factor())
        B.push_back(std::sqrt(signal_variance) * entry);
  }



  unsigned int
  ExportedNumbers::kernel_number() const
  {
    return kernel == KernelKind::rbf        ? 1 :
           kernel == KernelKind::matern_3_2 ? 3 :
                                              5;
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
