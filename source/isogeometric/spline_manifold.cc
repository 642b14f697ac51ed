#include <asperity/isogeometric/spline_manifold.h>

namespace asperity
{
  SplineManifold::SplineManifold(const SplineCurve &curve)
    : closest_point(std::make_shared<const ClosestPoint>(curve))
  {}



  std::unique_ptr<dealii::Manifold<2, 2>>
  SplineManifold::clone() const
  {
    return std::make_unique<SplineManifold>(*this);
  }



  dealii::Point<1>
  SplineManifold::pull_back(const dealii::Point<2> &point) const
  {
    return dealii::Point<1>(closest_point->project(point).parameter);
  }



  dealii::Point<2>
  SplineManifold::push_forward(const dealii::Point<1> &parameter) const
  {
    return curve().value(parameter[0]);
  }



  dealii::DerivativeForm<1, 1, 2>
  SplineManifold::push_forward_gradient(const dealii::Point<1> &parameter) const
  {
    const auto derivatives = curve().derivatives(parameter[0], 1);
    dealii::DerivativeForm<1, 1, 2> gradient;
    for (unsigned int d = 0; d < 2; ++d)
      gradient[d][0] = derivatives[1][d];
    return gradient;
  }



  const SplineCurve &
  SplineManifold::curve() const
  {
    return closest_point->curve();
  }
} // namespace asperity
