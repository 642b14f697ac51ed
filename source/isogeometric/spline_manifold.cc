#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
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



  void
  set_spline_wall(dealii::Triangulation<2>        &mesh,
                  const dealii::types::boundary_id wall,
                  const SplineCurve               &curve)
  {
    const SplineManifold manifold(curve);
    for (const auto &face : mesh.active_face_iterators())
      {
        if (!face->at_boundary() || face->boundary_id() != wall)
          continue;
        for (const unsigned int v : face->vertex_indices())
          {
            const dealii::Point<2> X = face->vertex(v);
            const double           distance =
              X.distance(manifold.push_forward(manifold.pull_back(X)));
            if (distance > 1e-6 * face->diameter())
              throw InputError("A vertex of a mesh at (" + format_number(X[0]) +
                               ", " + format_number(X[1]) + ") m is " +
                               format_number(distance) +
                               " m off the spline of its wall; expected one "
                               "on it.");
          }
        face->set_manifold_id(wall);
      }
    mesh.set_manifold(wall, manifold);
  }
} // namespace asperity
