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
     *  resolve the contacts, and tell nothing of steps and penalty. */
    constexpr double largest_change = 0.05;
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
      "`estimate`: coarser companions of the run tell the numerical error of "
      "mu by mesh, time steps and penalty, for about as much time again as "
      "the run took or, where its elements are far too long, twice as much; "
      "`adaptive`: runs at finer and finer settings until that error is the "
      "wanted one, beginning with half of the Spans, Ramp steps, Slide steps "
      "and penalty of the file, each round refining what costs least; `off`: "
      "nobody tells it.");
    parameters.number("Error",
                      error,
                      Range{0., 0.5, true, true},
                      "Relative numerical error of mu that is wanted: a run "
                      "whose estimate is larger ends with a warning that names "
                      "what to refine; 0: no estimate is made.");
    parameters.integer("Maximum unknowns",
                       maximum_unknowns,
                       Range::between(100, 10000000),
                       "`adaptive`: largest number of unknowns of a mesh that "
                       "may be chosen.");
  }



  double
  ErrorEstimate::total() const
  {
    const double squares = mesh * mesh + step * step + penalty * penalty;
    const double sum     = mesh + step + penalty;
    return std::sqrt(0.5 * (squares + sum * sum));
  }



  std::string
  ErrorEstimate::largest() const
  {
    const double of_mesh = std::abs(mesh), of_steps = std::abs(step),
                 of_penalty = std::abs(penalty);
    return of_mesh >= std::max(of_steps, of_penalty) ? "mesh" :
           of_steps >= of_penalty                    ? "step" :
                                                       "penalty";
  }



  ErrorEstimate
  ErrorEstimate::after(const Fineness &finer) const
  {
    return {std::ldexp(mesh, -mesh_order * finer.mesh),
            std::ldexp(step, -finer.step),
            std::ldexp(penalty, -finer.penalty)};
  }



  ErrorEstimate
  estimate_error(RunFamily &family, const Fineness &of)
  {
    const FamilyMember &run    = family.run(of);
    const double        scale  = 1. / std::max(std::abs(run.mu), 1e-300);
    const auto          change = [&](const Fineness &from, const Fineness &to) {
      return scale * (family.run(to).mu - family.run(from).mu);
    };
    const Fineness coarse{of.mesh - 1, of.step, of.penalty};
    const Fineness coarser{of.mesh - 2, of.step, of.penalty};
    ErrorEstimate  result;
    result.mesh = change(of, coarse) / change_over_error(mesh_order);
    if (has_mesh(family.parameters(), coarser.mesh))
      {
        const double before = change(coarse, coarser) /
                              change_over_error(mesh_order) /
                              std::ldexp(1., mesh_order);
        if (std::abs(before) < std::abs(result.mesh))
          result.mesh = std::copysign(before, result.mesh);
      }
    const Fineness base =
      std::abs(change(of, coarse)) < largest_change ? coarse : of;
    result.step =
      change(base, {base.mesh, of.step - 1, of.penalty}) / change_over_error(1);
    result.penalty =
      change(base, {base.mesh, of.step, of.penalty - 1}) / change_over_error(1);
    return result;
  }
} // namespace asperity
