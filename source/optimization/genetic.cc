#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/optimization/genetic.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "search_counter.h"

namespace asperity
{
  namespace
  {
    struct Individual
    {
      std::vector<double> genes;     ///< in the unit box
      double              cost = 0.; ///< infinite if it has no value
    };

    bool
    is_better(const Individual &a, const Individual &b)
    {
      return a.cost < b.cost;
    }

    class Evolution
    {
    public:
      Evolution(SearchCounter        &counter,
                const SearchBox      &box,
                const GeneticOptions &options)
        : counter(counter)
        , box(box)
        , options(options)
        , random(options.seed)
        , size(options.population_per_variable * box.size())
      {}

      void
      run();

    private:
      void
      evaluate(Individual &individual);

      void
      add_children(std::vector<Individual> &population);

      const Individual &
      parent();

      void
      cross(double &a, double &b);

      void
      mutate(double &gene);

      bool
      stands_still();

      SearchCounter          &counter;
      const SearchBox        &box;
      const GeneticOptions   &options;
      RandomNumbers           random;
      std::size_t             size;
      std::vector<Individual> population;
    };



    void
    Evolution::evaluate(Individual &individual)
    {
      std::vector<double> point(box.size());
      for (std::size_t i = 0; i < box.size(); ++i)
        point[i] =
          box.lower[i] + individual.genes[i] * (box.upper[i] - box.lower[i]);
      const Evaluation &evaluation = counter.evaluate(point);
      individual.cost              = evaluation.has_failed() ?
                                       std::numeric_limits<double>::infinity() :
                                       evaluation.value;
    }



    const Individual &
    Evolution::parent()
    {
      const Individual &a = population[random.below(size)];
      const Individual &b = population[random.below(size)];
      return is_better(b, a) ? b : a;
    }



    /** Two children whose mean is that of their parents. The spread beta has
     *  the density of Deb and Agrawal (1995), 0.5 (e + 1) beta^e below 1 and
     *  0.5 (e + 1) / beta^(e + 2) above. */
    void
    Evolution::cross(double &a, double &b)
    {
      const double u        = random.uniform();
      const double exponent = 1. / (options.crossover_exponent + 1.);
      const double beta     = u < 0.5 ? std::pow(2. * u, exponent) :
                                        std::pow(0.5 / (1. - u), exponent);
      const double mean = 0.5 * (a + b), half = 0.5 * beta * (b - a);
      a = std::clamp(mean - half, 0., 1.);
      b = std::clamp(mean + half, 0., 1.);
    }



    /** Moves a gene by delta of the density 0.5 (e + 1) (1 - |delta|)^e, e the
     *  exponent (Deb and Goyal 1996). */
    void
    Evolution::mutate(double &gene)
    {
      const double u        = random.uniform();
      const double exponent = 1. / (options.mutation_exponent + 1.);
      const double delta    = u < 0.5 ? std::pow(2. * u, exponent) - 1. :
                                        1. - std::pow(2. * (1. - u), exponent);
      gene                  = std::clamp(gene + delta, 0., 1.);
    }



    void
    Evolution::add_children(std::vector<Individual> &children)
    {
      Individual a = parent(), b = parent();
      const bool crosses = random.uniform() < options.crossover_rate;
      for (std::size_t i = 0; i < box.size(); ++i)
        if (const double u = random.uniform(); crosses && u < 0.5)
          cross(a.genes[i], b.genes[i]);
      const double rate = options.mutation_rate > 0. ?
                            options.mutation_rate :
                            1. / static_cast<double>(box.size());
      for (Individual *child : {&a, &b})
        for (double &gene : child->genes)
          if (random.uniform() < rate)
            mutate(gene);
      children.push_back(std::move(a));
      children.push_back(std::move(b));
    }



    bool
    Evolution::stands_still()
    {
      const auto       &history = counter.result.history;
      const std::size_t n       = options.patience;
      if (n == 0 || history.size() <= n)
        return false;
      const double old = history[history.size() - 1 - n];
      // no number where there was no value yet
      return old - history.back() <= options.least_change * std::abs(old);
    }



    void
    Evolution::run()
    {
      population.resize(size);
      for (Individual &individual : population)
        {
          for (std::size_t i = 0; i < box.size(); ++i)
            individual.genes.push_back(random.uniform());
          evaluate(individual);
          if (counter.has_ended())
            return;
        }
      std::stable_sort(population.begin(), population.end(), is_better);
      while (!stands_still())
        {
          std::vector<Individual> children;
          const std::size_t       n_children = options.children;
          while (children.size() < n_children)
            add_children(children);
          for (Individual &child : children)
            {
              evaluate(child);
              if (counter.has_ended())
                return;
            }
          population.insert(population.end(), children.begin(), children.end());
          std::stable_sort(population.begin(), population.end(), is_better);
          population.resize(size);
        }
      counter.result.end = "the best has stood still";
    }
  } // namespace



  void
  GeneticOptions::check() const
  {
    const auto require = [](const bool holds, const char *sentence) {
      if (!holds)
        throw InputError(sentence);
    };
    require(population_per_variable >= 2,
            "A genetic search needs at least two individuals for each "
            "variable.");
    require(children > 0, "A genetic search needs children.");
    require(crossover_rate >= 0. && crossover_rate <= 1. &&
              mutation_rate >= 0. && mutation_rate <= 1.,
            "The rates of crossover and mutation lie in 0 ... 1.");
    require(crossover_exponent >= 0. && mutation_exponent >= 0.,
            "The exponents of crossover and mutation cannot be negative.");
  }



  SearchResult
  search_genetically(const Objective      &objective,
                     EvaluationRecord     &record,
                     const GeneticOptions &options)
  {
    options.check();
    SearchCounter counter(objective,
                          record,
                          options.max_evaluations,
                          options.target);
    Evolution(counter, record.box(), options).run();
    return counter.result;
  }
} // namespace asperity
