#ifndef asperity_tests_learned_fields_field_family_h
#define asperity_tests_learned_fields_field_family_h

#include <asperity/learned_fields/field_data.h>
#include <asperity/surrogate/sample_table.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../postprocess/field_examples.h"

namespace asperity
{
  constexpr double p_low = 300e6, p_high = 1300e6, T_low = 300., T_high = 1100.;

  /** mu of the family at a time, as its tractions have it. */
  inline double
  family_mu(const double p, const double T, const unsigned int time)
  {
    return (0.1 + 0.08 * p / 1e9 + 4e-5 * (T - 300.) +
            1e-11 * p * (T - 300.) / 1e3) *
           (1. + 0.1 * time);
  }

  /** Fields of two cells at the load p and temperature T in balance:
   * combinations of 1, p, T, p T, p^2 and p^2 T, five modes beside a mean. */
  inline FieldSnapshots
  family_fields(const double p, const double T)
  {
    FieldSnapshots result = two_cells();
    for (unsigned int i = 0; i < 2; ++i)
      {
        FieldSnapshot &s  = result.snapshots[i];
        const double   mu = family_mu(p, T, i);
        s.pressure        = p;
        s.mu              = mu;
        s.T_x             = -mu * p * result.places.period;
        s.T_y             = -p * result.places.period;
        for (double &u : s.values[0])
          u *= p / 1e9;
        for (double &stress : s.values[1])
          stress = -p * (1. + i);
        for (std::size_t q = 0; q < 2; ++q)
          {
            s.values[2][2 * q]     = -mu * p;
            s.values[2][2 * q + 1] = -p;
            s.values[3][q]         = 0.1 * (q + 1) * p * T / 1e12;
            s.values[4][q]         = T;
          }
        for (std::size_t q = 0; q < 4; ++q)
          {
            s.values[6][q]         = p;
            s.values[7][2 * q]     = -mu * p;
            s.values[7][2 * q + 1] = -p;
          }
        s.values[8] = {0., 0.};
      }
    return result;
  }

  inline std::vector<LawInput>
  family_inputs()
  {
    return {
      {"Load/Pressure", "p", "MPa", p_low, p_high, Scale::linear, {}},
      {"Load/Temperature", "T", "degC", T_low, T_high, Scale::linear, {}}};
  }

  /** A campaign's folder with 5 x 5 runs on a grid and 4 test runs between.
   *  @param with_fields or without */
  inline void
  write_family(const std::string &folder, const bool with_fields = true)
  {
    std::filesystem::create_directories(folder + "/runs");
    SampleTable table(family_inputs(), {{"mu", "-"}});
    const auto  add = [&](const double a, const double b, const bool test) {
      Sample sample;
      sample.id = table.samples().size() + 1;
      sample.x  = {p_low + a * (p_high - p_low), T_low + b * (T_high - T_low)};
      sample.role    = test ? SampleRole::test : SampleRole::training;
      sample.outputs = {family_mu(sample.x[0], sample.x[1], 1)};
      table.add(sample);
      std::string number = std::to_string(sample.id);
      number.insert(0, 4 - number.size(), '0');
      if (with_fields)
        family_fields(sample.x[0], sample.x[1])
          .write(folder + "/runs/" + number + ".h5");
    };
    for (unsigned int i = 0; i < 5; ++i)
      for (unsigned int j = 0; j < 5; ++j)
        add(i / 4., j / 4., false);
    for (const double a : {0.22, 0.61})
      for (const double b : {0.36, 0.93})
        add(a, b, true);
    table.write(folder + "/runs.csv");
  }

  /** The same as it is read, in the folder of the running test. */
  inline FieldData
  read_family()
  {
    const std::string folder = test_folder();
    write_family(folder);
    return read_fields(folder);
  }
} // namespace asperity

#endif
