#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  void
  OutputParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Output");
    parameters.text("Output directory",
                    directory,
                    "Folder of the results, made if it does not exist. A name "
                    "with a `#` after a blank stands between quotation "
                    "marks.");
    parameters.integer("Picture interval",
                       picture_interval,
                       Range::between(0, 1000000),
                       "Steps between VTU files; 0 writes only the end.");
    parameters.integer("Checkpoint interval",
                       checkpoint_interval,
                       Range::between(0, 1000000),
                       "Steps between checkpoints; 0 writes none.");
    parameters.integer("Subdivisions",
                       subdivisions,
                       Range::between(1, 10),
                       "Pieces into which pictures divide an element in each "
                       "direction.");
    parameters.list(
      "Field times",
      field_times,
      "1",
      Range::between(0.001, 1.),
      "Shares of t_end, in growing order, as in 0.5, 1: at the first step at or "
      "after each of them the fields of the chip go into fields.h5 (HDF5), from "
      "which `asperity reduce` learns: displacement, stress, plastic strain and "
      "temperature, and pressure and traction of the contact edge. Each run of "
      "a campaign keeps its own. For profiles on a mesh that stays, and the "
      "window `time`. Empty: none.");
    parameters.flag(
      "Restart",
      restart,
      "Go on from the newest checkpoint of the output directory; false: a new "
      "run, which removes what an earlier one has left there. A checkpoint of "
      "other inputs is refused; only the other entries of Output, those of the "
      "solvers that do not change the solution, those of Accuracy, Window "
      "fraction, and how a `steady` window ends may differ.");
  }
} // namespace asperity
