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

    /** What is not known of their sum, since edges of contacts come to lie
     *  somewhere in elements: its standard deviation, not negative. */
    double chance = 0.;

    /** What is not known of the error by the mesh, since elements twice as long
     *  may not resolve the contacts; not negative. */
    double unresolved = 0.;

    /** All of them; not negative: the root of the squares of their sum, of what
     *  is left to chance, and of a share of each, by which it is uncertain. */
    double
    total() const;

    /** mu without these errors: Richardson's extrapolation in all of them. */
    double
    corrected(const double mu) const;

    /** How far corrected() may be off, relative to mu; not negative. */
    double
    uncertainty() const;

    /** What is left at settings that are finer by this. */
    ErrorEstimate
    after(const Fineness &finer) const;

    /** "mesh", "step" or "penalty", whichever is largest. */
    std::string
    largest() const;
  };

  /**
   * The error of a run by companions of its family, each of which differs in
   * one thing from another.
   *
   * Elements twice as long (in three dimensions along and across) tell the
   * error by the mesh, of second order and less where they do not resolve the
   * contacts, by a mean of two draws: their edges are moved by half an element
   * in each direction. What halving steps and penalty changes on
   * them tells the errors by these, of first order.
   *
   * If the two draws differ by so much that the sum of these errors is left to
   * chance, if the chip slides over less than two elements, or if longer
   * elements change mu by more than 5 %, the companions for steps and penalty
   * have the elements of the run; and another with its settings on moved
   * elements tells how far the run is from the mean of its own draws.
   *
   * They cost about 1.5 runs, or about 4 where much is left to chance; those of
   * a patch on longer elements have a quarter of the unknowns.
   *
   * @param of the run whose error is wanted; its mesh must have a coarser one
   * @throws ComputationError if a companion fails
   */
  ErrorEstimate
  estimate_error(RunFamily &family, const Fineness &of);
} // namespace asperity

#endif
