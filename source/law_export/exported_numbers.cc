#include "exported_numbers.h"

#include <asperity/base/quantity.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    std::size_t
    find(const std::vector<LawInput> &inputs, const std::string &name)
    {
      std::size_t i = 0;
      while (i < inputs.size() && inputs[i].name != name)
        ++i;
      return i;
    }

    /** k(eps) = hardening(eps) k(strain of k_0). */
    ExportedNumbers::Strength
    make_strength(const FrictionLawDescription &law)
    {
      if (!law.pressure_over_strength)
        return {false, 0, law.inputs.size(), law.inputs.size(), 1.};
      const ShearLimit &k = law.shear_limit;
      return {true,
              find(law.inputs, "Load/Pressure"),
              find(law.inputs, "Load/Temperature"),
              find(law.inputs, "Load/Plastic strain"),
              1. +
                k.hardening_ratio * std::pow(std::min(k.strain, k.strain_limit),
                                             k.hardening_exponent)};
    }

    ExportedNumbers::Coordinate
    make_coordinate(const LawInput       &input,
                    const unsigned int    place,
                    const LawCoordinates &seen,
                    const std::size_t     i)
    {
      ExportedNumbers::Coordinate c;
      c.place       = place;
      c.lower       = input.lower;
      c.margin      = FrictionLaw::edge_tolerance * (input.upper - input.lower);
      c.upper       = input.upper;
      c.logarithmic = input.scale == Scale::logarithmic;
      c.origin      = seen.start(i);
      c.span        = seen.extent(i);
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
    , noise_variance(law.law().fitted() != nullptr ?
                       law.law().fitted()->noise_variance() :
                       law.law().process().noise_variance())
    , shear_limit(law.law().description().shear_limit)
    , strength(make_strength(law.law().description()))
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
        coordinates.push_back(
          make_coordinate(inputs[i], place, law.law().coordinates(), i));
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
