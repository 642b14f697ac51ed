#include <asperity/contact_zone/run_family.h>
#include <asperity/contact_zone/scene_computation.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <tuple>

namespace asperity
{
  namespace
  {
    /** n 2^k, rounded up. */
    unsigned int
    times_power_of_two(const unsigned int n, const int k)
    {
      return static_cast<unsigned int>(std::ceil(std::ldexp(1. * n, k)));
    }
  } // namespace



  bool
  Fineness::operator<(const Fineness &other) const
  {
    return std::tie(mesh, step, penalty, offset) <
           std::tie(other.mesh, other.step, other.penalty, other.offset);
  }



  bool
  Fineness::operator==(const Fineness &other) const
  {
    return std::tie(mesh, step, penalty, offset) ==
           std::tie(other.mesh, other.step, other.penalty, other.offset);
  }



  bool
  has_mesh(const SceneParameters &parameters, const int fineness)
  {
    MeshParameters mesh = parameters.mesh;
    for (int k = 0; k > fineness; --k)
      {
        if (!mesh.has_coarser() ||
            (parameters.geometry.dimension == 3 && !mesh.has_coarser_across()))
          return false;
        mesh.coarsen();
      }
    for (int k = 0; k < fineness; ++k)
      {
        if (!mesh.has_finer())
          return false;
        mesh.refine();
      }
    return true;
  }



  SceneParameters
  with_fineness(const SceneParameters &parameters, const Fineness &fineness)
  {
    Assert(has_mesh(parameters, fineness.mesh),
           dealii::ExcMessage("no such mesh"));
    SceneParameters result = parameters;
    for (int k = 0; k > fineness.mesh; --k)
      result.mesh.coarsen();
    for (int k = 0; k < fineness.mesh; ++k)
      result.mesh.refine();
    result.mesh.offset += 0.5 * fineness.offset;
    ContactParameters &contact = result.contact;
    // The factor counts in penalties of elements of their own length.
    contact.penalty_factor =
      std::ldexp(contact.penalty_factor, fineness.penalty - fineness.mesh);
    if (contact.penalty)
      contact.penalty = std::ldexp(*contact.penalty, fineness.penalty);
    ProtocolParameters &protocol = result.protocol;
    protocol.ramp_steps =
      times_power_of_two(protocol.ramp_steps, fineness.step);
    protocol.slide_steps =
      times_power_of_two(protocol.slide_steps, fineness.step);
    protocol.steady_step = std::ldexp(protocol.steady_step, -fineness.step);
    protocol.strain_increment =
      std::ldexp(protocol.strain_increment, -fineness.step);
    return result;
  }



  RunFamily::RunFamily(const SceneParameters &parameters,
                       const Progress        &progress,
                       const Ranks           &ranks)
    : parameters_(parameters)
    , progress(progress)
    , ranks(ranks)
  {}



  const FamilyMember &
  RunFamily::run(const Fineness &fineness)
  {
    if (!has(fineness))
      {
        if (progress)
          progress(fineness);
        SceneParameters   scene  = with_fineness(parameters_, fineness);
        const SceneResult result = compute_scene(scene, ranks);
        add(fineness,
            {result.friction.mu, result.unknowns, result.newton_iterations});
      }
    return members.at(fineness);
  }



  bool
  RunFamily::has(const Fineness &fineness) const
  {
    return members.count(fineness) != 0;
  }



  void
  RunFamily::add(const Fineness &fineness, const FamilyMember &member)
  {
    members[fineness] = member;
  }



  const SceneParameters &
  RunFamily::parameters() const
  {
    return parameters_;
  }



  double
  RunFamily::cost() const
  {
    double sum = 0.;
    for (const auto &[fineness, member] : members)
      sum += member.cost();
    return sum;
  }



  std::size_t
  RunFamily::size() const
  {
    return members.size();
  }
} // namespace asperity
