#include <asperity/base/version.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_output.h>

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



  template <int dim>
  SceneOutput<dim>::SceneOutput(const SceneParameters &parameters,
                                const InputRecord     &inputs,
                                const Scene<dim>      &scene,
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



  template <int dim>
  void
  SceneOutput<dim>::step(const SlidingRun<dim> &run)
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



  template <int dim>
  void
  SceneOutput<dim>::write_pictures(const SlidingRun<dim> &run)
  {
    const unsigned int step = run.state().step;
    const double       time = run.state().time;
    last_picture            = step;
    write_chip(run);

    write_tool(step, time);
    write_contact(run.state().u, step, time);
    if (oil)
      oil->write(step, time, [&](std::ostream &out) {
        scene.gap_flow->write(out, time, step);
      });
  }



  template <int dim>
  void
  SceneOutput<dim>::write_chip(const SlidingRun<dim> &run)
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



  template <int dim>
  void
  SceneOutput<dim>::write_checkpoint(const SlidingRun<dim> &run) const
  {
    checkpoints.write({version_line(), inputs, save(run, scene)},
                      run.state().step);
  }



  template <int dim>
  double
  SceneOutput<dim>::seconds() const
  {
    return seconds_;
  }



  template class SceneOutput<2>;
  template class SceneOutput<3>;
} // namespace asperity
