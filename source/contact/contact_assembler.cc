#include <asperity/contact/contact_assembler.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <limits>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  namespace
  {
    /** Where a point was whose gap is unknown: no other is equal to it. */
    template <int dim>
    dealii::Point<dim>
    nowhere()
    {
      dealii::Point<dim> x;
      x[0] = std::numeric_limits<double>::quiet_NaN();
      return x;
    }
  } // namespace



  template <int dim>
  ContactAssembler<dim>::ContactAssembler(
    std::shared_ptr<const SplineSpace<dim>>   space,
    const PatchGeometry<dim>                 &geometry,
    const Edge                                edge,
    std::shared_ptr<const RigidObstacle<dim>> obstacle,
    const ContactOptions                     &options,
    const CellShare                          &cells)
    : space(std::move(space))
    , obstacle(std::move(obstacle))
    , options_(options)
    , law{options.penalty}
    , table_(
        tabulate_edge(*this->space,
                      geometry,
                      edge,
                      dealii::QGauss<dim - 1>(options.points_per_element > 0 ?
                                                options.points_per_element :
                                                this->space->degree() + 2)))
    , share{cells.ranks, {}}
    , tractions(*this->space, table_, edge, options.formulation, cells)
    , multiplier(tractions.size(), 0.)
    , hint(table_.JxW.size())
    , position(table_.JxW.size())
    , gap(table_.JxW.size())
    , traction_pressure(tractions.size())
    , point_pressure(table_.JxW.size(), 0.)
  {
    for (unsigned int q = 0; q < hint.size(); ++q)
      for (unsigned int k = 0; k < dim - 1; ++k)
        hint[q][k] = table_.position[q][k];
    if (!cells.owner.empty())
      for (const auto &element : table_.elements)
        share.owner.push_back(cells.owner[element.cell]);
    position.assign(position.size(), nowhere<dim>());
    if (options.interface.law != InterfaceShear::none)
      shear_.emplace(tractions,
                     table_,
                     options.interface,
                     options.penalty,
                     options.element_length,
                     options.motion);
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_couplings(
    dealii::DynamicSparsityPattern &pattern) const
  {
    tractions.add_couplings(pattern);
  }



  template <int dim>
  void
  ContactAssembler<dim>::measure(const Vector &u)
  {
    bool anything_new = false;
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        if (!share.is_own(e))
          continue;
        const ElementView<dim> element(table_, table_.elements[e]);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            const unsigned int point = element.point(q);
            dealii::Point<dim> x     = table_.position[point];
            element.add_displacement(q, u, x);
            // A tangent is often wanted where the residual was.
            if (x == position[point])
              continue;
            anything_new    = true;
            position[point] = x;
            gap[point]      = obstacle->gap(x - offset, hint[point]);
          }
      }
    if (!share.ranks.all(!anything_new))
      share_measured();
  }



  template <int dim>
  void
  ContactAssembler<dim>::share_measured()
  {
    struct Measured
    {
      dealii::Point<dim>     position;
      dealii::Point<dim - 1> hint;
      GapPoint<dim>          gap;
    };
    if (!share.ranks.are_several())
      return;
    std::vector<Measured> measured(gap.size());
    for (unsigned int q = 0; q < gap.size(); ++q)
      measured[q] = {position[q], hint[q], gap[q]};
    share.ranks.share(share.owner, measured);
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        position[q] = measured[q].position;
        hint[q]     = measured[q].hint;
        gap[q]      = measured[q].gap;
      }
  }



  template <int dim>
  void
  ContactAssembler<dim>::set_pressures()
  {
    std::vector<double> gaps(gap.size());
    for (unsigned int q = 0; q < gap.size(); ++q)
      gaps[q] = gap[q].gap;
    const std::vector<double> mean_gap = tractions.means(gaps);
    std::vector<double>       values(mean_gap.size());
    for (unsigned int a = 0; a < values.size(); ++a)
      {
        traction_pressure[a] = law.evaluate(mean_gap[a], multiplier[a]);
        values[a]            = traction_pressure[a].value;
      }
    point_pressure = tractions.at_points(values);
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_residual(Vector &residual) const
  {
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        if (!share.is_own(e))
          continue;
        const ElementView<dim> element(table_, table_.elements[e]);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            const unsigned int point = element.point(q);
            if (point_pressure[point] != 0.)
              element.add_force(q,
                                -point_pressure[point] * element.JxW(q) *
                                  gap[point].normal,
                                residual);
          }
      }
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_stiffness(Matrix &tangent) const
  {
    typename TractionSpace<dim>::Vectors n(gap.size()), t(gap.size());
    std::vector<double> turning(gap.size()), factors(tractions.size());
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        for (unsigned int q = 0; q < gap.size(); ++q)
          {
            t[q]       = gap[q].direction[k];
            turning[q] = -point_pressure[q] * gap[q].normal_rotation(k);
          }
        tractions.add_pointwise(turning, t, t, tangent);
      }
    for (unsigned int q = 0; q < gap.size(); ++q)
      n[q] = gap[q].normal;
    for (unsigned int a = 0; a < factors.size(); ++a)
      factors[a] = -traction_pressure[a].slope;
    tractions.add_stiffness(factors, n, n, tangent);
  }



  template <int dim>
  bool
  ContactAssembler<dim>::add(const Vector &u, Vector &residual, Matrix *tangent)
  {
    measure(u);
    set_pressures();
    add_residual(residual);
    if (tangent != nullptr)
      add_stiffness(*tangent);
    if (shear_)
      add_shear(residual, tangent);
    return true;
  }



  template <int dim>
  void
  ContactAssembler<dim>::add_shear(Vector &residual, Matrix *tangent)
  {
    std::vector<dealii::Point<dim>> seen_from_obstacle = position;
    for (dealii::Point<dim> &x : seen_from_obstacle)
      x -= offset;
    shear_->evaluate(seen_from_obstacle, gap, traction_pressure);
    shear_->add_residual(residual);
    if (tangent == nullptr)
      return;
    if (shear_tangent.empty())
      {
        dealii::DynamicSparsityPattern pattern(residual.size());
        add_couplings(pattern);
        shear_couplings.copy_from(pattern);
        shear_tangent.reinit(shear_couplings);
      }
    shear_tangent = 0.;
    shear_->add_stiffness(*tangent, shear_tangent);
  }



  template <int dim>
  const Matrix *
  ContactAssembler<dim>::unsymmetric_tangent() const
  {
    return shear_ ? &shear_tangent : nullptr;
  }



  template <int dim>
  void
  ContactAssembler<dim>::set_obstacle_offset(const Tensor<1, dim> &new_offset)
  {
    offset = new_offset;
    position.assign(position.size(), nowhere<dim>());
  }



  template <int dim>
  void
  ContactAssembler<dim>::augment()
  {
    for (unsigned int a = 0; a < multiplier.size(); ++a)
      multiplier[a] = traction_pressure[a].value;
  }



  template <int dim>
  const std::vector<double> &
  ContactAssembler<dim>::multipliers() const
  {
    return multiplier;
  }



  template <int dim>
  void
  ContactAssembler<dim>::set_multipliers(const std::vector<double> &multipliers)
  {
    AssertDimension(multipliers.size(), multiplier.size());
    multiplier = multipliers;
  }



  template <int dim>
  const std::vector<dealii::Point<dim - 1>> &
  ContactAssembler<dim>::hints() const
  {
    return hint;
  }



  template <int dim>
  void
  ContactAssembler<dim>::set_hints(
    const std::vector<dealii::Point<dim - 1>> &hints)
  {
    AssertDimension(hints.size(), hint.size());
    hint = hints;
  }



  // Of the members that are defined here.
  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace asperity
