#ifndef asperity_constitutive_material_law_h
#define asperity_constitutive_material_law_h

#include <asperity/constitutive/elastic_parameters.h>

#include <array>
#include <string>

namespace asperity
{
  /**
   * Components of a two-point tensor of plane kinematics, in this order:
   * 11, 12, 21, 22, 33. The deformation gradient is
   * F = [F11 F12 0; F21 F22 0; 0 0 F33] with F33 = 1 in plane strain and
   * F33 = r/R in axisymmetry (axes 1 = r, 2 = z, 3 = hoop).
   */
  using PlaneTensor = std::array<double, 5>;

  /** dP/dF, row = component of P, column = component of F. */
  using PlaneTangent = std::array<PlaneTensor, 5>;

  /** What a material point remembers from one time step to the next. */
  struct MaterialState
  {
    /** Inverse plastic right Cauchy-Green tensor C_p^{-1} in the reference
     *  frame: 11, 22, 12 (tensor component), 33. */
    std::array<double, 4> Cp_inverse = {{1., 1., 0., 1.}};

    /** Equivalent plastic strain. */
    double plastic_strain = 0.;

    /** Temperature in kelvin. */
    double temperature = 293.15;

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
    PlaneTensor   P{};        ///< first Piola-Kirchhoff stress [Pa]
    PlaneTangent  tangent{};  ///< consistent tangent dP/dF [Pa]
    MaterialState state;      ///< at the end of the step
    double        mises = 0.; ///< equivalent (von Mises) Kirchhoff stress [Pa]
    bool          plastic = false; ///< whether the step yielded
    LawStatus     status  = LawStatus::ok;
  };

  /**
   * A point law: a pure function (F, old state, dt) -> (P, dP/dF, new state,
   * status), without mesh or degrees of freedom. All are isotropically elastic
   * at small strain.
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
     */
    virtual void
    evaluate(const PlaneTensor   &F,
             const MaterialState &old,
             const double         dt,
             const bool           with_tangent,
             MaterialResponse    &response) const = 0;

    virtual std::string
    name() const = 0;

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
