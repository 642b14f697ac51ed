#ifndef asperity_contact_zone_run_family_h
#define asperity_contact_zone_run_family_h

#include <asperity/base/ranks.h>
#include <asperity/contact_zone/scene_parameters.h>

#include <functional>
#include <map>

namespace asperity
{
  /** How much finer than the entries of its scene a run is, in powers of two;
   *  negative numbers are coarser. */
  struct Fineness
  {
    int mesh    = 0; ///< elements along the contact edge, and across
    int step    = 0; ///< time steps
    int penalty = 0; ///< penalty [Pa/m], whatever the mesh

    /** Halves of an element by which the surfaces are moved against the mesh,
     *  in three dimensions along x and y: no finer, but another draw of what is
     *  left to chance. */
    int offset = 0;

    bool
    operator<(const Fineness &other) const;

    bool
    operator==(const Fineness &other) const;
  };

  /** Whether the scene has a mesh that is so much finer. */
  bool
  has_mesh(const SceneParameters &parameters, const int fineness);

  /** The run that is so much finer; the mesh must be there, has_mesh(). */
  SceneParameters
  with_fineness(const SceneParameters &parameters, const Fineness &fineness);

  /** What a run tells of itself. */
  struct FamilyMember
  {
    double       mu                = 0.;
    unsigned int unknowns          = 0;
    unsigned int newton_iterations = 0;

    /** Elements of the contact edge over which the chip slides, on its way
     * back, too; 0 where nobody has said it. */
    double elements_passed = 0.;

    /** To which the time of a run is nearly proportional. */
    double
    cost() const
    {
      return 1. * unknowns * newton_iterations;
    }
  };

  /** Runs of a scene that differ in mesh, time steps and penalty only. Each is
   *  computed once. */
  class RunFamily
  {
  public:
    /** Told of a run that is about to be computed. */
    using Progress = std::function<void(const Fineness &)>;

    /** @param parameters of the scene, with models chosen by `automatic` in
     *  them
     *  @param ranks that compute each run of a patch together */
    explicit RunFamily(const SceneParameters &parameters,
                       const Progress        &progress = {},
                       const Ranks           &ranks    = Ranks());

    /** @throws ComputationError if the run fails */
    const FamilyMember &
    run(const Fineness &fineness);

    /** Whether run() has it already. */
    bool
    has(const Fineness &fineness) const;

    /** Takes over a run that somebody else has computed. */
    void
    add(const Fineness &fineness, const FamilyMember &member);

    const SceneParameters &
    parameters() const;

    /** Of all runs so far. */
    double
    cost() const;

    std::size_t
    size() const;

  private:
    SceneParameters                  parameters_;
    Progress                         progress;
    Ranks                            ranks;
    std::map<Fineness, FamilyMember> members;
  };
} // namespace asperity

#endif
