#ifndef asperity_learned_fields_field_modes_h
#define asperity_learned_fields_field_modes_h

#include <asperity/learned_fields/field_layout.h>

#include <array>
#include <vector>

namespace asperity
{
  /** Fields that are linear in coefficients c: mean + sum over k of
   *  c_k mode_k. */
  struct FieldModes
  {
    std::vector<double> mean, modes; ///< modes one after the other

    unsigned int
    n_modes() const;

    const double *
    mode(const unsigned int k) const;

    /** @return the vector of a FieldLayout, SI */
    std::vector<double>
    combine(const std::vector<double> &coefficients) const;
  };

  /** What mu and the balances need of the fields at a time; linear in them. */
  struct FieldForces
  {
    /** Of the tractions [N/m]. */
    std::array<double, 2> traction{{0., 0.}};

    /** See imbalance_of_stress() [N/m]; 0 with inertia. */
    std::array<double, 2> imbalance{{0., 0.}};
  };

  /** By integrals over the fields, one a time. */
  std::vector<FieldForces>
  forces_of(const FieldLayout &layout, const std::vector<double> &values);

  /** The same forces from coefficients of modes, without the fields: those of
   *  the mean and of each mode are integrated once. */
  class ForcesOfModes
  {
  public:
    ForcesOfModes(const FieldLayout &layout, const FieldModes &modes);

    /** One a time. */
    std::vector<FieldForces>
    combine(const std::vector<double> &coefficients) const;

  private:
    std::vector<FieldForces>              mean;
    std::vector<std::vector<FieldForces>> modes; ///< [mode][time]
  };
} // namespace asperity

#endif
