#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  HeatConduction::HeatConduction(const BasisTable<2>     &cells,
                                 const unsigned int       n_functions,
                                 const ThermalProperties &material)
    : cells(cells)
    , integrals(cells)
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



  template <class Block>
  void
  HeatConduction::add_blocks(const Block &block, Matrix &sum)
  {
    entries.begin(sum);
    for (unsigned int e = 0; e < cells.elements.size(); ++e)
      {
        const std::vector<unsigned int> &functions =
          cells.elements[e].functions;
        const double *row = block(e);
        for (const unsigned int a : functions)
          {
            for (unsigned int b = 0; b < functions.size(); ++b)
              entries.add(a, functions[b], row[b]);
            row += integrals.stride(e);
          }
      }
  }



  void
  HeatConduction::assemble_capacity()
  {
    capacity     = 0.;
    heat_content = 0.;
    std::vector<double> block;
    add_blocks(
      [&](const unsigned int e) {
        const ElementView<2> element(cells, cells.elements[e]);
        const unsigned int   n    = element.n_functions(),
                           stride = integrals.stride(e);
        block.assign(n * stride, 0.);
        for (unsigned int q = 0; q < cells.points_per_element; ++q)
          {
            const double heat = material.volumetric_capacity() * element.JxW(q);
            for (unsigned int a = 0; a < n; ++a)
              {
                heat_content(element.function(a)) += heat * element.N(q, a);
                for (unsigned int b = 0; b < n; ++b)
                  block[a * stride + b] +=
                    heat * element.N(q, a) * element.N(q, b);
              }
          }
        return block.data();
      },
      capacity);
  }



  void
  HeatConduction::assemble_conductance(const Vector &u)
  {
    conductance = 0.;
    add_blocks([&](const unsigned int e) { return integrals.integrate(e, u); },
               conductance);
    conductance *= material.conductivity;
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
