#ifndef asperity_splines_closest_point_on_sheet_h
#define asperity_splines_closest_point_on_sheet_h

#include <asperity/splines/spline_sheet.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>

namespace asperity
{
  /** The side of a sheet on which distances are positive and to which normals
   *  point: the free side. For a tool above the chip that is `below`. */
  enum class SheetSide
  {
    below,
    above
  };



  /** The point of a sheet that is closest to a given point. */
  struct SheetProjection
  {
    dealii::Point<2> parameters; ///< (x, y) of the point [m], of any turn
    dealii::Point<3> point;      ///< (x, y, s(x, y)) [m]

    /** Distance [m], positive on the free side. */
    double distance = 0.;

    /** Gradient of `distance` with respect to the given point: the unit normal
     *  of the sheet to the free side. */
    dealii::Tensor<1, 3> normal;

    /** Principal directions t of the sheet, of unit length, and its curvatures
     *  k along them [1/m], positive where it bends to the free side (valley).
     */
    std::array<dealii::Tensor<1, 3>, 2> direction;
    std::array<double, 2>               curvature{};

    /** Gradient of `normal` with respect to the given point [1/m], the sum of
     *  -k/(1 - k distance) t t^T; zero along the normal. Infinite where the
     *  closest point is about to split in two. */
    dealii::SymmetricTensor<2, 3>
    normal_gradient() const;

    unsigned int iterations = 0;

    /** A local minimum of the distance was found to round-off. */
    bool converged = false;

    /** Proved: no point of the sheet is closer (up to round-off). */
    bool certified = false;
  };



  /**
   * Closest-point projection on a periodic sheet of degree 2 to 7, which has
   * no edges, so that closest points are stationary.
   *
   * A local minimum is found by Newton's method (the Hessian made positive,
   * Armijo line search) from the guess or from the point of the sheet above or
   * below the given one, whichever is closer. The certificate rests on Taylor's
   * theorem along the line from there to any other place (x, y): bounds of the
   * second and third derivatives give a radius within which no point is closer,
   * for a near point mostly all that could be. Else the Bezier pieces whose box
   * is within the distance found are searched as those of ClosestPoint, by the
   * coefficients of the squared distance and of its derivatives.
   *
   * project() does not allocate memory and is thread-safe. A point that is not
   * finite, or a thousand periods away, or so special (centre of a sphere) that
   * the search becomes too long, gives `certified = false`.
   */
  class ClosestPointOnSheet
  {
  public:
    /** @throws InputError if a degree is not 2 to 7. */
    explicit ClosestPointOnSheet(const SplineSheet &sheet,
                                 const SheetSide free_side = SheetSide::below);

    ~ClosestPointOnSheet();

    const SplineSheet &
    sheet() const;

    SheetProjection
    project(const dealii::Point<3> &point) const;

    /** As above, starting from a place (x, y), of any turn, that is thought to
     *  be near. */
    SheetProjection
    project(const dealii::Point<3> &point, const dealii::Point<2> &guess) const;

  private:
    struct Implementation;
    std::unique_ptr<const Implementation> implementation;
  };
} // namespace asperity

#endif
