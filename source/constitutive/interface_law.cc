#include <asperity/base/parameters.h>
#include <asperity/constitutive/interface_law.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    void
    declare_strength(InterfaceParameters &p, ParameterDeclarator &parameters)
    {
      parameters.choice(
        "Shear law",
        p.law,
        {{"none", InterfaceShear::none},
         {"Coulomb", InterfaceShear::coulomb},
         {"shear factor", InterfaceShear::shear_factor},
         {"limited Coulomb", InterfaceShear::limited_coulomb},
         {"Wanheim-Bay", InterfaceShear::wanheim_bay}},
        "What limits the shear stress where chip and tool touch: `none`, a "
        "frictionless contact, whose mu comes from ploughing alone; `Coulomb`, "
        "mu_0 p; `shear factor`, m k with the shear strength k of the chip; "
        "`limited Coulomb`, the smaller of both; `Wanheim-Bay`, from the one "
        "to the other by the real contact of asperities that are too small for "
        "the spline.");
      parameters.number("Friction coefficient",
                        p.friction_coefficient,
                        Range::between(0., 5.),
                        "mu_0 of Coulomb's law, of the spots themselves.");
      parameters.number("Shear factor",
                        p.shear_factor,
                        Range::between(0., 1.),
                        "m, the part of the chip's shear strength k that a dry "
                        "interface bears, however little it presses: 0 slips "
                        "freely, 1 is a weld. No theory gives m; it is to be "
                        "calibrated by a measured mu (asperity calibrate).");
      parameters.number("Wet shear factor",
                        p.wet_shear_factor,
                        Range::between(0., 1.),
                        "m of a spot that oil covers; `automatic` takes that "
                        "of the dry one. A spot counts as covered to the part "
                        "of the gap there that is full of oil: of its pocket, "
                        "or of the film at the spot.");
    }
  } // namespace



  void
  InterfaceParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Interface");
    declare_strength(*this, parameters);
    parameters.quantity(
      "Shear layer",
      shear_layer,
      "um",
      Range::between(1e-9, 1e-3),
      "Thickness of the layer of the chip that shears, which "
      "makes k a number: it is taken at the sliding velocity "
      "over this thickness, and at the strain and temperature "
      "that the chip has there. Ten times less raises k by "
      "5 %.");
    parameters.number("Stick penalty",
                      stick_penalty,
                      Range::between(1e-6, 1e3),
                      "Stiffness of a spot that sticks, over the penalty "
                      "epsilon of the pressure.");
    parameters.number("Contact transition",
                      transition,
                      Range::between(1e-4, 1.),
                      "A spot bears m k where the gap is closed, and less up "
                      "to a gap of this part of the element length at the "
                      "contact edge.");
  }



  bool
  InterfaceParameters::uses_shear_strength() const
  {
    return law != InterfaceShear::none && law != InterfaceShear::coulomb;
  }



  InterfaceLaw::InterfaceLaw(const InterfaceParameters &parameters)
    : law(parameters.law)
    , friction_coefficient(parameters.friction_coefficient)
    , dry_shear_factor(parameters.shear_factor)
    , wet_shear_factor(
        parameters.wet_shear_factor.value_or(parameters.shear_factor))
  {}



  ShearStrength
  InterfaceLaw::strength(const InterfaceState &state) const
  {
    const double m =
      dry_shear_factor + state.wet * (wet_shear_factor - dry_shear_factor);
    const ShearStrength coulomb{friction_coefficient * state.pressure,
                                friction_coefficient,
                                0.};
    const ShearStrength touching{m * state.k * state.touching, 0., m * state.k};
    switch (law)
      {
        case InterfaceShear::coulomb:
          return coulomb;
        case InterfaceShear::shear_factor:
          return touching;
        case InterfaceShear::limited_coulomb:
          return coulomb.value < touching.value ? coulomb : touching;
        case InterfaceShear::wanheim_bay:
          return wanheim_bay(state.pressure, state.k, m);
        default:
          return {};
      }
  }



  ShearStrength
  InterfaceLaw::wanheim_bay(const double pressure,
                            const double k,
                            const double f) const
  {
    if (f == 0. || k == 0.)
      return {};
    const double s = std::sqrt(1. - f), at_limit = 1. - s;
    const double limit =
      k * (1. + dealii::numbers::PI_2 + std::acos(f) + std::sqrt(1. - f * f)) /
      (1. + s);
    if (pressure <= limit)
      return {at_limit * k * pressure / limit, at_limit * k / limit, 0.};
    const double rest = f - at_limit;
    if (rest <= 0.) // f = 1
      return {f * k, 0., 0.};
    const double decay =
      std::exp(-at_limit * (pressure - limit) / (limit * rest));
    return {k * (f - rest * decay), k * at_limit / limit * decay, 0.};
  }
} // namespace asperity
