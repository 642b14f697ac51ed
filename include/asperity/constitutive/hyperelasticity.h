#ifndef asperity_constitutive_hyperelasticity_h
#define asperity_constitutive_hyperelasticity_h

#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <memory>

namespace asperity
{
  /**
   * St. Venant-Kirchhoff elasticity, S = lambda tr(E) 1 + 2 mu E with the
   * Green-Lagrange strain E; for moderate compression only. The state passes
   * through unchanged.
   */
  class StVenantKirchhoff final : public MaterialLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    explicit StVenantKirchhoff(const ElasticParameters &elasticity);

    void
    evaluate(const dealii::Tensor<2, 3> &F,
             const MaterialState        &old,
             const double                dt,
             const bool                  with_tangent,
             MaterialResponse           &response) const override;

    std::string
    name() const override;

  private:
    double lambda, mu;
  };

  /** Chooses StVenantKirchhoff, which needs no further constants. */
  struct StVenantKirchhoffParameters
  {
    static constexpr const char *name = "St. Venant-Kirchhoff";
    static constexpr const char *description =
      "elasticity, linear in the Green-Lagrange strain, for moderate "
      "compression only";

    /** Declares nothing. */
    void
    declare(ParameterDeclarator &)
    {}

    /** Nothing to check. */
    void
    check(const ParameterDeclarator &) const
    {}

    /** @throws InputError if a constant has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law(const ElasticParameters &elasticity,
             const HeatingParameters &heating) const;
  };

  /**
   * Compressible neo-Hooke elasticity,
   *   psi = mu/2 (tr(F^T F) - 3) - mu ln J + lambda/2 (ln J)^2,
   *   P   = mu (F - F^{-T}) + lambda ln J F^{-T}.
   * The state passes through unchanged.
   */
  class NeoHooke final : public MaterialLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    explicit NeoHooke(const ElasticParameters &elasticity);

    void
    evaluate(const dealii::Tensor<2, 3> &F,
             const MaterialState        &old,
             const double                dt,
             const bool                  with_tangent,
             MaterialResponse           &response) const override;

    std::string
    name() const override;

  private:
    double lambda, mu;
  };

  /** Chooses NeoHooke, which needs no further constants. */
  struct NeoHookeParameters
  {
    static constexpr const char *name = "neo-Hooke";
    static constexpr const char *description =
      "compressible elasticity of neo-Hooke";

    /** Declares nothing. */
    void
    declare(ParameterDeclarator &)
    {}

    /** Nothing to check. */
    void
    check(const ParameterDeclarator &) const
    {}

    /** @throws InputError if a constant has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law(const ElasticParameters &elasticity,
             const HeatingParameters &heating) const;
  };
} // namespace asperity

#endif
