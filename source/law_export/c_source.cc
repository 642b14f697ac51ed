#include <asperity/law_export/generated_source.h>

#include "export_text.h"
#include "exported_numbers.h"

namespace asperity
{
  namespace
  {
    std::string
    comment(const std::vector<std::string> &title, const ContactPointLaw &law)
    {
      return "/*\n" + comment_header(title, law, " *") + " */\n";
    }

    std::string
    array(const std::string         &name,
          const std::string         &size,
          const std::vector<double> &values)
    {
      std::vector<std::string> numbers;
      for (const double value : values)
        numbers.push_back(c_number(value));
      std::string text = "static const double " + name + "[" + size + "] = {\n";
      for (const std::string &line : number_lines(numbers, 74, "};"))
        text += "  " + line + "\n";
      return text + "\n";
    }

    /** "p", "v" or "T", as the arguments are called. */
    std::string
    argument(const ExportedNumbers::Coordinate &c)
    {
      return ContactPointLaw::symbols()[c.index];
    }

    std::string
    data(const ExportedNumbers &numbers)
    {
      std::string text = "/* 1/14!, 1/13!, ..., 1/2! */\n" +
                         array("taylor", "13", taylor_coefficients()) +
                         "#define N " + std::to_string(numbers.weights.size()) +
                         " /* training runs */\n\n"
                         "/* their scaled inputs and weights */\n";
      for (const auto &c : numbers.coordinates)
        text += array("points_" + argument(c), "N", c.points);
      text += array("weights", "N", numbers.weights);
      if (!numbers.rest.empty())
        text +=
          "/* squared distance along the inputs that are held fixed */\n" +
          array("rest", "N", numbers.rest);
      if (!numbers.B.empty())
        text +=
          "/* inverse triangular factor of the covariance, row by row */\n" +
          array("B", "N * (N + 1) / 2", numbers.B);
      return text;
    }

    /** Scales one input and tells the derivative by it. */
    std::string
    scaling(const ExportedNumbers::Coordinate &c)
    {
      const std::string x = argument(c);
      std::string       text =
        "/* what the kernel sees of " + x + ", and its derivative */\n" +
        "static double\nscaled_" + x + "(double " + x + ", double *slope)\n{\n";
      const std::string span = c_number(c.span), length = c_number(c.length);
      // tiny numbers have no inverse
      if (c.logarithmic)
        text += "  *slope = " + x + " > 1e-300 ? 1. / (" + x + " * " + span +
                " * " + length + ") : 0.;\n  if (" + x + " <= 0.)\n    " + x +
                " = " + c_number(c.lower) + ";\n  return (log(" + x + ") - (" +
                c_number(c.origin) + ")) / " + span + " / " + length + ";\n";
      else
        text += "  *slope = 1. / (" + span + " * " + length + ");\n  return (" +
                x + " - (" + c_number(c.origin) + ")) / " + span + " / " +
                length + ";\n";
      return text + "}\n\n";
    }

    /** In terms of r2, a, R = (exp(-a) - 1 + a) / a^2 and e = exp(-a): f - 1
     *  for small and for large a. */
    struct KernelText
    {
      std::string argument, small, large, slope;
    };

    KernelText
    kernel_text(const KernelKind kernel)
    {
      switch (kernel)
        {
          case KernelKind::rbf:
            return {"0.5 * r2", "a * (a * R - 1.)", "e - 1.", "e"};
          case KernelKind::matern_3_2:
            return {"sqrt(3. * r2)",
                    "a * a * ((1. + a) * R - 1.)",
                    "(1. + a) * e - 1.",
                    "3. * e"};
          case KernelKind::matern_5_2:
            return {"sqrt(5. * r2)",
                    "a * a * ((1. + a + a * a / 3.) * R - (2. + a) / 3.)",
                    "(1. + a + a * a / 3.) * e - 1.",
                    "5. / 3. * (1. + a) * e"};
        }
      return {};
    }

    /** The correlation of a point with training run j. */
    std::string
    correlation(const ExportedNumbers &numbers)
    {
      const KernelText kernel = kernel_text(numbers.kernel);
      std::string      text =
        "/* correlation with run j minus 1, which is accurate also for small\n"
        " * distances, and -2 times its derivative by r^2 */\n"
        "static double\ndeficit(const double s[3], int j, double *slope)\n"
        "{\n";
      std::string r2 = numbers.rest.empty() ? "" : "rest[j]";
      for (const auto &c : numbers.coordinates)
        {
          const std::string d = "d" + argument(c);
          text += "  const double " + d + " = points_" + argument(c) +
                  "[j] - s[" + std::to_string(c.index) + "];\n";
          r2 += (r2.empty() ? "" : " + ") + d + " * " + d;
        }
      return text + "  const double r2 = " + (r2.empty() ? "0." : r2) +
             ";\n  const double a = " + kernel.argument +
             ";\n  double e, R = 1. / 1307674368000.; /* 1/15! */\n"
             "  int i;\n\n"
             "  if (a >= 700.) /* too far away to matter */\n"
             "    {\n      *slope = 0.;\n      return -1.;\n    }\n"
             "  e = exp(-a);\n  *slope = " +
             kernel.slope + ";\n  if (!(a < 0.5))\n    return " + kernel.large +
             ";\n"
             "  /* (exp(-a) - 1 + a) / a^2 by its Taylor series */\n"
             "  for (i = 0; i < 13; ++i)\n"
             "    R = taylor[i] - a * R;\n  return " +
             kernel.small + ";\n}\n\n";
    }

    std::string
    scale_all(const ExportedNumbers &numbers)
    {
      std::string text;
      for (const auto &c : numbers.coordinates)
        {
          const std::string i = std::to_string(c.index), x = argument(c);
          text +=
            "  s[" + i + "] = scaled_" + x + "(" + x + ", &ds[" + i + "]);\n";
        }
      return text;
    }

    std::string
    inside_condition(const ExportedNumbers &numbers)
    {
      std::string text;
      for (const auto &c : numbers.coordinates)
        text += (text.empty() ? "" : " &&\n         ") + argument(c) +
                " >= " + c_number(c.lower - c.margin) + " && " + argument(c) +
                " <= " + c_number(c.upper + c.margin);
      return text.empty() ? "1" : text;
    }

    /** Arguments that the law does not depend on, for strict compilers. */
    std::string
    ignore_absent(const ExportedNumbers &numbers)
    {
      std::string text;
      for (unsigned int i = 0; i < ContactPointLaw::n_coordinates; ++i)
        {
          bool used = false;
          for (const auto &c : numbers.coordinates)
            used = used || c.index == i;
          if (!used)
            text += "  (void)" + ContactPointLaw::symbols()[i] + ";\n";
        }
      return text;
    }

    std::string
    mean_function(const ExportedNumbers &numbers)
    {
      const bool  logarithmic = numbers.output_scale == Scale::logarithmic;
      std::string text =
        "double\ntribmu(double p, double v, double T, double dmu[3], "
        "int *inside)\n{\n"
        "  double s[3] = {0., 0., 0.}, ds[3] = {0., 0., 0.};\n"
        "  double g[3] = {0., 0., 0.}, mu, slope;\n  double m = " +
        c_number(numbers.sum_of_weights) + ";\n  int j;\n\n" +
        ignore_absent(numbers) + scale_all(numbers) +
        "  for (j = 0; j < N; ++j)\n    {\n"
        "      m += weights[j] * deficit(s, j, &slope);\n"
        "      if (slope <= 0.)\n        continue;\n"
        "      slope *= weights[j];\n";
      for (const auto &c : numbers.coordinates)
        {
          const std::string i = std::to_string(c.index);
          text += "      g[" + i + "] += slope * (points_" + argument(c) +
                  "[j] - s[" + i + "]);\n";
        }
      const std::string value =
        c_number(numbers.offset) + " + " + c_number(numbers.factor) + " * m";
      text += "    }\n  mu = " + (logarithmic ? "exp(" + value + ")" : value) +
              ";\n  if (dmu)\n    for (j = 0; j < 3; ++j)\n      dmu[j] = " +
              (logarithmic ? "mu * " : "") + c_number(numbers.factor) +
              " * g[j] * ds[j];\n"
              "  if (inside)\n    *inside = is_inside(p, v, T);\n"
              "  return mu;\n}\n\n";
      return text;
    }

    std::string
    deviation_function(const ExportedNumbers &numbers)
    {
      std::string text =
        "double\ntribmu_sigma(double p, double v, double T, int *trusted)\n"
        "{\n";
      if (numbers.B.empty())
        return text + "  if (trusted)\n    *trusted = is_inside(p, v, T);\n"
                      "  return -1.;\n}\n\n";
      const bool logarithmic = numbers.output_scale == Scale::logarithmic;
      text +=
        "  double s[3] = {0., 0., 0.}, ds[3], f[N], slope, norm = 0.;\n"
        "  double mu, sigma;\n  const double *b = B;\n  int i, j;\n\n" +
        scale_all(numbers) +
        "  for (j = 0; j < N; ++j)\n"
        "    f[j] = 1. + deficit(s, j, &slope);\n"
        "  for (i = 0; i < N; ++i)\n    {\n      double product = 0.;\n"
        "      for (j = 0; j <= i; ++j)\n        product += *b++ * f[j];\n"
        "      norm += product * product;\n    }\n"
        "  sigma = norm >= 1. ? 0. : " +
        c_number(numbers.factor) + " * sqrt(" +
        c_number(numbers.signal_variance) + " * (1. - norm));\n" +
        "  mu = tribmu(p, v, T, NULL, NULL);\n" +
        (logarithmic ? "  sigma *= mu;\n" : "") +
        "  if (trusted)\n    *trusted = is_inside(p, v, T) && sigma <= " +
        c_number(numbers.largest_trusted_deviation) +
        " * fabs(mu);\n  return sigma;\n}\n\n";
      return text;
    }

    std::string
    inside_function(const ExportedNumbers &numbers)
    {
      return "/* in the box of the training data; false if not a number */\n"
             "static int\nis_inside(double p, double v, double T)\n{\n" +
             ignore_absent(numbers) + "  return " + inside_condition(numbers) +
             ";\n}\n\n";
    }

    std::string
    shear_functions(const ShearLimit &limit)
    {
      std::string text = "double\ntribmu_k(double T, double *dk)\n{\n";
      if (!(limit.k_0 > 0.))
        text += "  (void)T;\n  if (dk)\n    *dk = 0.;\n  return HUGE_VAL;\n";
      else
        {
          const std::string k_0 = c_number(limit.k_0),
                            m   = c_number(limit.exponent);
          const std::string range =
            c_number(limit.melting_temperature - limit.transition_temperature);
          text += "  const double t = (T - " +
                  c_number(limit.transition_temperature) + ") / " + range +
                  ";\n\n  if (dk)\n    *dk = t > 0. && t < 1. ? -" + k_0 +
                  " * " + m + " * pow(t, " + m + " - 1.) / " + range +
                  " : 0.;\n  if (t <= 0.)\n    return " + k_0 +
                  ";\n  return t >= 1. ? 0. : " + k_0 + " * (1. - pow(t, " + m +
                  "));\n";
        }
      return text +
             "}\n\ndouble\ntribmu_tau(double p, double v, double T)\n{\n"
             "  const double coulomb = tribmu(p, v, T, NULL, NULL) * p;\n"
             "  const double k = tribmu_k(T, NULL);\n\n"
             "  return coulomb < k ? coulomb : k;\n}\n";
    }
  } // namespace



  std::string
  c_header(const ContactPointLaw &law)
  {
    return comment({"tribmu.h: friction coefficient by pressure, velocity and",
                    "temperature, with its derivatives. C99, SI units."},
                   law) +
           R"(#ifndef TRIBMU_H
#define TRIBMU_H

#ifdef __cplusplus
extern "C" {
#endif

/* The friction coefficient.
 * p: pressure [Pa], v: sliding velocity [m/s], T: temperature [K]
 * dmu: the derivatives by p, v and T, or NULL
 * inside: whether the point is in the box of the training data, or NULL
 *
 * Outside of the box the law is still answered, with finite numbers: far away it
 * falls back to the mean of its data. A pressure, velocity or temperature that
 * is not positive is replaced by the lower end of its range if the law sees its
 * logarithm (see the ranges above); the derivative by it is 0 then. */
double
tribmu(double p, double v, double T, double dmu[3], int *inside);

/* The standard deviation of mu, which takes longer than mu itself; and whether
 * mu is to be trusted: in the box, and with a deviation that is small. See
 * tribmu.c if this file was written with the deviation: -1 means without. */
double
tribmu_sigma(double p, double v, double T, int *trusted);

/* The shear limit k [Pa], HUGE_VAL if unknown; dk: its derivative, or NULL. */
double
tribmu_k(double T, double *dk);

/* The shear stress min(mu p, k) [Pa]. */
double
tribmu_tau(double p, double v, double T);

#ifdef __cplusplus
}
#endif

#endif
)";
  }



  std::string
  c_source(const ContactPointLaw &law, const bool with_deviation)
  {
    const ExportedNumbers numbers(law, with_deviation);

    std::vector<std::string> title = {
      "tribmu.c: friction coefficient by pressure, velocity and",
      "temperature, with its derivatives. C99, SI units; see tribmu.h."};
    if (with_deviation)
      title.push_back("With the deviation: `trusted` is that of the program.");
    else
      for (
        const char *const line :
        {"Without the deviation, since there are too many runs: tribmu_sigma",
         "gives -1, and `trusted` means in the box only."})
        title.push_back(line);

    std::string text =
      comment(title, law) +
      "#include \"tribmu.h\"\n\n#include <math.h>\n#include <stddef.h>\n\n" +
      data(numbers);
    for (const auto &c : numbers.coordinates)
      text += scaling(c);
    return text + correlation(numbers) + inside_function(numbers) +
           mean_function(numbers) + deviation_function(numbers) +
           shear_functions(numbers.shear_limit);
  }
} // namespace asperity
