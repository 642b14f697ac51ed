#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  namespace
  {
    /** The load ramp and the time steps. */
    void
    declare_steps(ProtocolParameters &protocol, ParameterDeclarator &parameters)
    {
      parameters.number("Ramp fraction",
                        protocol.ramp_fraction,
                        Range::between(0.001, 1.),
                        "t_r/t_end: the pressure follows p/2 (1 - cos(pi "
                        "t/t_r)) until t_r.");
      parameters.integer("Ramp steps",
                         protocol.chosen_ramp_steps,
                         Range::between(1, 100000),
                         "Time steps in the load ramp; `automatic`: 24, or 36 "
                         "where spots bear a part of the strength of the chip, "
                         "which hardens while they grow.");
      parameters.integer("Slide steps",
                         protocol.slide_steps,
                         Range::between(1, 1000000),
                         "Time steps from the end of the ramp to t_end.");
      parameters.number("Maximum strain increment",
                        protocol.strain_increment,
                        Range::between(0., 10.),
                        "Largest growth of the plastic strain in a time step "
                        "anywhere in the chip: a step with a larger one is "
                        "halved, and the next ones grow by a factor of two at "
                        "most until they are as long as the entries above say; "
                        "0: any growth.");
    }
  } // namespace



  void
  ProtocolParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Protocol");
    parameters.quantity("End time",
                        end_time,
                        "us",
                        Range::between(1e-12, 10.),
                        "t_end. With the window `steady` it only sets the "
                        "length of the load ramp.");
    parameters.quantity("Sliding distance",
                        sliding_distance,
                        "um",
                        Range::between(1e-12, 1.),
                        "Distance that the chip slides until t_end, which is "
                        "then this distance over the velocity, so that fast "
                        "and slow runs are compared after the same way; "
                        "`automatic` takes the end time as it is.");
    parameters.quantity("Reversal distance",
                        reversal_distance,
                        "um",
                        Range::between(0., 1.),
                        "Sliding distance after which the chip slides back "
                        "with the same velocity, until t_end; mu is that of "
                        "the way back then. 0: it goes on. For the window "
                        "`time` and a chip without inertia.");
    declare_steps(*this, parameters);
    parameters.choice("Inertia",
                      inertia,
                      {{"automatic", Inertia::automatic},
                       {"quasi-static", Inertia::quasi_static},
                       {"dynamic", Inertia::dynamic}},
                      "Whether the chip's mass counts: `automatic` follows the "
                      "scene audit; `quasi-static`; `dynamic`, "
                      "generalized-alpha, the chip starting with velocity v.");
    parameters.number("Spectral radius",
                      spectral_radius,
                      Range::between(0., 1.),
                      "Dynamic runs: spectral radius of generalized-alpha at "
                      "infinite frequency; 1 damps nothing.");
    declare_window(parameters);
  }



  void
  ProtocolParameters::declare_window(ParameterDeclarator &parameters)
  {
    parameters.choice("Friction window",
                      window,
                      {{"time", FrictionWindow::time},
                       {"steady", FrictionWindow::steady}},
                      "Over what mu is averaged: `time`, the last part of "
                      "t_end; `steady`, windows of sliding distance, until two "
                      "in succession agree.");
    parameters.number("Window fraction",
                      window_fraction,
                      Range::between(0.001, 1.),
                      "Window `time`: the averaged last part of t_end.");
    parameters.quantity("Steady distance",
                        steady_distance,
                        "um",
                        Range::between(1e-10, 1.),
                        "Window `steady`: sliding distance of a window.");
    parameters.quantity("Steady step",
                        steady_step,
                        "nm",
                        Range::between(1e-12, 1e-3),
                        "Window `steady`: sliding distance of a time step.");
    parameters.number("Steady tolerance",
                      steady_tolerance,
                      Range{0., 0.5, false, true},
                      "Window `steady`: relative change of mu between "
                      "successive windows that ends the run.");
    parameters.quantity("Maximum distance",
                        maximum_distance,
                        "um",
                        Range::between(1e-10, 1.),
                        "Window `steady`: sliding distance at which the run "
                        "ends with a warning if mu is not steady.");
  }
} // namespace asperity
