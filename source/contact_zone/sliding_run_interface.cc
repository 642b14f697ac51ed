#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/sliding_run.h>

#include <algorithm>

namespace asperity
{
  template <int dim>
  void
  SlidingRun<dim>::warm_oil()
  {
    const LubricantParameters &oil = parameters.lubrication.oil;
    if (scene.lubricant && oil.temperature.law != TemperatureLaw::none)
      scene.lubricant->set_oil(
        oil.at(oil_temperature(), parameters.load.temperature));
  }



  template <int dim>
  double
  SlidingRun<dim>::oil_temperature() const
  {
    const double tool = scene.heat ? scene.heat->mean_tool_temperature() :
                                     parameters.load.temperature;
    return 0.5 * (tool + scene.interface_temperature());
  }



  template <int dim>
  void
  SlidingRun<dim>::renew_interface()
  {
    ShearTraction<dim> *shear = scene.contact->shear();
    if (shear == nullptr)
      return;
    std::vector<double> k(state_.coverage.size(), 0.);
    if (parameters.interface.uses_shear_strength())
      k = shear_strength();
    shear->set_interface(k, state_.coverage);
  }



  template <int dim>
  std::vector<double>
  SlidingRun<dim>::shear_strength() const
  {
    std::vector<double> k = scene.shear_strength(
      parameters.load.velocity / parameters.interface.shear_layer);
    const std::vector<double> stretch = scene.contact->stretch(state_.u);
    for (unsigned int q = 0; q < k.size(); ++q)
      k[q] *= stretch[q];
    return k;
  }



  template <int dim>
  std::vector<double>
  SlidingRun<dim>::frictional_power(const double dt) const
  {
    const ShearTraction<dim> *shear = scene.contact->shear();
    if (shear == nullptr)
      return std::vector<double>(scene.contact->table().JxW.size(), 0.);
    std::vector<double> power = shear->dissipation();
    for (double &value : power)
      value /= dt;
    return power;
  }



  template <int dim>
  void
  SlidingRun<dim>::record_interface(FrictionRow &row) const
  {
    const ContactState<dim> contact   = scene.contact->state();
    const double            direction = protocol_.direction(row.time);
    const LineLoad          shear     = per_width(contact.shear_force);
    row.interface_T_x                 = shear.along;
    row.interface_T_y                 = shear.up;
    row.interface_shear =
      friction_coefficient(row.interface_T_x, row.T_y, direction);
    row.oil_shear = friction_coefficient(row.shear_T_x, row.T_y, direction);
    row.ploughing = row.mu - row.interface_shear - row.oil_shear;
    row.sticking  = contact.sticking;
    const CurrentContact current = scene.contact->current_state(state_.u);
    row.touching_length          = current.length / scene.width;
    row.real_contact_pressure    = current.mean_pressure;
    row.max_contact_pressure     = current.max_pressure;
  }



  template <int dim>
  void
  SlidingRun<dim>::record_lubricant(FrictionRow &row) const
  {
    const LubricantState       oil   = scene.lubricant->state();
    const dealii::Tensor<1, 2> force = oil.pressure_force + oil.shear_force;
    row.T_x += force[0];
    row.T_y += force[1];
    row.T_transverse += oil.transverse;
    row.oil_pressure         = oil.mean_pressure;
    row.max_oil_pressure     = oil.max_pressure;
    row.oil_T_x              = oil.pressure_force[0];
    row.shear_T_x            = oil.shear_force[0];
    row.shear_T_y            = oil.shear_force[1];
    row.void_volume          = oil.void_volume;
    row.oil_volume           = oil.oil_volume;
    row.oil_reference_volume = oil.reference_volume;
    row.oil_in               = oil.oil_in;
    row.oil_out              = oil.oil_out;
    row.pockets              = oil.n_pockets;
    row.coupling_iterations  = oil.coupling_iterations;
  }



  // Of the members that are defined here.
  template class SlidingRun<2>;
  template class SlidingRun<3>;
} // namespace asperity
