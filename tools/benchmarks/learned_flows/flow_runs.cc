#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cstdio>

#include "flow_snapshots.h"

namespace learned_flows
{
  namespace
  {
    std::vector<double>
    to_list(const Vector &values)
    {
      return {values.begin(), values.end()};
    }

    /** |div v| over |grad v|. */
    double
    divergence_of(const NavierStokes &flow, const Vector &solution)
    {
      const FluidSpace                        &space = flow.space();
      const dealii::QGauss<2>                  gauss(space.degree() + 1);
      dealii::FEValues<2>                      values(flow.mapping(),
                                 space.dofs().get_fe(),
                                 gauss,
                                 dealii::update_gradients |
                                   dealii::update_JxW_values);
      const dealii::FEValuesExtractors::Vector velocity(0);
      std::vector<Tensor<2, 2>>                gradients(gauss.size());
      double                                   of_div = 0., of_grad = 0.;
      for (const auto &cell : space.cells())
        {
          values.reinit(cell);
          values[velocity].get_function_gradients(solution, gradients);
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              of_div += std::pow(trace(gradients[q]), 2) * values.JxW(q);
              of_grad += gradients[q].norm_square() * values.JxW(q);
            }
        }
      return std::sqrt(of_div / of_grad);
    }

    /** Integral of the stress on a wall, as seen by the wall [N/m]: linear in
     *  the solution, and of a decoded one defined without an equation. */
    Tensor<1, 2>
    force_on(const NavierStokes &flow,
             const BoundaryIds  &walls,
             const double        viscosity,
             const Vector       &solution)
    {
      const FluidSpace                        &space = flow.space();
      const dealii::QGauss<1>                  gauss(space.degree() + 2);
      dealii::FEFaceValues<2>                  values(flow.mapping(),
                                     space.dofs().get_fe(),
                                     gauss,
                                     dealii::update_values |
                                       dealii::update_gradients |
                                       dealii::update_normal_vectors |
                                       dealii::update_JxW_values);
      const dealii::FEValuesExtractors::Vector velocity(0);
      const dealii::FEValuesExtractors::Scalar pressure(2);
      std::vector<Tensor<2, 2>>                gradients(gauss.size());
      std::vector<double>                      pressures(gauss.size());
      Tensor<1, 2>                             force;
      for (const auto &cell : space.cells())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary() &&
              walls.count(cell->face(face)->boundary_id()) > 0)
            {
              values.reinit(cell, face);
              values[velocity].get_function_gradients(solution, gradients);
              values[pressure].get_function_values(solution, pressures);
              for (unsigned int q = 0; q < gauss.size(); ++q)
                {
                  const auto n = values.normal_vector(q); // out of the fluid
                  const Tensor<2, 2> D = gradients[q] + transpose(gradients[q]);
                  force +=
                    (pressures[q] * n - viscosity * (D * n)) * values.JxW(q);
                }
            }
      return force;
    }



    class Street : public LearnedFlow
    {
    public:
      Street()
        : channel(false, 1, 0, street_options(), [](double) { return 1.; })
      {}

      std::string
      name() const override
      {
        return "street";
      }

      FlowSnapshots
      compute() override
      {
        constexpr double    dt = 0.005, end = 8.;
        std::vector<double> t;
        FlowSnapshots       all;
        double              lift_before = 0.;
        std::vector<double> crossings; // of zero lift, upwards
        while (crossings.size() < 2)
          {
            step(channel.flow->time() < 0.5 * end ? 2. * dt : dt);
            const double lift = channel.force()[1], time = channel.flow->time();
            if (time > end && lift_before < 0. && lift >= 0.)
              crossings.push_back(time - dt * lift / (lift - lift_before));
            lift_before = lift;
            if (crossings.size() == 1)
              {
                all.inputs.push_back(time);
                all.solutions.push_back(to_list(channel.flow->solution()));
              }
          }
        const double period = crossings[1] - crossings[0];
        for (double &time : all.inputs)
          time = (time - crossings[0]) / period;
        std::printf("period %.5f s, Strouhal number %.5f\n",
                    period,
                    0.1 / period);
        return all;
      }

      std::vector<std::string>
      measures() const override
      {
        return {"drag", "lift"};
      }

      FlowNumbers
      numbers(const std::vector<double> &solution) override
      {
        const Vector u = to_vector(solution);
        // 2 F / (rho U^2 D) with U = 1 m/s and D = 0.1 m
        const auto force =
          20. * force_on(*channel.flow, channel.walls, 1e-3, u);
        return {{force[0], force[1]}, divergence_of(*channel.flow, u)};
      }

      std::vector<double>
      coordinates(const double phase) const override
      {
        const double angle = 2. * dealii::numbers::PI * phase;
        return {std::cos(angle), std::sin(angle)};
      }

      const NavierStokes &
      flow() const override
      {
        return *channel.flow;
      }

      std::array<unsigned int, 2>
      waves() const override
      {
        return {{16, 2}};
      }

    private:
      static FluidOptions
      street_options()
      {
        FluidOptions options             = channel_options(1., 1e-3);
        options.degree                   = 3;
        options.geometry_degree          = 3;
        options.kept_tangent_contraction = 0.3;
        return options;
      }

      void
      step(const double dt)
      {
        NavierStokes &flow = *channel.flow;
        flow.begin_step(dt);
        // A swing of the cylinder's velocity wakes the street up.
        const double t_swing = std::min(flow.time() / 0.33, 1.);
        const double push    = std::sin(2. * dealii::numbers::PI * t_swing);
        flow.boundary().set_velocity(channel.walls, constant(0., push));
        solve(flow);
        flow.accept();
      }

      ChannelFlow channel;
    };



    class Cavity : public LearnedFlow
    {
    public:
      Cavity()
        : cavity(32)
      {
        cavity.solve_at(1.);
      }

      std::string
      name() const override
      {
        return "cavity";
      }

      FlowSnapshots
      compute() override
      {
        FlowSnapshots result;
        for (unsigned int i = 0; i < n; ++i)
          {
            result.inputs.push_back(lowest *
                                    std::pow(highest / lowest, i / (n - 1.)));
            cavity.solve_at(result.inputs.back());
            result.solutions.push_back(to_list(cavity.flow->solution()));
          }
        return result;
      }

      std::vector<std::string>
      measures() const override
      {
        return {"least u on x = 1/2"};
      }

      FlowNumbers
      numbers(const std::vector<double> &solution) override
      {
        const Vector u = to_vector(solution);
        cavity.flow->set_solution(u);
        double minimum = 0.;
        for (unsigned int i = 1; i < 1000; ++i)
          minimum =
            std::min(minimum, cavity.flow->velocity_at({0.5, i / 1000.})[0]);
        return {{minimum}, divergence_of(*cavity.flow, u)};
      }

      std::vector<double>
      coordinates(const double Reynolds) const override
      {
        return {2. * std::log(Reynolds / lowest) / std::log(highest / lowest) -
                1.};
      }

      const NavierStokes &
      flow() const override
      {
        return *cavity.flow;
      }

      std::array<unsigned int, 2>
      waves() const override
      {
        return {{8, 4}};
      }

    private:
      static constexpr unsigned int n      = 41;
      static constexpr double       lowest = 100., highest = 1000.;

      LidCavity cavity;
    };
  } // namespace



  std::unique_ptr<LearnedFlow>
  make_street()
  {
    return std::make_unique<Street>();
  }



  std::unique_ptr<LearnedFlow>
  make_cavity()
  {
    return std::make_unique<Cavity>();
  }
} // namespace learned_flows
