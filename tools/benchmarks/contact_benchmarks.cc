// Contact benchmarks that take longer than a test should. Writes
//   contact_penalty.csv, contact_ironing.csv, contact_punch.csv
// into the directory given as the first argument (default: the current one);
// tools/benchmarks/contact_charts.py draws them. With a second argument `hertz`
// only a short contact_penalty.csv of Hertz's contact, for tools/charts.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/solvers/linear_solver.h>

#include <contact/contact_examples.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

namespace
{
  using namespace asperity;
  using namespace example;

  const ContactFormulation formulations[] = {ContactFormulation::mortar,
                                             ContactFormulation::gauss_point};

  std::string
  name(const ContactFormulation formulation)
  {
    return formulation == ContactFormulation::mortar ? "mortar" : "gauss_point";
  }



  /** Largest over smallest eigenvalue in magnitude, by 40 steps of the power
   *  method each way, at the last tangent. */
  double
  condition_number(ContactProblem &problem)
  {
    dealii::Vector<double> R(problem.u.size()), d(problem.u.size());
    problem.equilibrium->linearize(problem.u, R);
    // Eliminates the prescribed components from the matrix, too.
    problem.equilibrium->direction(R, d);
    const auto &matrix = problem.equilibrium->tangent();
    const auto  solver = make_linear_solver(LinearSolverKind::umfpack);
    if (!solver->factorize(matrix))
      return std::nan("");
    dealii::Vector<double> high(R.size()), low(R.size()), product(R.size());
    for (unsigned int i = 0; i < R.size(); ++i)
      high(i) = low(i) = std::sin(1. + 3. * i);
    double largest = 0., inverse = 0.;
    for (unsigned int k = 0; k < 40; ++k)
      {
        high /= high.l2_norm();
        matrix.vmult(product, high);
        high    = product;
        largest = high.l2_norm();
        low /= low.l2_norm();
        solver->solve(low);
        inverse = low.l2_norm();
      }
    return largest * inverse;
  }



  /** A row of the penalty sweep: Hertz's contact. */
  void
  hertz_row(std::ostream &table, const Discretization &discretization)
  {
    HalfPlane  body = hertz(discretization);
    const bool found =
      std::isfinite(body.problem->press(body.force, body.depth));
    const auto   state = body.problem->contact->state();
    const double p0    = hertz_pressure(body, 0.);
    const double a2_R  = 1. / 500.; // a^2/R, the scale of the gap
    table << "hertz," << name(discretization.formulation) << ','
          << discretization.penalty_factor << ','
          << (found ? pressure_error(*body.problem,
                                     2.,
                                     [&](const double x) {
                                       return hertz_pressure(body, x);
                                     }) :
                      std::nan(""))
          << ',' << state.max_pressure / p0 - 1. << ','
          << state.max_penetration / a2_R << ','
          << body.problem->statistics.iterations << ','
          << condition_number(*body.problem) << std::endl;
  }



  /** A row of the penalty sweep: Westergaard's wave. */
  void
  westergaard_row(std::ostream &table, Discretization discretization)
  {
    discretization.resolution = 128.;
    Westergaard        wave(discretization);
    const double       a          = 0.25;
    const bool         pressed    = wave.press(a);
    const unsigned int iterations = wave.problem->statistics.iterations;
    table << "westergaard," << name(discretization.formulation) << ','
          << discretization.penalty_factor << ','
          << (pressed ? pressure_error(*wave.problem,
                                       0.5,
                                       [&](const double x) {
                                         return wave.exact_pressure(a, x);
                                       }) :
                        std::nan(""))
          << ',' << wave.half_width() / a - 1. << ','
          << wave.problem->contact->state().max_penetration / 4e-4 << ','
          << iterations << ',' << condition_number(*wave.problem) << std::endl;
  }



  std::ofstream
  penalty_table(const std::string &directory)
  {
    std::ofstream table(directory + "/contact_penalty.csv");
    table << "case,formulation,penalty_h_over_E,pressure_error,peak_error,"
             "penetration,iterations,condition\n";
    return table;
  }



  void
  penalty_sweep(const std::string &directory)
  {
    std::ofstream table = penalty_table(directory);
    for (const ContactFormulation formulation : formulations)
      for (const double c :
           {1e-2, 3e-2, 1e-1, 3e-1, 1., 3., 10., 30., 1e2, 3e2, 1e3, 3e3, 1e4})
        {
          Discretization discretization;
          discretization.formulation    = formulation;
          discretization.penalty_factor = c;
          hertz_row(table, discretization);
          westergaard_row(table, discretization);
        }
  }



  /** Hertz alone, a penalty a decade and the program's default. */
  void
  hertz_sweep(const std::string &directory)
  {
    std::ofstream table = penalty_table(directory);
    for (const ContactFormulation formulation : formulations)
      for (const double c : {1e-1, 1., 8., 1e2, 1e3, 1e4})
        {
          Discretization discretization;
          discretization.formulation    = formulation;
          discretization.penalty_factor = c;
          hertz_row(table, discretization);
        }
  }



  void
  ironing_table(const std::string &directory)
  {
    std::ofstream table(directory + "/contact_ironing.csv");
    std::ofstream curves(directory + "/contact_ironing_curves.csv");
    table << "formulation,degree,elements_on_thickness,penalty_h_over_E,"
             "vertical_force,vertical_ripple,lateral_ripple,iterations\n";
    curves << "formulation,degree,position_over_h,vertical,lateral\n";
    for (const double resolution : {16., 32.})
      for (const double c : {10., 100., 1000.})
        for (const ContactFormulation formulation : formulations)
          for (unsigned int degree = 1; degree <= 3; ++degree)
            {
              Discretization discretization;
              discretization.formulation    = formulation;
              discretization.degree         = degree;
              discretization.penalty_factor = c;
              discretization.resolution     = resolution;
              const unsigned int steps      = 16;
              const Ironing      result     = ironing(discretization, steps);
              if (!result.converged)
                {
                  std::cerr << "Ironing, " << name(formulation) << ", degree "
                            << degree << ", " << resolution / 2.
                            << " elements, penalty " << c
                            << " E/h: Newton's method did not converge.\n";
                  continue;
                }
              table << name(formulation) << ',' << degree << ','
                    << resolution / 2. << ',' << c << ','
                    << result.vertical_force << ',' << result.vertical_ripple
                    << ',' << result.lateral_ripple << ',' << result.iterations
                    << std::endl;
              if (c == 100. && resolution == 16.)
                for (unsigned int k = 0; k < result.position.size(); ++k)
                  curves << name(formulation) << ',' << degree << ','
                         << double(k) / steps << ','
                         << result.vertical[k] / result.vertical_force - 1.
                         << ',' << result.lateral[k] / result.vertical_force
                         << '\n';
            }
  }



  void
  punch_table(const std::string &directory)
  {
    std::ofstream table(directory + "/contact_punch.csv");
    table << "formulation,penalty_h_over_E,x,pressure,exact\n";
    for (const ContactFormulation formulation : formulations)
      for (const double c : {1., 100.})
        {
          Discretization discretization;
          discretization.formulation    = formulation;
          discretization.penalty_factor = c;
          HalfPlane body                = flat_punch(discretization);
          body.problem->press(body.force, body.depth);
          const auto  &contact = *body.problem->contact;
          const double mean    = 0.5 * body.force;
          for (unsigned int q = 0; q < contact.pressure().size(); ++q)
            {
              const double x = contact.table().position[q][0];
              if (std::abs(x) < 1.2)
                table << name(formulation) << ',' << c << ',' << x << ','
                      << contact.pressure()[q] / mean << ','
                      << punch_pressure(body.force, x) / mean << '\n';
            }
        }
  }
} // namespace



int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  const MpiSession  mpi(argc, argv);
  const std::string directory = argc > 1 ? argv[1] : ".";
  if (argc > 2 && argv[2] == std::string("hertz"))
    {
      hertz_sweep(directory);
      return 0;
    }
  punch_table(directory);
  ironing_table(directory);
  penalty_sweep(directory);
  std::cout << "Tables are in " << directory << "/contact_*.csv" << std::endl;
}
