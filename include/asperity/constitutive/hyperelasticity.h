#ifndef asperity_constitutive_hyperelasticity_h
#define asperity_constitutive_hyperelasticity_h

#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <memory>

namespace asperity
{
  /** Base of the laws whose stress follows from F alone; the state passes
   *  through unchanged. */
  class HyperelasticLaw : public MaterialLaw
  {
  public:
    void
    evaluate(const dealii::Tensor<2, 3> &F,
             const MaterialState        &old,
             const double                dt,
             const bool                  with_tangent,
             MaterialResponse           &response) const override;

    void
    evaluate_general(const unsigned int          n_points,
                     const dealii::Tensor<2, 3> *F,
                     const MaterialState        *old,
                     const double                dt,
                     const bool                  with_tangent,
                     MaterialResponse           *responses) const override;

  protected:
    /** @throws InputError if a constant has no physical meaning */
    explicit HyperelasticLaw(const ElasticParameters &elasticity);

    const double lambda, mu; ///< Lame's constants [Pa]

  private:
    /** Stress, von Mises stress and, if wanted, tangent of any F whose
     *  determinant J is positive. */
    virtual void
    respond(const dealii::Tensor<2, 3> &F,
            const double                J,
            const bool                  with_tangent,
            MaterialResponse           &response) const = 0;

    /** Unless J is positive and finite the point is inverted. */
    void
    respond_if_regular(const dealii::Tensor<2, 3> &F,
                       const double                J,
                       const MaterialState        &old,
                       const bool                  with_tangent,
                       MaterialResponse           &response) const;
  };

  /**
   * St. Venant-Kirchhoff elasticity, S = lambda tr(E) 1 + 2 mu E with the
   * Green-Lagrange strain E; for moderate compression only.
   */
  class StVenantKirchhoff final : public HyperelasticLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    explicit StVenantKirchhoff(const ElasticParameters &elasticity);

    std::string
    name() const override;

  private:
    void
    respond(const dealii::Tensor<2, 3> &F,
            const double                J,
            const bool                  with_tangent,
            MaterialResponse           &response) const override;
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
   */
  class NeoHooke final : public HyperelasticLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    explicit NeoHooke(const ElasticParameters &elasticity);

    std::string
    name() const override;

  private:
    void
    respond(const dealii::Tensor<2, 3> &F,
            const double                J,
            const bool                  with_tangent,
            MaterialResponse           &response) const override;
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
