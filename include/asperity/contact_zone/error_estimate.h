#ifndef asperity_contact_zone_error_estimate_h
#define asperity_contact_zone_error_estimate_h

#include <asperity/contact_zone/run_family.h>

#include <string>

namespace asperity
{
  /** The numerical error of mu by source, each relative to mu, and positive if
   *  mu seems to be too large. */
  struct ErrorEstimate
  {
    double mesh = 0., step = 0., penalty = 0.;

    /** All of them; not negative. Their signs are known where mu converges
     *  smoothly, and left to chance where edges of contacts pass few elements:
     *  the quadratic mean of their sum and of the root of the sum of their
     *  squares. */
    double
    total() const;

    /** What is left of it at settings that are finer by this. */
    ErrorEstimate
    after(const Fineness &finer) const;

    /** "mesh", "step" or "penalty", whichever is largest. */
    std::string
    largest() const;
  };

  /**
   * The error of a run by coarser companions of its family, each of which
   * differs in one thing from another.
   *
   * Halving the elements twice measures the constant C of an error C h^2 by two
   * changes of mu. Edges of contacts, which come to lie somewhere in elements,
   * add a share to each that is left to chance, and on the longest elements
   * contacts may not be resolved at all, so that the smaller one counts. The
   * error by steps and penalty, which is of first order, is told by what
   * halving each of them changes on elements twice as long, which cost a
   * third; on those of the run if longer ones change mu by more than 5 %.
   *
   * @param of the run whose error is wanted; its mesh must have a coarser one
   * @throws ComputationError if a companion fails
   */
  ErrorEstimate
  estimate_error(RunFamily &family, const Fineness &of);
} // namespace asperity

#endif
