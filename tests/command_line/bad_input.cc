#include "program.h"

// What a user can get wrong in a parameter file. Each ends with exit status 2
// and one sentence that names the place, what was found and what is expected.

using namespace asperity;

using BadInput = Program;

namespace
{
  std::string
  in(const std::string &section, const std::string &line)
  {
    return "subsection " + section + "\n  " + line + "\nend\n";
  }
} // namespace

TEST_F(BadInput, unknown_entry)
{
  EXPECT_EQ(refusal(in("Load", "set Presure = 300 MPa")),
            "Error: scene.prm, line 2: There is no entry 'Presure' in "
            "subsection 'Load'; did you mean 'Pressure' in subsection "
            "'Load'?\n");
}

TEST_F(BadInput, unknown_subsection)
{
  EXPECT_EQ(refusal(in("Loads", "set Pressure = 300 MPa")),
            "Error: scene.prm, line 2: There is no entry 'Pressure' in "
            "subsection 'Loads'; did you mean 'Pressure' in subsection "
            "'Load'?\n");
}

TEST_F(BadInput, entry_outside_of_its_subsection)
{
  EXPECT_EQ(refusal("set Velocity = 200 m/min\n"),
            "Error: scene.prm, line 1: There is no entry 'Velocity' at the top "
            "level; did you mean 'Velocity' in subsection 'Load'?\n");
}

TEST_F(BadInput, wrong_dimension)
{
  EXPECT_EQ(refusal(in("Load", "set Pressure = 300 mm")),
            "Error: scene.prm, line 2, entry 'Load/Pressure': '300 mm' is a "
            "length; a stress is expected, in one of the units Pa, kPa, MPa, "
            "GPa, bar, N/m2, N/mm2.\n");
}

TEST_F(BadInput, missing_unit)
{
  EXPECT_EQ(refusal(in("Load", "set Velocity = 200")),
            "Error: scene.prm, line 2, entry 'Load/Velocity': '200' has no "
            "unit; a velocity is expected, in one of the units m/s, m/min, "
            "km/h, mm/s, mm/min, um/us.\n");
}

TEST_F(BadInput, unknown_unit)
{
  EXPECT_EQ(refusal(in("Load", "set Temperature = 300 C")),
            "Error: scene.prm, line 2, entry 'Load/Temperature': '300 C' has "
            "the unknown unit 'C'; a temperature is expected, in one of the "
            "units K, degC, degF.\n");
}

TEST_F(BadInput, not_a_number)
{
  EXPECT_EQ(refusal(in("Load", "set Pressure = high")),
            "Error: scene.prm, line 2, entry 'Load/Pressure': 'high' does not "
            "start with a number; a stress is expected, in one of the units "
            "Pa, kPa, MPa, GPa, bar, N/m2, N/mm2.\n");
  EXPECT_NE(refusal(in("Load", "set Pressure = nan MPa")).find("'nan MPa'"),
            std::string::npos);
}

TEST_F(BadInput, negative_density)
{
  EXPECT_EQ(refusal(in("Material", "set Density = -7850 kg/m3")),
            "Error: scene.prm, line 2, entry 'Material/Density': '-7850 kg/m3' "
            "is out of range; 1 kg/m3 to 100000 kg/m3 is expected.\n");
}

TEST_F(BadInput, incompressible_steel)
{
  EXPECT_EQ(refusal(in("Material", "set Poisson's ratio = 0.5")),
            "Error: scene.prm, line 2, entry 'Material/Poisson's ratio': '0.5' "
            "is out of range; -0.9 to 0.49 is expected.\n");
  EXPECT_NE(refusal(in("Material", "set Poisson's ratio = 0.4999"))
              .find("-0.9 to 0.49 is expected"),
            std::string::npos)
    << "the splines would lock";
}

TEST_F(BadInput, temperature_below_absolute_zero)
{
  EXPECT_NE(refusal(in("Load", "set Temperature = -300 degC"))
              .find("'-300 degC' is out of range"),
            std::string::npos);
}

TEST_F(BadInput, degree_zero)
{
  EXPECT_EQ(refusal(in("Mesh", "set Degree = 0")),
            "Error: scene.prm, line 2, entry 'Mesh/Degree': '0' is out of "
            "range; a whole number, 1 to 4 is expected.\n");
}

TEST_F(BadInput, half_an_element)
{
  EXPECT_NE(refusal(in("Mesh", "set Spans = 80.5"))
              .find("entry 'Mesh/Spans': '80.5' is not a whole number"),
            std::string::npos);
}

TEST_F(BadInput, spans_that_cannot_be_halved)
{
  EXPECT_EQ(refusal("subsection Mesh\n set Spans = 162\n"
                    " set Refinement levels = 2\nend\n"),
            "Error: scene.prm, line 2, entry 'Mesh/Spans': found 162; expected "
            "a multiple of 4, 2 to the power of the refinement levels.\n");
}

TEST_F(BadInput, refined_strip_deeper_than_the_chip)
{
  EXPECT_NE(refusal(in("Mesh", "set Strip depth = 6 um"))
              .find("entry 'Mesh/Strip depth': found 6 um; expected less than "
                    "the chip height of 5 um"),
            std::string::npos);
}

TEST_F(BadInput, bodies_that_overlap_at_the_start)
{
  EXPECT_EQ(refusal(in("Geometry", "set Initial gap = -0.1 um")),
            "Error: scene.prm, line 2, entry 'Geometry/Initial gap': '-0.1 um' "
            "is out of range; 0 um to 1000 um is expected.\n");
}

TEST_F(BadInput, empty_window)
{
  EXPECT_EQ(refusal(in("Protocol", "set Window fraction = 0")),
            "Error: scene.prm, line 2, entry 'Protocol/Window fraction': '0' "
            "is out of range; 0.001 to 1 is expected.\n");
}

TEST_F(BadInput, unknown_choice)
{
  EXPECT_EQ(refusal(in("Contact", "set Formulation = nitsche")),
            "Error: scene.prm, line 2, entry 'Contact/Formulation': 'nitsche' "
            "is not a choice; one of mortar, gauss-point is expected.\n");
}

TEST_F(BadInput, flag_that_is_neither_true_nor_false)
{
  EXPECT_EQ(refusal(in("Output", "set Restart = yes")),
            "Error: scene.prm, line 2, entry 'Output/Restart': 'yes' is "
            "neither 'true' nor 'false'.\n");
}

TEST_F(BadInput, harmonics_with_a_phase_too_few)
{
  EXPECT_EQ(refusal("subsection Tool\n set Wave numbers = 1, 2\n"
                    " set Amplitudes = 0.1, 0.2 um\n set Phases = 1 rad\n"
                    "end\n"),
            "Error: scene.prm, line 4, entry 'Tool/Phases': found 1 values; "
            "expected 2, one for each wave number.\n");
}

TEST_F(BadInput, wave_that_is_not_periodic)
{
  EXPECT_NE(refusal("subsection Tool\n set Wave numbers = 1.5\n"
                    " set Amplitudes = 0.1 um\n set Phases = 1 rad\nend\n")
              .find("found 1.5; expected whole numbers"),
            std::string::npos);
}

TEST_F(BadInput, missing_end)
{
  EXPECT_EQ(refusal("subsection Load\n  set Pressure = 300 MPa\n"),
            "Error: scene.prm: The file ends inside of subsection 'Load'; an "
            "'end' is missing.\n");
}

TEST_F(BadInput, entry_set_twice)
{
  EXPECT_EQ(refusal("subsection Load\n  set Pressure = 3 MPa\n"
                    "  set Pressure = 4 MPa\nend\n"),
            "Error: scene.prm, line 3: The entry 'Load/Pressure' has already "
            "been set in line 2.\n");
}

TEST_F(BadInput, line_that_is_none)
{
  EXPECT_NE(refusal("pressure: 300 MPa\n")
              .find("scene.prm, line 1: The line is not understood"),
            std::string::npos);
}

TEST_F(BadInput, missing_and_circular_includes)
{
  EXPECT_EQ(refusal("\ninclude common.prm\n"),
            "Error: scene.prm, line 2: The parameter file 'common.prm' does "
            "not exist or cannot be read.\n");
  write("common.prm", "include scene.prm\n");
  EXPECT_EQ(refusal("\ninclude common.prm\n"),
            "Error: common.prm, line 1: The file 'scene.prm' includes "
            "itself.\n");
}

TEST_F(BadInput, missing_height_map)
{
  const std::string message =
    refusal("subsection Tool\n set Kind = measured\n"
            " subsection Topography\n  set File = nowhere.x3p\n end\nend\n");
  EXPECT_EQ(message,
            "Error: scene.prm, line 4, entry 'Tool/Topography/File': the file "
            "'nowhere.x3p' does not exist or cannot be read.\n");
}

TEST_F(BadInput, height_map_that_is_none)
{
  write("letter.x3p", "Dear Sir or Madam,\n");
  const std::string message =
    refusal("subsection Tool\n set Kind = measured\n"
            " subsection Topography\n  set File = letter.x3p\n end\nend\n");
  EXPECT_NE(message.find("letter.x3p"), std::string::npos) << message;
}

TEST_F(BadInput, output_directory_that_is_a_file)
{
  write("results", "not a folder\n");
  const std::string message =
    refusal(in("Output", "set Output directory = results"));
  EXPECT_NE(message.find("results"), std::string::npos) << message;
}

TEST_F(BadInput, restart_without_a_checkpoint)
{
  const std::string message = refusal("subsection Output\n"
                                      "  set Output directory = new\n"
                                      "  set Restart = true\nend\n");
  EXPECT_NE(message.find("checkpoint"), std::string::npos) << message;
}

TEST_F(BadInput, wetting_beyond_the_void)
{
  EXPECT_EQ(refusal(in("Lubrication", "set Wetting = 1.5")),
            "Error: scene.prm, line 2, entry 'Lubrication/Wetting': '1.5' is "
            "out of range; 0 to 1 is expected.\n");
}

TEST_F(BadInput, lubricant_without_oil)
{
  EXPECT_EQ(refusal(in("Lubrication", "set Model = pocket\n  set Wetting = 0")),
            "Error: scene.prm, line 3, entry 'Lubrication/Wetting': found 0, "
            "so that there is no oil; expected a positive number, or the model "
            "`none`.\n");
}

TEST_F(BadInput, unknown_lubricant_model)
{
  EXPECT_NE(refusal(in("Lubrication", "set Model = grease")).find("pocket"),
            std::string::npos);
}

TEST_F(BadInput, oil_of_negative_stiffness)
{
  EXPECT_EQ(refusal(in("Lubricant", "set Bulk modulus = -1.6 GPa")),
            "Error: scene.prm, line 2, entry 'Lubricant/Bulk modulus': '-1.6 "
            "GPa' is out of range; 0.001 GPa to 1000 GPa is expected.\n");
}

TEST_F(BadInput, output_directory_without_a_name)
{
  const std::string reason = "Output directory': found nothing; expected a "
                             "folder, such as '.' for the current one.\n";
  EXPECT_EQ(refusal(in("Output", "set Output directory =")),
            "Error: scene.prm, line 2, entry 'Output/" + reason);
  write("map.csv", "1 2\n3 4\n");
  write("surface.prm",
        "set Output directory =\n" + in("Topography", "set File = map.csv"));
  EXPECT_EQ(run("topography surface.prm").errors,
            "Error: surface.prm, line 1, entry '" + reason);
}

TEST_F(BadInput, oil_that_thickens_with_the_shear_rate)
{
  EXPECT_EQ(refusal("subsection Lubrication\n set Model = Reynolds\nend\n"
                    "subsection Lubricant\n set Viscosity = 0.2 Pa s\n"
                    " set Shear law = Carreau\n subsection Carreau\n"
                    "  set Infinite shear viscosity = 5 Pa s\n end\nend\n"),
            "Error: scene.prm, line 8, entry 'Lubricant/Carreau/Infinite shear "
            "viscosity': found 5 Pa s; expected at most the viscosity at rest, "
            "0.2 Pa s.\n");
}

TEST_F(BadInput, oil_too_thin_for_the_law_of_roelands)
{
  EXPECT_EQ(
    refusal("subsection Lubrication\n set Model = Reynolds\nend\n"
            "subsection Lubricant\n set Viscosity = 5e-5 Pa s\n"
            " set Pressure law = Roelands\nend\n"),
    "Error: scene.prm, line 5, entry 'Lubricant/Viscosity': found 5e-05 "
    "Pa s; expected more than 6.31e-05 Pa s for the law of Roelands.\n");
}

TEST_F(BadInput, heat_model_against_the_material)
{
  EXPECT_EQ(refusal(in("Material", "set Adiabatic heating = false") +
                    in("Heat", "set Model = conducting")),
            "Error: scene.prm, line 5, entry 'Heat/Model': found conducting "
            "with Material/Adiabatic heating = false; expected that to be "
            "true, or the model isothermal.\n");
}
