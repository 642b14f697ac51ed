#ifndef asperity_tests_isogeometric_example_spaces_h
#define asperity_tests_isogeometric_example_spaces_h

#include <asperity/isogeometric/spline_space.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace example
{
  using asperity::KnotVector;
  using asperity::SplineSpace;

  /** n spans of unequal length on [0, length]. */
  inline std::vector<double>
  breakpoints(const unsigned int n, const double length)
  {
    std::vector<double> t(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double s = double(i) / n;
        t[i]           = length * (s + 0.3 * s * (1. - s));
      }
    t[n] = length;
    return t;
  }

  /** [0, 2] x [0, 1] with 7 x 5 unequal spans. */
  inline std::unique_ptr<SplineSpace<2>>
  uniform(const unsigned int degree, const bool periodic)
  {
    return std::make_unique<SplineSpace<2>>(
      KnotVector(degree, breakpoints(7, 2.), periodic),
      KnotVector(degree, breakpoints(5, 1.)));
  }

  /** Three levels, refined towards the start of the period and the top. */
  inline std::unique_ptr<SplineSpace<2>>
  graded(const unsigned int degree, const bool periodic)
  {
    auto space = uniform(degree, periodic);
    space->refine_to_level(2,
                           [](const dealii::Point<2> &low,
                              const dealii::Point<2> &high) {
                             return low[0] < 0.3 && high[1] > 0.9;
                           });
    return space;
  }

  /** Four levels around a point inside. */
  inline std::unique_ptr<SplineSpace<2>>
  spot(const unsigned int degree, const bool periodic)
  {
    auto space = uniform(degree, periodic);
    space->refine_to_level(3,
                           [](const dealii::Point<2> &low,
                              const dealii::Point<2> &high) {
                             return low[0] <= 1.1 && high[0] >= 1.1 &&
                                    low[1] <= 0.4 && high[1] >= 0.4;
                           });
    return space;
  }

  /** Degrees to be tested. Debug builds with sanitizers are some fifty times
   *  slower; they look for errors of another kind and take fewer. */
  inline std::vector<unsigned int>
  degrees()
  {
#ifdef DEBUG
    return {1, 3};
#else
    return {1, 2, 3, 4};
#endif
  }

  struct Case
  {
    std::string                     name;
    std::unique_ptr<SplineSpace<2>> space;
  };

  /** All of the above for degrees(), open and periodic. */
  inline std::vector<Case>
  all()
  {
    std::vector<Case> cases;
    for (const unsigned int degree : degrees())
      for (const bool periodic : {false, true})
        {
          const std::string name = "degree " + std::to_string(degree) +
                                   (periodic ? ", periodic" : ", open");
          cases.push_back({name + ", uniform", uniform(degree, periodic)});
          cases.push_back({name + ", graded", graded(degree, periodic)});
          cases.push_back({name + ", spot", spot(degree, periodic)});
        }
    return cases;
  }

  /** Reproducible points of the rectangle. */
  inline std::vector<dealii::Point<2>>
  random_points(const unsigned int n)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::vector<dealii::Point<2>>          points;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double x = 2. * uniform(generator);
        points.emplace_back(x, uniform(generator));
      }
    return points;
  }

  /** Value of a spline at a parameter. */
  template <int dim>
  double
  value(const SplineSpace<dim>    &space,
        const std::vector<double> &coefficients,
        const dealii::Point<dim>  &parameter)
  {
    const unsigned int  cell = space.find_cell(parameter);
    std::vector<double> N;
    space.evaluate(cell, parameter, N);
    double sum = 0.;
    for (unsigned int a = 0; a < N.size(); ++a)
      sum += N[a] * coefficients[space.cell_functions(cell)[a]];
    return sum;
  }

  /** Reproducible coefficients in [-1, 1]. */
  inline std::vector<double>
  random_coefficients(const unsigned int n)
  {
    std::mt19937                           generator(11);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<double>                    coefficients(n);
    for (double &c : coefficients)
      c = uniform(generator);
    return coefficients;
  }
} // namespace example

#endif
