#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/elastic_parameters.h>

#include <string>

namespace asperity
{
  double
  ElasticParameters::lame_lambda() const
  {
    return young_modulus * poisson_ratio /
           ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
  }



  double
  ElasticParameters::shear_modulus() const
  {
    return young_modulus / (2. * (1. + poisson_ratio));
  }



  double
  ElasticParameters::bulk_modulus() const
  {
    return young_modulus / (3. * (1. - 2. * poisson_ratio));
  }



  void
  ElasticParameters::declare(ParameterDeclarator &parameters)
  {
    parameters.quantity("Density",
                        density,
                        "kg/m^3",
                        Range::between(1., 1e5),
                        "Mass density rho of the undeformed body.");
    parameters.quantity("Young's modulus",
                        young_modulus,
                        "GPa",
                        Range::between(1e3, 2e12),
                        "Young's modulus E at small strain.");
    parameters.number(
      "Poisson's ratio",
      poisson_ratio,
      Range::between(-0.9, 0.49),
      "Poisson's ratio nu at small strain; nearer to 0.5, where a body "
      "keeps its volume, the splines lock: they hardly yield.");
  }



  void
  ElasticParameters::validate() const
  {
    if (!(density > 0.))
      throw InputError("The density must be positive, but it is " +
                       std::to_string(density) + " kg/m^3.");
    if (!(young_modulus > 0.))
      throw InputError("Young's modulus must be positive, but it is " +
                       std::to_string(young_modulus) + " Pa.");
    if (!(poisson_ratio > -1. && poisson_ratio < 0.5))
      throw InputError(
        "Poisson's ratio must lie between -1 and 0.5, but it is " +
        std::to_string(poisson_ratio) + ".");
  }
} // namespace asperity
