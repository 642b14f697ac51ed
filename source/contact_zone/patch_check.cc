#include "patch_check.h"

#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Pieces of a sheet of harmonics, which take about 200 bytes each. */
    constexpr double largest_sheet = 1e6;

    /** The entries across the motion. */
    void
    check_mesh(const MeshParameters      &mesh,
               const ParameterDeclarator &parameters)
    {
      if (!mesh.across)
        return;
      const unsigned int multiple = 1u << mesh.refinement,
                         fewest   = (mesh.degree + 1) * multiple;
      if (*mesh.across % multiple != 0 || *mesh.across < fewest)
        throw InputError(parameters.where("Mesh/Spans across") + ": found " +
                         std::to_string(*mesh.across) + " with " +
                         std::to_string(mesh.refinement) +
                         " refinement levels; expected a multiple of " +
                         std::to_string(multiple) + " of at least " +
                         std::to_string(fewest) +
                         ", so that the coarsest level has p + 1 spans.");
    }

    /** Companions that tell the error of mu have elements twice as long. */
    void
    check_coarser(const MeshParameters      &mesh,
                  const ParameterDeclarator &parameters)
    {
      if (!mesh.has_coarser_across())
        throw InputError(
          parameters.where("Mesh/Spans across") + ": found " +
          (mesh.across ? std::to_string(*mesh.across) : "automatic") +
          " without refinement levels, of which no mesh twice as coarse can be "
          "made that would tell the error of mu (Accuracy/Control); expected "
          "an even number of at least " +
          std::to_string(2 * mesh.degree + 2) + ", or Refinement levels.");
    }

    void
    check_waves(const SurfaceParameters   &surface,
                const std::string         &section,
                const ParameterDeclarator &parameters)
    {
      if (surface.kind != SurfaceKind::harmonics || surface.across.empty())
        return;
      const std::string found =
        parameters.where(section + "/Wave numbers across") + ": found ";
      if (surface.across.size() != surface.wave_numbers.size())
        throw InputError(found + std::to_string(surface.across.size()) +
                         " values; expected " +
                         std::to_string(surface.wave_numbers.size()) +
                         ", one for each wave number, or none.");
      for (const double j : surface.across)
        if (j != std::floor(j))
          throw InputError(found + format_number(j) +
                           "; expected whole numbers, so that the surface is "
                           "periodic.");
      double highest = 0.;
      for (const double j : surface.across)
        highest = std::max(highest, std::abs(j));
      const double n = surface.n_spans_of_harmonics() *
                       SurfaceParameters::spans_across * std::max(1., highest);
      if (n > largest_sheet)
        throw InputError(found + format_number(highest) +
                         " waves, for which the sheet has " +
                         format_quantity(n, "1", 2) +
                         " pieces; expected at most a million: fewer waves, or "
                         "fewer Spline spans.");
    }
  } // namespace



  void
  check_profiles(const SceneParameters     &p,
                 const ParameterDeclarator &parameters)
  {
    if (p.load.direction != 0.)
      throw InputError(parameters.where("Load/Sliding direction") + ": found " +
                       format_quantity(p.load.direction, "deg") +
                       " in two dimensions; expected 0, since a profile has no "
                       "other direction, or Geometry/Dimension = 3.");
  }



  void
  check_patch(const SceneParameters &p, const ParameterDeclarator &parameters)
  {
    const auto fail = [&](const std::string &found,
                          const std::string &expected) {
      throw InputError(parameters.where("Geometry/Dimension") +
                       ": found 3 with " + found + "; expected 2, or " +
                       expected + ".");
    };
    const LubricantModel lubricant = p.lubrication.model;
    if (lubricant == LubricantModel::reynolds || fills_gap(lubricant))
      fail("the lubricant model `" + name(lubricant) + "`, " +
             (fills_gap(lubricant) ? "whose flow is that of a plane" :
                                     "whose film is that of a profile"),
           "Lubrication/Model = pocket, automatic or none");
    if (p.tool.kind == SurfaceKind::measured && p.tool.topography.length == 0.)
      throw InputError(parameters.where("Tool/Topography/Profile length") +
                       ": found 0 um in three dimensions; expected the length "
                       "of the window along the motion, since a patch of all "
                       "of a map would be too large.");
    if (p.tool.kind == SurfaceKind::measured &&
        p.tool.topography.direction != 0.)
      throw InputError(
        parameters.where("Tool/Topography/Profile direction") + ": found " +
        format_quantity(p.tool.topography.direction, "deg") +
        " in three dimensions; expected 0, since the window keeps "
        "the axes of the map: choose Load/Sliding direction.");
    if (p.chip.kind == SurfaceKind::measured)
      fail("a measured chip", "Chip surface/Kind = flat or harmonics");
    if (p.contact.quadrature == 1)
      throw InputError(parameters.where("Contact/Quadrature points") +
                       ": found 1 in three dimensions; expected 0, or at least "
                       "2.");
    check_mesh(p.mesh, parameters);
    if (p.accuracy.is_wanted())
      check_coarser(p.mesh, parameters);
    check_waves(p.tool, "Tool", parameters);
    check_waves(p.chip, "Chip surface", parameters);
  }
} // namespace asperity
