#ifndef asperity_splines_curve_pieces_h
#define asperity_splines_curve_pieces_h

#include <asperity/splines/spline_curve.h>

#include <vector>

namespace asperity
{
  /** A place on a curve: s in [-1, 1] on a Bezier piece of a turn. */
  struct CurveLocation
  {
    unsigned int piece = 0;
    int          turn  = 0;
    double       s     = 0.;
  };



  /** Half the squared distance between a curve and a point, with its
   * derivatives with respect to s, and what they are made of. */
  struct DistanceJet
  {
    double rx = 0., ry = 0.; ///< curve minus point [m]
    double x1 = 0., y1 = 0.; ///< dC/ds
    double x2 = 0., y2 = 0.; ///< d2C/ds2

    double
    squared_distance() const
    {
      return rx * rx + ry * ry;
    }

    double
    squared_speed() const
    {
      return x1 * x1 + y1 * y1;
    }

    double
    gradient() const
    {
      return rx * x1 + ry * y1;
    }

    double
    hessian() const
    {
      return squared_speed() + rx * x2 + ry * y2;
    }
  };



  /**
   * A curve as a table of polynomials about the middle of its pieces, which
   * evaluates in some ten nanoseconds, and the way from one piece to the next.
   */
  class CurvePieces
  {
  public:
    static constexpr unsigned int max_degree = 10;

    /** @throws InputError if the degree exceeds max_degree. */
    explicit CurvePieces(const SplineCurve &curve);

    unsigned int
    size() const
    {
      return half_width.size();
    }

    CurveLocation
    locate(const double parameter) const;

    double
    parameter(const CurveLocation &location) const;

    /** The curve at a location seen from (px, py). */
    DistanceJet
    jet(const CurveLocation &location, const double px, const double py) const;

    /** Goes over the end of a piece in the direction +1 or -1, to the beginning
     *  of the next one. Closed and periodic curves go on.
     *  @return false, and nothing changes, at the end of an open curve */
    bool
    step_over(CurveLocation &location, const int direction) const;

    /** dt/ds on a piece. */
    double
    parameter_scale(const unsigned int piece) const
    {
      return half_width[piece];
    }

    /** Homogeneous Bernstein coefficients: degree + 1 triples (w x, w y, w). */
    const double *
    bernstein(const unsigned int piece) const
    {
      return bernstein_table.data() + 3 * (p + 1) * std::size_t(piece);
    }

    unsigned int
    degree() const
    {
      return p;
    }

    bool
    is_rational() const
    {
      return rational;
    }

    /** Largest coordinate [m]: round-off of a position is 1e-16 of it. */
    double
    magnitude() const
    {
      return largest_coordinate;
    }

    /** Diagonal of the bounding box of one turn's control points [m]. */
    double
    extent() const
    {
      return box_diagonal;
    }

    const dealii::Tensor<1, 2> &
    period() const
    {
      return turn_shift;
    }

  private:
    template <unsigned int P>
    void
    evaluate(const double *table, const double s, DistanceJet &jet) const;

    void
    evaluate_rational(const double *table,
                      const double  s,
                      DistanceJet  &jet) const;

    KnotVector           knots;
    unsigned int         p        = 1;
    bool                 rational = false;
    bool                 periodic = false;
    bool                 closed = false; ///< the last piece leads to the first
    double               largest_coordinate = 0.;
    double               box_diagonal       = 0.;
    dealii::Tensor<1, 2> turn_shift;
    std::vector<double>  middle, half_width;
    std::vector<double>  bernstein_table;
    std::vector<double>  power_table; ///< as above, for powers of s
  };
} // namespace asperity

#endif
