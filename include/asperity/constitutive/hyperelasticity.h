#ifndef asperity_constitutive_hyperelasticity_h
#define asperity_constitutive_hyperelasticity_h

#include <asperity/constitutive/material_law.h>

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
    evaluate(const PlaneTensor   &F,
             const MaterialState &old,
             const double         dt,
             const bool           with_tangent,
             MaterialResponse    &response) const override;

    std::string
    name() const override;

  private:
    double lambda, mu;
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
    evaluate(const PlaneTensor   &F,
             const MaterialState &old,
             const double         dt,
             const bool           with_tangent,
             MaterialResponse    &response) const override;

    std::string
    name() const override;

  private:
    double lambda, mu;
  };
} // namespace asperity

#endif
