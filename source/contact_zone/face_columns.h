#ifndef asperity_source_contact_zone_face_columns_h
#define asperity_source_contact_zone_face_columns_h

#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <array>
#include <utility>
#include <vector>

namespace asperity
{
  /** Columns of material points under a face that is periodic along x and y
   *  and whose cells, of different sizes, have n times n each, at Gauss
   *  points. */
  class FaceColumns
  {
  public:
    /** Numbers of columns and their weights, 1 in sum. */
    using Place = std::vector<std::pair<unsigned int, double>>;

    /** @param columns cell by cell, x fastest [m]
     *  @param n at least 2 */
    FaceColumns(const std::vector<dealii::Point<2>> &columns,
                const unsigned int                   n);

    /**
     * Linear along x between the nearest lines of columns along y, those of the
     * cell or of the ones beside it, and on each line linear along y; a cell
     * beside it in y counts with the value that it has at the x of the line,
     * constant beyond its columns. Bilinear where the columns are a grid, and
     * linear along x where all is the same along y.
     * @param cell first column of the cell that holds the point
     */
    Place
    around(const dealii::Point<2> &x, const unsigned int cell) const;

  private:
    /** One of the n lines of columns of a cell across a direction. */
    struct Line
    {
      unsigned int cell, number;
      double       weight;
    };

    /** The lines on both sides of a point. @param d direction across them */
    std::array<Line, 2>
    lines(const dealii::Point<2> &x,
          const unsigned int      cell,
          const unsigned int      d) const;

    /** Where a line of a cell is. */
    double
    at(const unsigned int cell,
       const unsigned int line,
       const unsigned int d) const;

    /** The columns of a cell around an x, constant beyond them. */
    std::array<Line, 2>
    within(const unsigned int cell, const double x) const;

    /** The first column of the cell that holds a point of the face. */
    unsigned int
    cell_at(dealii::Point<2> x) const;

    std::vector<dealii::Point<2>> columns;
    unsigned int                  n;
    double                        rim; ///< of a cell beyond its lines, over
                                       ///< the way from the first to the last
    std::array<double, 2>                                          period{};
    dealii::RTree<std::pair<dealii::BoundingBox<2>, unsigned int>> tree;
  };
} // namespace asperity

#endif
