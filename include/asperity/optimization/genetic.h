#ifndef asperity_optimization_genetic_h
#define asperity_optimization_genetic_h

#include <asperity/optimization/evaluation_record.h>

#include <cstdint>

namespace asperity
{
  struct GeneticOptions
  {
    unsigned int max_evaluations = 1000;

    /** Size of the population for each variable. */
    unsigned int population_per_variable = 10;

    /** Children between selections. Few of them use the best at once, which
     *  pays if evaluations are dear; at most the size of the population. */
    unsigned int children = 2;

    double crossover_rate = 1.; ///< of pairs
    double mutation_rate  = 0.; ///< of variables; 0: one of each child's

    /** Exponents of the densities of simulated binary crossover and of
     *  polynomial mutation: the larger, the nearer children are to parents. */
    double crossover_exponent = 2.;
    double mutation_exponent  = 50.;

    /** Ends when the best has become better by less than this share of itself
     *  over so many evaluations; 0 evaluations: never. */
    double       least_change = 1e-3;
    unsigned int patience     = 0;

    double target = -std::numeric_limits<double>::infinity();

    std::uint64_t seed = 1;

    /** @throws InputError that says what cannot be */
    void
    check() const;
  };

  /**
   * Minimises over a box by a genetic algorithm with real variables. Parents
   * win tournaments of two; pairs have two children by simulated binary
   * crossover (Deb and Agrawal 1995), which mutate by a polynomial density (Deb
   * and Goyal 1996); the best of parents and children live on (elitism). A
   * point whose evaluation fails is worse than all others. Follows its seed.
   *
   * Lee (2025) uses the single-objective algorithm of JEGA through Dakota, with
   * this size of the population and this budget.
   *
   * @throws InputError if the options cannot be, and what the objective throws
   *   but ComputationError
   */
  SearchResult
  search_genetically(const Objective      &objective,
                     EvaluationRecord     &record,
                     const GeneticOptions &options = GeneticOptions());
} // namespace asperity

#endif
