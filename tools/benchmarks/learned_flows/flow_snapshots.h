#ifndef asperity_benchmarks_learned_flows_flow_snapshots_h
#define asperity_benchmarks_learned_flows_flow_snapshots_h

#include <asperity/flow/navier_stokes.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "flow/channel_examples.h"

namespace learned_flows
{
  using namespace flow_examples;

  Vector
  to_vector(const std::vector<double> &values);

  /** Solutions of a flow over one input. */
  struct FlowSnapshots
  {
    std::vector<double>              inputs;    ///< phase in [0, 1), or Re
    std::vector<std::vector<double>> solutions; ///< velocity and pressure

    void
    write(const std::string &path) const;

    static FlowSnapshots
    read(const std::string &path);
  };

  /** The numbers by which a decoded flow is judged. */
  struct FlowNumbers
  {
    std::vector<double> measured;        ///< see LearnedFlow::measures()
    double              divergence = 0.; ///< |div v| over |grad v|, L2 norms
  };

  /** A flow that is learnt: how it is computed, measured and interpolated. */
  class LearnedFlow
  {
  public:
    virtual ~LearnedFlow() = default;

    virtual std::string
    name() const = 0;

    /** Runs. */
    virtual FlowSnapshots
    compute() = 0;

    /** What is measured of a solution. */
    virtual std::vector<std::string>
    measures() const = 0;

    virtual FlowNumbers
    numbers(const std::vector<double> &solution) = 0;

    /** What a smooth law of the code sees of an input, in [-1, 1] each. */
    virtual std::vector<double>
    coordinates(const double input) const = 0;

    virtual const NavierStokes &
    flow() const = 0;

    /** Squares of velocities sum up to their integral with these weights, by
     *  Gauss-Lobatto quadrature at the nodes; those of the pressure are too
     *  small to matter. */
    std::vector<double>
    weights() const;

    /** Nodes of the velocity, and their two unknowns. */
    struct VelocityNodes
    {
      std::vector<double>       positions; ///< x, y of node after node [m]
      std::vector<unsigned int> u, v;
    };

    VelocityNodes
    velocity_nodes() const;

    /** Nodes of the pressure, and their unknowns. */
    struct PressureNodes
    {
      std::vector<double>       positions;
      std::vector<unsigned int> p;
    };

    PressureNodes
    pressure_nodes() const;

    /** The pressure at the nodes of the velocity. */
    std::vector<double>
    pressure_at_velocity_nodes(const std::vector<double> &solution) const;

    /** Half waves along x and y that a network sees places by. */
    virtual std::array<unsigned int, 2>
    waves() const = 0;

  private:
    /** Calls f(dof, component, place, pressure) for each unknown of each cell.
     *  @param solution of the pressure; not evaluated if null */
    template <typename Function>
    void
    for_each_node(const std::vector<double> *solution, const Function &f) const;
  };

  /** DFG 2D-2 over a period: the input is the phase. */
  std::unique_ptr<LearnedFlow>
  make_street();

  /** The lid cavity over the Reynolds number. */
  std::unique_ptr<LearnedFlow>
  make_cavity();
} // namespace learned_flows

#endif
