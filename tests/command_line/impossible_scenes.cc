#include <sstream>
#include <string>
#include <vector>

#include "program.h"

// Scenes that no computation can be made of: each is refused before the start
// with a sentence that names the entries.

using namespace asperity;

using ImpossibleScene = Program;

namespace
{
  std::string
  in(const std::string &section, const std::string &lines)
  {
    return "subsection " + section + "\n" + lines + "\nend\n";
  }
} // namespace

TEST_F(ImpossibleScene, a_chip_above_its_melting_temperature)
{
  // The flow stress is at its floor of 0.001 from (1500 - 20) 0.999 + 20 degC
  // on, with the exponent m = 1.
  const std::string material =
    "subsection Material\n subsection Johnson-Cook\n  set m = 1\n end\nend\n";
  EXPECT_EQ(refusal(in("Load", " set Temperature = 1600 degC") + material),
            "Error: scene.prm, line 2, entry 'Load/Temperature': found 1600 "
            "degC, at which the chip has no strength; expected less than "
            "1498.52 degC, near the melting temperature of 1500 degC "
            "(Material/Johnson-Cook/Melting temperature).\n");
  EXPECT_NE(refusal(in("Load", " set Temperature = 1500 degC") + material)
              .find("found 1500 degC, at which the chip has no strength"),
            std::string::npos);
  write("scene.prm",
        in("Load", " set Temperature = 1600 degC") +
          in("Material", " set Law = Voce"));
  EXPECT_EQ(run("check scene.prm").status, 0) << "this law does not melt";
}

TEST_F(ImpossibleScene, softening_that_starts_above_the_melting_temperature)
{
  EXPECT_EQ(
    refusal("subsection Material\n subsection Johnson-Cook\n"
            "  set Transition temperature = 1600 degC\n end\nend\n"),
    "Error: entry 'Material/Johnson-Cook/Melting temperature': found 1500 "
    "degC; expected more than the transition temperature of 1600 degC, at "
    "which softening starts.\n");
}

TEST_F(ImpossibleScene, fewer_quadrature_points_than_the_degree)
{
  EXPECT_EQ(refusal(in("Mesh", " set Quadrature points = 1")),
            "Error: scene.prm, line 2, entry 'Mesh/Quadrature points': found 1 "
            "with splines of degree 2; expected at least 2, or 0 for the usual "
            "number, since the chip could move without stress.\n");
  EXPECT_NE(refusal(in("Mesh", " set Degree = 4\n set Quadrature points = 3"))
              .find("expected at least 4"),
            std::string::npos);
  EXPECT_NE(refusal(in("Mesh", " set Degree = 1\n set Quadrature points = 1"))
              .find("expected at least 2"),
            std::string::npos);
}

TEST_F(ImpossibleScene, a_steady_window_within_one_step)
{
  const std::string steady = " set Friction window = steady\n";
  EXPECT_EQ(refusal(in("Protocol", steady + " set Steady distance = 15 nm")),
            "Error: scene.prm, line 3, entry 'Protocol/Steady distance': found "
            "0.015 um with a Steady step of 0.01 um; expected at least two "
            "steps, so that a window has a mean.\n");
  EXPECT_NE(refusal(in("Protocol", steady + " set Steady step = 1 mm"))
              .find("expected at least two steps"),
            std::string::npos);
  EXPECT_EQ(refusal(in("Protocol",
                       steady + " set Steady distance = 2 um\n"
                                " set Maximum distance = 3 um")),
            "Error: scene.prm, line 4, entry 'Protocol/Maximum distance': "
            "found 3 um with a Steady distance of 2 um; expected at least "
            "twice as much, since two windows are compared.\n");
  EXPECT_NE(refusal(in("Protocol",
                       steady + " set Steady step = 0.001 nm\n"
                                " set Maximum distance = 2 um"))
              .find("expected at least a millionth of it"),
            std::string::npos);
}

TEST_F(ImpossibleScene, a_chip_that_turns_back_while_mu_is_averaged)
{
  // 0.25 us at 200 m/min are 0.83 um; the load grows over a fifth of that.
  const std::string back = " set Reversal distance = ";
  EXPECT_EQ(refusal(in("Protocol", back + "0.6 um")),
            "Error: scene.prm, line 2, entry 'Protocol/Reversal distance': "
            "found 0.6 um; expected a value between the ends of the load ramp "
            "(0.1667 um) and of the way that is not averaged (0.4167 "
            "um).\n");
  EXPECT_NE(refusal(in("Protocol", back + "0.1 um")).find("found 0.1 um"),
            std::string::npos);
  EXPECT_NE(refusal(
              in("Protocol", back + "0.3 um\n set Friction window = steady"))
              .find("expected none with the friction window `steady`"),
            std::string::npos);
  EXPECT_NE(refusal(in("Protocol", back + "0.3 um\n set Inertia = dynamic"))
              .find("expected none with a chip that has inertia"),
            std::string::npos);
  EXPECT_NE(refusal(in("Protocol", back + "0.3 um") +
                    in("Lubrication", " set Model = Stokes"))
              .find("found a chip that turns back with a lubricant that fills "
                    "the gap"),
            std::string::npos);
}

TEST_F(ImpossibleScene, a_mesh_without_a_coarser_one_for_the_error_of_mu)
{
  const std::string estimate = in("Accuracy", " set Control = estimate");
  EXPECT_EQ(refusal(in("Mesh", " set Spans = 81\n set Refinement levels = 0") +
                    estimate),
            "Error: scene.prm, line 2, entry 'Mesh/Spans': found 81, of which "
            "no coarser mesh can be made that would tell the error of mu "
            "(Accuracy/Control); expected an even number of at "
            "least 12 spans.\n");
  EXPECT_NE(refusal(in("Mesh", " set Spans = 8\n set Refinement levels = 0") +
                    estimate)
              .find("found 8, of which no coarser mesh"),
            std::string::npos);
}

TEST_F(ImpossibleScene, more_waves_than_the_splines_hold)
{
  const std::string waves = " set Wave numbers = 1, 50\n"
                            " set Amplitudes = 0.1 um, 0.01 um\n"
                            " set Phases = 0 rad, 1 rad\n";
  EXPECT_EQ(refusal(in("Tool", waves + " set Spline spans = 399")),
            "Error: scene.prm, line 5, entry 'Tool/Spline spans': found 399 "
            "for up to 50 waves in a period; expected at least 400, so that "
            "the spline follows them.\n");
  EXPECT_EQ(refusal(in("Chip surface", " set Kind = harmonics\n" + waves)),
            "Error: entry 'Mesh/Spans': found 160 for a chip of up to 50 waves "
            "in a period; expected at least 200, so that the mesh follows "
            "them.\n");
}

TEST_F(ImpossibleScene, a_mesh_beyond_all_memory)
{
  const std::string message =
    refusal(in("Geometry", " set Chip height = 10 mm") +
            in("Mesh", " set Row grading = 1"));
  EXPECT_NE(message.find("make a mesh of about 4e+05 elements"),
            std::string::npos)
    << message;
  EXPECT_NE(message.find("a larger Row grading"), std::string::npos);
}

TEST_F(ImpossibleScene, tolerances_that_accept_everything)
{
  EXPECT_EQ(refusal(in("Coupling", " set Tolerance = 5")),
            "Error: scene.prm, line 2, entry 'Coupling/Tolerance': '5' is out "
            "of range; more than 0 and at most 0.01 is expected.\n");
  for (const std::string entry : {"Solver/Tolerance = 0.5",
                                  "Protocol/Steady tolerance = 5",
                                  "Coupling/Displacement floor = 1 um",
                                  "Coupling/Force floor = 1e6 N/m",
                                  "Coupling/Velocity floor = 1 km/h"})
    EXPECT_NE(refusal(in(entry.substr(0, entry.find('/')),
                         " set " + entry.substr(entry.find('/') + 1)))
                .find("out of range"),
              std::string::npos)
      << entry;
}

TEST_F(ImpossibleScene, quantities_that_no_workshop_has)
{
  for (const std::string entry : {"Geometry/Period = 1e9 m",
                                  "Geometry/Chip height = 1e-12 m",
                                  "Geometry/Initial gap = 1 m",
                                  "Load/Pressure = 1e300 MPa",
                                  "Load/Velocity = 1e-300 m/s",
                                  "Load/Temperature = 1e6 degC",
                                  "Protocol/End time = 1e99 s",
                                  "Material/Density = 1e-30 kg/m3",
                                  "Material/Young's modulus = 1 Pa",
                                  "Contact/Penalty factor = 1e30",
                                  "Lubricant/Viscosity = 1e11 Pa s"})
    EXPECT_NE(refusal(in(entry.substr(0, entry.find('/')),
                         " set " + entry.substr(entry.find('/') + 1)))
                .find("out of range"),
              std::string::npos)
      << entry;
}

TEST_F(ImpossibleScene, no_entry_with_a_number_is_without_bounds)
{
  std::istringstream table(run("parameters --markdown").output);
  unsigned int       n_numbers = 0;
  for (std::string line; std::getline(table, line);)
    {
      // | entry | default | kind and range | meaning |
      std::vector<std::string> cells;
      std::istringstream       row(line);
      for (std::string cell; std::getline(row, cell, '|');)
        cells.push_back(cell);
      if (cells.size() < 5 || cells[1] == " entry " || cells[1] == " --- ")
        continue;
      const std::string &kind      = cells[3];
      bool               is_number = true;
      for (const std::string word : {" text", " choice", " file", " flag"})
        is_number = is_number && kind.find(word) != 0;
      if (!is_number)
        continue;
      ++n_numbers;
      EXPECT_TRUE(kind.find(" to ") != std::string::npos ||
                  kind.find("less than") != std::string::npos ||
                  kind.find("at most") != std::string::npos)
        << line;
    }
  EXPECT_GT(n_numbers, 70u);
}

TEST_F(ImpossibleScene, what_shows_while_it_is_built_names_the_file)
{
  write("map.txt", "1 2 1 2\n2 1 2 1\n1 2 1 2\n2 1 2 1\n");
  EXPECT_EQ(refusal("subsection Tool\n set Kind = measured\n"
                    " subsection Topography\n  set File = map.txt\n"
                    "  set Lateral unit = parsec\n end\nend\n")
              .find("Error: scene.prm: The entry 'Lateral unit' = 'parsec'"),
            0u);
  EXPECT_EQ(refusal(in("Geometry", " set Chip height = 10 mm") +
                    in("Mesh", " set Row grading = 1"))
              .find("Error: scene.prm: Mesh: these entries make"),
            0u);
}

TEST_F(ImpossibleScene, no_oil_or_a_part_of_it_that_the_model_cannot_take)
{
  EXPECT_EQ(refusal(in("Lubrication",
                       " set Model = pocket\n"
                       " set Oil amount = film thickness\n"
                       " set Oil film = 0 nm")),
            "Error: scene.prm, line 4, entry 'Lubrication/Oil film': found 0, "
            "so that there is no oil; expected a positive number, or the model "
            "`none`.\n");
  EXPECT_EQ(refusal(in("Lubrication",
                       " set Model = Stokes\n"
                       " set Oil amount = film thickness")),
            "Error: scene.prm, line 3, entry 'Lubrication/Oil amount': found "
            "film thickness, but the model `Stokes` fills the void with oil; "
            "expected part of void at start, or the model `pocket` or "
            "`Reynolds`.\n");
}

TEST_F(ImpossibleScene, oil_beyond_the_law_of_its_temperature)
{
  const std::string cold = in("Load", " set Temperature = -65 degC") +
                           in("Lubrication", " set Model = Reynolds");
  EXPECT_EQ(refusal(cold + in("Lubricant", " set Temperature law = Vogel")),
            "Error: scene.prm, line 2, entry 'Load/Temperature': found -65 "
            "degC, at which the oil is a glass by its Temperature law; "
            "expected more than -51.17 degC.\n");
  EXPECT_EQ(refusal(in("Lubrication", " set Model = Reynolds") +
                    in("Lubricant",
                       " set Temperature law = Vogel\n"
                       " set Pressure law = Roelands")),
            "Error: scene.prm, line 5, entry 'Lubricant/Temperature law': "
            "found Vogel with the Pressure law Roelands, which falls where a "
            "hot oil is thinner than 6.31e-5 Pa s; expected Roelands for both, "
            "or another pressure law.\n");
}

TEST_F(ImpossibleScene, an_interpolation_that_its_points_do_not_determine)
{
  const std::string tool = " set Kind = measured\n"
                           " set Spline fit = interpolation\n";
  EXPECT_EQ(refusal(in("Tool", tool + " set Spline spans = 50")),
            "Error: scene.prm, line 4, entry 'Tool/Spline spans': found 50 "
            "with the Spline fit interpolation, which has one for each point; "
            "expected automatic.\n");
  EXPECT_EQ(refusal(in("Tool", tool + " set Spline degree = 4")),
            "Error: scene.prm, line 4, entry 'Tool/Spline degree': found 4 "
            "with the Spline fit interpolation; expected an odd degree, for "
            "which the points determine the spline.\n");
}
