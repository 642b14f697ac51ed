#include <asperity/contact/shear_traction.h>

#include <cmath>

namespace asperity
{
  using dealii::Tensor;

  template <int dim>
  const std::vector<double> &
  ShearTraction<dim>::at_points(const unsigned int k) const
  {
    return point_traction[k];
  }



  template <int dim>
  double
  ShearTraction<dim>::size_at(const unsigned int point) const
  {
    Tensor<1, dim - 1> tau;
    for (unsigned int k = 0; k < dim - 1; ++k)
      tau[k] = point_traction[k][point];
    return tau.norm();
  }



  template <int dim>
  const std::vector<SlipPoint<dim>> &
  ShearTraction<dim>::slip() const
  {
    return slip_;
  }



  template <int dim>
  void
  ShearTraction<dim>::sum_up(Tensor<1, dim> &force, double &sticking_part) const
  {
    const std::vector<double> sticks = sticking();
    double                    stuck = 0., all = 0.;
    for (unsigned int q = 0; q < slip_.size(); ++q)
      {
        Tensor<1, dim - 1> load;
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            load[k] = point_traction[k][q] * table.JxW[q];
            force -= load[k] * slip_[q].tangent[k];
          }
        stuck += sticks[q] * load.norm();
        all += load.norm();
      }
    sticking_part = all > 0. ? stuck / all : 0.;
  }



  template <int dim>
  std::vector<double>
  ShearTraction<dim>::dissipation() const
  {
    std::vector<double> work(pressure.size(), 0.);
    for (unsigned int k = 0; k < dim - 1; ++k)
      for (unsigned int a = 0; a < work.size(); ++a)
        work[a] +=
          traction[k][a] *
          (mean_slip[k][a] -
           (traction[k][a] - start.tractions[k * work.size() + a]) / penalty);
    return tractions.at_points(work);
  }



  template <int dim>
  std::vector<double>
  ShearTraction<dim>::sticking() const
  {
    std::vector<double> stuck(pressure.size());
    for (unsigned int a = 0; a < stuck.size(); ++a)
      {
        bool bears = false;
        for (unsigned int k = 0; k < dim - 1; ++k)
          bears = bears || traction[k][a] != 0.;
        stuck[a] = sticks[a] && bears ? 1. : 0.;
      }
    return tractions.at_points(stuck);
  }



  // Of the members that are defined here.
  template class ShearTraction<2>;
  template class ShearTraction<3>;
} // namespace asperity
