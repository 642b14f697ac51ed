#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/point_values.h>
#include <asperity/heat/thermal_contact.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <cmath>
#include <utility>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Of the exchange, relative; it decides about temperatures, not about the
     *  balance of heat. */
    constexpr double tolerance = 1e-8;

    /** What the temperature of the tool's surface answers to heat at points. */
    template <int dim>
    class ToolResponse
    {
    public:
      ToolResponse(const PeriodicHalfSpace<dim>              &tool,
                   const std::vector<dealii::Point<dim - 1>> &places,
                   const double                               dt)
        : basis(tool.basis())
        , values(basis, places)
        , response(tool.response(dt))
      {}

      /** Coefficients of the flux, of heat by point [W/m^(3 - dim)]. */
      Vector
      flux(const Vector &heat) const
      {
        Vector q = values.sums(heat);
        for (unsigned int m = 0; m < q.size(); ++m)
          q(m) *= basis.norm(m);
        return q;
      }

      /** Rise at the points by a flux in the step, plus another rise. */
      Vector
      rise(const Vector &flux, const Vector &coefficients) const
      {
        Vector theta = flux;
        theta.scale(response);
        theta += coefficients;
        return values.at_points(theta);
      }

    private:
      const FourierBasis<dim> &basis;
      FourierValues<dim>       values;
      Vector                   response;
    };

    /** The points where heat can go over, mostly a few of the edge, and
     *  s = sqrt(h W) there. */
    template <int dim>
    struct Exchange
    {
      std::vector<unsigned int>                              points;
      std::vector<std::pair<ElementView<dim>, unsigned int>> places;
      Vector                                                 s;

      Exchange(const InterfaceHeat<dim> &interface, const BasisTable<dim> &edge)
      {
        for (const auto &entry : edge.elements)
          {
            const ElementView<dim> element(edge, entry);
            for (unsigned int q = 0; q < edge.points_per_element; ++q)
              if (interface.conductance[element.point(q)] > 0.)
                {
                  points.push_back(element.point(q));
                  places.emplace_back(element, q);
                }
          }
        s.reinit(points.size());
        for (unsigned int i = 0; i < points.size(); ++i)
          s(i) =
            std::sqrt(interface.conductance[points[i]] * edge.JxW[points[i]]);
      }

      /** Of values at all points of the edge. */
      Vector
      gather(const Vector &values) const
      {
        Vector result(points.size());
        values.extract_subvector_to(points.begin(),
                                    points.end(),
                                    result.begin());
        return result;
      }

      std::vector<dealii::Point<dim - 1>>
      gather(const std::vector<dealii::Point<dim - 1>> &values) const
      {
        std::vector<dealii::Point<dim - 1>> result;
        for (const unsigned int point : points)
          result.push_back(values[point]);
        return result;
      }

      /** The reverse, zero elsewhere. */
      Vector
      spread(const Vector &values, const unsigned int n) const
      {
        Vector result(n);
        for (unsigned int i = 0; i < points.size(); ++i)
          result(points[i]) = values(i);
        return result;
      }

      /** Values of a spline of the chip. */
      Vector
      values(const Vector &coefficients) const
      {
        Vector result(points.size());
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const auto &[element, q] = places[i];
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              result(i) += element.N(q, a) * coefficients(element.function(a));
          }
        return result;
      }

      /** Power by function of heat by point. */
      Vector
      power(const Vector &heat, const unsigned int n_functions) const
      {
        Vector result(n_functions);
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const auto &[element, q] = places[i];
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              result(element.function(a)) += element.N(q, a) * heat(i);
          }
        return result;
      }
    };

    /** As conjugate gradients see a matrix. */
    template <class Product>
    struct Operator
    {
      Product product;

      void
      vmult(Vector &result, const Vector &y) const
      {
        result = product(y);
      }
    };

    /** Solves product(y) = right.
     *  @return number of iterations */
    template <class Product>
    unsigned int
    conjugate_gradients(const Product &product, const Vector &right, Vector &y)
    {
      const double norm = right.l2_norm();
      if (norm == 0.)
        return 0;
      dealii::SolverControl control(right.size(), tolerance * norm);
      try
        {
          dealii::SolverCG<Vector>(control).solve(
            Operator<Product>{product},
            y,
            right,
            dealii::PreconditionIdentity());
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          throw ComputationError(
            "The exchange of heat between chip and tool was not found within " +
            std::to_string(right.size()) + " iterations.");
        }
      return control.last_step();
    }



    /** Rise of the chip's coefficients by heat at points of the exchange. */
    template <int dim>
    struct ChipResponse
    {
      const HeatConduction<dim> &chip;
      const Exchange<dim>       &exchange;
      unsigned int               n_dofs;

      Vector
      operator()(const Vector &heat) const
      {
        Vector result = exchange.power(heat, n_dofs);
        chip.respond(result);
        return result;
      }
    };



    /**
     * Heat by point of the exchange that goes over from chip to tool, s y
     * [W/m^(3 - dim)].
     * @param difference of the temperatures there without exchange
     */
    template <int dim>
    Vector
    exchanged_heat(const Exchange<dim>     &exchange,
                   const ChipResponse<dim> &chip,
                   const ToolResponse<dim> &tool,
                   const Vector            &difference,
                   unsigned int            &iterations)
    {
      const auto product = [&](const Vector &y) {
        Vector heat = y;
        heat.scale(exchange.s);
        Vector       result = exchange.values(chip(heat));
        const Vector flux   = tool.flux(heat);
        result += tool.rise(flux, Vector(flux.size()));
        result.scale(exchange.s);
        result += y;
        return result;
      };
      Vector right = difference;
      right.scale(exchange.s);
      Vector y(right.size());
      iterations = conjugate_gradients(product, right, y);
      y.scale(exchange.s);
      return y;
    }
  } // namespace



  template <int dim>
  ThermalContact<dim>::ThermalContact(const BasisTable<dim>   &edge,
                                      const ThermalProperties &tool,
                                      const FourierBasis<dim> &waves,
                                      const double             offset)
    : edge(edge)
    , tool(tool, waves)
    , offset(offset)
  {}



  template <int dim>
  typename ThermalContact<dim>::Step
  ThermalContact<dim>::solve(const HeatConduction<dim> &chip,
                             const double               dt,
                             const Vector              &power,
                             const InterfaceHeat<dim>  &interface) const
  {
    const unsigned int      n = edge.JxW.size();
    const ToolResponse<dim> tool_response(tool, interface.places, dt);
    Vector                  half_friction(n);
    for (unsigned int q = 0; q < n; ++q)
      half_friction(q) = 0.5 * interface.friction[q] * edge.JxW[q];

    // Without exchange.
    Step step;
    step.dt      = dt;
    Vector total = power;
    add_point_values(edge, half_friction, total);
    step.chip_change        = chip.change(total);
    step.tool_flux          = tool_response.flux(half_friction);
    const Vector remembered = tool.remembered(dt);
    Vector       chip_rise  = values_at_points(edge, chip.rise());
    chip_rise += values_at_points(edge, step.chip_change);
    Vector tool_rise = tool_response.rise(step.tool_flux, remembered);
    tool_rise.add(offset);

    const Exchange<dim>     exchange(interface, edge);
    const ChipResponse<dim> respond{chip,
                                    exchange,
                                    static_cast<unsigned int>(power.size())};
    Vector                  difference = chip_rise;
    difference -= tool_rise;
    const Vector exchanged = exchanged_heat(
      exchange,
      respond,
      ToolResponse<dim>(tool, exchange.gather(interface.places), dt),
      exchange.gather(difference),
      step.iterations);

    const Vector heat      = exchange.spread(exchanged, n);
    const Vector from_chip = respond(exchanged),
                 to_tool   = tool_response.flux(heat);
    step.chip_change -= from_chip;
    step.tool_flux += to_tool;
    chip_rise -= values_at_points(edge, from_chip);
    tool_rise += tool_response.rise(to_tool, Vector(to_tool.size()));
    step.chip.assign(chip_rise.begin(), chip_rise.end());
    step.tool.assign(tool_rise.begin(), tool_rise.end());
    for (unsigned int q = 0; q < n; ++q)
      step.to_tool.push_back((half_friction(q) + heat(q)) / edge.JxW[q]);
    return step;
  }



  template <int dim>
  void
  ThermalContact<dim>::accept(const Step &step)
  {
    tool.accept(step.tool_flux, step.dt);
  }



  template <int dim>
  double
  ThermalContact<dim>::heat_of_tool() const
  {
    return tool.heat();
  }



  template <int dim>
  void
  ThermalContact<dim>::save(OutputArchive &archive) const
  {
    tool.save(archive);
  }



  template <int dim>
  void
  ThermalContact<dim>::load(InputArchive &archive)
  {
    tool.load(archive);
  }



  template class ThermalContact<2>;
  template class ThermalContact<3>;
} // namespace asperity
