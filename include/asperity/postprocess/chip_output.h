#ifndef asperity_postprocess_chip_output_h
#define asperity_postprocess_chip_output_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/cell_partition.h>

#include <deal.II/base/table.h>
#include <deal.II/lac/vector.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /** What a picture of the chip shows. Names carry the unit,
   *  "equivalent plastic strain [-]". */
  struct ChipFields
  {
    template <typename Values>
    using Named = std::vector<std::pair<std::string, Values>>;

    /** Coefficients of the displacement [m], [dim * function + component]. */
    dealii::Vector<double> displacement;

    /** Further spline fields: vectors (interleaved as the displacement) and
     *  scalars, [function]. */
    Named<dealii::Vector<double>> spline_vectors;
    Named<dealii::Vector<double>> spline_scalars;

    /** Values at the quadrature points of all cells, in the order of the table
     *  that tabulate_cells() makes with QGauss<dim>(n_gauss_points). */
    Named<std::vector<double>> quadrature_scalars;
  };

  /**
   * Pictures of the deformed chip. Each Bezier cell is divided into equal
   * quadrilaterals or hexahedra; corners lie on the deformed geometry x = X +
   * u. Quadrature fields are drawn through the polynomial that interpolates
   * them at the Gauss points of the cell, limited to the range that they have
   * there: the picture shows no overshoot, and jumps between cells stay
   * visible.
   *
   * Holds tables of a space and a geometry; after refinement make a new one.
   */
  template <int dim>
  class ChipOutput
  {
  public:
    /**
     * @param n_subdivisions of a cell in each direction
     * @param n_gauss_points Gauss points a direction at which quadrature fields
     *   are given
     * @param share cells of this rank, which draws them
     */
    ChipOutput(const SplineSpace<dim>   &space,
               const PatchGeometry<dim> &geometry,
               const unsigned int        n_subdivisions,
               const unsigned int        n_gauss_points,
               const CellShare          &share = {});

    /**
     * Writes VTU. The displacement is a field of its own, too, named
     * "displacement [m]".
     *
     * @param time physical time [s]
     * @param n_periods how often a periodic chip is drawn side by side
     * @throws ComputationError naming the field whose length is wrong or that
     *   holds a number that is not finite (in single precision, which VTU
     *   stores), or if a chip without period is to be drawn more than once
     */
    void
    write(std::ostream      &out,
          const ChipFields  &fields,
          const double       time,
          const unsigned int step,
          const unsigned int n_periods = 1) const;

    /** Collective: what each rank draws of the picture, on the first one; all
     *  are to have the same fields.
     *  @throws SharedError as write(), on all ranks if on one */
    std::vector<std::string>
    pieces(const ChipFields  &fields,
           const double       time,
           const unsigned int step) const;

    /** The picture of these pieces. */
    static void
    write(std::ostream &out, const std::vector<std::string> &pieces);

  private:
    /** The cells of this rank, with the names of their rows. */
    void
    write_piece(std::ostream      &out,
                const ChipFields  &fields,
                const double       time,
                const unsigned int step,
                const unsigned int n_periods) const;

    void
    check_sizes(const ChipFields &fields) const;

    /** Value of a spline field at a table point. */
    double
    spline_value(const typename BasisTable<dim>::Element &element,
                 const unsigned int                       point,
                 const dealii::Vector<double>            &coefficients,
                 const unsigned int                       n_components,
                 const unsigned int                       component) const;

    /** Draws one cell's quadrature field into a row of the data. */
    void
    fill_from_gauss_points(const double            *values,
                           const unsigned int       row,
                           dealii::Table<2, float> &data) const;

    /** All rows of one cell: displacement, fields, position. */
    void
    fill_cell(const unsigned int       e,
              const ChipFields        &fields,
              dealii::Table<2, float> &data) const;

    unsigned int
    n_gauss_of_cell() const;

    unsigned int n_subdivisions, n_gauss_points, n_functions;
    CellShare    share;

    /** 0 if the space is not periodic [m]. */
    double period;

    BasisTable<dim> table;

    /** [picture point of a line * n_gauss_points + Gauss point] */
    std::vector<double> lagrange;
  };
} // namespace asperity

#endif
