#ifndef asperity_flow_fluid_options_h
#define asperity_flow_fluid_options_h

#include <asperity/flow/flow_solver.h>
#include <asperity/flow/fluid_outlets.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  enum class FluidTimeScheme
  {
    steady,
    implicit_euler, ///< first order, as in Lee (2025)
    bdf2            ///< second order; its first step is implicit Euler
  };

  struct FluidOptions
  {
    FluidModel      model;
    FluidElement    element         = FluidElement::taylor_hood;
    unsigned int    degree          = 2; ///< of the velocity
    unsigned int    geometry_degree = 2; ///< of cells and mesh displacement
    FluidTimeScheme scheme          = FluidTimeScheme::bdf2;

    /** Residual over the sum of the absolute contributions of the cells, for
     *  momentum and continuity alike. */
    double       tolerance                 = 1e-9;
    unsigned int maximum_newton_iterations = 20;

    FlowSolverKind   linear_solver = FlowSolverKind::direct;
    LinearSolverKind solver        = LinearSolverKind::umfpack; ///< if direct
    KrylovOptions    krylov;                                    ///< if krylov

    /** Tangents are kept from one solution to the next while each step with
     *  them reduces the residual to this share or less,
     *  NewtonOptions::kept_tangent_contraction; 0: never. The flow then depends
     *  on earlier ones within the tolerance. */
    double kept_tangent_contraction = 0.;

    /** Net flux over the integral of |v| on the boundary of an enclosed part:
     *  below it the flux is taken for an error of interpolation and spread over
     *  the part, above it there is no solution. */
    double flux_tolerance = 1e-8;

    /** Of enclosed parts [Pa]. */
    double mean_pressure = 0.;
  };

  class InputArchive;
  class OutputArchive;

  /** All that a restart needs. */
  struct FluidState
  {
    double                 time    = 0.; ///< [s]
    double                 dt      = 0.; ///< of the last step [s]
    unsigned int           n_steps = 0;  ///< accepted
    dealii::Vector<double> u, u_old;     ///< at t_n and t_{n-1}
    dealii::Vector<double> displacement, displacement_old; ///< of the mesh
    dealii::Vector<double> divergence; ///< at t_n, see NavierStokes
    std::vector<bool>      active;     ///< cells, by active_cell_index()

    std::vector<PassedVolume> passed; ///< of the outlets

    void
    save(OutputArchive &archive) const;

    /** Takes what save() wrote.
     *  @throws InputError if vectors are not as long as those of this state */
    void
    load(InputArchive &archive);
  };
} // namespace asperity

#endif
