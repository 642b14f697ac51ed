#ifndef asperity_experiment_experiment_parameters_h
#define asperity_experiment_experiment_parameters_h

#include <asperity/experiment/orthogonal_cut.h>
#include <asperity/experiment/pin_contact.h>

#include <optional>
#include <string>

namespace asperity
{
  class ParameterDeclarator;

  enum class ExperimentKind
  {
    cut,
    pin
  };

  /** A parameter file of an experiment, from which `asperity conditions`
   *  computes pressure, velocity and temperature of a scene. */
  struct ExperimentParameters
  {
    ExperimentKind kind = ExperimentKind::cut;
    OrthogonalCut  cut;
    PinContact     pin;

    /** Declares all entries, at the top and in the subsections "Cut", "Pin",
     *  "Chip" and "Tool". */
    void
    declare(ParameterDeclarator &parameters);

    /** Completes `cut` and `pin` from the entries.
     *  @throws InputError if an entry that the experiment needs is missing, is
     *  no force, or contradicts another one */
    void
    check(const ParameterDeclarator &parameters);

  private:
    void
    declare_cut(ParameterDeclarator &parameters);

    void
    declare_pin(ParameterDeclarator &parameters);

    void
    declare_chip(ParameterDeclarator &parameters);

    void
    check_cut(const ParameterDeclarator &parameters);

    void
    check_pin(const ParameterDeclarator &parameters);

    /** Forces as texts, since no other entry has their dimension. */
    std::string cutting_force, passive_force;
    std::string edge_cutting_force = "0 N", edge_passive_force = "0 N";
    std::string normal_force;

    std::optional<double> width, uncut_chip_thickness, cutting_speed;
    std::optional<double> chip_thickness, shear_angle, shear_limit;
    std::optional<double> radius, pin_velocity, friction_coefficient;
  };
} // namespace asperity

#endif
