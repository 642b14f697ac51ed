#include "numerics_audit.h"

#include <asperity/contact/penalty_warnings.h>
#include <asperity/contact_zone/load_protocol.h>
#include <asperity/coupling/coupling_warnings.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    void
    add(const std::string &warning, SceneAudit &audit)
    {
      if (!warning.empty())
        audit.warnings.push_back(warning);
    }

    /** c of a penalty c E/h. */
    template <int dim>
    double
    penalty_factor(const Scene<dim> &scene)
    {
      return scene.penalty() * scene.contact_element_length() /
             scene.law->young_modulus();
    }

    /** The constraint of a volume that is kept takes the freedom to yield from
     *  the elements. Measured on R0 (300 MPa, 200 m/min): at nu = 0.49 the
     *  contact fraction falls by 5 % on 160 spans and by 40 % on 40, and mu
     *  rises by 0.3 % and 3.7 %. */
    template <int dim>
    void
    audit_locking(const SceneParameters &parameters,
                  const Scene<dim>      &scene,
                  SceneAudit            &audit)
    {
      if (scene.law->poisson_ratio() > 0.47)
        audit.warnings.push_back(
          "With a Poisson's ratio of " +
          format_quantity(scene.law->poisson_ratio(), "1") +
          " the chip nearly keeps its volume, and coarse meshes lock: at 0.49 "
          "the contact fraction is 5 % too small with 160 spans in a period "
          "of R0 and 40 % too small with 40, mu 0.3 % and 4 % too large; raise "
          "Mesh/Spans until they settle.");
      if (parameters.mesh.degree == 1)
        audit.warnings.push_back(
          "Elements of degree 1 lock where the chip keeps its volume, as in "
          "plastic flow: the membrane of Cook on 16 cells gives way by 60 % of "
          "what it should, with degree 2 by 98 %; raise Mesh/Degree.");
    }

    /** Penalty c = epsilon h/E from which on the pressures of a Gauss-point
     *  contact oscillate: of Hertz 5 % at 100, 17 % at 1000. */
    constexpr double hard_for_points = 30.;

    template <int dim>
    void
    audit_contact_points(const SceneParameters &parameters,
                         const Scene<dim>      &scene,
                         SceneAudit            &audit)
    {
      const double c = penalty_factor(scene);
      if (parameters.contact.formulation == ContactFormulation::gauss_point &&
          c > hard_for_points)
        audit.warnings.push_back(
          "The pressure of a Gauss-point contact oscillates with a penalty "
          "factor of " +
          format_quantity(c, "1", 3) +
          ", since it has more constraints than the edge has freedom; lower it "
          "to about 10, or take Contact/Formulation = mortar.");
    }

    template <int dim>
    void
    audit_penalty(const SceneParameters &parameters,
                  const Scene<dim>      &scene,
                  SceneAudit            &audit)
    {
      const double position = std::max({scene.length,
                                        dim == 3 ? scene.width : 0.,
                                        parameters.geometry.height});
      add(rounding_warning(scene.penalty(),
                           position,
                           parameters.load.pressure,
                           parameters.solver.tolerance),
          audit);
      if (parameters.contact.augmentations == 0)
        add(soft_penalty_warning(penalty_factor(scene)), audit);
    }

    /** Time steps of the sliding over the time that an elastic wave needs
     *  through an element of the contact. */
    template <int dim>
    double
    waves_in_a_step(const SceneParameters &parameters, const Scene<dim> &scene)
    {
      const LoadProtocol course(parameters.load, parameters.protocol);
      const double       step = (course.end_time() - course.ramp_time()) /
                          parameters.protocol.slide_steps;
      return step *
             std::sqrt(scene.law->young_modulus() / scene.law->density()) /
             scene.contact_element_length();
    }

    /** A bar that flies against a wall gains energy without damping, and a chip
     *  that yields goes on ringing in steps that are long for its waves:
     *  measured on R0 at 1300 MPa, 200 m/min, 675 degC in steps of 6 ns, mu is
     *  16 % above that without mass with a radius of 0.8, 12 % in steps of a
     *  quarter, 4 % in steps of a sixteenth, and 1, 2 and 3 % with a radius of
     *  0. Oil that fills the gap damps. */
    template <int dim>
    void
    audit_damping(const SceneParameters &parameters,
                  const Scene<dim>      &scene,
                  SceneAudit            &audit)
    {
      const double radius = parameters.protocol.spectral_radius;
      if (parameters.protocol.inertia != Inertia::dynamic)
        return;
      if (radius > 0.9)
        audit.warnings.push_back(
          "With a spectral radius of " + format_quantity(radius, "1", 3) +
          " nothing damps the chatter of the contact, which can gain energy "
          "from each impact; lower Protocol/Spectral radius to 0.8.");
      else if (const double waves = waves_in_a_step(parameters, scene);
               radius > 0.2 && waves > 10. && scene.gap_flow == nullptr)
        audit.warnings.push_back(
          "With a spectral radius of " + format_quantity(radius, "1", 3) +
          " and time steps in which a wave passes through " +
          format_quantity(waves, "1", 2) +
          " elements a chip that yields goes on ringing, which has made mu of "
          "R0 at 1300 MPa and 675 degC 16 % too large; expected with such steps "
          "is Protocol/Inertia = quasi-static, or Spectral radius = 0.");
    }

    /** What of the load's growth gets into mu. Measured on R0 (tools/stability
     *  C23): a ramp of half of the time or all of it takes 3 to 11 % or 22 to
     *  99 % off a mean over the second half. */
    void
    audit_ramp(const SceneParameters &parameters, SceneAudit &audit)
    {
      const ProtocolParameters &protocol = parameters.protocol;
      const LoadProtocol        course(parameters.load, protocol);
      if (protocol.window == FrictionWindow::time &&
          course.ramp_time() >=
            (1. - protocol.window_fraction) * course.end_time())
        audit.warnings.push_back(
          "The load still grows where the window of mu begins, so that mu is "
          "too small; lower Protocol/Ramp fraction or Window fraction.");
    }



    /** Way that a spot under the mean pressure slides before its shear is as
     *  large as Coulomb's law allows, against the way of the run. */
    template <int dim>
    void
    audit_stick(const SceneParameters &parameters,
                const Scene<dim>      &scene,
                SceneAudit            &audit)
    {
      const InterfaceParameters &interface = parameters.interface;
      if (interface.law != InterfaceShear::coulomb &&
          interface.law != InterfaceShear::limited_coulomb)
        return;
      const double stick = interface.friction_coefficient *
                           parameters.load.pressure /
                           (interface.stick_penalty * scene.penalty());
      const double way =
        parameters.load.velocity *
        LoadProtocol(parameters.load, parameters.protocol).end_time();
      if (stick > 0.1 * way)
        audit.warnings.push_back(
          "Spots stick over " + format_quantity(stick, "nm", 3) +
          ", more than a tenth of the way of the run, before they slip, so "
          "that mu is too small; raise Interface/Stick penalty.");
    }
  } // namespace



  template <int dim>
  void
  audit_numerics(const SceneParameters &parameters,
                 const Scene<dim>      &scene,
                 SceneAudit            &audit)
  {
    audit_locking(parameters, scene, audit);
    audit_contact_points(parameters, scene, audit);
    audit_penalty(parameters, scene, audit);
    if (fills_gap(parameters.lubrication.model))
      add(loose_tolerance_warning(parameters.lubrication.coupling), audit);
    audit_damping(parameters, scene, audit);
    audit_ramp(parameters, audit);
    audit_stick(parameters, scene, audit);
  }



  template void
  audit_numerics(const SceneParameters &, const Scene<2> &, SceneAudit &);
  template void
  audit_numerics(const SceneParameters &, const Scene<3> &, SceneAudit &);
} // namespace asperity
