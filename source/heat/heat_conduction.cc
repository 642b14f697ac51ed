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

  template <int dim>
  HeatConduction<dim>::HeatConduction(const BasisTable<dim>   &cells,
                                      const SplineSpace<dim>  &space,
                                      const ThermalProperties &material,
                                      const CellShare         &share,
                                      const GradientRows      &rows)
    : cells(cells)
    , space(space)
    , share(share)
    , integrals(cells, rows)
    , material(material)
    , solver(make_linear_solver(LinearSolverKind::cholmod))
    , rise_(space.n_functions())
    , rise_at_points_(cells.JxW.size())
    , heat_content(space.n_functions())
  {
    make_pattern();
    assemble_capacity();
  }



  template <int dim>
  void
  HeatConduction<dim>::continue_beyond(const BasisTable<dim>   &edge,
                                       const FourierBasis<dim> &waves)
  {
    continuation.emplace(edge, material, waves);
    make_pattern();
    assemble_capacity();
  }



  template <int dim>
  void
  HeatConduction<dim>::make_pattern()
  {
    dealii::DynamicSparsityPattern couplings(rise_.size());
    for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
      {
        const std::vector<unsigned int> &functions = space.cell_functions(cell);
        for (const unsigned int a : functions)
          couplings.add_entries(a, functions.begin(), functions.end());
      }
    if (continuation)
      continuation->add_couplings(couplings);
    pattern.copy_from(couplings);
    for (Matrix *m : {&capacity, &conductance, &matrix})
      m->reinit(pattern);
    solver->reset();
  }



  template <int dim>
  template <class Block>
  void
  HeatConduction<dim>::add_blocks(const Block &block, Matrix &sum)
  {
    entries.begin(sum);
    for (unsigned int e = 0; e < cells.elements.size(); ++e)
      {
        const std::vector<unsigned int> &functions =
          cells.elements[e].functions;
        if (functions.empty()) // of another rank
          continue;
        const double *row = block(e);
        for (const unsigned int a : functions)
          {
            entries.add(a, functions, row);
            row += integrals.stride(e);
          }
      }
    share.ranks.sum(&sum.diag_element(0), sum.n_nonzero_elements());
  }



  template <int dim>
  void
  HeatConduction<dim>::assemble_capacity()
  {
    capacity     = 0.;
    heat_content = 0.;
    std::vector<double> block;
    add_blocks(
      [&](const unsigned int e) {
        const ElementView<dim> element(cells, cells.elements[e]);
        const unsigned int     n  = element.n_functions(),
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
    share.ranks.sum(heat_content.begin(), heat_content.size());
  }



  template <int dim>
  void
  HeatConduction<dim>::assemble_conductance(const Vector &u)
  {
    conductance = 0.;
    add_blocks([&](const unsigned int e) { return integrals.integrate(e, u); },
               conductance);
    conductance *= material.conductivity;
  }



  template <int dim>
  void
  HeatConduction<dim>::begin_step(const Vector &u, const double dt)
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



  template <int dim>
  void
  HeatConduction<dim>::add_source(const Vector &source, Vector &power) const
  {
    Vector heat = source;
    heat.scale(Vector(cells.JxW.begin(), cells.JxW.end()));
    Vector sum(power.size());
    add_point_values(cells, heat, sum);
    share.ranks.sum(sum.begin(), sum.size());
    power += sum;
  }



  template <int dim>
  void
  HeatConduction<dim>::respond(Vector &power) const
  {
    solver->solve(power);
  }



  template <int dim>
  Vector
  HeatConduction<dim>::change(const Vector &power) const
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



  template <int dim>
  void
  HeatConduction<dim>::accept(const Vector &change)
  {
    rise_ += change;
    if (continuation)
      continuation->accept(rise_);
    evaluate_points();
  }



  template <int dim>
  const Vector &
  HeatConduction<dim>::rise() const
  {
    return rise_;
  }



  template <int dim>
  void
  HeatConduction<dim>::evaluate_points()
  {
    rise_at_points_ = values_at_points(cells, rise_);
    if (!share.ranks.are_several())
      return;
    std::vector<double> all(rise_at_points_.begin(), rise_at_points_.end());
    share.ranks.share(share.owner, all);
    rise_at_points_ = Vector(all.begin(), all.end());
  }



  template <int dim>
  const Vector &
  HeatConduction<dim>::rise_at_points() const
  {
    return rise_at_points_;
  }



  template <int dim>
  double
  HeatConduction<dim>::stored() const
  {
    return heat_content * rise_;
  }



  template <int dim>
  double
  HeatConduction<dim>::passed_on() const
  {
    return continuation ? continuation->heat() : 0.;
  }



  template <int dim>
  void
  HeatConduction<dim>::save(OutputArchive &archive) const
  {
    archive << rise_;
    if (continuation)
      continuation->save(archive);
  }



  template <int dim>
  void
  HeatConduction<dim>::load(
    InputArchive &archive,
    const std::function<std::vector<double>(const std::vector<double> &)>
      &transfer)
  {
    Vector rise;
    archive >> rise;
    if (transfer)
      {
        const auto moved =
          transfer(std::vector<double>(rise.begin(), rise.end()));
        rise = Vector(moved.begin(), moved.end());
      }
    require_length("temperatures of the chip", rise.size(), rise_.size());
    rise_ = rise;
    if (continuation)
      continuation->load(archive);
    evaluate_points();
  }



  template class HeatConduction<2>;
  template class HeatConduction<3>;
} // namespace asperity
