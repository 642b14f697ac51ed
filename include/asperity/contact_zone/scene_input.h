#ifndef asperity_contact_zone_scene_input_h
#define asperity_contact_zone_scene_input_h

#include <asperity/base/input_record.h>
#include <asperity/base/parameters.h>
#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/scene_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /** Entries by their paths, {"Load/Pressure", "450 MPa"}. */
  using EntryValues = std::vector<std::pair<std::string, std::string>>;

  /** A parameter file of a scene, declared, read and checked. */
  struct SceneInput
  {
    /**
     * @param file the parameter file
     * @param changes entries that are set after the file has been read
     * @throws InputError if the file, a change, or their combination is wrong
     */
    explicit SceneInput(const std::string &file,
                        const EntryValues &changes = {});

    const std::string        file; ///< as given
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator;
    SceneParameters          parameters;

    /** Taken before anything reads the files that are named. */
    InputRecord record;
  };

  /** A scene with the models that the parameters ask for or, where they say
   *  `automatic`, those of the audit; these go into the parameters. */
  template <int dim>
  struct AuditedScene
  {
    /** @throws InputError if no scene can be made of the parameters, which
     *    shows only when surfaces are read and meshes are built */
    explicit AuditedScene(SceneParameters &parameters,
                          const Ranks     &ranks = Ranks());

    /** The scene of a file, which errors name. */
    explicit AuditedScene(SceneInput &input, const Ranks &ranks = Ranks());

    std::unique_ptr<Scene<dim>> scene;
    SceneAudit                  audit;
  };
} // namespace asperity

#endif
