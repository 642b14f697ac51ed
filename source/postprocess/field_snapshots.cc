#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/field_snapshots.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr unsigned int columns_of_places = 3; // x, y, weight

    bool
    are_near(const std::vector<double> &a,
             const std::vector<double> &b,
             const double               tolerance)
    {
      return a.size() == b.size() &&
             std::equal(a.begin(),
                        a.end(),
                        b.begin(),
                        [&](const double first, const double second) {
                          return std::abs(first - second) <= tolerance;
                        });
    }

    const std::vector<double> &
    places_of(const FieldPlaces &places, const PlaceKind kind)
    {
      return kind == PlaceKind::nodes  ? places.nodes :
             kind == PlaceKind::points ? places.points :
                                         places.edge;
    }
  } // namespace



  std::size_t
  FieldPlaces::n_places(const PlaceKind kind) const
  {
    return kind == PlaceKind::whole ?
             1 :
             places_of(*this, kind).size() / columns_of_places;
  }



  double
  FieldPlaces::weight(const PlaceKind kind, const std::size_t place) const
  {
    return kind == PlaceKind::whole ?
             1. :
             places_of(*this, kind)[columns_of_places * place + 2];
  }



  unsigned int
  FieldPlaces::n_cells() const
  {
    return n_places(PlaceKind::points) / (n_gauss * n_gauss);
  }



  bool
  FieldPlaces::is_same_as(const FieldPlaces &other) const
  {
    const double tolerance = 1e-9 * period; // of lengths; areas are smaller
    return n_subdivisions == other.n_subdivisions && n_gauss == other.n_gauss &&
           std::abs(period - other.period) <= tolerance &&
           are_near(nodes, other.nodes, tolerance) &&
           are_near(points, other.points, tolerance) &&
           are_near(edge, other.edge, tolerance);
  }



  bool
  FieldSnapshots::is_complete() const
  {
    return !shares.empty() && snapshots.size() == shares.size();
  }



  std::size_t
  FieldSnapshots::find(const std::string &field) const
  {
    return std::find_if(fields.begin(),
                        fields.end(),
                        [&](const FieldKind &kind) {
                          return kind.name == field;
                        }) -
           fields.begin();
  }



  std::array<double, 2>
  force_of_tractions(const FieldSnapshots                   &about,
                     const std::vector<std::vector<double>> &values)
  {
    std::array<double, 2>      force{{0., 0.}};
    const std::vector<double> &t = values.at(about.find(field_names::traction));
    for (std::size_t q = 0; q < about.places.n_places(PlaceKind::edge); ++q)
      for (unsigned int i = 0; i < 2; ++i)
        force[i] += about.places.weight(PlaceKind::edge, q) * t[2 * q + i];
    if (const std::size_t further = about.find(field_names::further_force);
        further < about.fields.size())
      for (unsigned int i = 0; i < 2; ++i)
        force[i] += values[further][i];
    return force;
  }



  std::array<double, 2>
  imbalance_of_stress(const FieldSnapshots                   &about,
                      const std::vector<std::vector<double>> &values)
  {
    const FieldPlaces         &places = about.places;
    double                     area = 0., length = 0., under_edge = 0.;
    std::array<double, 2>      work{{0., 0.}};
    const std::vector<double> &P =
      values.at(about.find(field_names::nominal_stress));
    for (std::size_t q = 0; q < places.n_places(PlaceKind::points); ++q)
      {
        const double weight = places.weight(PlaceKind::points, q);
        area += weight;
        for (unsigned int i = 0; i < 2; ++i)
          work[i] += weight * P[2 * q + i];
      }
    const std::vector<double> &t = values.at(about.find(field_names::traction));
    for (std::size_t q = 0; q < places.n_places(PlaceKind::edge); ++q)
      {
        const double weight = places.weight(PlaceKind::edge, q),
                     Y      = places.edge[columns_of_places * q + 1];
        length += weight;
        under_edge += weight * Y;
        for (unsigned int i = 0; i < 2; ++i)
          work[i] -= weight * t[2 * q + i] * Y;
      }
    const double height  = area / places.period;
    const auto   further = about.find(field_names::further_force);
    for (unsigned int i = 0; i < 2; ++i)
      {
        if (further < about.fields.size())
          work[i] -= values[further][i] * under_edge / length;
        work[i] /= height;
      }
    return work;
  }
} // namespace asperity
