#ifndef asperity_contact_zone_surface_layer_h
#define asperity_contact_zone_surface_layer_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/basis_table.h>

#include <array>
#include <utility>
#include <vector>

namespace asperity
{
  /** The material points of a body that are next to its top edge. What happens
   *  at the edge itself lies on the straight line through the uppermost points
   *  of the two uppermost cells: the points come closer to the edge with every
   *  refinement of the mesh, and strain changes by per cents on the way. Two
   *  points of one cell would lead too far where strain falls steeply towards
   *  the edge, as it does where a spot first touched: the strain of one element
   *  is nearly linear, and its slope that of the whole fall. */
  template <int dim>
  class SurfaceLayer
  {
  public:
    /** @param body table of its cells, periodic along the edge
     *  @param edge table of its top edge, of the same space */
    SurfaceLayer(const BasisTable<dim> &body, const BasisTable<dim> &edge);

    /** What the edge sees of the body. */
    struct Point
    {
      double plastic_strain;
      double temperature; ///< [K]
    };

    /** One for each point of the edge; a strain is not negative. Linear along
     *  the edge between the material points, in three dimensions bilinear.
     *  Where the elements of a face are no grid, it is linear along x between
     *  the nearest points of the same or the next element, and there along y;
     *  in an element next to it in y, whose points are at other x, between them
     *  and constant beyond. */
    std::vector<Point>
    at_edge(const std::vector<MaterialState> &history) const;

    /** Mean temperature of the edge [K]. */
    double
    mean_temperature(const std::vector<MaterialState> &history) const;

  private:
    /** A material point next to the edge, and points with weights (1 in sum)
     *  that stand for the one below it. */
    struct Column
    {
      unsigned int                                 top;
      std::vector<std::pair<unsigned int, double>> below;
      double beyond; ///< way from the upper one to the edge, over theirs
    };

    static std::vector<Column>
    columns_under(const BasisTable<dim> &body, const BasisTable<dim> &edge);

    /** @return whether the columns are a grid */
    bool
    place_on_grid(const BasisTable<dim> &body, const BasisTable<dim> &edge);

    /** Between the columns of cells of different sizes. */
    void
    place_between_cells(const BasisTable<dim> &body,
                        const BasisTable<dim> &edge);

    Point
    at_top(const std::vector<MaterialState> &history,
           const Column                     &column) const;

    /** A point of the edge between columns: their numbers and weights. */
    using Place = std::vector<std::pair<unsigned int, double>>;

    /** Along the first parameter of the edge first. */
    std::vector<Column> columns;
    std::vector<double> area; ///< of the uppermost points [m^dim]
    std::vector<Place>  places;
  };
} // namespace asperity

#endif
