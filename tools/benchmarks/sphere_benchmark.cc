// A rigid ball on an elastic-plastic block without hardening: load over
// approach and mean pressure, beside published curves. Prints a table.
//   sphere_benchmark [largest approach over that of first yield, 60]

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <contact/quarter_of_block.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#include "markdown_table.h"

namespace
{
  using example::QuarterOfBlock;

  constexpr double radius = 2., nu = 0.3;
  constexpr double contact_at_yield = 0.0125, largest_contact = 0.15;

  /** Of first yield: p0 = C Y with C = 1.295 exp(0.736 nu); R. L. Jackson, I.
   *  Green, J. Tribol. 127 (2005) 343-354. */
  struct FirstYield
  {
    double C        = 1.295 * std::exp(0.736 * nu),
           E        = QuarterOfBlock::reduced_modulus();
    double Y        = 2. * E * contact_at_yield / (M_PI * radius) / C;
    double approach = contact_at_yield * contact_at_yield / radius;
    double force    = 4. / 3. * E * std::sqrt(radius) * std::pow(approach, 1.5);
  };

  /** Force over that of first yield, of an elastic-plastic ball on a rigid
   *  plane: the same reference. */
  double
  jackson_green(const double w, const FirstYield &yield)
  {
    if (w < 1.9)
      return std::pow(w, 1.5);
    const double B = 0.14 * std::exp(23. * yield.Y / yield.E);
    const double a =
      contact_at_yield * std::sqrt(w) * std::pow(w / 1.9, 0.5 * B);
    const double H = // hardness over Y
      2.84 * (1. - std::exp(-0.82 * std::pow(a / radius, -0.7)));
    return std::exp(-0.25 * std::pow(w, 5. / 12.)) * std::pow(w, 1.5) +
           4. * H / yield.C * (1. - std::exp(-std::pow(w, 5. / 9.) / 25.)) * w;
  }

  /** As before; L. Kogut, I. Etsion, J. Appl. Mech. 69 (2002) 657-662. */
  double
  kogut_etsion(const double w)
  {
    if (w <= 1.)
      return std::pow(w, 1.5);
    return w <= 6. ? 1.03 * std::pow(w, 1.425) : 1.40 * std::pow(w, 1.263);
  }

  std::string
  text(const double value, const int digits = 3)
  {
    std::ostringstream out;
    out << std::setprecision(digits) << value;
    return out.str();
  }

  void
  run(const double largest)
  {
    const FirstYield yield;
    QuarterOfBlock   block(radius,
                         largest_contact,
                         QuarterOfBlock::plastic(yield.Y),
                         4);
    std::cout << block.u.size() << " unknowns, Y/E* = " << yield.Y / yield.E
              << "\n\n";
    markdown_table::row("approach",
                        "a/R",
                        "load",
                        "Hertz",
                        "Jackson-Green",
                        "Kogut-Etsion",
                        "mean pressure over Y",
                        "plastic strain");
    markdown_table::row("---", "---", "---", "---", "---", "---", "---", "---");
    for (double w = 2.; w < 1.001 * largest; w *= 1.3)
      {
        const double force = block.press(w * yield.approach);
        block.accept();
        const double area = block.touching_area();
        markdown_table::row(text(w),
                            text(std::sqrt(area / M_PI) / radius),
                            text(force / yield.force),
                            text(std::pow(w, 1.5)),
                            text(jackson_green(w, yield)),
                            text(kogut_etsion(w)),
                            text(force / area / yield.Y),
                            text(block.largest_plastic_strain()));
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession session(argc, argv);
  markdown_table::attempt([&]() { run(argc > 1 ? std::stod(argv[1]) : 60.); });
  return 0;
}
