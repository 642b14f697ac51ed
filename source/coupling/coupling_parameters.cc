#include <asperity/coupling/coupling_parameters.h>

namespace asperity
{
  namespace
  {
    void
    declare_acceleration(AccelerationParameters &p, ParameterDeclarator &d)
    {
      d.choice("Acceleration",
               p.kind,
               {{"relaxation", AccelerationKind::relaxation},
                {"Aitken", AccelerationKind::aitken},
                {"IQN-ILS", AccelerationKind::iqn_ils}},
               "How the iteration is made faster: `relaxation`, a constant "
               "factor; `Aitken`, a factor from the last two residuals; "
               "`IQN-ILS`, quasi-Newton with a least-squares model.");
      d.number("Relaxation",
               p.relaxation,
               Range{0., 2., false, true},
               "The constant factor; with the other accelerations that of the "
               "first iteration.");
      d.integer("Reused steps",
                p.reused_steps,
                Range::between(0, 100),
                "IQN-ILS: earlier steps whose columns are used.");
      d.number("Filter",
               p.filter,
               Range{0., 1., true, false},
               "IQN-ILS: share of its norm that a column must have orthogonal "
               "to newer ones.");
    }
  } // namespace



  void
  CouplingParameters::declare(ParameterDeclarator &d)
  {
    const auto section = d.subsection("Coupling");
    d.choice(
      "Scheme",
      scheme,
      {{"Robin-Neumann", CouplingScheme::robin_neumann},
       {"Dirichlet-Neumann", CouplingScheme::dirichlet_neumann}},
      "`Robin-Neumann`: the fluid may cross its wall until the iteration "
      "has converged; `Dirichlet-Neumann`: the fluid has the velocity "
      "of its wall, impossible where incompressible fluid is sealed.");
    d.quantity("Robin coefficient",
               robin_coefficient,
               "Pa s/m",
               Range::between(1., 1e15),
               "Coefficient alpha of the Robin condition; `automatic` takes "
               "the impedance of the solid.");
    declare_acceleration(acceleration, d);
    d.number("Tolerance",
             tolerance,
             Range{0., 0.01, false, true},
             "Relative change of displacement and force and relative jump of "
             "the velocity that end the iteration.");
    d.integer("Maximum iterations",
              maximum_iterations,
              Range::between(1, 10000),
              "Coupling iterations after which a step is given up.");
    d.integer("Predictor degree",
              predictor_degree,
              Range::between(0, 3),
              "Degree of the polynomial in time that extrapolates the force.");
    d.quantity("Displacement floor",
               displacement_floor,
               "um",
               Range::between(0., 1e-9),
               "Smallest displacement of a step that changes are compared "
               "with.");
    d.quantity("Force floor",
               force_floor,
               "N/m",
               Range::between(0., 1.),
               "Smallest nodal force that differences are compared with.");
    d.quantity("Velocity floor",
               velocity_floor,
               "m/s",
               Range::between(0., 0.01),
               "Smallest velocity that jumps are compared with.");
  }
} // namespace asperity
