#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  HeatConduction::HeatConduction(const BasisTable<2>     &cells,
                                 const unsigned int       n_functions,
                                 const ThermalProperties &material)
    : cells(cells)
    , material(material)
    , solver(make_direct_solver(DirectSolverKind::cholmod))
    , rise_(n_functions)
    , heat_content(n_functions)
  {
    make_pattern();
    assemble_capacity();
  }



  void
  HeatConduction::continue_beyond(const BasisTable<2> &edge,
                                  const double         period,
                                  const unsigned int   n_waves)
  {
    continuation.emplace(edge, material, period, n_waves);
    make_pattern();
    assemble_capacity();
  }



  void
  HeatConduction::make_pattern()
  {
    dealii::DynamicSparsityPattern couplings(rise_.size());
    for (const auto &element : cells.elements)
      for (const unsigned int a : element.functions)
        couplings.add_entries(a,
                              element.functions.begin(),
                              element.functions.end());
    if (continuation)
      continuation->add_couplings(couplings);
    pattern.copy_from(couplings);
    for (Matrix *m : {&capacity, &conductance, &matrix})
      m->reinit(pattern);
    solver->reset();
  }



  namespace
  {
    /** Adds integrals over the elements of products of two functions, which are
     *  symmetric.
     *  @param integrand adds what a point q of an element gives to the block
     *    [a * n_functions + b] of its functions, b <= a */
    template <class Integrand>
    void
    integrate(const BasisTable<2> &cells,
              const Integrand     &integrand,
              MatrixEntries       &entries,
              Matrix              &sum)
    {
      entries.begin(sum);
      std::vector<double> block;
      for (const auto &entry : cells.elements)
        {
          const ElementView<2> element(cells, entry);
          const unsigned int   n = element.n_functions();
          block.assign(n * n, 0.);
          for (unsigned int q = 0; q < cells.points_per_element; ++q)
            integrand(element, q, block.data());
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              entries.add(entry.functions[a],
                          entry.functions[b],
                          block[std::max(a, b) * n + std::min(a, b)]);
        }
    }
  } // namespace



  void
  HeatConduction::assemble_capacity()
  {
    capacity     = 0.;
    heat_content = 0.;
    integrate(
      cells,
      [this](const ElementView<2> &element,
             const unsigned int    q,
             double               *block) {
        const unsigned int n = element.n_functions();
        const double heat    = material.volumetric_capacity() * element.JxW(q);
        for (unsigned int a = 0; a < n; ++a)
          {
            heat_content(element.function(a)) += heat * element.N(q, a);
            for (unsigned int b = 0; b <= a; ++b)
              block[a * n + b] += heat * element.N(q, a) * element.N(q, b);
          }
      },
      entries,
      capacity);
  }



  void
  HeatConduction::assemble_conductance(const Vector &u)
  {
    conductance = 0.;
    std::vector<Tensor<1, 2>> g;
    integrate(
      cells,
      [&](const ElementView<2> &element, const unsigned int q, double *block) {
        const unsigned int n = element.n_functions();
        Tensor<2, 2>       F;
        F[0][0] = F[1][1] = 1.;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            F[c] += u(element.dof(a, c)) * element.gradient(q, a);
        // With the gradient in the current frame, g_a = F^{-T} Grad N_a, the
        // integrand is lambda J g_a g_b.
        const Tensor<2, 2> F_inverse_transposed = transpose(invert(F));
        g.resize(n);
        for (unsigned int a = 0; a < n; ++a)
          g[a] = F_inverse_transposed * element.gradient(q, a);
        const double weight =
          material.conductivity * determinant(F) * element.JxW(q);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            block[a * n + b] += weight * (g[a] * g[b]);
      },
      entries,
      conductance);
  }



  void
  HeatConduction::begin_step(const Vector &u, const double dt)
  {
    assemble_conductance(u);
    matrix.copy_from(conductance);
    matrix.add(1. / dt, capacity);
    if (continuation)
      {
        continuation->begin_step(dt);
        continuation->add_conductance(matrix);
      }
    if (!solver->factorize(matrix))
      throw ComputationError("The matrix of heat conduction in the chip is "
                             "singular or not finite; no remedy is known.");
  }



  void
  HeatConduction::add_source(const Vector &source, Vector &power) const
  {
    Vector heat = source;
    heat.scale(Vector(cells.JxW.begin(), cells.JxW.end()));
    add_point_values(cells, heat, power);
  }



  void
  HeatConduction::respond(Vector &power) const
  {
    solver->solve(power);
  }



  Vector
  HeatConduction::change(const Vector &power) const
  {
    Vector change(power.size());
    conductance.vmult(change, rise_);
    change *= -1.;
    change += power;
    if (continuation)
      continuation->add_power(rise_, change);
    respond(change);
    return change;
  }



  void
  HeatConduction::accept(const Vector &change)
  {
    rise_ += change;
    if (continuation)
      continuation->accept(rise_);
  }



  const Vector &
  HeatConduction::rise() const
  {
    return rise_;
  }



  Vector
  HeatConduction::rise_at_points() const
  {
    return values_at_points(cells, rise_);
  }



  double
  HeatConduction::stored() const
  {
    return heat_content * rise_;
  }



  double
  HeatConduction::passed_on() const
  {
    return continuation ? continuation->heat() : 0.;
  }



  void
  HeatConduction::save(OutputArchive &archive) const
  {
    archive << rise_;
    if (continuation)
      continuation->save(archive);
  }



  void
  HeatConduction::load(InputArchive &archive)
  {
    archive >> fixed_length(rise_, "temperatures of the chip");
    if (continuation)
      continuation->load(archive);
  }
} // namespace asperity
