#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/field_recorder.h>
#include <asperity/contact_zone/friction_result.h>
#include <asperity/isogeometric/element_view.h>

#include <cmath>
#include <limits>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Equidistant points of a cell with its edges, x fastest. */
    dealii::Quadrature<2>
    picture_points(const unsigned int n_subdivisions)
    {
      std::vector<dealii::Point<2>> points;
      for (unsigned int j = 0; j <= n_subdivisions; ++j)
        for (unsigned int i = 0; i <= n_subdivisions; ++i)
          points.emplace_back(1. * i / n_subdivisions, 1. * j / n_subdivisions);
      return dealii::Quadrature<2>(points,
                                   std::vector<double>(points.size(),
                                                       1. / points.size()));
    }

    /** x, y and weight of each point. */
    std::vector<double>
    places_of(const BasisTable<2> &table)
    {
      std::vector<double> places;
      for (std::size_t q = 0; q < table.JxW.size(); ++q)
        places.insert(places.end(),
                      {table.position[q][0],
                       table.position[q][1],
                       table.JxW[q]});
      return places;
    }

    /** Displacement at all points without the sliding. */
    std::vector<double>
    displacement(const BasisTable<2> &table,
                 const Vector        &u,
                 const double         sliding)
    {
      std::vector<double> values(2 * table.JxW.size());
      for (const auto &entry : table.elements)
        {
          const ElementView<2> element(table, entry);
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            for (unsigned int c = 0; c < 2; ++c)
              {
                double &value = values[2 * element.point(q) + c];
                value         = c == 0 ? -sliding : 0.;
                for (unsigned int a = 0; a < element.n_functions(); ++a)
                  value += element.N(q, a) * u(element.dof(a, c));
              }
        }
      return values;
    }

    /** sigma = P F^T / det F */
    std::vector<double>
    cauchy_stress(const std::vector<Tensor<2, 3>> &P,
                  const std::vector<Tensor<2, 3>> &F)
    {
      std::vector<double> values;
      for (std::size_t q = 0; q < P.size(); ++q)
        {
          const Tensor<2, 3> stress =
            P[q] * transpose(F[q]) / determinant(F[q]);
          values.insert(
            values.end(),
            {stress[0][0], stress[1][1], stress[2][2], stress[0][1]});
        }
      return values;
    }

    /** Outward, not of unit length: present over reference length of the edge
     *  times its normal. The edge runs along x, the chip is below. */
    std::vector<Tensor<1, 2>>
    edge_normals(const BasisTable<2> &table, const Vector &u)
    {
      std::vector<Tensor<1, 2>> normals(table.JxW.size());
      for (const auto &entry : table.elements)
        {
          const ElementView<2> element(table, entry);
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            {
              Tensor<1, 2> t = table.tangent[element.point(q)];
              element.add_stretch(q, u, t, 0);
              normals[element.point(q)] = Tensor<1, 2>({-t[1], t[0]});
            }
        }
      return normals;
    }

    /** With 0 for what is nothing beside the size: a field counts as much as
     *  any other in what is learnt, and rounding errors are none. */
    std::vector<double>
    without_rounding(std::vector<double> values, const double size)
    {
      constexpr double rounding = 1e-12;
      for (double &value : values)
        if (std::abs(value) <= rounding * size)
          value = 0.;
      return values;
    }

    std::vector<FieldKind>
    fields_of(const Scene<2> &scene)
    {
      namespace names               = field_names;
      std::vector<FieldKind> fields = {
        {names::displacement, PlaceKind::nodes, 2},
        {names::stress, PlaceKind::points, 4},
        {names::nominal_stress, PlaceKind::points, 2},
        {names::plastic_strain, PlaceKind::points, 1},
        {names::temperature, PlaceKind::points, 1},
        {names::edge_displacement, PlaceKind::edge, 2},
        {names::contact_pressure, PlaceKind::edge, 1},
        {names::traction, PlaceKind::edge, 2}};
      if (scene.contact->shear() != nullptr)
        fields.push_back({names::shear_traction, PlaceKind::edge, 1});
      if (scene.lubricant)
        {
          fields.push_back({names::oil_pressure, PlaceKind::edge, 1});
          fields.push_back({names::further_force, PlaceKind::whole, 2});
        }
      return fields;
    }
  } // namespace



  FieldRecorder::FieldRecorder(const SceneParameters &parameters,
                               const Scene<2>        &scene)
    : parameters(parameters)
    , scene(scene)
    , nodes(tabulate_cells(*scene.space,
                           scene.geometry,
                           picture_points(parameters.output.subdivisions)))
    , end_time(LoadProtocol(parameters.load, parameters.protocol).end_time())
  {
    fields_.places.period         = scene.length;
    fields_.places.n_subdivisions = parameters.output.subdivisions;
    fields_.places.n_gauss        = parameters.mesh.n_quadrature_points();
    fields_.places.nodes          = places_of(nodes);
    fields_.places.points         = places_of(scene.chip->table());
    fields_.places.edge           = places_of(scene.contact->table());
    fields_.fields                = fields_of(scene);
    fields_.shares                = parameters.output.field_times;
    fields_.is_quasi_static =
      parameters.protocol.inertia == Inertia::quasi_static;
  }



  double
  FieldRecorder::next_time() const
  {
    const std::size_t n = fields_.snapshots.size();
    // Times of steps are sums with rounding errors.
    return n < fields_.shares.size() ?
             (1. - 1e-9) * fields_.shares[n] * end_time :
             std::numeric_limits<double>::max();
  }



  bool
  FieldRecorder::step(const SlidingRun<2> &run)
  {
    const std::size_t before = fields_.snapshots.size();
    while (run.state().time >= next_time())
      fields_.snapshots.push_back(take(run));
    return fields_.snapshots.size() > before;
  }



  const FieldSnapshots &
  FieldRecorder::fields() const
  {
    return fields_;
  }



  void
  FieldRecorder::go_on(const std::string &path, const RunState &state)
  {
    const auto fail = [&](const std::string &found) {
      throw InputError("The file " + quoted_name(path) + " " + found +
                       "; expected the fields that the run had taken before "
                       "its checkpoint, or a new run.");
    };
    if (state.time < next_time())
      return; // none is to be there
    FieldSnapshots found = FieldSnapshots::read(path);
    if (!found.places.is_same_as(fields_.places))
      fail("is of another mesh");
    if (found.shares != fields_.shares)
      fail("is of other Field times");
    for (const FieldSnapshot &snapshot : found.snapshots)
      if (snapshot.step <= state.step)
        fields_.snapshots.push_back(snapshot);
    if (state.time >= next_time())
      fail("misses the fields at " +
           format_quantity(fields_.shares[fields_.snapshots.size()], "1") +
           " of the end time");
  }



  void
  FieldRecorder::set(const std::string    &name,
                     std::vector<double> &&values,
                     FieldSnapshot        &snapshot) const
  {
    if (const std::size_t f = fields_.find(name); f < fields_.fields.size())
      snapshot.values[f] = std::move(values);
  }



  FieldSnapshot
  FieldRecorder::take(const SlidingRun<2> &run) const
  {
    const FrictionRow &row = run.state().rows.back();
    FieldSnapshot      snapshot;
    snapshot.time             = row.time;
    snapshot.step             = row.step;
    snapshot.sliding_distance = row.sliding_distance;
    snapshot.direction        = run.protocol().direction(row.time);
    snapshot.pressure         = run.protocol().pressure(row.time);
    snapshot.T_x              = row.T_x;
    snapshot.T_y              = row.T_y;
    snapshot.mu               = row.mu;
    snapshot.values.resize(fields_.fields.size());
    take_chip(run.state().u, row.sliding_distance, snapshot);
    take_edge(run.state().u, row.sliding_distance, snapshot);
    if (scene.lubricant)
      {
        set(field_names::further_force, {0., 0.}, snapshot);
        const auto force = force_of_tractions(fields_, snapshot.values);
        set(field_names::further_force,
            without_rounding({row.T_x - force[0], row.T_y - force[1]},
                             std::hypot(row.T_x, row.T_y)),
            snapshot);
      }
    return snapshot;
  }



  void
  FieldRecorder::take_chip(const Vector  &u,
                           const double   sliding,
                           FieldSnapshot &snapshot) const
  {
    set(field_names::displacement, displacement(nodes, u, sliding), snapshot);
    const std::vector<Tensor<2, 3>> &P = scene.chip->stress();
    set(field_names::stress,
        cauchy_stress(P, scene.chip->deformation(u)),
        snapshot);
    std::vector<double> nominal, strain, temperature;
    for (const Tensor<2, 3> &stress : P)
      nominal.insert(nominal.end(), {stress[0][1], stress[1][1]});
    for (const MaterialState &point : scene.chip->history())
      {
        strain.push_back(point.plastic_strain);
        temperature.push_back(point.temperature);
      }
    set(field_names::nominal_stress, std::move(nominal), snapshot);
    set(field_names::plastic_strain, std::move(strain), snapshot);
    set(field_names::temperature, std::move(temperature), snapshot);
  }



  void
  FieldRecorder::take_edge(const Vector  &u,
                           const double   sliding,
                           FieldSnapshot &snapshot) const
  {
    const ContactAssembler<2>      &contact = *scene.contact;
    const BasisTable<2>            &table   = contact.table();
    const ShearTraction<2>         *shear   = contact.shear();
    const std::vector<double>       stretch = contact.stretch(u);
    const std::vector<Tensor<1, 2>> outward = edge_normals(table, u);
    std::vector<double>             pressure, shear_traction, oil, traction;
    for (std::size_t q = 0; q < stretch.size(); ++q)
      {
        pressure.push_back(contact.pressure()[q] / stretch[q]);
        Tensor<1, 2> t = contact.pressure()[q] * contact.gaps()[q].normal;
        if (shear != nullptr)
          {
            shear_traction.push_back(shear->at_points()[q] / stretch[q]);
            t -= shear->at_points()[q] * shear->slip()[q].tangent[0];
          }
        if (scene.lubricant)
          {
            oil.push_back(scene.lubricant->pressure(table.parameter[q]));
            t -= oil.back() * outward[q];
          }
        traction.insert(traction.end(), {t[0], t[1]});
      }
    set(field_names::edge_displacement,
        displacement(table, u, sliding),
        snapshot);
    set(field_names::contact_pressure, std::move(pressure), snapshot);
    set(field_names::traction, std::move(traction), snapshot);
    set(field_names::shear_traction, std::move(shear_traction), snapshot);
    set(field_names::oil_pressure, std::move(oil), snapshot);
  }
} // namespace asperity
