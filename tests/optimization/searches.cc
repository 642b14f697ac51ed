#include <asperity/base/errors.h>
#include <asperity/optimization/direct.h>
#include <asperity/optimization/genetic.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "../files.h"

using namespace asperity;

namespace
{
  const double pi = 3.14159265358979323846;

  /** A function with a known least value. */
  struct TestFunction
  {
    SearchBox box;
    Objective objective;
    double    least;

    /** The value that is 1e-4 of the least above it, as in the counts of Jones
     *  et al. (1993). */
    double
    target() const
    {
      return least + 1e-4 * std::abs(least);
    }
  };

  /** Branin's function, minima at (-pi, 12.275), (pi, 2.275), (9.42478, 2.475);
   *  Dixon and Szego 1978. */
  TestFunction
  branin()
  {
    TestFunction result;
    result.box       = {{"x", "y"}, {-5., 0.}, {10., 15.}};
    result.objective = [](const std::vector<double> &x) {
      const double a =
        x[1] - 5.1 / (4. * pi * pi) * x[0] * x[0] + 5. / pi * x[0] - 6.;
      return Evaluation{a * a + 10. * (1. - 1. / (8. * pi)) * std::cos(x[0]) +
                          10.,
                        ""};
    };
    result.least = 0.397887;
    return result;
  }

  /** Hartmann's function of six variables; Dixon and Szego 1978. */
  TestFunction
  hartmann_6()
  {
    TestFunction result;
    for (unsigned int i = 0; i < 6; ++i)
      {
        result.box.names.push_back("x_" + std::to_string(i));
        result.box.lower.push_back(0.);
        result.box.upper.push_back(1.);
      }
    result.objective = [](const std::vector<double> &x) {
      const double alpha[4] = {1., 1.2, 3., 3.2};
      const double a[4][6]  = {{10., 3., 17., 3.5, 1.7, 8.},
                               {0.05, 10., 17., 0.1, 8., 14.},
                               {3., 3.5, 1.7, 10., 17., 8.},
                               {17., 8., 0.05, 10., 0.1, 14.}};
      const double p[4][6]  = {{0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886},
                               {0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991},
                               {0.2348, 0.1451, 0.3522, 0.2883, 0.3047, 0.6650},
                               {0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381}};
      double       sum      = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        {
          double exponent = 0.;
          for (unsigned int j = 0; j < 6; ++j)
            exponent += a[i][j] * std::pow(x[j] - p[i][j], 2);
          sum -= alpha[i] * std::exp(-exponent);
        }
      return Evaluation{sum, ""};
    };
    result.least = -3.32237;
    return result;
  }

  using Search = SearchResult (*)(const TestFunction &, EvaluationRecord &);

  SearchResult
  direct(const TestFunction &function, EvaluationRecord &record)
  {
    DirectOptions options;
    options.target = function.target();
    return search_by_direct(function.objective, record, options);
  }

  SearchResult
  genetic_of_seed(const TestFunction &function, const unsigned int seed)
  {
    GeneticOptions options;
    options.seed = seed;
    EvaluationRecord record(function.box);
    return search_genetically(function.objective, record, options);
  }

  SearchResult
  genetic(const TestFunction &function, EvaluationRecord &record)
  {
    GeneticOptions options;
    options.seed   = 1;
    options.target = function.target();
    return search_genetically(function.objective, record, options);
  }

  SearchResult
  search(const Search method, const TestFunction &function)
  {
    EvaluationRecord record(function.box);
    return method(function, record);
  }
} // namespace



TEST(Direct, finds_least_values_within_the_published_evaluations)
{
  // Jones et al. (1993), table 1, count whole divisions of a rectangle, at most
  // two points a variable; the search ends at the first point
  const auto plane = search(direct, branin());
  EXPECT_EQ(plane.end, "the target is reached");
  EXPECT_LE(plane.n_evaluations, 195u);
  EXPECT_GT(plane.n_evaluations, 195u - 2 * 2);

  const auto six = search(direct, hartmann_6());
  EXPECT_EQ(six.end, "the target is reached");
  EXPECT_LE(six.n_evaluations, 571u);
  EXPECT_GT(six.n_evaluations, 571u - 2 * 6);
  EXPECT_EQ(six.n_to_best, six.n_evaluations);
}



TEST(Direct, needs_fewer_evaluations_if_it_is_locally_biased)
{
  DirectOptions options;
  options.locally_biased = true;
  for (const TestFunction &function : {branin(), hartmann_6()})
    {
      options.target = function.target();
      EvaluationRecord record(function.box);
      const auto biased = search_by_direct(function.objective, record, options);
      EXPECT_EQ(biased.end, "the target is reached");
      EXPECT_LT(biased.n_evaluations, search(direct, function).n_evaluations);
    }
}



TEST(Genetic, finds_least_values_within_its_budget)
{
  EXPECT_LT(search(genetic, branin()).value, branin().target());
  // six variables have a second minimum at -3.2032, where many seeds end
  const double least = hartmann_6().least;
  EXPECT_NEAR(genetic_of_seed(hartmann_6(), 2).value, least, 1e-2 * -least);
  for (unsigned int seed = 1; seed <= 10; ++seed)
    {
      EXPECT_NEAR(genetic_of_seed(branin(), seed).value, 0.397887, 4e-3);
      const auto result = genetic_of_seed(hartmann_6(), seed);
      EXPECT_LT(result.value, 0.9 * least) << seed;
      EXPECT_LE(result.n_evaluations, 1000u);
    }
}



TEST(Genetic, ends_when_its_best_stands_still)
{
  const TestFunction function = branin();
  GeneticOptions     options;
  options.patience = 200;
  EvaluationRecord record(function.box);
  const auto result = search_genetically(function.objective, record, options);
  EXPECT_EQ(result.end, "the best has stood still");
  const auto &history = result.history;
  ASSERT_GT(history.size(), 200u);
  ASSERT_LT(history.size(), 1000u);
  EXPECT_LE(history[history.size() - 201] - history.back(),
            1e-3 * history[history.size() - 201]);
}



class EachSearch : public testing::TestWithParam<Search>
{};



TEST_P(EachSearch, is_resumed_without_repeating_an_evaluation)
{
  const std::string path     = test_folder() + "/record.csv";
  TestFunction      function = branin();
  const auto        whole    = search(GetParam(), function);

  // the program is killed by its 60th evaluation
  unsigned int    n = 0;
  const Objective counted =
    [&, objective = function.objective](const std::vector<double> &x) {
      if (++n == 60)
        throw std::runtime_error("killed");
      return objective(x);
    };
  function.objective = counted;
  const auto run     = [&]() {
    EvaluationRecord record(function.box, path, "Branin");
    return GetParam()(function, record);
  };
  EXPECT_EQ(message_of<std::runtime_error>(run), "killed");
  const auto resumed = run();
  EXPECT_EQ(n, whole.n_evaluations + 1);
  EXPECT_EQ(resumed.best, whole.best);
  EXPECT_EQ(resumed.value, whole.value);
  EXPECT_EQ(resumed.n_evaluations, whole.n_evaluations);
  EXPECT_EQ(resumed.history.back(), whole.history.back());

  // and a third time there is nothing to do
  EXPECT_EQ(run().value, whole.value);
  EXPECT_EQ(n, whole.n_evaluations + 1);
}



TEST_P(EachSearch, goes_on_after_evaluations_that_fail)
{
  // no value where two of the three minima are
  TestFunction    function = branin();
  const Objective whole    = function.objective;
  function.objective = [whole](const std::vector<double> &x) -> Evaluation {
    if (x[0] < 0.)
      return {NAN, "The shape, \"torn\", has no mesh."};
    if (x[0] > 6.)
      throw ComputationError("The run failed.");
    if (x[1] > 14.)
      return {NAN, ""};
    return whole(x);
  };
  const std::string path = test_folder() + "/record.csv";
  EvaluationRecord  record(function.box, path);
  const auto        result = GetParam()(function, record);
  EXPECT_NEAR(result.value, function.least, 1e-2);
  EXPECT_NEAR(result.best[0], pi, 0.1);
  EXPECT_GT(result.n_failed, 10u);
  EXPECT_LT(result.n_failed, result.n_evaluations);

  // failures are kept with their reasons
  const EvaluationRecord read(function.box, path);
  std::set<std::string>  reasons;
  ASSERT_EQ(read.entries().size(), result.n_evaluations);
  for (std::size_t i = 0; i < read.entries().size(); ++i)
    {
      const Evaluation &a = read.entries()[i].evaluation;
      const Evaluation &b = record.entries()[i].evaluation;
      EXPECT_EQ(read.entries()[i].point, record.entries()[i].point);
      EXPECT_EQ(a.failure, b.failure);
      EXPECT_TRUE(a.has_failed() || a.value == b.value);
      reasons.insert(a.failure);
    }
  EXPECT_EQ(reasons.count("The shape, \"torn\", has no mesh."), 1u);
  EXPECT_EQ(reasons.count("The run failed."), 1u);
}



TEST_P(EachSearch, ends_if_nothing_has_a_value)
{
  TestFunction function = branin();
  function.objective    = [](const std::vector<double> &) {
    return Evaluation{NAN, "Nothing works."};
  };
  EvaluationRecord record(function.box);
  const auto       result = GetParam()(function, record);
  EXPECT_TRUE(result.best.empty());
  EXPECT_EQ(result.n_failed, result.n_evaluations);
}



INSTANTIATE_TEST_SUITE_P(Methods,
                         EachSearch,
                         testing::Values(direct, genetic),
                         [](const auto &method) {
                           return method.index == 0 ? "direct" : "genetic";
                         });



TEST(EvaluationRecord, refuses_the_file_of_another_search)
{
  const std::string  path     = test_folder() + "/record.csv";
  const TestFunction function = branin();
  {
    EvaluationRecord record(function.box, path, "Branin");
    record.evaluate(function.objective, {1., 2.});
  }
  const auto refuse = [&](const std::string &description,
                          const SearchBox   &box) {
    return message_of<InputError>(
      [&]() { EvaluationRecord record(box, path, description); });
  };
  const std::string where = "The record of evaluations '" + path + "', line ";
  EXPECT_EQ(refuse("mu", function.box),
            where + "1: these are evaluations of another objective than 'mu'; "
                    "name another file or remove it.");
  SearchBox other = function.box;
  other.names[1]  = "z";
  EXPECT_EQ(refuse("Branin", other),
            where + "2: the columns 'x, z, value, failure' are expected.");
  overwrite(path, content(path) + "1,2,three,\n");
  EXPECT_EQ(refuse("Branin", function.box),
            where + "4: '1,2,three,' is no evaluation.");
}



TEST(SearchBox, refuses_what_is_no_range)
{
  EXPECT_EQ(message_of<InputError>([]() {
              EvaluationRecord record({{"x", "y"}, {0., 1.}, {1., 1.}});
            }),
            "The variable 'y' of a search ranges from 1 to 1, which is no "
            "range.");
  EXPECT_EQ(message_of<InputError>([]() {
              EvaluationRecord record(branin().box);
              DirectOptions    options;
              options.max_evaluations = 0;
              search_by_direct(branin().objective, record, options);
            }),
            "A search needs at least one evaluation.");
  EXPECT_EQ(message_of<InputError>([]() {
              EvaluationRecord record(branin().box);
              GeneticOptions   options;
              options.children = 0;
              search_genetically(branin().objective, record, options);
            }),
            "A genetic search needs children.");
}
