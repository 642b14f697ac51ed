#include <asperity/contact_zone/error_estimate.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Order of mu in the element length: of the changes that halving the
     *  elements makes on the reference scenes, and twice that of the
     *  displacement, whose edges of contacts leave it in H^(5/2)
     *  (Z. Belhachmi and F. Ben Belgacem, Math. Comp. 72 (2003) 83-104), less
     *  what plastic flow takes. */
    constexpr int mesh_order = 2;

    /** What halving elements, steps or penalty changes over the error that is
     *  left, if the error has an order: the extrapolation of Richardson. */
    double
    change_over_error(const int order)
    {
      return std::ldexp(1., order) - 1.;
    }

    /** Relative change of mu by elements twice as long above which these do not
     *  resolve the contacts, and tell nothing of steps and penalty; and that at
     *  which so much more of it than by its order is gone on the elements of
     *  the run that half of the extrapolation is left. */
    constexpr double largest_change = 0.05, unresolved_change = 0.1;

    /** What moving elements twice as long changes of mu over the error that
     *  they tell, above which this is left to chance. */
    constexpr double largest_chance = 0.4;

    /** Elements over which the chip must slide for two draws to differ by what
     *  is left to chance, rather than to agree by it. */
    constexpr double fewest_elements = 2.;

    /** Part of each error by which it is uncertain, for all of them together;
     *  and that which a correction by them may miss, which keeps a wanted error
     *  in nine of ten scenes (tools/benchmarks/README.md). */
    constexpr double uncertain_part = 0.1, missed_part = 0.8;

    /** Error by the elements, of what those twice as long change of mu. */
    double
    error_by_mesh(const double change)
    {
      return change / change_over_error(mesh_order) /
             (1. + std::abs(change) / unresolved_change);
    }

    /** What this may miss: second order in the change, as much as was found
     *  where elements twice as long change mu by half. */
    double
    unresolved_by_mesh(const double change)
    {
      return 0.5 * change * change;
    }

    /** Differences of mu in a family, relative to mu of one of its runs. */
    class Changes
    {
    public:
      Changes(RunFamily &family, const Fineness &of)
        : family(family)
        , mu(family.run(of).mu)
      {}

      double
      operator()(const Fineness &from, const Fineness &to) const
      {
        return (family.run(to).mu - family.run(from).mu) /
               std::max(std::abs(mu), 1e-300);
      }

      /** By steps and penalty, which are halved one at a time.
       *  @param base at which */
      ErrorEstimate
      of_steps_and_penalty(const Fineness &base) const
      {
        Fineness fewer = base, softer = base;
        --fewer.step;
        --softer.penalty;
        ErrorEstimate result;
        result.step    = (*this)(base, fewer) / change_over_error(1);
        result.penalty = (*this)(base, softer) / change_over_error(1);
        return result;
      }

    private:
      RunFamily   &family;
      const double mu;
    };

    /** The same on elements that are moved by half of their length. */
    Fineness
    moved(Fineness fineness)
    {
      ++fineness.offset;
      return fineness;
    }
  } // namespace



  void
  AccuracyParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Accuracy");
    parameters.choice(
      "Control",
      control,
      {{"off", AccuracyControl::off},
       {"estimate", AccuracyControl::estimate},
       {"adaptive", AccuracyControl::adaptive}},
      "`estimate`: companions of the run tell the numerical error of mu by "
      "mesh, time steps and penalty, and mu that is corrected for it, for one "
      "to two times the time that the run took or, where contacts pass few "
      "elements or are not resolved by twice as long ones, for up to five "
      "times; "
      "`adaptive`: runs at finer and finer settings until the corrected mu "
      "keeps the wanted error, as it did in nine of ten profiles that were "
      "tried, beginning with half of the Ramp steps, Slide steps and penalty "
      "of the file and, for an Error of 2, 0.7 and 0.2 %, with a quarter, "
      "half and all of its Spans, each round refining what costs least; "
      "`off`: nobody tells it.");
    parameters.number("Error",
                      error,
                      Range{0., 0.5, true, true},
                      "Relative numerical error of mu that is wanted, with "
                      "`adaptive` of the corrected mu: a run whose estimate is "
                      "larger ends with a warning that names what to refine; "
                      "0: no estimate is made.");
    parameters.integer("Maximum unknowns",
                       maximum_unknowns,
                       Range::between(100, 10000000),
                       "`adaptive`: largest number of unknowns of a mesh that "
                       "may be chosen.");
  }



  double
  ErrorEstimate::total() const
  {
    return std::hypot(mesh + step + penalty,
                      uncertain_part * std::hypot(mesh, step, penalty),
                      chance);
  }



  double
  ErrorEstimate::corrected(const double mu) const
  {
    return mu - (mesh + step + penalty) * std::abs(mu);
  }



  double
  ErrorEstimate::uncertainty() const
  {
    return std::hypot(missed_part * std::hypot(mesh, step, penalty),
                      chance,
                      unresolved);
  }



  std::string
  ErrorEstimate::largest() const
  {
    const double of_mesh  = std::hypot(mesh, chance, unresolved),
                 of_steps = std::abs(step), of_penalty = std::abs(penalty);
    return of_mesh >= std::max(of_steps, of_penalty) ? "mesh" :
           of_steps >= of_penalty                    ? "step" :
                                                       "penalty";
  }



  ErrorEstimate
  ErrorEstimate::after(const Fineness &finer) const
  {
    return {std::ldexp(mesh, -mesh_order * finer.mesh),
            std::ldexp(step, -finer.step),
            std::ldexp(penalty, -finer.penalty),
            std::ldexp(chance, -mesh_order * finer.mesh),
            std::ldexp(unresolved, -2 * mesh_order * finer.mesh)};
  }



  ErrorEstimate
  estimate_error(RunFamily &family, const Fineness &of)
  {
    const Changes  change(family, of);
    const Fineness coarse{of.mesh - 1, of.step, of.penalty, of.offset};
    const double   left = std::ldexp(1., -mesh_order); // by half the elements
    // The mean of two draws, against the run.
    const double by_coarse =
      0.5 * (change(of, coarse) + change(of, moved(coarse)));
    const double passed  = family.run(of).elements_passed;
    const bool   is_slow = passed > 0. && passed < fewest_elements;
    if (std::abs(by_coarse) < largest_change && !is_slow)
      {
        ErrorEstimate result = change.of_steps_and_penalty(coarse);
        result.mesh          = error_by_mesh(by_coarse);
        result.unresolved    = unresolved_by_mesh(by_coarse);
        const double chance  = 0.5 * std::abs(change(coarse, moved(coarse)));
        result.chance        = left * chance;
        if (chance <= largest_chance *
                        std::abs(result.mesh + result.step + result.penalty))
          return result;
      }
    const double  half   = 0.5 * change(of, moved(of));
    ErrorEstimate result = change.of_steps_and_penalty(of);
    result.mesh          = error_by_mesh(by_coarse - half) - half;
    result.unresolved    = unresolved_by_mesh(by_coarse - half);
    result.chance        = left * std::abs(half);
    return result;
  }
} // namespace asperity
