#ifndef asperity_tests_surrogate_exported_law_h
#define asperity_tests_surrogate_exported_law_h

#include <asperity/law_export/contact_point_law.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "../surrogate/sample_data.h"

namespace asperity_test
{
  using namespace asperity;

  /** What varies between the laws that are exported in the tests. */
  struct LawKind
  {
    KernelKind kernel       = KernelKind::matern_5_2;
    Scale      output_scale = Scale::logarithmic;
    Scale      p_scale      = Scale::linear;
    Scale      v_scale      = Scale::logarithmic;
    bool       has_wetting  = false;
    bool       over_k       = false; ///< sees p over the strength
    bool       has_strain   = false;

    std::string
    name() const
    {
      return "kernel " + std::to_string(static_cast<int>(kernel)) +
             ", output " + std::to_string(static_cast<int>(output_scale)) +
             ", p " + std::to_string(static_cast<int>(p_scale)) + ", v " +
             std::to_string(static_cast<int>(v_scale)) +
             (over_k ? ", p over k" : "");
    }
  };

  /** Every kernel, and every scale of inputs and output. */
  inline const std::vector<LawKind> law_kinds = {
    {KernelKind::rbf, Scale::logarithmic, Scale::logarithmic, Scale::linear},
    {KernelKind::matern_3_2, Scale::linear, Scale::linear, Scale::logarithmic},
    {KernelKind::matern_5_2,
     Scale::logarithmic,
     Scale::linear,
     Scale::logarithmic},
    {KernelKind::matern_5_2,
     Scale::logarithmic,
     Scale::linear,
     Scale::linear,
     false,
     true},
    {KernelKind::matern_3_2,
     Scale::linear,
     Scale::logarithmic,
     Scale::linear,
     false,
     true}};

  /** A smooth law over the ranges of Lee (2025), section 2.3. */
  inline double
  formula(const double p, const double v, const double T, const double wetting)
  {
    return (0.12 + 0.2 * std::exp(-p / 6e8)) * std::pow(v, -0.08) *
           (1. - 0.3 * std::pow((T - 298.15) / 1000., 2)) *
           (1. - 0.4 * wetting);
  }

  inline FrictionLawDescription
  description(const LawKind &kind)
  {
    FrictionLawDescription result;
    result.inputs = {
      {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, kind.p_scale},
      {"Load/Velocity", "v", "m/min", 0.375, 10. / 3., kind.v_scale},
      {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};
    if (kind.has_wetting)
      result.inputs.insert(result.inputs.begin() + 1,
                           {"Lubrication/Wetting", "Wetting", "1", 0., 1.});
    if (kind.has_strain)
      result.inputs.push_back(
        {"Load/Plastic strain", "Plasticstrain", "1", 0., 2.});
    result.pressure_over_strength = kind.over_k;
    result.kernel                 = kind.kernel;
    result.output_scale           = kind.output_scale;
    result.n_profiles             = 3;
    result.topography_scatter     = 0.2;
    result.shear_limit            = {6e8, 1.3558, 293.15, 1773.15, 1., 1e4};
    result.shear_limit.hardening_ratio    = 2.4;
    result.shear_limit.hardening_exponent = 0.28;
    result.shear_limit.strain_limit       = 1.5;
    result.mechanisms                     = {"ploughing", "oil"};
    result.provenance["surface"]          = "blasted.x3p";
    // what would end a comment in C, or a line of it
    result.provenance["note"] =
      std::string("*/ int x; /* ") + std::string(90, 'x') + " \n \"quoted\" \\";
    return result;
  }

  /** With a scatter of some per mille, as runs have it. */
  inline FrictionLaw
  train(const LawKind &kind, const std::size_t n_runs = 45)
  {
    const FrictionLawDescription law = description(kind);
    std::vector<double>          x, y;
    for (std::size_t j = 0; j < n_runs; ++j)
      {
        const std::vector<double> unit =
          evenly_spread_point(j, law.inputs.size() + 1);
        std::vector<double> at;
        for (std::size_t i = 0; i < law.inputs.size(); ++i)
          at.push_back(law.inputs[i].lower +
                       unit[i] * (law.inputs[i].upper - law.inputs[i].lower));
        x.insert(x.end(), at.begin(), at.end());
        const double      wetting = kind.has_wetting ? at[1] : 0.;
        const double      scatter = 0.01 * (unit.back() - 0.5);
        const std::size_t v       = kind.has_wetting ? 2 : 1;
        y.push_back(formula(at[0], at[v], at[v + 1], wetting) *
                    (1. + 0.1 * (kind.has_strain ? at[3] : 0.)) *
                    (1. + scatter));
      }
    return FrictionLaw::train(law, x, y);
  }

  /** Points inside of the box, on its edges, around it, and where pressure and
   *  velocity vanish. */
  inline std::vector<ContactPoint>
  points()
  {
    std::vector<ContactPoint> result;
    for (std::size_t j = 0; j < 200; ++j)
      {
        const std::vector<double> u = evenly_spread_point(j + 1000, 3);
        result.push_back({{3e8 + 1e9 * u[0],
                           0.375 + (10. / 3. - 0.375) * u[1],
                           298.15 + 875. * u[2]}});
      }
    for (std::size_t j = 0; j < 150; ++j)
      {
        const std::vector<double> u = evenly_spread_point(j + 2000, 3);
        result.push_back({{3e9 * u[0], 8. * u[1], 1800. * u[2]}});
      }
    for (const double p : {-1e8, 0., 1., 3e8, 1.3e9, 1e12})
      for (const double v : {-1., 0., 1e-9, 0.375, 10. / 3., 1e6})
        for (const double T : {0., 298.15, 1173.15, 2000.})
          result.push_back({{p, v, T}});
    return result;
  }

  inline bool
  is_in_box(const ContactPoint &point)
  {
    return point[0] >= 3e8 && point[0] <= 1.3e9 && point[1] >= 0.375 &&
           point[1] <= 10. / 3. && point[2] >= 298.15 && point[2] <= 1173.15;
  }

  inline std::string
  exact(const double value)
  {
    char text[40];
    std::snprintf(text, sizeof(text), "%.17g", value);
    return text;
  }

  /** A folder that is empty at first and removed at last. */
  class Folder
  {
  public:
    Folder()
      : path(std::filesystem::temp_directory_path() /
             (std::string("asperity_surrogate_") + std::to_string(getpid()) +
              "_" +
              testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
      std::filesystem::remove_all(path);
      std::filesystem::create_directories(path);
    }

    ~Folder()
    {
      std::filesystem::remove_all(path);
    }

    void
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(path / name) << text;
    }

    std::string
    read(const std::string &name) const
    {
      std::ifstream in(path / name);
      return {std::istreambuf_iterator<char>(in), {}};
    }

    /** Runs a command there; fails with what it says. */
    void
    run(const std::string &command) const
    {
      const std::string line =
        "cd '" + path.string() + "' && (" + command + ") >log.txt 2>&1";
      EXPECT_EQ(std::system(line.c_str()), 0) << command << "\n"
                                              << read("log.txt");
    }

    /** Rows of numbers of a file. */
    std::vector<std::vector<double>>
    rows(const std::string &name) const
    {
      std::vector<std::vector<double>> result;
      std::istringstream               in(read(name));
      for (std::string line; std::getline(in, line);)
        {
          std::istringstream  numbers(line);
          std::vector<double> row;
          for (std::string word; numbers >> word;)
            row.push_back(std::strtod(word.c_str(), nullptr));
          result.push_back(row);
        }
      return result;
    }

    void
    write_points(const std::string               &name,
                 const std::vector<ContactPoint> &points) const
    {
      std::string text;
      for (const ContactPoint &point : points)
        text += exact(point[0]) + " " + exact(point[1]) + " " +
                exact(point[2]) + "\n";
      write(name, text);
    }

    const std::filesystem::path path;
  };

  inline bool
  has_program(const std::string &name)
  {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) ==
           0;
  }

  /**
   * How closely two evaluations of a law have to agree: to 1e-12 in the box of
   * its data. Away from it, where the correlations are neither close to 1 nor
   * to 0, the mean is a sum of huge terms that cancel, and their rounding is
   * inevitable.
   */
  inline double
  accuracy(const FrictionLaw &law, const ContactPoint &point, const double mean)
  {
    if (is_in_box(point))
      return 1e-12 * std::abs(mean);
    double terms = 0.;
    for (const double alpha : law.process().alpha())
      terms += std::abs(alpha);
    terms *= law.process().hyperparameters().signal_variance * law.factor();
    if (law.description().output_scale == Scale::logarithmic)
      terms *= std::abs(mean);
    return 1e-12 * std::abs(mean) +
           std::numeric_limits<double>::epsilon() * terms;
  }

  /** Smallest size of a derivative by a coordinate that matters: mu over a
   *  thousandth of its range. */
  inline double
  derivative_scale(const double mu, const unsigned int coordinate)
  {
    const ContactPoint extent = {{1e9, 3., 875.}};
    return std::abs(mu) / extent[coordinate];
  }

  /** Whether rounding can decide if a prediction is trusted. */
  inline bool
  is_borderline(const FrictionLaw &law, const LawPrediction &at)
  {
    const double limit =
      law.description().largest_trusted_deviation * std::abs(at.mean);
    return std::abs(at.deviation - limit) < 1e-9 * limit;
  }
} // namespace asperity_test

#endif
