#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/contact_point_law.h>

#include <algorithm>
#include <limits>

namespace asperity
{
  namespace
  {
    const double *
    find_fixed(const std::map<std::string, double> &fixed,
               const LawInput                      &input)
    {
      for (const std::string &key : {input.name, input.symbol})
        if (const auto entry = fixed.find(key); entry != fixed.end())
          return &entry->second;
      return nullptr;
    }

    std::string
    range(const LawInput &input)
    {
      return format_quantity(input.lower, input.unit, 6) + " to " +
             format_quantity(input.upper, input.unit, 6);
    }

    void
    require_known(const std::map<std::string, double> &fixed,
                  const std::vector<LawInput>         &inputs)
    {
      for (const auto &[key, value] : fixed)
        {
          std::vector<std::string> names;
          bool                     known = false;
          for (const LawInput &input : inputs)
            {
              const auto &symbols = ContactPointLaw::symbols();
              if (std::find(symbols.begin(), symbols.end(), input.symbol) !=
                  symbols.end())
                continue;
              names.push_back(quoted_name(input.name));
              known = known || key == input.name || key == input.symbol;
            }
          if (!known)
            throw InputError(
              "A value is given for " + quoted_name(key) +
              ", but the friction law has no such input beside pressure, "
              "velocity and temperature; " +
              (names.empty() ? "it has no others." :
                               "its others are " + join(names, ", ") + "."));
        }
    }

    double
    fixed_value(const std::map<std::string, double> &fixed,
                const LawInput                      &input)
    {
      const double *value = find_fixed(fixed, input);
      if (value == nullptr && input.reference)
        value = &*input.reference;
      if (value == nullptr)
        throw InputError("The friction law also depends on " +
                         quoted_name(input.name) +
                         "; a value of it is expected, " + range(input) + ".");
      if (!(*value >= input.lower && *value <= input.upper))
        throw InputError("The value of " + quoted_name(input.name) + " is " +
                         format_quantity(*value, input.unit, 6) +
                         "; a value inside of the training data is expected, " +
                         range(input) + ".");
      return *value;
    }
  } // namespace



  const std::array<std::string, ContactPointLaw::n_coordinates> &
  ContactPointLaw::symbols()
  {
    static const std::array<std::string, n_coordinates> names = {
      {"p", "v", "T"}};
    return names;
  }



  ContactPointLaw::ContactPointLaw(const FrictionLaw                   &law,
                                   const std::map<std::string, double> &fixed)
    : law_(law)
  {
    const FrictionLawDescription &description = law.description();
    if (!is_friction_coefficient(description.output))
      throw InputError("The law is one of " + quoted_name(description.output) +
                       "; a law of 'mu' is expected.");
    require_known(fixed, description.inputs);
    for (const LawInput &input : description.inputs)
      {
        const auto symbol =
          std::find(symbols().begin(), symbols().end(), input.symbol);
        const bool is_fixed = symbol == symbols().end();
        coordinates_.push_back(
          static_cast<unsigned int>(symbol - symbols().begin()));
        fixed_values_.push_back(is_fixed ? fixed_value(fixed, input) : 0.);
      }
  }



  std::vector<double>
  ContactPointLaw::law_input(const ContactPoint &point) const
  {
    std::vector<double> x = fixed_values_;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (coordinates_[i] < n_coordinates)
        x[i] = point[coordinates_[i]];
    return x;
  }



  double
  ContactPointLaw::mean(const ContactPoint &point) const
  {
    return law_.mean(law_input(point).data());
  }



  std::vector<double>
  ContactPointLaw::means(const std::vector<ContactPoint> &points) const
  {
    std::vector<double> inputs, result(points.size());
    inputs.reserve(points.size() * fixed_values_.size());
    for (const ContactPoint &point : points)
      for (const double x : law_input(point))
        inputs.push_back(x);
    law_.means(points.size(), inputs.data(), result.data());
    return result;
  }



  LawPrediction
  ContactPointLaw::predict(const ContactPoint &point) const
  {
    LawPrediction prediction = law_.predict(law_input(point).data());

    std::vector<double> gradient(n_coordinates, 0.);
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      if (coordinates_[i] < n_coordinates)
        gradient[coordinates_[i]] = prediction.gradient[i];
    prediction.gradient = gradient;
    return prediction;
  }



  bool
  ContactPointLaw::is_inside(const ContactPoint &point) const
  {
    return law_.is_inside(law_input(point).data());
  }



  const LawInput *
  ContactPointLaw::input(const unsigned int coordinate) const
  {
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      if (coordinates_[i] == coordinate)
        return &law_.description().inputs[i];
    return nullptr;
  }



  double
  ContactPointLaw::shear_limit(const double temperature) const
  {
    const ShearLimit &limit = law_.description().shear_limit;
    return limit.k_0 > 0. ? limit(temperature) :
                            std::numeric_limits<double>::infinity();
  }



  double
  ContactPointLaw::shear_stress(const ContactPoint &point) const
  {
    return std::min(mean(point) * point[0], shear_limit(point[2]));
  }



  const FrictionLaw &
  ContactPointLaw::law() const
  {
    return law_;
  }



  const std::vector<unsigned int> &
  ContactPointLaw::coordinates() const
  {
    return coordinates_;
  }



  const std::vector<double> &
  ContactPointLaw::fixed_values() const
  {
    return fixed_values_;
  }
} // namespace asperity
