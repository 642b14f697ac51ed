#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/lubricant/film_term.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  FilmTerm::FilmTerm(const SplineSpace<2>   &space,
                     const PatchGeometry<2> &geometry,
                     const SplineCurve      &tool,
                     const FilmTermOptions  &options,
                     const unsigned int      first_unknown)
    : options(options)
    , first_unknown(first_unknown)
    , edge_(space, geometry, tool, options.gap, options.cells_per_span)
    , film(options.oil, edge_.n_cells(), FilmEnds())
    , states(edge_.n_cells(), FilmState{0., options.wetting})
  {
    if (!(options.wetting >= 0. && options.wetting <= 1.))
      throw InputError("The wetting must lie between 0 and 1, but it is " +
                       format_number(options.wetting) + ".");
    step.dt = 1.;
    step.old_content.resize(edge_.n_cells());
    old_position.resize(edge_.n_cells());
    Vector u(first_unknown + n_unknowns());
    start(u);
    void_volume = state().void_volume;
    initialize(u);
  }



  unsigned int
  FilmTerm::n_unknowns() const
  {
    return 2 * edge_.n_cells();
  }



  unsigned int
  FilmTerm::pressure_unknown(const unsigned int cell) const
  {
    return first_unknown + 2 * cell;
  }



  unsigned int
  FilmTerm::fraction_unknown(const unsigned int cell) const
  {
    return first_unknown + 2 * cell + 1;
  }



  void
  FilmTerm::start(const Vector &u)
  {
    if (!evaluate(u))
      throw InputError("The lubricant film cannot start: " + failure + ".");
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      old_position[i] = edge_.position(i);
  }



  void
  FilmTerm::initialize(Vector &u)
  {
    start(u);
    const double oil_volume = options.oil_film ?
                                *options.oil_film * edge_.period() :
                                options.wetting * void_volume;
    const double fraction   = std::min(1., oil_volume / state().void_volume);
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      {
        step.old_content[i]    = fraction * film_geometry.volume[i];
        u(pressure_unknown(i)) = 0.;
        u(fraction_unknown(i)) = fraction * options.gap_scale;
      }
  }



  void
  FilmTerm::set_tool_offset(const Tensor<1, 2> &offset)
  {
    tool_offset = offset;
  }



  void
  FilmTerm::set_oil(const LubricantParameters &oil)
  {
    film.set_lubricant(oil);
  }



  void
  FilmTerm::begin_step(const Vector &,
                       const unsigned int,
                       const double,
                       const double dt)
  {
    step.dt = dt;
  }



  bool
  FilmTerm::evaluate(const Vector &u)
  {
    const unsigned int n = edge_.n_cells();
    if (!edge_.measure(u, tool_offset))
      {
        failure = "the chip's edge under the film is no graph over x";
        return false;
      }
    film_geometry.volume.resize(n);
    film_geometry.faces.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        states[i] = {u(pressure_unknown(i)) * options.pressure_scale /
                       options.gap_scale,
                     u(fraction_unknown(i)) / options.gap_scale};
        film_geometry.volume[i] = edge_.volume(i);
        const double sliding    = (tool_offset[0] - old_tool_offset[0] -
                                edge_.position(i) + old_position[i]) /
                               step.dt;
        const double before    = i > 0 ? edge_.position(i - 1) :
                                         edge_.position(n - 1) - edge_.period();
        const double behind    = i + 1 < n ? edge_.position(i + 1) :
                                             edge_.position(0) + edge_.period();
        film_geometry.faces[i] = {edge_.gap(i),
                                  0.5 * sliding,
                                  sliding,
                                  0.5 * (behind - before)};
        if (!(film.lubricant().density_ratio(states[i].pressure) > 0.))
          {
            failure = "the film's pressure fell below any that the law of "
                      "density knows";
            return false;
          }
      }
    film.linearize(states,
                   film_geometry,
                   options.pressure_scale,
                   linearization);
    failure.clear();
    return true;
  }



  void
  FilmTerm::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      {
        auto dofs = edge_.cell_dofs(i);
        dofs.push_back(pressure_unknown(i));
        dofs.push_back(fraction_unknown(i));
        for (const unsigned int row : dofs)
          for (const unsigned int column : dofs)
            pattern.add(row, column);
        // With those of its pressure, a cell's fraction is eliminated behind
        // that by a factorisation without pivoting.
        const auto columns = face_gradient(i, {});
        auto       rows    = edge_.position_gradient(i);
        rows.insert(rows.end(), columns.begin(), columns.begin() + 4);
        for (const auto &[row, ignored] : rows)
          for (const auto &[column, also_ignored] : columns)
            pattern.add(row, column);
      }
  }



  bool
  FilmTerm::add(const Vector &u, Vector &residual, Matrix *matrix)
  {
    if (!evaluate(u))
      return false;
    if (matrix != nullptr)
      tangent.begin(*matrix);
    const double to_force = options.pressure_scale / options.gap_scale;
    const auto   balance  = film.balance(linearization, film_geometry, step);
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      {
        residual(pressure_unknown(i)) += to_force * balance[i];
        residual(fraction_unknown(i)) += options.pressure_scale *
                                         edge_.reference_length(i) *
                                         linearization.complementarity[i].value;
        for (const auto &[dof, area] : edge_.area_vector(i))
          residual(dof) += states[i].pressure * area;
        for (const auto &[dof, N] : edge_.position_gradient(i))
          residual(dof) -= N * linearization.fluxes[i].lower_shear.value;
        if (matrix != nullptr)
          {
            add_cell_tangent(i);
            add_face_tangent(i);
          }
      }
    return true;
  }



  void
  FilmTerm::add_cell_tangent(const unsigned int cell)
  {
    const double       to_force   = options.pressure_scale / options.gap_scale;
    const double       d_fraction = 1. / options.gap_scale;
    const unsigned int p = pressure_unknown(cell), t = fraction_unknown(cell);
    const FilmContent &m = linearization.content[cell];
    tangent.add(p, p, to_force * m.d_pressure * to_force);
    tangent.add(p, t, to_force * m.d_fraction * d_fraction);
    for (const auto &[dof, dV] : edge_.volume_gradient(cell))
      tangent.add(p, dof, to_force * m.d_volume * dV);

    const FilmComplementarity &phi = linearization.complementarity[cell];
    const double row = options.pressure_scale * edge_.reference_length(cell);
    tangent.add(t, p, row * phi.d_pressure * to_force);
    tangent.add(t, t, row * phi.d_fraction * d_fraction);

    for (const auto &[dof, area] : edge_.area_vector(cell))
      tangent.add(dof, p, area * to_force);
    edge_.for_each_area_derivative(
      cell, [&](const unsigned int i, const unsigned int j, const double d) {
        tangent.add(i, j, states[cell].pressure * d);
      });
  }



  SparseGradient
  FilmTerm::face_gradient(const unsigned int   face,
                          const FilmFaceValue &value) const
  {
    const unsigned int n           = edge_.n_cells();
    const unsigned int left        = *film.left_cell(face);
    const unsigned int right       = *film.right_cell(face);
    const double       to_pressure = options.pressure_scale / options.gap_scale;
    const auto        &d           = value.derivative;
    SparseGradient     gradient    = {
             {pressure_unknown(left), d[left_pressure] * to_pressure},
             {pressure_unknown(right), d[right_pressure] * to_pressure},
             {fraction_unknown(left), d[left_fraction] / options.gap_scale},
             {fraction_unknown(right), d[right_fraction] / options.gap_scale}};
    const auto append = [&](const SparseGradient &inner, const double outer) {
      for (const auto &[dof, derivative] : inner)
        gradient.emplace_back(dof, outer * derivative);
    };
    append(edge_.gap_gradient(face), d[face_gap]);
    append(edge_.position_gradient(face),
           -(0.5 * d[couette_speed] + d[sliding_speed]) / step.dt);
    append(edge_.position_gradient((face + 1) % n), 0.5 * d[face_distance]);
    append(edge_.position_gradient((face + n - 1) % n),
           -0.5 * d[face_distance]);
    return gradient;
  }



  void
  FilmTerm::add_face_tangent(const unsigned int face)
  {
    const FilmFluxes &fluxes = linearization.fluxes[face];
    const double passed = step.dt * options.pressure_scale / options.gap_scale;
    for (const auto &[dof, d] : face_gradient(face, fluxes.flow))
      {
        tangent.add(pressure_unknown(*film.left_cell(face)), dof, passed * d);
        tangent.add(pressure_unknown(*film.right_cell(face)), dof, -passed * d);
      }
    const auto shear_gradient = face_gradient(face, fluxes.lower_shear);
    for (const auto &[row, N] : edge_.position_gradient(face))
      for (const auto &[dof, d] : shear_gradient)
        tangent.add(row, dof, -N * d);
  }



  std::string
  FilmTerm::reason() const
  {
    return failure.empty() ? film.warning(film_geometry, states) : failure;
  }



  void
  FilmTerm::accept(const Vector &u)
  {
    const bool exists = evaluate(u);
    AssertThrow(exists, dealii::ExcMessage(failure));
    step.old_content =
      film.advanced_content(linearization, film_geometry, step);
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      old_position[i] = edge_.position(i);
    old_tool_offset = tool_offset;
  }



  LubricantState
  FilmTerm::state() const
  {
    LubricantState result;
    result.smallest_film = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < edge_.n_cells(); ++i)
      {
        for (const auto &[dof, area] : edge_.area_vector(i))
          result.pressure_force[dof % 2] -= states[i].pressure * area;
        result.shear_force[0] += linearization.fluxes[i].lower_shear.value;
        result.max_pressure = std::max(result.max_pressure, states[i].pressure);
        result.void_volume += film_geometry.volume[i];
        result.reference_volume += step.old_content[i];
        result.oil_volume += states[i].fraction * film_geometry.volume[i];
        result.smallest_film = std::min(result.smallest_film, edge_.gap(i));
      }
    result.mean_pressure = -result.pressure_force[1] / edge_.period();
    return result;
  }



  unsigned int
  FilmTerm::cell_at(const double parameter) const
  {
    unsigned int low = 0, high = edge_.n_cells();
    while (high - low > 1)
      {
        const unsigned int middle                           = (low + high) / 2;
        (edge_.parameter(middle) <= parameter ? low : high) = middle;
      }
    return low;
  }



  double
  FilmTerm::pressure(const dealii::Point<2> &parameter) const
  {
    return states[cell_at(parameter[0])].pressure;
  }



  double
  FilmTerm::coverage(const dealii::Point<2> &parameter) const
  {
    return std::clamp(states[cell_at(parameter[0])].fraction, 0., 1.);
  }



  const std::vector<FilmState> &
  FilmTerm::film_states() const
  {
    return states;
  }



  const FilmEdge &
  FilmTerm::edge() const
  {
    return edge_;
  }



  void
  FilmTerm::save(OutputArchive &archive) const
  {
    archive << step.old_content << old_position << old_tool_offset;
  }



  void
  FilmTerm::load(InputArchive &archive)
  {
    const unsigned int n = edge_.n_cells();
    step.old_content.resize(n);
    old_position.resize(n);
    archive >> fixed_length(step.old_content, "cells of a film") >>
      fixed_length(old_position, "faces of a film") >> old_tool_offset;
  }
} // namespace asperity
