#ifndef asperity_contact_zone_surface_layer_h
#define asperity_contact_zone_surface_layer_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/basis_table.h>

#include <vector>

namespace asperity
{
  /** The material points of a body that are next to its top edge. */
  class SurfaceLayer
  {
  public:
    /** @param body table of its cells, periodic along the edge
     *  @param edge table of its top edge, of the same space
     *  @param period of the first parameter */
    SurfaceLayer(const BasisTable &body,
                 const BasisTable &edge,
                 const double      period);

    /** What the edge sees of the body. */
    struct Point
    {
      double plastic_strain;
      double temperature; ///< [K]
    };

    /** One for each point of the edge, linear along the edge between the
     *  material points. */
    std::vector<Point>
    at_edge(const std::vector<MaterialState> &history) const;

    /** Mean temperature of the uppermost row of points [K]. */
    double
    mean_temperature(const std::vector<MaterialState> &history) const;

  private:
    /** A point of the edge between two material points. */
    struct Place
    {
      unsigned int left, right;
      double       weight; ///< of the right one
    };

    std::vector<unsigned int> uppermost;
    std::vector<double>       area; ///< of each of these [m^2]
    std::vector<Place>        places;
  };
} // namespace asperity

#endif
