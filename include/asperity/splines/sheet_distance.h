#ifndef asperity_splines_sheet_distance_h
#define asperity_splines_sheet_distance_h

#include <asperity/splines/sheet_pieces.h>

#include <deal.II/base/point.h>

#include <cmath>

namespace asperity
{
  /** A place of a sheet as seen from a point, and half its squared distance
   *  with derivatives with respect to (x, y). */
  struct SheetFoot
  {
    double       x = 0., y = 0.;            ///< [m]
    double       rx = 0., ry = 0., rz = 0.; ///< sheet minus point [m]
    SheetJet     jet;
    unsigned int iterations = 0;
    bool         converged  = false; ///< the distance is a local minimum

    double
    squared_distance() const
    {
      return rx * rx + ry * ry + rz * rz;
    }

    dealii::Tensor<1, 2>
    gradient() const
    {
      dealii::Tensor<1, 2> g;
      g[0] = rx + rz * jet.gradient[0];
      g[1] = ry + rz * jet.gradient[1];
      return g;
    }

    /** 1 + grad s grad s^T + rz Hess s */
    dealii::SymmetricTensor<2, 2>
    hessian() const
    {
      dealii::SymmetricTensor<2, 2> h;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = a; b < 2; ++b)
          h[a][b] = (a == b ? 1. : 0.) + jet.gradient[a] * jet.gradient[b] +
                    rz * jet.hessian[a][b];
      return h;
    }
  };



  /** The smaller eigenvalue. */
  inline double
  least_eigenvalue(const dealii::SymmetricTensor<2, 2> &h)
  {
    return (h[0][0] + h[1][1]) / 2. -
           std::hypot((h[0][0] - h[1][1]) / 2., h[0][1]);
  }



  /**
   * A local minimum of the distance from a point to a sheet by Newton's method,
   * with the Hessian made positive definite and Armijo's condition.
   */
  class SheetDistance
  {
  public:
    SheetDistance(const SheetPieces &pieces, const dealii::Point<3> &point);

    SheetFoot
    foot(const double x, const double y) const;

    SheetFoot
    minimize(const SheetFoot &start) const;

    const dealii::Point<3> &
    point() const
    {
      return given_point;
    }

    /** Round-off of a position [m]. */
    double
    position_noise() const
    {
      return noise;
    }

  private:
    /** The distance is stationary to round-off. */
    bool
    stationary(const SheetFoot &foot) const;

    dealii::Tensor<1, 2>
    newton_step(const SheetFoot &foot) const;

    const SheetPieces     &pieces;
    const dealii::Point<3> given_point;
    const double           noise;
  };
} // namespace asperity

#endif
