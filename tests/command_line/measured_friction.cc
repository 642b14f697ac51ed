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
