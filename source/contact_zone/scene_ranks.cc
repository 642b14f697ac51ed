#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    /** Bezier elements whose tables, tangent and factors take about 2 GB in two
     *  dimensions. */
    constexpr double largest_mesh = 1e5;

    /** Beside the integration of a cell with its tangent: the search of the
     *  closest points of a face, and the tangent of the shear where a sixth of
     *  the faces touch, as runs of hills of degree 2 took them. */
    CellWork
    work_of(const SceneParameters &parameters)
    {
      CellWork work;
      work.face = parameters.interface.law == InterfaceShear::none ? 600 : 1300;
      return work;
    }

    std::string
    format_number_of_bytes(const double bytes)
    {
      return format_quantity(1e-9 * bytes, "1", 2) + " GB";
    }

    bool
    runs_on_several(const DirectSolverKind kind)
    {
      return kind == DirectSolverKind::automatic ||
             kind == DirectSolverKind::mumps ||
             kind == DirectSolverKind::krylov;
    }
  } // namespace



  double
  numbers_in_factor(const double n_elements, const unsigned int degree)
  {
    return 20.4 * std::pow(3. * degree * n_elements, 1.38);
  }



  double
  patch_memory(const double           n_elements,
               const unsigned int     degree,
               const DirectSolverKind solver)
  {
    // Of a degree of 2 tables take 18 to 22 kB, and the matrices as much.
    const double bandwidth  = std::pow((2. * degree + 1.) / 5., 3);
    const double n_unknowns = 3. * n_elements;
    const double of_solver =
      solver == DirectSolverKind::krylov ?
        n_unknowns * 6e3 * bandwidth :
        2. * sizeof(double) * numbers_in_factor(n_elements, degree);
    return of_solver + n_unknowns * 40e3 * bandwidth;
  }



  template <>
  void
  Scene<2>::choose_solver(const SceneParameters &parameters,
                          const double           n_elements)
  {
    linear_solver_ = parameters.solver.linear_solver;
    if (linear_solver_ == DirectSolverKind::automatic)
      linear_solver_ = DirectSolverKind::cholmod;
    if (n_elements > largest_mesh)
      throw InputError("Mesh: these entries make a mesh of about " +
                       format_quantity(n_elements, "1", 2) +
                       " elements; expected at most " +
                       format_quantity(largest_mesh, "1") +
                       ": fewer Spans, a larger Row grading, a smaller Strip "
                       "depth, or a smaller Chip height.");
  }



  template <>
  void
  Scene<3>::choose_solver(const SceneParameters &parameters,
                          const double           n_elements)
  {
    const Ranks           &ranks  = share_.ranks;
    const unsigned int     degree = parameters.mesh.degree;
    const DirectSolverKind wanted = parameters.solver.linear_solver;
    if (ranks.are_several() && !runs_on_several(wanted))
      throw InputError("Entry 'Solver/Linear solver': found one that runs on "
                       "one rank, on " +
                       std::to_string(ranks.size()) +
                       " ranks; expected automatic, mumps or krylov.");
    // What is left when some ranks have begun differs a little.
    const double available = -ranks.largest(-available_memory());
    const auto   fits      = [&](const DirectSolverKind kind) {
      return available <= 0. ||
             patch_memory(n_elements, degree, kind) <= available;
    };
    linear_solver_ = wanted;
    if (wanted == DirectSolverKind::automatic)
      linear_solver_ = !fits(DirectSolverKind::cholmod) ?
                         DirectSolverKind::krylov :
                       ranks.are_several() ? DirectSolverKind::mumps :
                                             DirectSolverKind::cholmod;
    // The tangent of a dry scene is symmetric but for the shear.
    if (linear_solver_ == DirectSolverKind::mumps)
      linear_solver_ = DirectSolverKind::mumps_symmetric;
    if (fits(linear_solver_))
      return;
    const std::string remedy = fits(DirectSolverKind::krylov) ?
                                 "Solver/Linear solver = krylov, fewer Spans" :
                                 "fewer Spans";
    throw InputError(
      "Mesh: these entries make a mesh of about " +
      format_quantity(n_elements, "1", 2) + " elements, which takes about " +
      format_number_of_bytes(patch_memory(n_elements, degree, linear_solver_)) +
      " of memory; this machine can give " + format_number_of_bytes(available) +
      ": " + remedy +
      " or Spans across, a larger Row grading, a smaller Strip depth, or a "
      "smaller Chip height.");
  }



  template <int dim>
  void
  Scene<dim>::build_share(const SceneParameters &parameters)
  {
    const unsigned int n = share_.ranks.size();
    if (n < 2)
      return;
    const auto weights = cell_weights(*space, Edge::top, work_of(parameters));
    share_.owner       = partition_cells(*space, weights, n);
    imbalance_ = count_partition(*space, weights, share_.owner, n).imbalance;
  }



  template <int dim>
  std::vector<dealii::Vector<double>>
  Scene<dim>::rigid_motions() const
  {
    // Greville abscissae are the coefficients of the identity.
    const auto                      hierarchy = space->hierarchy();
    std::vector<dealii::Point<dim>> place(space->n_functions());
    for (unsigned int a = 0; a < place.size(); ++a)
      {
        auto [cell, number] = hierarchy->function_home(a);
        const auto &index   = hierarchy->cell_index(cell);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const KnotVector &knots     = hierarchy->knots(index.level, d);
            const auto        functions = knots.span_functions(index.spans[d]);
            place[a][d] =
              knots.greville()[functions[number % functions.size()]];
            number /= functions.size();
          }
      }
    const unsigned int                  n_rotations = dim == 2 ? 1 : 3;
    std::vector<dealii::Vector<double>> motions(
      dim + n_rotations, dealii::Vector<double>(n_unknowns()));
    for (unsigned int a = 0; a < place.size(); ++a)
      for (unsigned int c = 0; c < dim; ++c)
        {
          motions[c](displacement_dof<dim>(a, c)) = 1.;
          // In the plane of the axes c and d, in units of the length.
          const unsigned int d = (c + 1) % dim;
          if (c == n_rotations)
            continue;
          motions[dim + c](displacement_dof<dim>(a, c)) = -place[a][d] / length;
          motions[dim + c](displacement_dof<dim>(a, d)) = place[a][c] / length;
        }
    return motions;
  }



  template <int dim>
  DirectSolverKind
  Scene<dim>::linear_solver() const
  {
    return linear_solver_;
  }



  template <int dim>
  const CellShare &
  Scene<dim>::share() const
  {
    return share_;
  }



  template <int dim>
  double
  Scene<dim>::imbalance() const
  {
    return imbalance_;
  }



  template void
  Scene<2>::build_share(const SceneParameters &);
  template void
  Scene<3>::build_share(const SceneParameters &);
  template std::vector<dealii::Vector<double>>
  Scene<2>::rigid_motions() const;
  template std::vector<dealii::Vector<double>>
  Scene<3>::rigid_motions() const;
  template DirectSolverKind
  Scene<2>::linear_solver() const;
  template DirectSolverKind
  Scene<3>::linear_solver() const;
  template const CellShare &
  Scene<2>::share() const;
  template const CellShare &
  Scene<3>::share() const;
  template double
  Scene<2>::imbalance() const;
  template double
  Scene<3>::imbalance() const;
} // namespace asperity
