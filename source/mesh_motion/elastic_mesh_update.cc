#include <asperity/base/errors.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/numerics/matrix_tools.h>

#include <cmath>
#include <map>

namespace asperity
{
  namespace
  {
    const dealii::FEValuesExtractors::Vector displacement(0);
  }



  ElasticMeshUpdate::ElasticMeshUpdate(const dealii::DoFHandler<2> &dofs,
                                       const dealii::Mapping<2>    &reference,
                                       const ElasticMeshOptions    &options)
    : dof_handler(dofs)
    , solver(make_linear_solver(LinearSolverKind::cholmod))
  {
    make_constraints(options);
    dealii::DynamicSparsityPattern couplings(dofs.n_dofs());
    dealii::DoFTools::make_sparsity_pattern(dofs, couplings, topology, false);
    sparsity.copy_from(couplings);
    matrix.reinit(sparsity);
    assemble(reference, options);

    dealii::SparseMatrix<double> free(sparsity);
    free.copy_from(matrix);
    std::map<dealii::types::global_dof_index, double> zeros;
    for (const auto &line : prescribed.get_lines())
      zeros[line.index] = 0.;
    Vector solution(dofs.n_dofs()), rhs(dofs.n_dofs());
    dealii::MatrixTools::apply_boundary_values(zeros, free, solution, rhs);
    if (!solver->factorize(free))
      throw InputError("The matrix of the elastic mesh update is singular: a "
                       "part of the mesh is not held by its boundaries.");
  }



  void
  ElasticMeshUpdate::make_constraints(const ElasticMeshOptions &options)
  {
    using dealii::DoFTools::make_periodicity_constraints;
    dealii::DoFTools::make_hanging_node_constraints(dof_handler, topology);
    for (const auto &[left, right] : options.periodic)
      make_periodicity_constraints(dof_handler, right, left, 0, topology);
    topology.close();

    const auto prescribe = [this](const auto                  &boundaries,
                                  const dealii::ComponentMask &components) {
      if (boundaries.empty())
        return;
      for (const auto i : dealii::DoFTools::extract_boundary_dofs(dof_handler,
                                                                  components,
                                                                  boundaries))
        if (!topology.is_constrained(i))
          prescribed.add_line(i);
    };
    prescribe(options.prescribed, dealii::ComponentMask(2, true));
    if (prescribed.n_constraints() == 0)
      throw InputError("An elastic mesh update needs a boundary with both "
                       "components of the displacement prescribed, but there "
                       "is none.");
    prescribe(options.sliding_in_x,
              dealii::ComponentMask(std::vector<bool>{false, true}));
    prescribed.close();
  }



  void
  ElasticMeshUpdate::assemble(const dealii::Mapping<2> &reference,
                              const ElasticMeshOptions &options)
  {
    const auto             &fe = dof_handler.get_fe();
    const dealii::QGauss<2> quadrature(fe.degree + 1);
    dealii::FEValues<2>     phi(reference,
                            fe,
                            quadrature,
                            dealii::update_gradients |
                              dealii::update_JxW_values);
    const unsigned int      n = fe.n_dofs_per_cell();

    // J_0 scales the matrix only; the mean keeps its entries near one.
    double area = 0.;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        phi.reinit(cell);
        for (const unsigned int q : phi.quadrature_point_indices())
          area += phi.JxW(q);
      }
    const double J_0 = area / dof_handler.get_triangulation().n_active_cells();

    // Plane strain with Young's modulus 1.
    const double nu     = options.poisson_ratio;
    const double mu     = 0.5 / (1. + nu);
    const double lambda = nu / ((1. + nu) * (1. - 2. * nu));

    dealii::FullMatrix<double>                   local(n, n);
    std::vector<dealii::types::global_dof_index> dofs(n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        phi.reinit(cell);
        local         = 0.;
        const auto &u = phi[displacement];
        for (const unsigned int q : phi.quadrature_point_indices())
          {
            const double J = phi.JxW(q) / quadrature.weight(q);
            const double stiffened =
              std::pow(J_0 / J, options.stiffening_exponent) * phi.JxW(q);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                local(i, j) +=
                  (lambda * u.divergence(i, q) * u.divergence(j, q) +
                   2. * mu *
                     (u.symmetric_gradient(i, q) *
                      u.symmetric_gradient(j, q))) *
                  stiffened;
          }
        cell->get_dof_indices(dofs);
        topology.distribute_local_to_global(local, dofs, matrix);
      }
  }



  ElasticMeshUpdate::Vector
  ElasticMeshUpdate::update(const Vector &boundary_displacement) const
  {
    Vector given(dof_handler.n_dofs());
    for (const auto &line : prescribed.get_lines())
      given(line.index) = boundary_displacement(line.index);
    Vector d(dof_handler.n_dofs());
    matrix.vmult(d, given);
    d *= -1.;
    prescribed.set_zero(d);
    solver->solve(d);
    d += given;
    topology.distribute(d);
    return d;
  }
} // namespace asperity
