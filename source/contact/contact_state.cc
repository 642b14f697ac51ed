#include <asperity/contact/contact_assembler.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>
#include <array>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  template <int dim>
  std::vector<double>
  ContactAssembler<dim>::stretch(const Vector &u) const
  {
    std::vector<double> result(table_.JxW.size());
    for (const auto &entry : table_.elements)
      {
        const ElementView<dim> element(table_, entry);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            std::array<Tensor<1, dim>, dim - 1> t;
            for (unsigned int k = 0; k < dim - 1; ++k)
              {
                t[k] = table_.tangent[(dim - 1) * element.point(q) + k];
                element.add_stretch(q, u, t[k], k);
              }
            if constexpr (dim == 2)
              result[element.point(q)] = t[0].norm();
            else
              result[element.point(q)] =
                dealii::cross_product_3d(t[0], t[1]).norm();
          }
      }
    return result;
  }



  template <int dim>
  std::vector<bool>
  ContactAssembler<dim>::touching() const
  {
    // A mortar pressure reaches a support beyond the touching points; those
    // touch where the penalty law alone would press. A hard mortar contact
    // closes gaps in the mean over a function only, and its points open and
    // close at random; but where every function presses, all of them touch.
    std::vector<double> pressures(tractions.size());
    for (unsigned int a = 0; a < pressures.size(); ++a)
      pressures[a] = traction_pressure[a].value;
    const std::vector<bool> inside = tractions.inside(pressures);
    std::vector<bool>       touches(gap.size());
    for (unsigned int q = 0; q < gap.size(); ++q)
      touches[q] =
        inside[q] || (point_pressure[q] > 0. &&
                      law.evaluate(gap[q].gap, point_pressure[q]).value > 0.);
    return touches;
  }



  template <int dim>
  ContactState<dim>
  ContactAssembler<dim>::state() const
  {
    ContactState<dim>       state;
    const std::vector<bool> touches = touching();
    double                  length = 0., touching_length = 0.;
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        const double p = point_pressure[q];
        length += table_.JxW[q];
        if (touches[q])
          touching_length += table_.JxW[q];
        state.force += p * table_.JxW[q] * gap[q].normal;
        state.max_pressure = std::max(state.max_pressure, p);
        state.mean_gap += std::max(gap[q].gap, 0.) * table_.JxW[q];
        state.max_penetration = std::max(state.max_penetration, -gap[q].gap);
      }
    if (shear_)
      shear_->sum_up(state.shear_force, state.sticking);
    state.force += state.shear_force;
    for (unsigned int a = 0; a < multiplier.size(); ++a)
      state.constraint_violation =
        std::max(state.constraint_violation,
                 std::abs(traction_pressure[a].value - multiplier[a]) /
                   options_.penalty);
    state.contact_fraction = touching_length / length;
    state.mean_gap /= length;
    return state;
  }



  template <int dim>
  CurrentContact
  ContactAssembler<dim>::current_state(const Vector &u) const
  {
    CurrentContact            state;
    const std::vector<bool>   touches  = touching();
    const std::vector<double> stretch_ = stretch(u);
    double                    force    = 0.;
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        const double p = point_pressure[q];
        force += p * table_.JxW[q];
        state.max_pressure = std::max(state.max_pressure, p / stretch_[q]);
        if (touches[q])
          state.length += stretch_[q] * table_.JxW[q];
      }
    if (state.length > 0.)
      state.mean_pressure = force / state.length;
    return state;
  }



  template <int dim>
  const BasisTable<dim> &
  ContactAssembler<dim>::table() const
  {
    return table_;
  }



  template <int dim>
  const std::vector<double> &
  ContactAssembler<dim>::pressure() const
  {
    return point_pressure;
  }



  template <int dim>
  const std::vector<GapPoint<dim>> &
  ContactAssembler<dim>::gaps() const
  {
    return gap;
  }



  template <int dim>
  const std::vector<dealii::Point<dim>> &
  ContactAssembler<dim>::positions() const
  {
    return position;
  }



  template <int dim>
  const ContactOptions &
  ContactAssembler<dim>::options() const
  {
    return options_;
  }



  template <int dim>
  ShearTraction<dim> *
  ContactAssembler<dim>::shear()
  {
    return shear_ ? &*shear_ : nullptr;
  }



  template <int dim>
  const ShearTraction<dim> *
  ContactAssembler<dim>::shear() const
  {
    return shear_ ? &*shear_ : nullptr;
  }



  // Of the members that are defined here.
  template class ContactAssembler<2>;
  template class ContactAssembler<3>;
} // namespace asperity
