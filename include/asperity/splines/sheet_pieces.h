#ifndef asperity_splines_sheet_pieces_h
#define asperity_splines_sheet_pieces_h

#include <asperity/splines/spline_sheet.h>

#include <array>
#include <vector>

namespace asperity
{
  /** Bounds of second and third derivatives of a sheet on one piece or some. */
  struct SheetBending
  {
    double least    = 0.; ///< of the Hessian's eigenvalues [1/m]
    double greatest = 0.; ///< of the Hessian's eigenvalues [1/m]
    double change   = 0.; ///< |H(a) - H(b)| <= change |a - b| [1/m^2]

    /** The bounds of both; of a plane to begin with. */
    void
    include(const SheetBending &other);
  };



  /**
   * A sheet as a table of polynomials about the middle of its pieces, which
   * evaluates in some tens of nanoseconds, with bounds of each piece. Spans of
   * all turns are numbered through: span i + k n is span i of turn k.
   */
  class SheetPieces
  {
  public:
    static constexpr unsigned int max_degree = 7;

    /** @throws InputError if a degree is less than 2, so that the sheet has
     *  edges, or exceeds max_degree. */
    explicit SheetPieces(const SplineSheet &sheet);

    /** As SplineSheet::jet(). */
    SheetJet
    jet(const double x, const double y) const;

    unsigned int
    degree(const unsigned int direction) const
    {
      return axes[direction].degree;
    }

    double
    period(const unsigned int direction) const
    {
      return axes[direction].period;
    }

    /** Mean width of the spans [m]. */
    double
    mean_width(const unsigned int direction) const
    {
      return 1. / axes[direction].spans_per_length;
    }

    /** The span of any turn that holds a place. */
    long
    span(const unsigned int direction, const double t) const;

    /** Where a span of any turn begins [m]. */
    double
    begin(const unsigned int direction, const long span) const;

    /** Index of the piece of two spans of any turns. */
    std::size_t
    piece(const long span_x, const long span_y) const;

    /** Blocks of neighbouring pieces, for a first look at many: the first span
     *  of any turn after the block of this one. */
    long
    end_of_block(const unsigned int direction, const long span) const;

    /** Lowest and highest control height of the block of a piece [m]. */
    const std::array<double, 2> &
    block_bounds(const std::size_t piece) const
    {
      return blocks[block_of[piece]];
    }

    /** Control heights [m], as SheetPiece. */
    const double *
    heights(const std::size_t piece) const
    {
      return bernstein.data() + piece * n_coefficients;
    }

    double
    lowest(const std::size_t piece) const
    {
      return height_bounds[2 * piece];
    }

    double
    highest(const std::size_t piece) const
    {
      return height_bounds[2 * piece + 1];
    }

    const SheetBending &
    bending(const std::size_t piece) const
    {
      return bendings[piece];
    }

    /** Of all pieces. */
    const SheetBending &
    bending() const
    {
      return all_bending;
    }

    double
    lowest() const
    {
      return all_lowest;
    }

    double
    highest() const
    {
      return all_highest;
    }

    /** The middle of the piece that holds the lowest control height, in the
     *  first turn. */
    const std::array<double, 2> &
    lowest_place() const
    {
      return place_of_lowest;
    }

    const std::array<double, 2> &
    highest_place() const
    {
      return place_of_highest;
    }

  private:
    static constexpr unsigned int spans_of_block = 8; ///< in each direction

    struct Axis
    {
      unsigned int        degree = 0, n = 0;
      double              front = 0., period = 0., spans_per_length = 0.;
      std::vector<double> breakpoints, middle, inverse_half_width;

      /** Span of the first turn that holds the place, and where in [-1, 1]. */
      unsigned int
      locate(const double t, double &s) const;
    };

    std::array<double, 2>
    middle_of(const std::size_t piece) const;

    void
    build_blocks();

    template <unsigned int P, unsigned int Q>
    void
    evaluate(const double *table,
             const double  s,
             const double  t,
             double       *values) const;

    std::array<Axis, 2>       axes;
    std::size_t               n_coefficients = 0; ///< of a piece
    std::vector<double>       bernstein;
    std::vector<double>       powers; ///< of s and t in [-1, 1]
    std::vector<double>       height_bounds;
    std::vector<SheetBending> bendings;

    std::vector<unsigned int>          block_of; ///< of a piece
    std::vector<std::array<double, 2>> blocks;

    SheetBending          all_bending;
    double                all_lowest = 0., all_highest = 0.;
    std::array<double, 2> place_of_lowest{}, place_of_highest{};
  };
} // namespace asperity

#endif
