#ifndef asperity_tests_solid_loaded_solid_h
#define asperity_tests_solid_loaded_solid_h

#include <asperity/constitutive/material_parameters.h>
#include <asperity/isogeometric/element_view.h>
#include <asperity/solid/edge_load.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solid/solid_assembler.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace loaded_solid
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  /** n equal spans on [0, 1]. */
  inline std::vector<double>
  equal_spans(const unsigned int n)
  {
    std::vector<double> t(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      t[i] = double(i) / n;
    return t;
  }

  /** n spans on [0, 1]; the last is `ratio` times as long as the first. */
  inline std::vector<double>
  graded_spans(const unsigned int n, const double ratio)
  {
    std::vector<double> t(1, 0.);
    for (unsigned int i = 0; i < n; ++i)
      t.push_back(t.back() + std::pow(ratio, n > 1 ? i / (n - 1.) : 0.));
    for (double &x : t)
      x /= t.back();
    return t;
  }

  inline std::shared_ptr<SplineSpace<2>>
  make_space(const unsigned int         degree,
             const std::vector<double> &x,
             const std::vector<double> &y)
  {
    return std::make_shared<SplineSpace<2>>(KnotVector(degree, x),
                                            KnotVector(degree, y));
  }

  /** A box with bent faces and oblique edges. */
  inline PatchGeometry<3>
  bent(const SplineSpace<3> &space)
  {
    return PatchGeometry<3>::from_map(space, [](const Point<3> &xi) {
      return Point<3>(1.3 * xi[0] + 0.2 * std::sin(2. * xi[1]),
                      xi[1] + 0.2 * xi[0] * xi[2],
                      0.8 * xi[2] + 0.1 * xi[0] * xi[1]);
    });
  }

  constexpr Edge four_edges[] = {Edge::left,
                                 Edge::right,
                                 Edge::bottom,
                                 Edge::top};

  /** A curved patch away from the axis, with corners (1, 0) and (3, 1) before
   *  its bends. */
  inline Point<2>
  bent_rectangle(const Point<2> &xi)
  {
    return {1. + 2. * xi[0] + 0.2 * std::sin(2. * xi[1]),
            xi[1] + 0.3 * xi[0] * xi[0] * (1. + xi[1])};
  }

  /** Entries equally distributed in [-size, size]. */
  inline Vector
  random_vector(const unsigned int n, const double size)
  {
    std::mt19937                           generator(3);
    std::uniform_real_distribution<double> uniform(-size, size);
    Vector                                 u(n);
    for (double &x : u)
      x = uniform(generator);
    return u;
  }

  inline NewtonOptions
  newton_options(const double tolerance)
  {
    NewtonOptions options;
    options.tolerance          = tolerance;
    options.maximum_iterations = 40;
    return options;
  }

  /** A patch of any shape, its law, supports, loads and Newton's method. */
  class Body
  {
  public:
    using Map = std::function<Point<2>(const Point<2> &)>;

    Body(const std::shared_ptr<SplineSpace<2>>    &space,
         const Map                                &map,
         const std::shared_ptr<const MaterialLaw> &law,
         const Kinematics   kinematics   = Kinematics::plane_strain,
         const unsigned int n_quadrature = 0)
      : space(space)
      , geometry(PatchGeometry<2>::from_map(*space, map))
      , kinematics(kinematics)
      , solid(space, geometry, law, kinematics, n_quadrature)
      , u(2 * space->n_functions())
      , load(2 * space->n_functions())
    {}

    /** Prescribes one component of u on an edge. */
    void
    prescribe(const Edge edge, const unsigned int component)
    {
      for (const unsigned int a : space->edge_functions(edge))
        constraints.add_line(displacement_dof<2>(a, component));
    }

    void
    clamp(const Edge edge)
    {
      prescribe(edge, 0);
      prescribe(edge, 1);
    }

    void
    add_traction(const Edge edge, const EdgeLoad<2>::Traction &traction)
    {
      edge_loads.push_back(
        std::make_unique<EdgeLoad<2>>(EdgeLoad<2>::dead_traction(
          *space, geometry, edge, traction, kinematics)));
    }

    void
    add_pressure(const Edge edge, const EdgeLoad<2>::Pressure &pressure)
    {
      edge_loads.push_back(
        std::make_unique<EdgeLoad<2>>(EdgeLoad<2>::follower_pressure(
          *space, geometry, edge, pressure, kinematics)));
    }

    /** Control points of the reference geometry, interleaved like u: the
     *  coefficients of the position X. */
    Vector
    control_points() const
    {
      const auto c = space->project(
        [](const Point<2> &xi) {
          return std::vector<double>{xi[0], xi[1]};
        },
        2);
      Vector X(u.size());
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        for (unsigned int d = 0; d < 2; ++d)
          X(2 * a + d) =
            c[d][a] + (geometry.offset.empty() ? 0. : geometry.offset[a][d]);
      return X;
    }

    Equilibrium &
    equilibrium()
    {
      if (!system)
        {
          std::vector<ForceTerm *> terms(1, &solid);
          for (auto &edge_load : edge_loads)
            terms.push_back(edge_load.get());
          constraints.close();
          system = std::make_unique<Equilibrium>(u.size(), terms, constraints);
        }
      return *system;
    }

    void
    set_load_factor(const double factor)
    {
      for (auto &edge_load : edge_loads)
        edge_load->set_factor(factor);
    }

    ConvergenceReport
    newton_from(Vector &start, const double tolerance)
    {
      return newton(equilibrium(),
                    start,
                    newton_options(tolerance),
                    statistics);
    }

    /** Moves u to equilibrium with the load and takes over the history.
     *  @param target its prescribed components become those of u */
    void
    solve(const double tolerance, const Vector *target = nullptr)
    {
      equilibrium().set_load(load);
      if (target != nullptr && !equilibrium().prescribe(u, *target))
        throw std::runtime_error("the supports could not be moved");
      const ConvergenceReport report = newton_from(u, tolerance);
      if (!report.converged)
        throw std::runtime_error("no equilibrium: " + report.reason +
                                 ", residual " +
                                 std::to_string(report.residual));
      solid.accept();
    }

    Tensor<1, 2>
    displacement(const Point<2> &parameter) const
    {
      const unsigned int  cell = space->find_cell(parameter);
      std::vector<double> N;
      space->evaluate(cell, parameter, N);
      Tensor<1, 2> value;
      for (unsigned int a = 0; a < N.size(); ++a)
        for (unsigned int c = 0; c < 2; ++c)
          value[c] += N[a] * u(2 * space->cell_functions(cell)[a] + c);
      return value;
    }

    std::shared_ptr<SplineSpace<2>>           space;
    PatchGeometry<2>                          geometry;
    Kinematics                                kinematics;
    SolidAssembler<2>                         solid;
    std::vector<std::unique_ptr<EdgeLoad<2>>> edge_loads;
    Vector                                    u, load;
    dealii::AffineConstraints<double>         constraints;
    NewtonStatistics                          statistics;

  private:
    std::unique_ptr<Equilibrium> system;
  };

  /** Adds a body force [N/m^3] that depends on the reference position. */
  inline void
  add_body_force(const SolidAssembler<2>                             &solid,
                 const std::function<Tensor<1, 2>(const Point<2> &)> &force,
                 Vector                                              &external)
  {
    const BasisTable<2> &table = solid.table();
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          element.add_force(q,
                            element.JxW(q) *
                              force(table.position[element.point(q)]),
                            external);
      }
  }

  /** Adds the gradient of a displacement to G [-]. */
  inline void
  add_gradient(const ElementView<2> &element,
               const unsigned int    q,
               const Vector         &u,
               Tensor<2, 2>         &G)
  {
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        G[c] += u(element.dof(a, c)) * element.gradient(q, a);
  }

  /** Largest difference between the tangent of a term times a direction and
   *  the central difference of its residual, relative to the former. */
  inline double
  tangent_error(ForceTerm    &term,
                const Vector &u,
                const Vector &direction,
                const double  step)
  {
    dealii::DynamicSparsityPattern couplings(u.size());
    term.add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    Matrix tangent(pattern);
    Vector R(u.size()), plus(u.size()), minus(u.size()), product(u.size());
    if (!term.add(u, R, &tangent))
      return INFINITY;
    tangent.vmult(product, direction);
    Vector v = u;
    v.add(step, direction);
    const bool first = term.add(v, plus, nullptr);
    v.add(-2. * step, direction);
    if (!first || !term.add(v, minus, nullptr))
      return INFINITY;
    plus -= minus;
    plus /= 2. * step;
    plus -= product;
    return plus.linfty_norm() / product.linfty_norm();
  }
} // namespace loaded_solid

#endif
