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

    /** From the better one of the guess and the place above or below. */
    SheetProjection
    project(const Point<3> &point, const Point<2> *guess) const;

    SheetProjection
    describe(const Point<3> &point, const SheetFoot &foot) const;

    SplineSheet sheet;
    SheetPieces pieces;
    SheetSide   side;
  };



  SheetProjection
  ClosestPointOnSheet::Implementation::project(const Point<3> &point,
                                               const Point<2> *guess) const
  {
    const SheetDistance distance(pieces, point);
    SheetFoot           start = distance.foot(point[0], point[1]);
    if (!std::isfinite(start.squared_distance()))
      return describe(point, start);
    if (guess != nullptr)
      {
        double place[2];
        for (unsigned int d = 0; d < 2; ++d)
          place[d] = (*guess)[d] +
                     pieces.period(d) *
                       std::round((point[d] - (*guess)[d]) / pieces.period(d));
        const SheetFoot guessed = distance.foot(place[0], place[1]);
        if (guessed.squared_distance() < start.squared_distance())
          start = guessed;
      }
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

    // With tangents T = (1, 0, s_x), (0, 1, s_y), metric G and second
    // fundamental form B = n_z Hess s, moving the point by dP moves the foot by
    // (G - d B)^-1 T^T dP and turns the normal by -T G^-1 B times that.
    const SymmetricTensor<2, 2> B = nz * jet.hessian;
    SymmetricTensor<2, 2>       G, M;
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = a; b < 2; ++b)
        G[a][b] = (a == b ? 1. : 0.) + jet.gradient[a] * jet.gradient[b];
    M = G - projection.distance * B;
    const Tensor<2, 2> turn =
      -1. * Tensor<2, 2>(invert(G)) * Tensor<2, 2>(B) * Tensor<2, 2>(invert(M));
    const double T[2][3] = {{1., 0., jet.gradient[0]},
                            {0., 1., jet.gradient[1]}};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = i; k < 3; ++k)
        {
          double sum = 0.;
          for (unsigned int a = 0; a < 2; ++a)
            for (unsigned int b = 0; b < 2; ++b)
              sum += T[a][i] * turn[a][b] * T[b][k];
          projection.normal_gradient[i][k] = sum;
        }
    return projection;
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
