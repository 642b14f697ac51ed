#ifndef asperity_tests_contact_zone_scene_examples_h
#define asperity_tests_contact_zone_scene_examples_h

#include <asperity/contact_zone/scene_output.h>

#include <memory>
#include <vector>

namespace asperity
{
  /** Tool and chip of the reference scene R0 on a coarse mesh, a few steps. */
  inline SceneParameters
  coarse_scene()
  {
    SceneParameters parameters;
    parameters.mesh.spans           = 40;
    parameters.mesh.refinement      = 1;
    parameters.mesh.grading         = 2.;
    parameters.protocol.ramp_steps  = 5;
    parameters.protocol.slide_steps = 10;
    parameters.protocol.inertia     = Inertia::quasi_static;
    return parameters;
  }

  /** R0 on a very coarse mesh, as wide as three of its columns. */
  inline SceneParameters
  narrow_scene()
  {
    SceneParameters parameters     = coarse_scene();
    parameters.mesh.spans          = 16;
    parameters.tool.spans          = 96;
    parameters.protocol.ramp_steps = 2, parameters.protocol.slide_steps = 3;
    parameters.solver.tolerance   = 1e-9;
    parameters.geometry.dimension = 3;
    parameters.geometry.width     = 3. / 8. * parameters.geometry.length;
    return parameters;
  }

  /** The tool of the scene moved by a distance s in x. */
  inline void
  shift_tool(SceneParameters &parameters, const double s)
  {
    for (std::size_t k = 0; k < parameters.tool.phases.size(); ++k)
      parameters.tool.phases[k] -= 2. * M_PI * parameters.tool.wave_numbers[k] *
                                   s / parameters.geometry.length;
  }

  /** A scene and its run, from the start to the end. */
  template <int dim>
  struct CompleteRunIn
  {
    explicit CompleteRunIn(
      const SceneParameters                    &scene_parameters,
      const typename SlidingRun<dim>::Observer &observer =
        [](const SlidingRun<dim> &) {})
      : parameters(scene_parameters)
      , scene(parameters)
      , run(parameters, scene)
    {
      run.run(observer);
    }

    const std::vector<FrictionRow> &
    rows() const
    {
      return run.state().rows;
    }

    /** p L [N/m] */
    double
    load() const
    {
      return parameters.load.pressure * scene.length;
    }

    const SceneParameters parameters;
    Scene<dim>            scene;
    SlidingRun<dim>       run;
  };

  using CompleteRun = CompleteRunIn<2>;
} // namespace asperity

#endif
