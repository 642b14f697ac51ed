#ifndef asperity_surrogate_law_coordinates_h
#define asperity_surrogate_law_coordinates_h

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** On which scale a quantity is nearly linear for the Gaussian process. */
  enum class Scale
  {
    linear,
    logarithmic
  };

  /** "linear" or "logarithmic", as in the model file. */
  std::string
  to_string(const Scale scale);

  /** An input of a law, with the box of its training data. */
  struct LawInput
  {
    std::string name;   ///< path of the scene's entry, "Load/Pressure"
    std::string symbol; ///< "p", "v", "T", or the key without blanks
    std::string unit;   ///< for people, "MPa"; all numbers here are SI
    double      lower = 0., upper = 1.;
    Scale       scale = Scale::linear;

    /** At which exports hold it that have no argument for it; SI. */
    std::optional<double> reference = {};
  };

  /**
   * Shear strength of the chip, the limit of tau in the sticking zone (Zorev):
   * k(T) = k_0 (1 - T*^m), T* = (T - T_transition) / (T_melt - T_transition) in
   * [0, 1], or k_0 at all temperatures; k_0 is the flow stress over sqrt(3) at
   * the strain and rate that are stated and below T_transition.
   */
  struct ShearLimit
  {
    double k_0                    = 0.;   ///< [Pa]; 0: unknown
    double exponent               = 1.;   ///< m
    double transition_temperature = 0.;   ///< [K]
    double melting_temperature    = 0.;   ///< [K]
    double strain                 = 0.;   ///< of k_0
    double rate                   = 0.;   ///< of k_0 [1/s]
    bool   softens                = true; ///< false: k is k_0 at all T

    /** k grows with plastic strain by 1 + ratio min(eps, strain_limit)^n. */
    double hardening_ratio    = 0.;
    double hardening_exponent = 1.; ///< n
    double strain_limit       = 1.;

    double
    operator()(const double temperature) const;

    /** dk/dT [Pa/K] */
    double
    slope(const double temperature) const;

    /** Strain that an indenter adds to that of a metal, so that its hardness is
     *  that of the sum (D. Tabor, The Hardness of Metals, 1951, chapter V). */
    static constexpr double strain_of_indentation = 0.08;

    /** k of an indented chip over that at `strain`. @param plastic_strain which
     *  the chip has without the indentation, not negative */
    double
    hardening(const double plastic_strain) const;

    /** Its derivative. */
    double
    hardening_slope(const double plastic_strain) const;
  };

  /**
   * What a regression sees of the inputs x of a law:
   *   z_i = (g(q_i) - g(q_i,min)) / (g(q_i,max) - g(q_i,min)),
   * g = identity or logarithm by the input's scale; q = x, or, where that is
   * wanted, q = p / k(T, eps) for the pressure: how much of a chip touches is
   * decided by the pressure over the strength of its skin, so that a law over q
   * needs fewer runs than one over p, T and eps. Beyond the box k keeps the
   * value of its edge.
   */
  class LawCoordinates
  {
  public:
    LawCoordinates() = default;

    /** @throws InputError naming @p origin if q = p / k is wanted, and there is
     *  no pressure among the inputs, no k, or none at the hottest point */
    LawCoordinates(const std::vector<LawInput> &inputs,
                   const ShearLimit            &limit,
                   const bool                   over_strength,
                   const std::string           &origin);

    /** The logarithm of a single input as it is. */
    static LawCoordinates
    logarithm(const LawInput &input);

    /** @param x d inputs in SI @param z d coordinates; an input that has no
     *  logarithm counts as the end of its range */
    void
    transform(const double *x, double *z) const;

    /** Row by row. @param x n x d */
    std::vector<double>
    transform(const std::vector<double> &x) const;

    /** Turns derivatives by z at a point into those by x. */
    void
    pull_back(const double *x, double *gradient) const;

    /** Of coordinate i. */
    double
    start(const std::size_t i) const;

    double
    extent(const std::size_t i) const;

  private:
    /** k at x, and its derivatives by T and the strain over k. */
    double
    strength(const double *x, double &by_temperature, double &by_strain) const;

    std::vector<LawInput>      inputs;
    ShearLimit                 limit;
    std::optional<std::size_t> pressure, temperature, strain;
    std::vector<double>        start_, extent_; ///< of g(q)
  };
} // namespace asperity

#endif
