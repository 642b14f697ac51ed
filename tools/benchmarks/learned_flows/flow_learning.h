#ifndef asperity_benchmarks_learned_flows_flow_learning_h
#define asperity_benchmarks_learned_flows_flow_learning_h

#include <asperity/learning/orthogonal_decomposition.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "flow_snapshots.h"

namespace learned_flows
{
  using Numbers = std::vector<double>;

  /** a - b */
  Numbers
  difference(const Numbers &a, const Numbers &b);

  /** Turns a latent code into a solution and back. */
  struct FlowDecoder
  {
    std::string                             name;
    unsigned int                            n_codes = 0;
    std::function<Numbers(const Numbers &)> decode, encode;
  };

  /** A flow with its snapshots, every second of which is held out. */
  class FlowStudy
  {
  public:
    FlowStudy(LearnedFlow &flow, const FlowSnapshots &all);

    /** Over the first, the squares of the singular values as shares. */
    void
    print_singular_values() const;

    /** The first modes (Sirovich 1987). */
    FlowDecoder
    pod(const unsigned int n) const;

    /** The first n modes, and what a network says of the others. */
    FlowDecoder
    manifold(const unsigned int n) const;

    /** A network f(z, x) of the deviation from the mean. */
    FlowDecoder
    network(const unsigned int n, const unsigned int n_epochs) const;

    /** Of the table of print_judgement(). */
    void
    print_head() const;

    /** A row: errors of held-out solutions, mean (largest). */
    void
    print_judgement(const FlowDecoder &decoder) const;

    /** x, y, u, v at the nodes of a held-out solution, as the run and each
     *  decoder have it. */
    void
    write_fields(const std::string              &path,
                 const std::vector<FlowDecoder> &decoders) const;

  private:
    bool
    is_held_out(const std::size_t i) const
    {
      return i % 2 == 1;
    }

    /** Codes of the inputs of held-out solutions, by Gaussian processes of
     *  those of the others. */
    std::vector<std::vector<double>>
    codes_of_inputs(const FlowDecoder &decoder) const;

    /** Root of the integral of the squared velocity. */
    double
    norm(const std::vector<double> &difference) const;

    LearnedFlow                                   &flow;
    FlowSnapshots                                  all;
    std::vector<double>                            weights;
    std::unique_ptr<const OrthogonalDecomposition> modes;
  };
} // namespace learned_flows

#endif
