#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_input.h>

namespace asperity
{
  SceneInput::SceneInput(const std::string &file, const EntryValues &changes)
    : file(file)
    , declarator(handler)
  {
    parameters.declare(declarator);
    declarator.read_file(file);
    for (const auto &[path, value] : changes)
      declarator.set(path, value);
    parameters.check(declarator);
    parameters.resolve();
    record = InputRecord(declarator);
  }



  template <int dim>
  AuditedScene<dim>::AuditedScene(SceneParameters &parameters,
                                  const Ranks     &ranks)
    : scene(std::make_unique<Scene<dim>>(parameters, ranks))
    , audit(audit_scene(parameters, *scene))
  {
    if (parameters.protocol.inertia == Inertia::automatic)
      parameters.protocol.inertia = audit.inertia;
    audit.inertia = parameters.protocol.inertia;
    if (parameters.protocol.reversal_distance > 0. &&
        audit.inertia == Inertia::dynamic)
      throw InputError(
        "Entry 'Protocol/Reversal distance': found a chip that turns back with "
        "a lubricant that fills the gap, for which the chip has inertia; "
        "expected 0 um or another lubricant model.");
    if (ranks.are_several() && audit.inertia == Inertia::dynamic)
      throw InputError("Entry 'Protocol/Inertia': found a chip whose inertia "
                       "counts on " +
                       std::to_string(ranks.size()) +
                       " ranks; expected quasi-static, or one rank.");
    if (parameters.mesh.adaptive_levels > 0 &&
        audit.inertia == Inertia::dynamic)
      throw InputError(
        "Entry 'Mesh/Adaptive levels': found " +
        std::to_string(parameters.mesh.adaptive_levels) +
        " with a chip whose inertia counts; expected 0, or Protocol/Inertia = "
        "quasi-static.");
    if (parameters.lubrication.model == LubricantModel::automatic)
      {
        if (parameters.mesh.adaptive_levels > 0 &&
            audit.lubricant != LubricantModel::pocket &&
            audit.lubricant != LubricantModel::none)
          throw InputError(
            "Entry 'Mesh/Adaptive levels': found " +
            std::to_string(parameters.mesh.adaptive_levels) +
            " with a scene for which the audit chooses the lubricant model `" +
            name(audit.lubricant) +
            "`; expected 0, or Lubrication/Model = pocket or none.");
        parameters.lubrication.model = audit.lubricant;
        scene = std::make_unique<Scene<dim>>(parameters, ranks);
      }
  }



  template <int dim>
  AuditedScene<dim>::AuditedScene(SceneInput &input, const Ranks &ranks)
  try : AuditedScene(input.parameters, ranks)
    {
      audit.unused = unused_entries(input.parameters, input.declarator);
    }
  catch (const InputError &error)
    {
      throw InputError(input.file + ": " + error.what());
    }



  template struct AuditedScene<2>;
  template struct AuditedScene<3>;
} // namespace asperity
