#include <asperity/base/version.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/postprocess/polyline.h>

#include <deal.II/base/timer.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Up to which step pictures stay. */
    int
    kept(const RunState &state)
    {
      return state.step > 0 ? static_cast<int>(state.step) :
                              VtuSeries::keep_nothing;
    }
  } // namespace



  SceneOutput::SceneOutput(const SceneParameters &parameters,
                           const InputRecord     &inputs,
                           const Scene           &scene,
                           const RunState        &state)
    : parameters(parameters)
    , inputs(inputs)
    , scene(scene)
    , table(parameters.output.directory, state.rows)
    , chip(parameters.output.directory, "chip", kept(state))
    , tool(parameters.output.directory, "tool", kept(state))
    , contact_line(parameters.output.directory, "contact", kept(state))
    , checkpoints(parameters.output.directory + "/checkpoint")
    , last_picture(state.step)
  {
    if (scene.gap_flow != nullptr)
      oil = std::make_unique<VtuSeries>(parameters.output.directory,
                                        "oil",
                                        kept(state));
  }



  void
  SceneOutput::step(const SlidingRun &run)
  {
    dealii::Timer timer;
    table.append(run.state().rows.back());
    const unsigned int step = run.state().step;
    if (parameters.output.picture_interval > 0 &&
        step % parameters.output.picture_interval == 0)
      write_pictures(run);
    if (parameters.output.checkpoint_interval > 0 &&
        parameters.mesh.adaptive_levels == 0 &&
        step % parameters.output.checkpoint_interval == 0)
      write_checkpoint(run);
    seconds_ += timer.wall_time();
  }



  void
  SceneOutput::write_pictures(const SlidingRun &run)
  {
    const unsigned int step = run.state().step;
    const double       time = run.state().time;
    last_picture            = step;
    write_chip(run);

    Polyline           curve;
    const unsigned int n = 4 * scene.tool_surface.curve.knot_vector().n_spans();
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = scene.length * i / n;
        curve.points.emplace_back(x, scene.tool_surface.height(x));
      }
    tool.write(step, time, [&](std::ostream &out) {
      write_polyline(out, curve, time, step);
    });
    write_contact_line(run.state().u, step, time);
    if (oil)
      oil->write(step, time, [&](std::ostream &out) {
        scene.gap_flow->write(out, time, step);
      });
  }



  void
  SceneOutput::write_chip(const SlidingRun &run)
  {
    const unsigned int step = run.state().step;
    const double       time = run.state().time;
    if (drawn_mesh != scene.space->hierarchy())
      {
        drawn_mesh = scene.space->hierarchy();
        chip_output.emplace(*scene.space,
                            scene.geometry,
                            parameters.output.subdivisions,
                            parameters.mesh.n_quadrature_points());
      }
    ChipFields fields;
    fields.displacement.reinit(scene.n_dofs());
    std::copy_n(run.state().u.begin(),
                scene.n_dofs(),
                fields.displacement.begin());
    const auto         &history = scene.chip->history();
    std::vector<double> strain(history.size()), temperature(history.size());
    for (std::size_t q = 0; q < history.size(); ++q)
      {
        strain[q]      = history[q].plastic_strain;
        temperature[q] = history[q].temperature - 273.15;
      }
    fields.quadrature_scalars = {{"equivalent plastic strain [-]", strain},
                                 {"temperature [degC]", temperature},
                                 {"von Mises stress [Pa]",
                                  scene.chip->mises_stress()}};
    chip.write(step, time, [&](std::ostream &out) {
      chip_output->write(out, fields, time, step);
    });
  }



  void
  SceneOutput::write_contact_line(const dealii::Vector<double> &u,
                                  const unsigned int            step,
                                  const double                  time)
  {
    Polyline                          line;
    const auto                       &contact = *scene.contact;
    std::vector<double>               gap, oil_pressure;
    std::vector<dealii::Tensor<1, 2>> traction;
    const ShearTraction<2>              *shear = contact.shear();
    // per present length
    std::vector<double>       pressure = contact.pressure(), shear_traction;
    const std::vector<double> stretch  = contact.stretch(u);
    if (shear != nullptr)
      shear_traction = shear->at_points();
    for (std::size_t q = 0; q < pressure.size(); ++q)
      {
        pressure[q] /= stretch[q];
        gap.push_back(contact.gaps()[q].gap);
        oil_pressure.push_back(
          scene.lubricant ?
            scene.lubricant->pressure(contact.table().parameter[q][0]) :
            0.);
        traction.push_back(pressure[q] * contact.gaps()[q].normal);
        if (shear == nullptr)
          continue;
        shear_traction[q] /= stretch[q];
        traction.back() -= shear_traction[q] * shear->slip()[q].tangent;
      }
    line.points  = contact.positions();
    line.scalars = {{"contact pressure [Pa]", pressure},
                    {"oil pressure [Pa]", oil_pressure},
                    {"gap [m]", gap}};
    line.vectors = {{"traction [Pa]", traction}};
    if (shear != nullptr)
      {
        line.scalars.emplace_back("shear traction [Pa]", shear_traction);
        line.scalars.emplace_back("sticking [-]", shear->sticking());
      }
    if (scene.heat)
      {
        const auto add = [&line](const std::string  &name,
                                 std::vector<double> temperature) {
          for (double &value : temperature)
            value -= 273.15;
          line.scalars.push_back({name, temperature});
        };
        add("temperature of the chip [degC]", scene.heat->chip_temperature());
        add("temperature of the tool [degC]", scene.heat->tool_temperature());
        line.scalars.push_back(
          {"heat flux into the tool [W/m^2]", scene.heat->flux_to_tool()});
      }
    contact_line.write(step, time, [&](std::ostream &out) {
      write_polyline(out, line, time, step);
    });
  }



  void
  SceneOutput::write_checkpoint(const SlidingRun &run) const
  {
    checkpoints.write({version_line(), inputs, save(run, scene)},
                      run.state().step);
  }



  double
  SceneOutput::seconds() const
  {
    return seconds_;
  }
} // namespace asperity
