#include <asperity/contact/shear_transfer.h>
#include <asperity/isogeometric/trace_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace asperity
{
  template <int dim>
  typename ShearTraction<dim>::History
  transfer_shear(const SplineHierarchy<dim>                 &from,
                 const SplineHierarchy<dim>                 &to,
                 const Edge                                  edge,
                 const ContactFormulation                    formulation,
                 const unsigned int                          points,
                 const typename ShearTraction<dim>::History &history,
                 const std::vector<dealii::Point<dim>>      &positions)
  {
    using Values = std::vector<double>;
    std::function<Values(const Values &)> moved;
    if (formulation == ContactFormulation::mortar)
      moved = [transfer = std::make_shared<TraceTransfer<dim>>(from, to, edge)](
                const Values &values) { return transfer->apply(values); };
    else
      moved = [&](const Values &values) {
        return transfer_edge_history(
          from, to, edge, dealii::QGauss<dim - 1>(points), values, 1);
      };
    typename ShearTraction<dim>::History result;
    result.positions = positions;
    result.pressures = moved(history.pressures);
    for (double &pressure : result.pressures)
      pressure = std::max(pressure, 0.);
    const std::size_t n = history.pressures.size();
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        const auto   begin     = history.tractions.begin() + k * n;
        const Values component = moved(Values(begin, begin + n));
        result.tractions.insert(result.tractions.end(),
                                component.begin(),
                                component.end());
      }
    return result;
  }



  template ShearTraction<2>::History
  transfer_shear(const SplineHierarchy<2> &,
                 const SplineHierarchy<2> &,
                 const Edge,
                 const ContactFormulation,
                 const unsigned int,
                 const ShearTraction<2>::History &,
                 const std::vector<dealii::Point<2>> &);
  template ShearTraction<3>::History
  transfer_shear(const SplineHierarchy<3> &,
                 const SplineHierarchy<3> &,
                 const Edge,
                 const ContactFormulation,
                 const unsigned int,
                 const ShearTraction<3>::History &,
                 const std::vector<dealii::Point<3>> &);
} // namespace asperity
