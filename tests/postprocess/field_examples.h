#ifndef asperity_tests_postprocess_field_examples_h
#define asperity_tests_postprocess_field_examples_h

#include <asperity/postprocess/field_snapshots.h>

namespace asperity
{
  /** Two square cells of edge 1 beside each other with one Gauss point each. */
  inline FieldPlaces
  places_of_two_cells()
  {
    FieldPlaces places;
    places.period = 2.;
    for (const double x : {0., 1.})
      {
        for (const double y : {0., 1.})
          for (const double dx : {0., 1.})
            places.nodes.insert(places.nodes.end(), {x + dx, y, 0.25});
        places.points.insert(places.points.end(), {x + 0.5, 0.5, 1.});
        for (const double dx : {0.25, 0.75})
          places.edge.insert(places.edge.end(), {x + dx, 1., 0.5});
      }
    return places;
  }

  /** On these cells, in balance under a traction of (3, -7) and a further force
   *  of (0, 1); the second snapshot has twice these values. */
  inline FieldSnapshots
  two_cells()
  {
    namespace names = field_names;
    FieldSnapshots result;
    result.places = places_of_two_cells();
    result.fields = {{names::displacement, PlaceKind::nodes, 2},
                     {names::stress, PlaceKind::points, 4},
                     {names::nominal_stress, PlaceKind::points, 2},
                     {names::plastic_strain, PlaceKind::points, 1},
                     {names::temperature, PlaceKind::points, 1},
                     {names::edge_displacement, PlaceKind::edge, 2},
                     {names::contact_pressure, PlaceKind::edge, 1},
                     {names::traction, PlaceKind::edge, 2},
                     {names::further_force, PlaceKind::whole, 2}};
    result.shares = {0.5, 1.};
    FieldSnapshot first;
    first.time             = 0.5;
    first.sliding_distance = 10.;
    first.pressure         = 6.5;
    first.T_x              = 6.;
    first.T_y              = -13.;
    first.mu               = 6. / 13.;
    first.step             = 3;
    first.values.resize(result.fields.size());
    for (std::size_t i = 0; i < 8; ++i)
      first.values[0].insert(first.values[0].end(),
                             {0.1 * result.places.nodes[3 * i + 1], 0.});
    for (unsigned int cell = 0; cell < 2; ++cell)
      {
        first.values[1].insert(first.values[1].end(), {0., 0., 0., 2.});
        first.values[2].insert(first.values[2].end(), {3., -6.5});
        first.values[3].push_back(0.2);
        first.values[4].push_back(300.);
      }
    for (unsigned int q = 0; q < 4; ++q)
      {
        first.values[5].insert(first.values[5].end(), {0., 0.25});
        first.values[6].push_back(7.);
        first.values[7].insert(first.values[7].end(), {3., -7.});
      }
    first.values[8]      = {0., 1.};
    FieldSnapshot second = first;
    second.time          = 1.;
    second.step          = 7;
    for (auto &values : second.values)
      for (double &value : values)
        value *= 2.;
    result.snapshots = {first, second};
    return result;
  }
} // namespace asperity

#endif
