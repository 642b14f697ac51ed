#ifndef asperity_splines_sheet_certificate_h
#define asperity_splines_sheet_certificate_h

#include <asperity/splines/sheet_distance.h>

#include <array>

namespace asperity
{
  /**
   * Proves that no point of a sheet is closer than the best one known, or finds
   * the closer one.
   *
   * Let F be stationary (a foot of the point P at the height r above P), and Q
   * be the place tau away from F in the direction e. With Taylor's remainder q
   * of s,
   *   |Q - P|^2 - |F - P|^2 = tau^2 + (tau e.grad s + q)^2 + 2 r q.
   * So no place is closer along which r e.Hess s e > -1; and, with the Hessian
   * H of half the squared distance at F, none within
   *   lambda_min(H)/(|r| change/3 + |grad s| |Hess s|_max).
   * Only places within the circle around P with the best distance count.
   */
  class SheetCertificate
  {
  public:
    /** @param known a stationary point, as far as it has converged */
    SheetCertificate(const SheetPieces   &pieces,
                     const SheetDistance &distance,
                     const SheetFoot     &known);

    /** The best point is the closest one, up to round-off. Examines the pieces
     *  where the proof does not follow from the known point alone. */
    bool
    prove();

    const SheetFoot &
    best() const
    {
      return best_foot;
    }

  private:
    static constexpr unsigned int max_degree  = SheetPieces::max_degree;
    static constexpr unsigned int max_circles = 8;

    /** Around a foot: no place within is closer than the foot itself. */
    struct Circle
    {
      double x = 0., y = 0., radius = 0.;
      double low[2], high[2]; ///< where this holds only, if not everywhere
    };

    /** A part of a piece seen from the point: control heights, rectangle. */
    struct Part
    {
      double heights[(max_degree + 1) * (max_degree + 1)];
      double low[2], high[2];
    };

    Circle
    circle_around(const SheetFoot &foot) const;

    SheetBending
    bending_within(const double radius) const;

    bool
    examine_all();

    /** @return whether the search may go on
     *  @param begin, end spans of one block along x and y */
    bool
    examine_block(const std::array<long, 2> &begin,
                  const std::array<long, 2> &end);

    void
    examine(const long span_x, const long span_y);

    void
    search(const Part &part, const unsigned int depth);

    bool
    in_a_circle(const Part &part) const;

    bool
    is_beyond_tangent_plane(const Part &part) const;

    /** Of the squared distance, of twice the degree, and its round-off. */
    double
    form_squared_distance(const Part &part, double *coefficients) const;

    /** The squared distance rises or falls everywhere along one direction. */
    bool
    is_monotonic(const double *coefficients, const double noise) const;

    /** Starts from the middle of a part. */
    void
    look_for_better(const Part &part, const unsigned int depth);

    const SheetPieces              &pieces;
    const SheetDistance            &distance;
    const unsigned int              p, q;
    SheetFoot                       best_foot;
    double                          best_squared_distance;
    std::array<Circle, max_circles> circles;
    unsigned int                    n_circles = 0;
    unsigned int                    n_parts   = 0;
  };
} // namespace asperity

#endif
