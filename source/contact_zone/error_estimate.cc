#include <asperity/contact_zone/error_estimate.h>
#include <asperity/contact_zone/scene_computation.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Order of mu in the element length. The edges of contacts leave a
     *  displacement in H^(5/2), whatever the degree from 2 on is (Z. Belhachmi
     *  and F. Ben Belgacem, Math. Comp. 72 (2003) 83-104). */
    constexpr double mesh_order = 1.5;

    unsigned int
    halved(const unsigned int n)
    {
      return std::max(1u, (n + 1) / 2);
    }
  } // namespace



  void
  AccuracyParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Accuracy");
    parameters.choice(
      "Control",
      control,
      {{"off", AccuracyControl::off}, {"estimate", AccuracyControl::estimate}},
      "`estimate`: three coarser companions of the run tell the "
      "numerical error of mu by mesh, time steps and penalty, "
      "for as much time again as the run took; `off`: nobody "
      "tells it.");
    parameters.number("Error",
                      error,
                      Range{0., 0.5, true, true},
                      "Relative numerical error of mu that is wanted: a run "
                      "whose estimate is larger ends with a warning that names "
                      "what to refine; 0: no estimate is made.");
  }



  double
  ErrorEstimate::total() const
  {
    return std::sqrt(mesh * mesh + step * step + penalty * penalty);
  }



  std::string
  ErrorEstimate::largest() const
  {
    return mesh >= std::max(step, penalty) ? "mesh" :
           step >= penalty                 ? "step" :
                                             "penalty";
  }



  SceneParameters
  with_coarser_mesh(const SceneParameters &parameters)
  {
    SceneParameters result = parameters;
    MeshParameters &mesh   = result.mesh;
    Assert(mesh.has_coarser(), dealii::ExcMessage("no coarser mesh"));
    mesh.spans /= 2;
    if (mesh.refinement > 0)
      --mesh.refinement;
    result.contact.penalty_factor *= 2.; // over elements twice as long
    return result;
  }



  SceneParameters
  with_longer_steps(const SceneParameters &parameters)
  {
    SceneParameters     result   = parameters;
    ProtocolParameters &protocol = result.protocol;
    protocol.ramp_steps          = halved(protocol.ramp_steps);
    protocol.slide_steps         = halved(protocol.slide_steps);
    protocol.steady_step *= 2.;
    return result;
  }



  SceneParameters
  with_softer_contact(const SceneParameters &parameters)
  {
    SceneParameters result = parameters;
    result.contact.penalty_factor *= 0.5;
    if (result.contact.penalty)
      *result.contact.penalty *= 0.5;
    return result;
  }



  ErrorEstimate
  estimate_error(const SceneParameters                   &parameters,
                 const double                             mu,
                 const std::function<void(unsigned int)> &progress)
  {
    unsigned int n     = 0;
    const auto   mu_of = [&](SceneParameters companion) {
      if (progress)
        progress(++n);
      return compute_scene(companion).friction.mu;
    };
    const SceneParameters coarse    = with_coarser_mesh(parameters);
    const double          mu_coarse = mu_of(coarse);
    const double          scale     = 1. / std::max(std::abs(mu), 1e-300);
    ErrorEstimate         result;
    result.mesh =
      scale * std::abs(mu - mu_coarse) / (std::pow(2., mesh_order) - 1.);
    result.step =
      scale * std::abs(mu_of(with_longer_steps(coarse)) - mu_coarse);
    result.penalty =
      scale * std::abs(mu_of(with_softer_contact(coarse)) - mu_coarse);
    return result;
  }
} // namespace asperity
