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
    , last_picture(state.step)
  {
    if (!scene.share().ranks.is_first())
      return;
    const std::string &directory = parameters.output.directory;
    files = std::make_unique<Files>(directory, state.rows, kept(state));
    if (scene.gap_flow != nullptr)
      files->oil = std::make_unique<VtuSeries>(directory, "oil", kept(state));
    if constexpr (dim == 2)
      if (!parameters.output.field_times.empty())
        {
          recorder = std::make_unique<FieldRecorder>(parameters, scene);
          recorder->go_on(directory + "/fields.h5", state);
        }
  }



  template <int dim>
  SceneOutput<dim>::Files::Files(const std::string              &directory,
                                 const std::vector<FrictionRow> &rows,
                                 const int keep_until_step)
    : table(directory, rows)
    , chip(directory, "chip", keep_until_step)
    , tool(directory, "tool", keep_until_step)
    , contact_line(directory, "contact", keep_until_step)
    , checkpoints(directory + "/checkpoint")
  {}



  template <int dim>
  void
  SceneOutput<dim>::step(const SlidingRun<dim> &run)
  {
    dealii::Timer timer;
    if (files)
      files->table.append(run.state().rows.back());
    const unsigned int step = run.state().step;
    if (parameters.output.picture_interval > 0 &&
        step % parameters.output.picture_interval == 0)
      write_pictures(run);
    write_fields(run);
    if (files && parameters.output.checkpoint_interval > 0 &&
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
    if (!files)
      return;
    write_tool(step, time);
    write_contact(run.state().u, step, time);
    if (files->oil)
      files->oil->write(step, time, [&](std::ostream &out) {
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
                            parameters.mesh.n_quadrature_points(),
                            scene.share());
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
    const auto pieces         = chip_output->pieces(fields, time, step);
    if (files)
      files->chip.write(step, time, [&](std::ostream &out) {
        ChipOutput<dim>::write(out, pieces);
      });
  }



  template <int dim>
  void
  SceneOutput<dim>::write_fields(const SlidingRun<dim> &run)
  {
    if constexpr (dim == 2)
      if (recorder && recorder->step(run))
        recorder->fields().write(parameters.output.directory + "/fields.h5");
  }



  template <int dim>
  void
  SceneOutput<dim>::write_checkpoint(const SlidingRun<dim> &run) const
  {
    files->checkpoints.write({version_line(), inputs, save(run, scene)},
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
