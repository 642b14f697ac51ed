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

  /** The narrow scene with two waves, over whose hills it slides obliquely. */
  inline SceneParameters
  narrow_hills()
  {
    SceneParameters parameters      = narrow_scene();
    parameters.mesh.spans           = 8;
    parameters.mesh.across          = 6;
    parameters.geometry.width       = 0.75 * parameters.geometry.length;
    parameters.tool.spans           = std::nullopt;
    parameters.tool.wave_numbers    = {1., 1.};
    parameters.tool.across          = {1., -1.};
    parameters.tool.amplitudes      = {0.15e-6, 0.1e-6};
    parameters.tool.phases          = {0.3, 0.7};
    parameters.load.direction       = M_PI / 6.;
    parameters.protocol.slide_steps = 2;
    return parameters;
  }

  /** A level of the mesh is at contacts only.
   *  @param spans of the finest elements */
  inline SceneParameters
  adaptive_patch(const unsigned int spans)
  {
    SceneParameters parameters           = narrow_scene();
    parameters.geometry.height           = 3e-6;
    parameters.mesh.degree               = 1;
    parameters.mesh.spans                = spans;
    parameters.mesh.grading              = 4.;
    parameters.mesh.adaptive_levels      = 1;
    parameters.mesh.halo                 = 3;
    parameters.mesh.remesh_distance      = 0.3e-6;
    parameters.protocol.sliding_distance = 1.5e-6;
    parameters.protocol.ramp_fraction    = 0.2;
    parameters.protocol.slide_steps      = 5;
    return parameters;
  }

  /** One ridge across the motion, two coarse elements wide. */
  inline SceneParameters
  adaptive_ridge()
  {
    SceneParameters parameters   = adaptive_patch(32);
    parameters.geometry.width    = 1. / 8. * parameters.geometry.length;
    parameters.tool.wave_numbers = {1.};
    parameters.tool.amplitudes   = {0.15e-6};
    parameters.tool.phases       = {0.4};
    return parameters;
  }

  /** Hills with the length and the spans of a narrow scene that slides along x,
   *  turned by 90 degrees with their way: (x, y) becomes (-y, x). */
  inline SceneParameters
  turned_by_a_right_angle(SceneParameters hills)
  {
    std::swap(hills.geometry.length, *hills.geometry.width);
    std::swap(hills.mesh.spans, *hills.mesh.across);
    // k x/L + j y/W = k y'/L - j x'/W
    hills.tool.across    = {-1., 1.};
    hills.tool.phases    = {-0.3, 0.7};
    hills.load.direction = M_PI / 2.;
    return hills;
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
