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
    make_coordinate(const LawInput &input, const unsigned int place)
    {
      ExportedNumbers::Coordinate c;
      c.place       = place;
      c.lower       = input.lower;
      c.margin      = FrictionLaw::edge_tolerance * (input.upper - input.lower);
      c.upper       = input.upper;
      c.logarithmic = input.scale == Scale::logarithmic;
      c.origin      = on_scale(input.scale, input.lower);
      c.span        = on_scale(input.scale, input.upper) - c.origin;
      return c;
    }
  } // namespace



  ExportedNumbers::ExportedNumbers(const ContactPointLaw &law,
                                   const bool             with_deviation)
    : output_scale(law.law().description().output_scale)
    , offset(law.law().offset())
    , factor(law.law().factor())
    , largest_trusted_deviation(
        law.law().description().largest_trusted_deviation)
    , shear_limit(law.law().description().shear_limit)
  {
    const std::vector<LawInput> &inputs = law.law().description().inputs;
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
        coordinates.push_back(make_coordinate(inputs[i], place));
      }
    if (law.law().fitted() != nullptr)
      set(*law.law().fitted());
    else
      set(law.law().process(), with_deviation);
  }



  void
  ExportedNumbers::set(const GaussianProcess &process,
                       const bool             with_deviation)
  {
    kernel          = process.kernel();
    sum_of_weights  = process.sum_of_weights();
    signal_variance = process.hyperparameters().signal_variance;
    has_deviation   = with_deviation;
    const std::vector<double> &lengths =
      process.hyperparameters().length_scales;
    for (std::size_t i = 0; i < lengths.size(); ++i)
      coordinates[i].length = lengths[i];
    points = process.data().x;
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] /= lengths[k % lengths.size()];
    for (const double alpha : process.alpha())
      weights.push_back(signal_variance * alpha);
    if (with_deviation)
      for (const double entry : process.inverse_factor())
        B.push_back(std::sqrt(signal_variance) * entry);
  }



  void
  ExportedNumbers::set(const PiecewisePowerRegression &formula)
  {
    const PiecewisePowerLaw &law = formula.law();
    fitted                       = {std::log(law.mu_0),
                                    std::log(law.v_0),
                                    law.exponent,
                                    formula.end(),
                                    law.covariance};
    for (double &entry : fitted->covariance)
      entry *= formula.factor() * formula.factor();
    coordinates[0].origin = 0.; // s is the logarithm itself
    coordinates[0].span   = 1.;
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
