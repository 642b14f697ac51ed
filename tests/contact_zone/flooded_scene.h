#ifndef asperity_tests_contact_zone_flooded_scene_h
#define asperity_tests_contact_zone_flooded_scene_h

#include <asperity/base/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

#include "scene_examples.h"

namespace asperity
{
  /** A rough chip below the tool of R0, the gap full of oil. */
  inline SceneParameters
  flooded_scene()
  {
    SceneParameters parameters   = coarse_scene();
    parameters.chip.kind         = SurfaceKind::harmonics;
    parameters.chip.wave_numbers = {2, 3, 5};
    parameters.chip.amplitudes   = {0.03e-6, 0.03e-6, 0.02e-6};
    parameters.chip.phases       = {1, 2, 3};
    // Wide enough for the surfaces never to touch.
    parameters.geometry.initial_gap  = 0.1e-6;
    parameters.protocol.inertia      = Inertia::dynamic;
    parameters.lubrication.model     = LubricantModel::navier_stokes;
    parameters.lubrication.mesh.rows = 2;
    return parameters;
  }

  /** Whatever is wrong, as the user reads it. */
  inline std::string
  complaint(SceneParameters parameters)
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    SceneParameters          declared;
    declared.declare(declarator);
    try
      {
        parameters.check(declarator);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace asperity

#endif
