#include <asperity/splines/closest_point_on_sheet.h>
#include <asperity/splines/sheet_certificate.h>
#include <asperity/splines/sheet_distance.h>
#include <asperity/splines/sheet_pieces.h>

#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  struct ClosestPointOnSheet::Implementation
  {
    Implementation(const SplineSheet &sheet, const SheetSide free_side)
      : sheet(sheet)
      , pieces(sheet)
      , side(free_side)
    {}

    /** The place that is closest among the guess, the place above or below,
     *  and, of a point further away than a period, the lowest or highest one:
     *  from there the certificate has far less to look at. */
    SheetFoot
    start_of(const SheetDistance &distance, const Point<2> *guess) const;

    SheetProjection
    project(const Point<3> &point, const Point<2> *guess) const;

    SheetProjection
    describe(const Point<3> &point, const SheetFoot &foot) const;

    SplineSheet sheet;
    SheetPieces pieces;
    SheetSide   side;
  };



  SheetFoot
  ClosestPointOnSheet::Implementation::start_of(const SheetDistance &distance,
                                                const Point<2> *guess) const
  {
    const Point<3> &point = distance.point();
    SheetFoot       best  = distance.foot(point[0], point[1]);
    const auto      look  = [&](const double x, const double y) {
      const double place[] = {x, y};
      double       nearest[2];
      for (unsigned int d = 0; d < 2; ++d)
        nearest[d] =
          place[d] + pieces.period(d) *
                       std::round((point[d] - place[d]) / pieces.period(d));
      const SheetFoot foot = distance.foot(nearest[0], nearest[1]);
      if (foot.squared_distance() < best.squared_distance())
        best = foot;
    };
    if (guess != nullptr)
      look((*guess)[0], (*guess)[1]);
    if (std::abs(best.rz) > std::min(pieces.period(0), pieces.period(1)))
      {
        const auto &place =
          best.rz > 0. ? pieces.lowest_place() : pieces.highest_place();
        look(place[0], place[1]);
      }
    return best;
  }



  SheetProjection
  ClosestPointOnSheet::Implementation::project(const Point<3> &point,
                                               const Point<2> *guess) const
  {
    const SheetDistance distance(pieces, point);
    const SheetFoot     start = start_of(distance, guess);
    if (!std::isfinite(start.squared_distance()))
      return describe(point, start);
    SheetCertificate certificate(pieces, distance, distance.minimize(start));
    const bool       certified  = certificate.prove();
    SheetProjection  projection = describe(point, certificate.best());
    projection.certified        = certified;
    // The search of all pieces found nothing better either.
    projection.converged = certified || certificate.best().converged;
    return projection;
  }



  SheetProjection
  ClosestPointOnSheet::Implementation::describe(const Point<3>  &point,
                                                const SheetFoot &foot) const
  {
    const SheetJet &jet    = foot.jet;
    const double    metric = 1. + jet.gradient.norm_square();
    const double nz = (side == SheetSide::below ? -1. : 1.) / std::sqrt(metric);
    SheetProjection projection;
    projection.parameters = Point<2>(foot.x, foot.y);
    projection.point      = Point<3>(foot.x, foot.y, point[2] + foot.rz);
    projection.iterations = foot.iterations;
    projection.converged  = foot.converged;
    projection.normal[0]  = -nz * jet.gradient[0];
    projection.normal[1]  = -nz * jet.gradient[1];
    projection.normal[2]  = nz;
    projection.distance =
      -(foot.rx * projection.normal[0] + foot.ry * projection.normal[1] +
        foot.rz * projection.normal[2]);

    // The second fundamental form B = n_z Hess s of the tangents (1, 0, s_x)
    // and (0, 1, s_y), in the orthonormal ones a and b that these make.
    const double along  = std::sqrt(1. + jet.gradient[0] * jet.gradient[0]);
    const double across = std::sqrt(metric) / along;
    const double mixed  = jet.gradient[0] * jet.gradient[1] / along;
    Tensor<1, 3> a, b;
    a[0] = 1. / along;
    a[2] = jet.gradient[0] / along;
    b[1] = 1.;
    b[2] = jet.gradient[1];
    b    = (b - mixed * a) / across;
    Tensor<2, 2> to_orthonormal;
    to_orthonormal[0][0] = 1. / along;
    to_orthonormal[1][0] = -mixed / (along * across);
    to_orthonormal[1][1] = 1. / across;
    const SymmetricTensor<2, 2> bend =
      symmetrize(to_orthonormal * Tensor<2, 2>(nz * jet.hessian) *
                 transpose(to_orthonormal));
    const auto principal =
      eigenvectors(bend, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned int k = 0; k < 2; ++k)
      {
        projection.curvature[k] = principal[k].first;
        projection.direction[k] =
          principal[k].second[0] * a + principal[k].second[1] * b;
      }
    return projection;
  }



  SymmetricTensor<2, 3>
  SheetProjection::normal_gradient() const
  {
    SymmetricTensor<2, 3> gradient;
    for (unsigned int k = 0; k < 2; ++k)
      gradient += -curvature[k] / (1. - curvature[k] * distance) *
                  symmetrize(outer_product(direction[k], direction[k]));
    return gradient;
  }



  ClosestPointOnSheet::ClosestPointOnSheet(const SplineSheet &sheet,
                                           const SheetSide    free_side)
    : implementation(std::make_unique<const Implementation>(sheet, free_side))
  {}



  ClosestPointOnSheet::~ClosestPointOnSheet() = default;



  const SplineSheet &
  ClosestPointOnSheet::sheet() const
  {
    return implementation->sheet;
  }



  SheetProjection
  ClosestPointOnSheet::project(const Point<3> &point) const
  {
    return implementation->project(point, nullptr);
  }



  SheetProjection
  ClosestPointOnSheet::project(const Point<3> &point,
                               const Point<2> &guess) const
  {
    return implementation->project(point, &guess);
  }
} // namespace asperity
