#ifndef asperity_law_export_exported_numbers_h
#define asperity_law_export_exported_numbers_h

#include <asperity/law_export/contact_point_law.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The numbers that generated source code evaluates a law with:
   *   s_i = (g(q_i) - origin_i) / span_i / length_i, q as LawCoordinates,
   *   mu = g^-1(offset + factor m(s)), and g by output scale.
   * For a Gaussian process
   *   r_j^2 = sum over i of (points_ji - s_i)^2,
   *   m = sum_of_weights + sum over j of weights_j (f(r_j) - 1), f by kernel;
   *   deviation of m: sqrt(signal_variance (1 - |B f|^2)),
   * with B = sqrt(signal_variance) L^-1, the lower triangle row by row; else m
   * is a line beyond a knee, see Fitted.
   */
  struct ExportedNumbers
  {
    /** An input of the law. */
    struct Coordinate
    {
      /** Pressure (0), velocity (1), temperature (2), or a further input. */
      unsigned int place = 0;

      double lower = 0., upper = 1.;
      double margin      = 0.; ///< that still counts as inside
      bool   logarithmic = false;
      double origin = 0., span = 1., length = 1.;
    };

    /** The shear strength that the fit may see the pressure over. */
    struct Strength
    {
      bool is_used = false;

      /** Coordinates; as many as there are if it is none of them. */
      std::size_t pressure = 0, temperature = 0, strain = 0;

      double hardening_of_k_0 = 1.; ///< 1 + ratio strain^n
    };

    /** An input beside pressure, velocity and temperature. */
    struct Further
    {
      std::string name, unit; ///< SI
      double      value;      ///< at which it is held where it is no argument
    };

    /** m = level + slope max(0, min(s, end) - knee), with the covariance of
     *  level, knee and slope, row by row. */
    struct Fitted
    {
      double                level, knee, slope, end;
      std::array<double, 9> covariance;
    };

    /** @param with_deviation whether B is wanted */
    ExportedNumbers(const ContactPointLaw &law, const bool with_deviation);

    Scale                   output_scale;
    std::vector<Coordinate> coordinates;
    std::vector<Further>    further; ///< places 3, 4, ...
    double                  offset, factor;
    double                  largest_trusted_deviation;
    double                  noise_variance; ///< of a run, scaled as m
    ShearLimit              shear_limit;
    Strength                strength;
    bool                    has_deviation = true;

    std::optional<Fitted> fitted; ///< empty: a Gaussian process, which follows

    KernelKind          kernel = KernelKind::matern_5_2;
    std::vector<double> points; ///< run by run
    std::vector<double> weights;
    double              sum_of_weights = 0., signal_variance = 0.;
    std::vector<double> B; ///< empty if not wanted

    /** 1: RBF, 3: Matern 3/2, 5: Matern 5/2, as templates call them. */
    unsigned int
    kernel_number() const;

  private:
    void
    set(const GaussianProcess &process, const bool with_deviation);

    void
    set(const PiecewisePowerRegression &formula);
  };

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
