#include <asperity/surrogate/friction_law.h>

#include <cmath>

#include "program.h"

using namespace asperity;

// `asperity fit` as its users call it, and what becomes of its law.

namespace
{
  class MeasuredFrictionLaws : public Program
  {
  protected:
    void
    SetUp() override
    {
      Program::SetUp();
      std::string text = "v [m/min],p [MPa],mu,series\n";
      for (const double v : {5., 10., 20., 40., 60., 90., 120., 180.})
        text += std::to_string(v) + "," + std::to_string(300. + v) + "," +
                std::to_string(0.54 * std::pow(std::max(v, 46.) / 46., -0.35)) +
                ",dry\n" + std::to_string(v) + ",300,0.2,wet\n";
      write("measured.csv", text);
    }

    std::string
    refused(const std::string &arguments) const
    {
      const Result result = run(arguments);
      EXPECT_EQ(result.status, 2) << result.output << result.errors;
      EXPECT_EQ(result.output, "");
      return result.errors;
    }

    /** mu = 0.08 to 0.11 over the pressure, and 0.45 m besides, a little less
     *  with plastic strain. */
    void
    train_law_of_shear() const
    {
      FrictionLawDescription description;
      description.inputs = {
        {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::logarithmic},
        {"Interface/Shear factor", "ShearFactor", "1", 0., 1.},
        {"Load/Plastic strain",
         "Plasticstrain",
         "1",
         0.,
         3.,
         Scale::linear,
         1.}};
      description.mechanisms = {"ploughing", "interface shear"};
      std::vector<double> x, y;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            {
              x.insert(x.end(),
                       {3e8 * std::pow(13. / 3., i / 3.), j / 3., 1.5 * k});
              y.push_back(0.08 + 0.01 * i + (0.45 - 0.01 * k) * j / 3.);
            }
      FrictionLaw::train(description, x, y)
        .save((folder / "friction_law.json").string());
    }
  };
} // namespace

TEST_F(MeasuredFrictionLaws, are_fitted_predicted_and_exported)
{
  const Result fit = run("fit measured.csv law.json --series dry");
  EXPECT_EQ(fit.status, 0) << fit.errors;
  for (const std::string text :
       {"mu = mu_0 (v/v_0)^n beyond v_0, mu_0 below, mu_0 = 0.54 ",
        ", v_0 = 46 m/min (standard error ",
        ", n = -0.35 (standard error ",
        "This mu was fitted to measurements: whatever acted in their contact "
        "is in it.",
        "Warning: p varies from 305 MPa to 480 MPa between the measurements, "
        "on which this law does not depend.",
        "'asperity predict law.json -v 30m/min' asks it."})
    EXPECT_NE(fit.output.find(text), std::string::npos) << fit.output;

  const Result slow = run("predict law.json -v 30m/min");
  EXPECT_EQ(slow.status, 0) << slow.errors;
  EXPECT_EQ(slow.output.rfind("mu = 0.54, ", 0), 0u) << slow.output;
  EXPECT_NE(slow.output.find("fitted to measurements"), std::string::npos);

  const Result exported = run("export law.json out");
  EXPECT_EQ(exported.status, 0) << exported.errors;
  for (const std::string file : {"tribmu.c",
                                 "tribmu.f",
                                 "abaqus_vfriction.f",
                                 "abaqus_friction.inp",
                                 "friction_table.csv",
                                 "README.txt"})
    EXPECT_NE(read("out/" + file).find("fitted to measurements"),
              std::string::npos)
      << file;

  const Result given =
    run("fit measured.csv law.json --series dry --constant-up-to 0.8m/s");
  EXPECT_NE(given.output.find("v_0 = 48 m/min, n"), std::string::npos)
    << given.output << given.errors;
  const Result none =
    run("fit measured.csv law.json --series=dry --constant-up-to none");
  EXPECT_NE(none.output.find("mu = mu_0 (v/v_0)^n, mu_0"), std::string::npos)
    << none.output << none.errors;
}

TEST_F(MeasuredFrictionLaws, say_what_is_wrong_with_the_measurements)
{
  EXPECT_EQ(refused("fit measured.csv"),
            "Error: 'asperity fit' takes a file of measurements and the file "
            "of the law, as in 'asperity fit measured.csv law.json'.\n");
  EXPECT_EQ(refused("fit measured.csv law.json"),
            "Error: The measurements measured.csv are of the series dry, wet; "
            "one or more of them are expected, as in --series 'dry'.\n");
  EXPECT_EQ(refused("fit measured.csv law.json --constant-up-to 46MPa"),
            "Error: Option '--constant-up-to': '46MPa' is a stress; a velocity "
            "is expected, in one of the units m/s, m/min, km/h, mm/s, mm/min, "
            "um/us, or one of the words automatic, none and fitted.\n");
  EXPECT_EQ(refused("fit measured.csv law.json --form cubic"),
            "Error: 'asperity fit' has no option '--form'; its options are "
            "--constant-up-to, --series.\n");
  write("no_velocity.csv", "p [MPa],mu\n300,0.5\n400,0.5\n500,0.5\n");
  EXPECT_EQ(refused("fit no_velocity.csv law.json"),
            "Error: The measurements no_velocity.csv have no column 'v'; they "
            "have p.\n");
  write("one.csv", "v [m/s],mu\n1,0.5\n1,0.5\n1,0.5\n");
  EXPECT_NE(refused("fit one.csv law.json").find("do not determine"),
            std::string::npos);
  EXPECT_EQ(read("law.json"), "");
}

namespace
{
  const char *const dry_cut = "set Experiment = cut\n"
                              "subsection Cut\n"
                              "  set Cutting force = 1196 N\n"
                              "  set Passive force = 0.647 kN\n"
                              "  set Width = 2 mm\n"
                              "  set Uncut chip thickness = 0.15 mm\n"
                              "  set Cutting speed = 5 m/min\n"
                              "  set Chip thickness = 0.81 mm\n"
                              "end\n";
} // namespace

TEST_F(MeasuredFrictionLaws, a_cut_gives_the_load_of_a_scene)
{
  write("cut.prm", dry_cut);
  const Result result = run("conditions cut.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  for (const std::string text :
       {"mu = 0.541\n",
        "Shear angle 10.49 deg, contact length 1.176 mm\n",
        "Pressure 508.3 MPa on average, 1525 MPa at the edge\n",
        "  set Pressure = 508.3 MPa\n  set Velocity = 0.9259 m/min\n  set "
        "Temperature = 146.7 degC\n  set Plastic strain = 3.225\nend\n",
        "\n508.3,0.9259,146.7,0.541\n"})
    EXPECT_NE(result.output.find(text), std::string::npos) << result.output;
  write("cut.prm",
        dry_cut + std::string("subsection Chip\n  set Shear limit = 500 "
                              "MPa\nend\n"));
  EXPECT_NE(run("conditions cut.prm").output.find("; the chip sticks on "),
            std::string::npos);
}

TEST_F(MeasuredFrictionLaws, a_pin_gives_the_load_of_a_scene)
{
  write("pin.prm",
        "set Experiment = pin\n"
        "subsection Pin\n"
        "  set Normal force = 1 kN\n"
        "  set Radius = 8.5 mm\n"
        "  set Velocity = 60 m/min\n"
        "  set Friction coefficient = 0.3\n"
        "end\n");
  const Result result = run("conditions pin.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("The contact is plastic, its radius 564.2 um\n"),
            std::string::npos)
    << result.output;
  EXPECT_NE(result.output.find("  set Pressure = 2000 MPa\n"),
            std::string::npos);
}

TEST_F(MeasuredFrictionLaws, conditions_say_what_is_missing)
{
  std::string text = dry_cut;
  text.replace(text.find("1196 N"), 6, "1196");
  write("cut.prm", text);
  EXPECT_EQ(refused("conditions cut.prm"),
            "Error: cut.prm, line 3, entry 'Cut/Cutting force': found '1196'; "
            "expected a force in N or kN, such as 1196 N.\n");
  text = dry_cut;
  text.erase(text.find("  set Width"), 19);
  write("cut.prm", text);
  EXPECT_EQ(refused("conditions cut.prm"),
            "Error: entry 'Cut/Width': found automatic; expected a value, "
            "which this experiment needs.\n");
  write("cut.prm",
        dry_cut + std::string("subsection Cut\n  set Shear angle = 10 "
                              "deg\nend\n"));
  EXPECT_NE(refused("conditions cut.prm").find("expected one of both"),
            std::string::npos);
  write("cut.prm",
        dry_cut + std::string("subsection Pin\n  set Radius = 1 mm\nend\n"));
  EXPECT_NE(refused("conditions cut.prm")
              .find("found an entry that this experiment does not have"),
            std::string::npos);
}

TEST_F(MeasuredFrictionLaws, calibrate_the_shear_factor)
{
  train_law_of_shear();
  write("points.csv",
        "p [MPa],mu,deviation of mu,source\n300,0.5,0.02,a test\n");
  const Result result = run("calibrate . points.csv");
  EXPECT_EQ(result.status, 0) << result.errors;
  // 0.08 + 0.4433 m = 0.5, and 0.02/0.4433, within what few runs teach
  const std::string head  = "Interface/Shear factor = ",
                    error = " (standard error ";
  ASSERT_EQ(result.output.rfind(head, 0), 0u) << result.output;
  EXPECT_NEAR(std::stod(result.output.substr(head.size())), 0.947, 0.03);
  ASSERT_NE(result.output.find(error), std::string::npos);
  EXPECT_NEAR(std::stod(
                result.output.substr(result.output.find(error) + error.size())),
              0.0451,
              0.003);
  EXPECT_NE(result.output.find("  line 2: mu = 0.5 measured, 0.5 computed, "),
            std::string::npos)
    << result.output;
  EXPECT_EQ(
    run("calibrate friction_law.json points.csv --plastic-strain 1").output,
    result.output);
}

TEST_F(MeasuredFrictionLaws, are_not_calibrated_by_what_does_not_determine_them)
{
  train_law_of_shear();
  write("points.csv",
        "p [MPa],mu,deviation of mu,source\n300,0.5,0.02,a test\n");
  EXPECT_NE(refused("calibrate . points.csv -p 300MPa")
              .find("is a column of the measurements and an option"),
            std::string::npos);
  write("points.csv", "mu\n0.5\n");
  EXPECT_EQ(refused("calibrate . points.csv"),
            "Error: The law also depends on 'Load/Pressure'; a column 'p' of "
            "the measurements or the option -p is expected.\n");
  write("points.csv", "p [MPa],v [m/min],mu\n300,5,0.5\n");
  EXPECT_NE(run("calibrate . points.csv")
              .output.find("The law does not depend on v; the measurements are "
                           "at 5 m/min, and its scene has to be, too.\n"),
            std::string::npos);
  write("points.csv", "p [MPa],v [m/min],mu\n300,5,0.5\n300,6,0.5\n");
  EXPECT_EQ(refused("calibrate . points.csv"),
            "Error: The measurements differ in v, on which the law does not "
            "depend; its inputs are p, ShearFactor, Plasticstrain.\n");
  write("points.csv", "p [MPa],mu\n300,0.9\n");
  EXPECT_NE(refused("calibrate . points.csv")
              .find("the best value is the end of its range, 1, "),
            std::string::npos);

  const Result fit = run("fit measured.csv other.json --series dry");
  EXPECT_EQ(fit.status, 0) << fit.errors;
  EXPECT_EQ(refused("calibrate other.json points.csv"),
            "Error: The law depends on 'Load/Velocity', and neither on "
            "'Interface/Shear factor' nor on 'Interface/Friction coefficient'; "
            "the law of a campaign that varies one of them is expected, or "
            "'--of' with another input.\n");
}
