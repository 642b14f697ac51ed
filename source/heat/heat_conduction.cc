#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

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
    /** block[a * stride + b] = sum over the rows r of r_a r_b. */
    ASPERITY_ALL_VECTOR_WIDTHS void
    sum_products(const unsigned int n_rows,
                 const unsigned int n,
                 const unsigned int stride,
                 const double      *rows,
                 double            *block)
    {
      std::fill(block, block + n * stride, 0.);
      for (const double *row = rows; row < rows + n_rows * stride;
           row += stride)
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < stride; b += neighbours::width)
            neighbours::at(block + a * stride + b) +=
              row[a] * neighbours::at(row + b);
    }



    /**
     * Adds integrals over the elements of products of two functions.
     *
     * @param n_factors of these products at a point, which are added up
     * @param write_factors (element, q, row, stride) writes the factors of a
     *   point, the root of its weight in them: that number f of function a to
     *   row[f * stride + a]
     */
    template <class Factors>
    void
    integrate(const BasisTable<2> &cells,
              const unsigned int   n_factors,
              const Factors       &write_factors,
              MatrixEntries       &entries,
              Matrix              &sum)
    {
      entries.begin(sum);
      std::vector<double> rows, block;
      for (const auto &entry : cells.elements)
        {
          const ElementView<2> element(cells, entry);
          const unsigned int   n    = element.n_functions(),
                             stride = neighbours::padded(n),
                             n_rows = n_factors * cells.points_per_element;
          rows.assign(n_rows * stride, 0.);
          block.resize(n * stride);
          for (unsigned int q = 0; q < cells.points_per_element; ++q)
            write_factors(element, q, &rows[q * n_factors * stride], stride);
          sum_products(n_rows, n, stride, rows.data(), block.data());
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              entries.add(entry.functions[a],
                          entry.functions[b],
                          block[a * stride + b]);
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
      1,
      [this](const ElementView<2> &element,
             const unsigned int    q,
             double               *row,
             const unsigned int) {
        const double heat = material.volumetric_capacity() * element.JxW(q);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            heat_content(element.function(a)) += heat * element.N(q, a);
            row[a] = std::sqrt(heat) * element.N(q, a);
          }
      },
      entries,
      capacity);
  }



  void
  HeatConduction::assemble_conductance(const Vector &u)
  {
    conductance = 0.;
    integrate(
      cells,
      2,
      [&](const ElementView<2> &element,
          const unsigned int    q,
          double               *row,
          const unsigned int    stride) {
        Tensor<2, 2> F = dealii::unit_symmetric_tensor<2>();
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int c = 0; c < 2; ++c)
            F[c] += u(element.dof(a, c)) * element.gradient(q, a);
        const double J = determinant(F);
        if (!(J > 0.))
          throw ComputationError("An element of the chip is inside out, where "
                                 "no heat can be conducted.");
        // With the gradient in the current frame, g_a = F^{-T} Grad N_a, the
        // integrand is lambda J g_a g_b.
        const double root =
          std::sqrt(material.conductivity * J * element.JxW(q));
        const Tensor<2, 2> to_current = root * transpose(invert(F));
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const Tensor<1, 2> g = to_current * element.gradient(q, a);
            row[a]               = g[0];
            row[stride + a]      = g[1];
          }
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
