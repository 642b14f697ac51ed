#ifndef asperity_constitutive_elastic_parameters_h
#define asperity_constitutive_elastic_parameters_h

namespace asperity
{
  class ParameterDeclarator;

  /** Isotropic elasticity and inertia; the defaults are steel. */
  struct ElasticParameters
  {
    double density       = 7800.; ///< reference density [kg/m^3]
    double young_modulus = 205e9; ///< [Pa]
    double poisson_ratio = 0.29;  ///< in (-1, 1/2)

    /** lambda [Pa]. */
    double
    lame_lambda() const;

    /** mu [Pa]. */
    double
    shear_modulus() const;

    /** lambda + 2/3 mu [Pa]. */
    double
    bulk_modulus() const;

    /** Declares the entries in the present subsection. */
    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if a constant has no physical meaning */
    void
    validate() const;
  };
} // namespace asperity

#endif
