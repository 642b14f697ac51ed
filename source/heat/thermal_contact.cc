#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/point_values.h>
#include <asperity/heat/thermal_contact.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <cmath>

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

      /** The same at some of the points. */
      ToolResponse(const ToolResponse<dim>         &all,
                   const std::vector<unsigned int> &points)
        : basis(all.basis)
        , values(all.values, points)
        , response(all.response)
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

    /** The points where heat can go over, and s = sqrt(h W) there. */
    struct Exchange
    {
      std::vector<unsigned int> points;
      Vector                    s;

      template <int dim>
      Exchange(const InterfaceHeat<dim> &interface, const BasisTable<dim> &edge)
      {
        for (unsigned int q = 0; q < edge.JxW.size(); ++q)
          if (interface.conductance[q] > 0.)
            points.push_back(q);
        s.reinit(points.size());
        for (unsigned int i = 0; i < points.size(); ++i)
          s(i) =
            std::sqrt(interface.conductance[points[i]] * edge.JxW[points[i]]);
      }

      /** Values at all points, to those where heat goes over. */
      Vector
      gather(const Vector &values) const
      {
        Vector result(points.size());
        values.extract_subvector_to(points.begin(),
                                    points.end(),
                                    result.begin());
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



    /**
     * Heat by point that goes over from chip to tool, s y [W/m^(3 - dim)].
     * @param respond rise of the chip's coefficients by heat at points
     * @param difference of the temperatures without exchange, at all points
     */
    template <int dim, class Respond>
    Vector
    exchanged_heat(const Exchange          &exchange,
                   const ToolResponse<dim> &tool,
                   const BasisTable<dim>   &edge,
                   const Respond           &respond,
                   const Vector            &difference,
                   unsigned int            &iterations)
    {
      const unsigned int n       = difference.size();
      const auto         product = [&](const Vector &y) {
        Vector heat = y;
        heat.scale(exchange.s);
        Vector result = exchange.gather(
          values_at_points(edge, respond(exchange.spread(heat, n))));
        const Vector flux = tool.flux(heat);
        result += tool.rise(flux, Vector(flux.size()));
        result.scale(exchange.s);
        result += y;
        return result;
      };
      Vector right = exchange.gather(difference);
      right.scale(exchange.s);
      Vector y(right.size());
      iterations = conjugate_gradients(product, right, y);
      y.scale(exchange.s);
      return exchange.spread(y, n);
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

    const auto respond = [&](const Vector &heat) {
      Vector result(power.size());
      add_point_values(edge, heat, result);
      chip.respond(result);
      return result;
    };
    Vector difference = chip_rise;
    difference -= tool_rise;
    const Exchange exchange(interface, edge);
    const Vector   heat =
      exchanged_heat(exchange,
                     ToolResponse<dim>(tool_response, exchange.points),
                     edge,
                     respond,
                     difference,
                     step.iterations);

    const Vector from_chip = respond(heat), to_tool = tool_response.flux(heat);
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
