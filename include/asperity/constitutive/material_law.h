#ifndef asperity_constitutive_material_law_h
#define asperity_constitutive_material_law_h

#include <asperity/constitutive/elastic_parameters.h>
#include <asperity/constitutive/softening.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <limits>
#include <optional>
#include <string>

namespace asperity
{
  /** What a material point remembers from one time step to the next. */
  struct MaterialState
  {
    /** Inverse plastic right Cauchy-Green tensor C_p^{-1} in the reference
     *  frame. */
    dealii::SymmetricTensor<2, 3> Cp_inverse =
      dealii::unit_symmetric_tensor<3>();

    double plastic_strain = 0.;     ///< equivalent plastic strain
    double temperature    = 293.15; ///< [K]

    /** For archives of Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &Cp_inverse &plastic_strain &temperature;
    }
  };

  enum class LawStatus
  {
    ok,
    inverted, ///< det F <= 0: no stress exists, the step must be cut
    no_return ///< the scalar return map found no root (does not happen for
              ///< input inside the documented ranges)
  };

  /** What a law answers. P and tangent are undefined unless status is ok. */
  struct MaterialResponse
  {
    dealii::Tensor<2, 3> P;       ///< first Piola-Kirchhoff stress P_iJ [Pa]
    dealii::Tensor<4, 3> tangent; ///< dP_iJ/dF_kL [Pa], indices i J k L
    MaterialState        state;   ///< at the end of the step
    double    mises   = 0.;    ///< equivalent (von Mises) Kirchhoff stress [Pa]
    bool      plastic = false; ///< whether the step yielded
    LawStatus status  = LawStatus::ok;
  };

  /**
   * A point law: a pure function (F, old state, dt) -> (P, dP/dF, new state,
   * status), without mesh or degrees of freedom. All are isotropically elastic
   * at small strain.
   *
   * The first index of F and P is spatial, the second one material.
   * evaluate() and evaluate_points() may rely on plane kinematics,
   * F = [F11 F12 0; F21 F22 0; 0 0 F33] with F33 = 1 in plane strain and
   * F33 = r/R in axisymmetry (axes 1 = r, 2 = z, 3 = hoop). They then write
   * those components of P and of the tangent alone that such an F has; the
   * others stay the zeros of a fresh response. evaluate_general() is the same
   * law for any F.
   */
  class MaterialLaw
  {
  public:
    virtual ~MaterialLaw() = default;

    /**
     * @param F deformation gradient at the end of the step, relative to the
     *   reference configuration
     * @param old state at the start of the step
     * @param dt length of the step [s]; rates are differences over dt
     * @param with_tangent whether response.tangent is wanted
     * @param response its state is read first: the end of the step as found
     *   last, where iterations may start. It changes the answer within their
     *   tolerance alone.
     */
    virtual void
    evaluate(const dealii::Tensor<2, 3> &F,
             const MaterialState        &old,
             const double                dt,
             const bool                  with_tangent,
             MaterialResponse           &response) const = 0;

    /** The same at several points, where a law may be faster; what is said of
     *  one point holds for each. */
    virtual void
    evaluate_points(const unsigned int          n_points,
                    const dealii::Tensor<2, 3> *F,
                    const MaterialState        *old,
                    const double                dt,
                    const bool                  with_tangent,
                    MaterialResponse           *responses) const
    {
      for (unsigned int q = 0; q < n_points; ++q)
        evaluate(F[q], old[q], dt, with_tangent, responses[q]);
    }

    /** The same at several points whose F need not be plane: every component
     *  of F and C_p^{-1} counts, and every one of P, the tangent and C_p^{-1}
     *  is written. */
    virtual void
    evaluate_general(const unsigned int          n_points,
                     const dealii::Tensor<2, 3> *F,
                     const MaterialState        *old,
                     const double                dt,
                     const bool                  with_tangent,
                     MaterialResponse           *responses) const = 0;

    /** As in a parameter file. */
    virtual std::string
    name() const = 0;

    /** Shear stress k at which the point flows [Pa] at an equivalent plastic
     *  strain, its rate [1/s] and a temperature [K]; infinite if it never
     *  does, as elastic laws. */
    virtual double
    shear_limit(const double plastic_strain,
                const double rate,
                const double temperature) const
    {
      return std::numeric_limits<double>::infinity();
    }

    /** How plastic strain raises the shear limit; empty if it does not, or by
     *  another formula. */
    virtual std::optional<PowerHardening>
    hardening_law() const
    {
      return {};
    }

    /** How the temperature weakens the shear limit; empty if it does not. */
    virtual std::optional<Softening>
    softening() const
    {
      return {};
    }

    /** Reference mass density [kg/m^3]. */
    double
    density() const
    {
      return elasticity.density;
    }

    /** Young's modulus at small strain [Pa]; scales penalties. */
    double
    young_modulus() const
    {
      return elasticity.young_modulus;
    }

    /** Poisson's ratio at small strain. */
    double
    poisson_ratio() const
    {
      return elasticity.poisson_ratio;
    }

  protected:
    /** @throws InputError if a constant has no physical meaning */
    explicit MaterialLaw(const ElasticParameters &elasticity)
      : elasticity(elasticity)
    {
      elasticity.validate();
    }

    const ElasticParameters elasticity;
  };
} // namespace asperity

#endif
