#ifndef asperity_law_export_exported_numbers_h
#define asperity_law_export_exported_numbers_h

#include <asperity/law_export/contact_point_law.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * The numbers that generated source code evaluates a law with:
   *   s_c = (g(x_c) - origin_c) / span_c / length_c,
   *   r_j^2 = rest_j + sum over c of (points_cj - s_c)^2,
   *   m = sum_of_weights + sum over j of weights_j (f(r_j) - 1),
   *   mu = g^-1(offset + factor m), and g, f by output scale and kernel;
   *   deviation of m: sqrt(signal_variance (1 - |B f|^2)),
   * where rest_j comes from the inputs that are held at fixed values and B =
   * sqrt(signal_variance) L^-1, the lower triangle row by row.
   */
  struct ExportedNumbers
  {
    /** An input among pressure (0), velocity (1), temperature (2). */
    struct Coordinate
    {
      unsigned int        index = 0;
      double              lower = 0., upper = 1.;
      double              margin      = 0.; ///< that still counts as inside
      bool                logarithmic = false;
      double              origin = 0., span = 1., length = 1.;
      std::vector<double> points;
    };

    /** @param with_deviation whether B is wanted */
    ExportedNumbers(const ContactPointLaw &law, const bool with_deviation);

    KernelKind              kernel;
    Scale                   output_scale;
    std::vector<Coordinate> coordinates;
    std::vector<double>     weights;
    double                  sum_of_weights;
    std::vector<double>     rest; ///< empty if nothing is fixed
    std::vector<double>     B;    ///< empty if not wanted
    double                  signal_variance, offset, factor;
    double                  largest_trusted_deviation;
    ShearLimit              shear_limit;
  };

  /** 1/14!, 1/13!, ..., 1/2!: with 1/15! before them, the Horner scheme of
   *  (exp(-a) - 1 + a) / a^2, as correlation::deficits() has it. */
  std::vector<double>
  taylor_coefficients();

  /** The shortest text that reads back as the same double, with a point or an
   *  exponent so that it is no whole number for C; "1.5e-07". */
  std::string
  c_number(const double value);

  /** The same for Fortran 77: "1.5D-07". */
  std::string
  fortran_number(const double value);

  /** Fills lines up to a width with numbers that commas separate.
   *  @param end stands after the last number */
  std::vector<std::string>
  number_lines(const std::vector<std::string> &numbers,
               const std::size_t               width,
               const std::string              &end);
} // namespace asperity

#endif
