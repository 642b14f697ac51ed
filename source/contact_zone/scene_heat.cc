#include <asperity/base/archive.h>
#include <asperity/contact_zone/scene_heat.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  double
  HeatAmounts::balance_error() const
  {
    const double size = std::abs(plastic) + std::abs(friction) +
                        std::abs(stored) + std::abs(depth) + std::abs(tool);
    return size > 0. ?
             std::abs(plastic + friction - stored - depth - tool) / size :
             0.;
  }



  HeatAmounts
  HeatAmounts::since(const HeatAmounts &before) const
  {
    return {plastic - before.plastic,
            friction - before.friction,
            stored - before.stored,
            depth - before.depth,
            tool - before.tool};
  }



  namespace
  {
    double
    temperature_of_tool(const SceneParameters &parameters)
    {
      return parameters.heat.tool_temperature.value_or(
        parameters.load.temperature);
    }

    /** Those of the chip where its table has none. */
    template <int dim>
    GradientRows
    rows_of_gradients(const SolidAssembler<dim> &chip)
    {
      if constexpr (dim == 2)
        return {};
      else
        return [&chip](const unsigned int element) {
          return chip.element_gradients(element).from_point(0);
        };
    }

    /** Elements of a face along a direction. */
    template <int dim>
    unsigned int
    n_elements_along(const BasisTable<dim> &face, const unsigned int direction)
    {
      std::vector<double> begins;
      for (const auto &element : face.elements)
        begins.push_back(face.parameter[element.first_point][direction]);
      std::sort(begins.begin(), begins.end());
      const double small = 1e-9 * (begins.back() - begins.front());
      unsigned int n     = 1;
      for (std::size_t i = 1; i < begins.size(); ++i)
        n += begins[i] - begins[i - 1] > small;
      return n;
    }

    /** The waves of a face whose shortest one is so many elements long. */
    template <int dim>
    FourierBasis<dim>
    waves_along(const BasisTable<dim>             &face,
                const Edge                         edge,
                const MeshParameters              &mesh,
                const std::array<double, dim - 1> &periods,
                const unsigned int                 elements_of_shortest)
    {
      std::array<unsigned int, dim - 1> n_waves;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          unsigned int n = n_elements_along(face, d);
          // Waves stay as they are where the mesh changes: of the finest
          // elements at the top, at the bottom of the coarsest.
          if (mesh.adaptive_levels > 0)
            n = (d == 0 ? mesh.spans :
                          mesh.n_spans_across(periods[0], periods[dim - 2])) >>
                (edge == Edge::top ? 0 : mesh.refinement);
          n_waves[d] = n / elements_of_shortest;
        }
      return FourierBasis<dim>(periods, n_waves);
    }
  } // namespace



  template <int dim>
  SceneHeat<dim>::SceneHeat(const SceneParameters       &parameters,
                            const SplineSpace<dim>      &space,
                            const PatchGeometry<dim>    &geometry,
                            const Periods               &periods,
                            SolidAssembler<dim>         &chip,
                            const ContactAssembler<dim> &contact,
                            const CellShare             &share)
    : parameters(parameters.heat)
    , has_oil(parameters.lubrication.model != LubricantModel::none)
    , start(parameters.load.temperature)
    , material(parameters.chip_thermal())
    , chip(chip)
    , contact(contact)
    , conduction(chip.table(), space, material, share, rows_of_gradients(chip))
    // shorter waves change nothing (doc/theory.md)
    , exchange(
        contact.table(),
        parameters.heat.tool,
        waves_along(contact.table(), Edge::top, parameters.mesh, periods, 2),
        temperature_of_tool(parameters) - start)
    , chip_rise(contact.table().JxW.size(), 0.)
    , tool_rise(chip_rise.size(), temperature_of_tool(parameters) - start)
    , to_tool(chip_rise.size(), 0.)
  {
    const BasisTable<dim> bottom =
      tabulate_edge(space,
                    geometry,
                    Edge::bottom,
                    dealii::QGauss<dim - 1>(space.degree() + 2),
                    true);
    // The bottom has the coarsest elements, four for the shortest wave.
    conduction.continue_beyond(
      bottom, waves_along(bottom, Edge::bottom, parameters.mesh, periods, 4));
  }



  template <int dim>
  Vector
  SceneHeat<dim>::plastic_power(const double dt) const
  {
    // At the start of the step the points had the temperature of the field.
    Vector power = conduction.rise_at_points();
    for (unsigned int q = 0; q < power.size(); ++q)
      power(q) = material.volumetric_capacity() / dt *
                 (chip.history()[q].temperature - (start + power(q)));
    return power;
  }



  template <int dim>
  InterfaceHeat<dim>
  SceneHeat<dim>::interface(const std::vector<double> &friction) const
  {
    InterfaceHeat<dim>      heat;
    const std::vector<bool> touches = contact.touching();
    const double            h       = parameters.contact_conductance;
    heat.friction                   = friction;
    heat.places                     = places_along(contact.positions());
    for (unsigned int q = 0; q < touches.size(); ++q)
      {
        const double gap = std::max(0., contact.gaps()[q].gap);
        // h and the oil's lambda/g in series.
        const double lambda = has_oil ? parameters.oil_conductivity : 0.;
        const double open = lambda > 0. ? h * lambda / (lambda + h * gap) : 0.;
        heat.conductance.push_back(touches[q] ? h : open);
      }
    return heat;
  }



  template <int dim>
  void
  SceneHeat<dim>::advance(const Vector              &u,
                          const double               dt,
                          const std::vector<double> &friction)
  {
    const HeatAmounts before  = total;
    const Vector      plastic = plastic_power(dt);
    conduction.begin_step(u, dt);
    Vector power(conduction.rise().size());
    conduction.add_source(plastic, power);
    const typename ThermalContact<dim>::Step step =
      exchange.solve(conduction, dt, power, interface(friction));
    conduction.accept(step.chip_change);
    exchange.accept(step);
    chip_rise = step.chip;
    tool_rise = step.tool;
    to_tool   = step.to_tool;

    for (unsigned int q = 0; q < plastic.size(); ++q)
      total.plastic += dt * chip.table().JxW[q] * plastic(q);
    warm_points();
    for (unsigned int q = 0; q < friction.size(); ++q)
      total.friction += dt * contact.table().JxW[q] * friction[q];
    total.stored   = conduction.stored();
    total.depth    = conduction.passed_on();
    total.tool     = exchange.heat_of_tool();
    balance_error_ = total.since(before).balance_error();
  }



  template <int dim>
  void
  SceneHeat<dim>::warm_points()
  {
    std::vector<MaterialState> points = chip.history();
    const Vector               rise   = conduction.rise_at_points();
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].temperature = start + rise(q);
    chip.set_history(points);
  }



  template <int dim>
  const HeatAmounts &
  SceneHeat<dim>::amounts() const
  {
    return total;
  }



  template <int dim>
  double
  SceneHeat<dim>::balance_error() const
  {
    return balance_error_;
  }



  namespace
  {
    std::vector<double>
    shifted(std::vector<double> values, const double offset)
    {
      for (double &value : values)
        value += offset;
      return values;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  SceneHeat<dim>::chip_temperature() const
  {
    return shifted(chip_rise, start);
  }



  template <int dim>
  std::vector<double>
  SceneHeat<dim>::tool_temperature() const
  {
    return shifted(tool_rise, start);
  }



  template <int dim>
  const std::vector<double> &
  SceneHeat<dim>::flux_to_tool() const
  {
    return to_tool;
  }



  template <int dim>
  double
  SceneHeat<dim>::mean_tool_temperature() const
  {
    double                     sum = 0., length = 0.;
    const std::vector<double> &weights = contact.table().JxW;
    for (unsigned int q = 0; q < weights.size(); ++q)
      {
        sum += weights[q] * tool_rise[q];
        length += weights[q];
      }
    return start + sum / length;
  }



  template <int dim>
  double
  SceneHeat<dim>::flash_temperature() const
  {
    return start +
           std::max(*std::max_element(chip_rise.begin(), chip_rise.end()),
                    *std::max_element(tool_rise.begin(), tool_rise.end()));
  }



  template <int dim>
  void
  SceneHeat<dim>::save(OutputArchive &archive) const
  {
    conduction.save(archive);
    exchange.save(archive);
    archive << chip_rise << tool_rise << to_tool << total.plastic
            << total.friction << total.stored << balance_error_;
  }



  template <int dim>
  void
  SceneHeat<dim>::load(InputArchive &archive)
  {
    conduction.load(archive);
    exchange.load(archive);
    archive >> fixed_length(chip_rise, "temperatures of the interface") >>
      fixed_length(tool_rise, "temperatures of the interface") >>
      fixed_length(to_tool, "heat fluxes of the interface") >> total.plastic >>
      total.friction >> total.stored >> balance_error_;
    total.depth = conduction.passed_on();
    total.tool  = exchange.heat_of_tool();
  }



  template <int dim>
  void
  SceneHeat<dim>::take_over(InputArchive   &archive,
                            const Transfer &of_splines,
                            const Transfer &of_points)
  {
    conduction.load(archive, of_splines);
    exchange.load(archive);
    for (std::vector<double> *values : {&chip_rise, &tool_rise, &to_tool})
      {
        std::vector<double> before;
        archive >> before;
        *values = of_points(before);
      }
    archive >> total.plastic >> total.friction >> total.stored >>
      balance_error_;
    total.depth = conduction.passed_on();
    total.tool  = exchange.heat_of_tool();
    warm_points();
  }



  template class SceneHeat<2>;
  template class SceneHeat<3>;
} // namespace asperity
