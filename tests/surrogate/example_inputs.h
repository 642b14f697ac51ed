#ifndef tests_surrogate_example_inputs_h
#define tests_surrogate_example_inputs_h

#include <asperity/surrogate/friction_law.h>

#include <vector>

/** Pressure, velocity and temperature in the ranges of Lee (2025). */
inline std::vector<asperity::LawInput>
example_inputs()
{
  using asperity::Scale;
  return {
    {"Load/Pressure", "p", "MPa", 300e6, 1300e6, Scale::linear},
    {"Load/Velocity", "v", "m/min", 22.5 / 60., 200. / 60., Scale::logarithmic},
    {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};
}

#endif
