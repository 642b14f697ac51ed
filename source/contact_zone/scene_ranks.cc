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

    /** Unknowns from which on GMRES with multigrid is faster than a factor: an
     *  iteration of Newton's method took 0.47 instead of 0.31 s with 5,076
     *  unknowns, 0.69 instead of 1.84 s with 9,984, on one rank. */
    constexpr double fewest_unknowns_of_krylov = 8e3;

    /** What each further rank of a machine repeats [bytes an unknown]: mesh,
     *  face, histories and vectors. */
    constexpr double repeated_by_rank = 1.8e3;

    /** What each rank takes to conduct heat [bytes]: a factor with one unknown
     *  a function, whose blocks are a ninth of those of three components, and
     *  three matrices with their pattern, and where their entries stand. */
    double
    heat_memory(const double n_elements, const unsigned int degree)
    {
      return sizeof(double) * numbers_in_factor(n_elements, degree) / 9. +
             n_elements * std::pow(2. * degree + 1., 3) *
               (3 * sizeof(double) + sizeof(unsigned int)) +
             n_elements * std::pow(degree + 1., 6) * sizeof(unsigned int);
    }

    std::string
    format_number_of_bytes(const double bytes)
    {
      return format_quantity(1e-9 * bytes, "1", 2) + " GB";
    }

    bool
    runs_on_several(const LinearSolverKind kind)
    {
      return kind == LinearSolverKind::automatic ||
             kind == LinearSolverKind::mumps ||
             kind == LinearSolverKind::krylov;
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
               const LinearSolverKind solver)
  {
    // Of a degree of 2 tables take 18 to 22 kB, and the matrices as much.
    const double bandwidth  = std::pow((2. * degree + 1.) / 5., 3);
    const double n_unknowns = 3. * n_elements;
    const double of_solver =
      solver == LinearSolverKind::krylov ?
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
    if (linear_solver_ == LinearSolverKind::automatic)
      linear_solver_ = LinearSolverKind::cholmod;
    if (linear_solver_ == LinearSolverKind::krylov)
      throw InputError("Entry 'Solver/Linear solver': found krylov in two "
                       "dimensions; expected a direct one there, or "
                       "automatic.");
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
    const LinearSolverKind wanted = parameters.solver.linear_solver;
    if (ranks.are_several() && !runs_on_several(wanted))
      throw InputError("Entry 'Solver/Linear solver': found one that runs on "
                       "one rank, on " +
                       std::to_string(ranks.size()) +
                       " ranks; expected automatic, mumps or krylov.");
    // What is left when some ranks have begun differs a little.
    const double available  = -ranks.largest(-available_memory());
    const double n_unknowns = 3. * n_elements;
    const double repeated = (ranks.size() - 1.) * repeated_by_rank * n_unknowns;
    const double beside =
      parameters.heat_model() == HeatModel::conducting ?
        repeated + ranks.size() * heat_memory(n_elements, degree) :
        repeated;
    const auto fits = [&](const LinearSolverKind kind) {
      return available <= 0. ||
             patch_memory(n_elements, degree, kind) + beside <= available;
    };
    linear_solver_ = wanted;
    if (wanted == LinearSolverKind::automatic)
      linear_solver_ = n_unknowns >= fewest_unknowns_of_krylov ||
                           !fits(LinearSolverKind::cholmod) ?
                         LinearSolverKind::krylov :
                       ranks.are_several() ? LinearSolverKind::mumps :
                                             LinearSolverKind::cholmod;
    // The tangent is symmetric but for the shear, that of pockets is.
    if (linear_solver_ == LinearSolverKind::mumps)
      linear_solver_ = LinearSolverKind::mumps_symmetric;
    if (fits(linear_solver_))
      return;
    const std::string remedy =
      std::string(fits(LinearSolverKind::krylov) ?
                    "Solver/Linear solver = krylov, " :
                    "") +
      (parameters.mesh.adaptive_levels > 0 ? "a bound by Maximum unknowns, " :
                                             "") +
      "fewer Spans";
    throw InputError(
      "Mesh: these entries make a mesh of about " +
      format_quantity(n_elements, "1", 2) + " elements, which takes about " +
      format_number_of_bytes(patch_memory(n_elements, degree, linear_solver_) +
                             beside) +
      " of memory; this machine can give " + format_number_of_bytes(available) +
      ": " + remedy +
      " or Spans across, a larger Row grading, a smaller Strip depth, or a "
      "smaller Chip height.");
  }



  template <int dim>
  void
  Scene<dim>::suit_solver(const SceneParameters &parameters)
  {
    if (dim == 2 ||
        parameters.solver.linear_solver != LinearSolverKind::automatic)
      return;
    linear_solver_ =
      n_unknowns() >= fewest_unknowns_of_krylov ? LinearSolverKind::krylov :
      share_.ranks.are_several() ? LinearSolverKind::mumps_symmetric :
                                   LinearSolverKind::cholmod;
  }



  template <int dim>
  void
  Scene<dim>::build_share(const SceneParameters &parameters)
  {
    const unsigned int n = share_.ranks.size();
    if (n < 2)
      return;
    if (space->n_cells() < n)
      throw InputError("Mesh: found " + std::to_string(space->n_cells()) +
                       " elements for " + std::to_string(n) +
                       " ranks; expected one for each at least.");
    const auto weights = cell_weights(*space, Edge::top, work_of(parameters));
    // METIS of another machine may cut otherwise: the first rank decides.
    std::vector<double> owner(space->n_cells(), 0.);
    if (share_.ranks.is_first())
      {
        const auto parts = partition_cells(*space, weights, n);
        owner.assign(parts.begin(), parts.end());
      }
    share_.ranks.sum(owner.data(), owner.size());
    share_.owner.assign(owner.begin(), owner.end());
    imbalance_ = count_partition(*space, weights, share_.owner, n).imbalance;
  }



  template <int dim>
  void
  Scene<dim>::build_equilibrium()
  {
    std::vector<ForceTerm *> terms = {chip.get(), contact.get()};
    if (lubricant)
      terms.push_back(lubricant.get());
    // The tangent of a film is symmetric in structure only.
    const bool symmetric = n_lubricant_unknowns == 0;
    if (!symmetric && linear_solver_ == LinearSolverKind::cholmod)
      linear_solver_ = LinearSolverKind::supernodal_lu;
    SharedSystem shared;
    shared.ranks           = share_.ranks;
    shared.n_components    = dim;
    shared.near_null_space = [this]() { return rigid_motions(); };
    if (!share_.owner.empty())
      for (const unsigned int owner : function_owners(*space, share_.owner))
        shared.row_owner.insert(shared.row_owner.end(), dim, owner);
    equilibrium = std::make_unique<Equilibrium>(
      n_unknowns(), terms, constraints_, linear_solver_, shared);
    // A chip that floats on oil is held by the oil's volume alone.
    equilibrium->set_support(
      displacement_dof<dim>(space->edge_functions(Edge::bottom).front(),
                            dim - 1));
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
  LinearSolverKind
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
  Scene<2>::build_equilibrium();
  template void
  Scene<3>::build_equilibrium();
  template void
  Scene<2>::suit_solver(const SceneParameters &);
  template void
  Scene<3>::suit_solver(const SceneParameters &);
  template void
  Scene<2>::build_share(const SceneParameters &);
  template void
  Scene<3>::build_share(const SceneParameters &);
  template std::vector<dealii::Vector<double>>
  Scene<2>::rigid_motions() const;
  template std::vector<dealii::Vector<double>>
  Scene<3>::rigid_motions() const;
  template LinearSolverKind
  Scene<2>::linear_solver() const;
  template LinearSolverKind
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
