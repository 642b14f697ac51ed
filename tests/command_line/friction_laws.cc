#include <asperity/surrogate/friction_law.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "program.h"

using namespace asperity;

// `asperity predict` and `asperity export` as their users call them.

namespace
{
  class FrictionLaws : public Program
  {
  protected:
    void
    SetUp() override
    {
      Program::SetUp();
      law(false).save((folder / "law.json").string());
    }

    /** mu = 0.1 (p / 300 MPa)^-0.2 v^-0.05 on 48 points, and half of that
     *  where all is wet. */
    static FrictionLaw
    law(const bool with_wetting)
    {
      FrictionLawDescription description;
      description.inputs = {
        {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::logarithmic},
        {"Load/Velocity", "v", "m/min", 0.375, 10. / 3., Scale::logarithmic},
        {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};
      if (with_wetting)
        description.inputs.push_back(
          {"Lubrication/Wetting", "Wetting", "1", 0., 1., Scale::linear});
      description.shear_limit = {6e8, 1.3558, 293.15, 1773.15, 1., 1e4};
      std::vector<double> x, y;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double p       = 3e8 * std::pow(13. / 3., i / 3.);
              const double v       = 0.375 * std::pow(80. / 9., j / 3.);
              const double wetting = ((i + j + k) % 4) / 3.;
              x.insert(x.end(), {p, v, 298.15 + k * 437.5});
              if (with_wetting)
                x.push_back(wetting);
              y.push_back(0.1 * std::pow(p / 3e8, -0.2) * std::pow(v, -0.05) *
                          (with_wetting ? 1. - 0.5 * wetting : 1.) *
                          (1. + 1e-3 * std::sin(i + 5. * j + 11. * k)));
            }
      return FrictionLaw::train(description, x, y);
    }

    std::string
    predict(const std::string &arguments) const
    {
      const Result result = run("predict law.json " + arguments);
      EXPECT_EQ(result.status, 0) << result.errors;
      return result.output;
    }

    /** The sentence that the program ends with, status 2. */
    std::string
    refused(const std::string &arguments) const
    {
      const Result result = run(arguments);
      EXPECT_EQ(result.status, 2) << result.output << result.errors;
      EXPECT_EQ(result.output, "");
      return result.errors;
    }

    /** The number behind a text. */
    static double
    number_behind(const std::string &text, const std::string &mark)
    {
      const std::size_t begin = text.find(mark);
      EXPECT_NE(begin, std::string::npos) << mark << " in " << text;
      return std::strtod(text.c_str() + begin + mark.size(), nullptr);
    }
  };
} // namespace

TEST_F(FrictionLaws, predict_says_all_about_a_point)
{
  const std::string text = predict("-p 450MPa -v 90m/min -T 300degC");
  const double      mu   = 0.1 * std::pow(1.5, -0.2) * std::pow(1.5, -0.05);
  EXPECT_NEAR(number_behind(text, "mu = "), mu, 2e-3 * mu);
  EXPECT_LT(number_behind(text, "interval "), mu);
  EXPECT_GT(number_behind(text, " to "), mu);
  EXPECT_NE(text.find("\ntrusted: inside of the data"), std::string::npos);
  EXPECT_NEAR(number_behind(text, "d mu/d p = "), -0.2 * mu / 450., 2e-6);
  EXPECT_NEAR(number_behind(text, "d mu/d v = "), -0.05 * mu / 90., 5e-6);
  EXPECT_NE(text.find(" per MPa\n"), std::string::npos);
  EXPECT_NE(text.find(" per m/min\n"), std::string::npos);
  EXPECT_NE(text.find(" per degC\n"), std::string::npos);
  const double k = 600. * (1. - std::pow(280. / 1480., 1.3558));
  EXPECT_NEAR(number_behind(text, "shear limit k = "), k, 0.06);
  EXPECT_NEAR(number_behind(text, "min(mu p, k) = "), 450. * mu, 0.2);
  EXPECT_NE(text.find("sliding"), std::string::npos);
}

TEST_F(FrictionLaws, predict_takes_inputs_by_name_too)
{
  EXPECT_EQ(predict("--set 'Load/Pressure = 450 MPa' --set v=1.5m/s "
                    "--set 'T = 573.15 K'"),
            predict("-p 450MPa -v 90m/min -T 300degC"));
}

// Every input has an option, and each is taken by name as a word as well.
TEST_F(FrictionLaws, predict_takes_further_inputs)
{
  law(true).save((folder / "wet.json").string());
  const std::string point = "predict wet.json -p 450MPa -v 90m/min -T 300degC ";
  const Result      result = run(point + "--wetting 0.6");
  EXPECT_EQ(result.status, 0) << result.errors;
  const double mu = 0.1 * std::pow(1.5, -0.2) * std::pow(1.5, -0.05) * 0.7;
  EXPECT_NEAR(number_behind(result.output, "mu = "), mu, 0.01 * mu);
  for (const std::string same : {"--wetting=0.6",
                                 "Wetting=0.6",
                                 "'Lubrication/Wetting = 60 %'",
                                 "--lubrication-wetting 0.6",
                                 "--set Wetting=0.6"})
    EXPECT_EQ(run(point + same).output, result.output) << same;
  EXPECT_EQ(refused(point),
            "Error: The law of 'mu' also needs --wetting \"0\", for "
            "example.\n");
  EXPECT_EQ(refused(point + "--plastic-strain 1"),
            "Error: 'asperity predict' has no option '--plastic-strain' for "
            "this law; its options are -p, -v, -T, --wetting, --set.\n");
}

TEST_F(FrictionLaws, predict_says_which_mechanisms_are_in_mu)
{
  EXPECT_NE(predict("-p 450MPa -v 90m/min -T 300degC")
              .find("\nWhich mechanisms are in this mu is not known: "),
            std::string::npos);
  const FrictionLaw      dry         = law(false);
  FrictionLawDescription description = dry.description();
  for (const auto &[mechanisms, sentence] :
       {std::make_pair(std::vector<std::string>{"ploughing"},
                       "\nThis mu comes from ploughing alone; adhesion, the "
                       "shear of the dry interface, is not in it.\n"),
        {{"ploughing", "oil"},
         "\nThis mu comes from ploughing and oil; adhesion, the shear of the "
         "dry interface, is not in it.\n"}})
    {
      description.mechanisms = mechanisms;
      FrictionLaw::train(description, dry.data().x, dry.data().y)
        .save((folder / "law.json").string());
      EXPECT_NE(predict("-p 450MPa -v 90m/min -T 300degC").find(sentence),
                std::string::npos);
    }
}

// Independent choices add by their squares: 0.3 and 0.4 are 0.5.
TEST_F(FrictionLaws, say_how_far_choices_by_hand_may_move_mu)
{
  const std::string point = "-p 450MPa -v 90m/min -T 300degC";
  EXPECT_EQ(predict(point).find("choices by hand"), std::string::npos);
  const FrictionLaw      plain       = law(false);
  FrictionLawDescription description = plain.description();
  description.choices = {{"preparation", 0.3, 0.5}, {"profile", 0.4, 1.2}};
  FrictionLaw::train(description, plain.data().x, plain.data().y)
    .save((folder / "law.json").string());
  const std::string text = predict(point);
  const double      mu   = number_behind(text, "mu = ");
  EXPECT_NEAR(number_behind(text, "found in one scene: "), 0.5 * mu, 1e-5);
  EXPECT_NE(text.find("(preparation -30 % to +50 %, profile -40 % to +120 %)"),
            std::string::npos)
    << text;
  const std::string line = text.substr(text.find("found in one scene: "));
  EXPECT_NEAR(number_behind(line, " to "), 2.3 * mu, 2e-5);

  ASSERT_EQ(run("export law.json laws").status, 0);
  EXPECT_NE(read("laws/abaqus_friction.inp").find("Choices by hand (profile)"),
            std::string::npos);
}

// What plane strain errs is no choice, so that it is told apart from them.
TEST_F(FrictionLaws, say_what_their_profiles_err_against_a_patch)
{
  const FrictionLaw      plain       = law(false);
  FrictionLawDescription description = plain.description();
  description.choices = {{"profile", 0.4, 1.2}, {"plane strain", 0., 1.5}};
  FrictionLaw::train(description, plain.data().x, plain.data().y)
    .save((folder / "law.json").string());
  const std::string text = predict("-p 450MPa -v 90m/min -T 300degC");
  const double      mu   = number_behind(text, "mu = ");
  EXPECT_NE(text.find("(profile -40 % to +120 %)"), std::string::npos) << text;
  const std::string line = text.substr(text.find("plane strain: a patch"));
  EXPECT_NEAR(number_behind(line, "may have "), mu, 1e-5);
  EXPECT_NEAR(number_behind(line, " to "), 2.5 * mu, 3e-5);
  EXPECT_NE(line.find("(-0 % to +150 %)"), std::string::npos) << line;

  ASSERT_EQ(run("export law.json laws").status, 0);
  const std::string head = read("laws/abaqus_friction.inp");
  EXPECT_NE(head.find("A patch of the surface in three dimensions"),
            std::string::npos);
  EXPECT_EQ(head.find("Choices by hand (plane strain)"), std::string::npos);
}

TEST_F(FrictionLaws, predict_says_why_a_point_is_not_trusted)
{
  const std::string text = predict("-p 1.5GPa -v 90m/min -T 1000degC");
  EXPECT_NE(text.find(
              "\nnot trusted: p = 1500 MPa is outside of the data, 300 MPa to "
              "1300 MPa; T = 1000 degC is outside of the data, 25 degC to 900 "
              "degC"),
            std::string::npos)
    << text;
  EXPECT_NE(predict("-p 40GPa -v 90m/min -T 1000degC").find("sticking"),
            std::string::npos);
}

TEST_F(FrictionLaws, predict_wants_units_and_all_inputs)
{
  EXPECT_EQ(refused("predict law.json -p 450 -v 90m/min -T 300degC"),
            "Error: Option '-p', input 'Load/Pressure': '450' has no unit; a "
            "stress is expected, in one of the units Pa, kPa, MPa, GPa, bar, "
            "N/m2, N/mm2.\n");
  EXPECT_EQ(refused("predict law.json -p 450MPa -T 300degC"),
            "Error: The law of 'mu' also needs -v \"22.5 m/min\", for "
            "example.\n");
  EXPECT_EQ(refused("predict law.json -p 450MPa -v 90m/min -T"),
            "Error: The option '-T' of 'asperity predict' needs a value behind "
            "it.\n");
  EXPECT_EQ(refused("predict law.json -p 450MPa -p 450MPa"),
            "Error: The option '-p' of 'asperity predict' is given twice.\n");
  EXPECT_EQ(refused("predict law.json -q 3"),
            "Error: 'asperity predict' has no option '-q' for this law; its "
            "options are -p, -v, -T, --set.\n");
  EXPECT_EQ(refused("predict law.json -p 450MPa -v 90m/min --set T=300degC "
                    "--set 'Load/Temperature = 300 degC'"),
            "Error: The input 'Load/Temperature' is set twice.\n");
  EXPECT_EQ(refused("predict law.json -p 450MPa --set p=400MPa"),
            "Error: The input 'Load/Pressure' is given by '-p' and once "
            "more.\n");
  EXPECT_EQ(refused("predict law.json --set 'Load/Presure = 400 MPa'"),
            "Error: The law has no input 'Load/Presure'; did you mean "
            "'Load/Pressure'?\n");
  EXPECT_EQ(
    refused("predict law.json --set 'Wetting 0.5'"),
    "Error: The setting 'Wetting 0.5' is not understood; \"name = value "
    "unit\" is expected.\n");
}

TEST_F(FrictionLaws, predict_wants_a_law)
{
  EXPECT_EQ(refused("predict -p 450MPa"),
            "Error: 'asperity predict' takes one law, as in 'asperity predict "
            "law.json -p 450MPa -v 90m/min -T 300degC'.\n");
  EXPECT_NE(refused("predict nowhere.json -p 450MPa").find("nowhere.json"),
            std::string::npos);
  write("letter.json", "Dear Sir or Madam,\n");
  EXPECT_NE(refused("predict letter.json -p 450MPa").find("letter.json"),
            std::string::npos);
}

TEST_F(FrictionLaws, export_writes_what_it_lists)
{
  const Result result = run("export law.json for_abaqus --tolerance 1%");
  EXPECT_EQ(result.status, 0) << result.errors;
  for (const std::string file : {"tribmu.c", "abaqus_friction.inp"})
    {
      EXPECT_NE(result.output.find(file), std::string::npos) << result.output;
      EXPECT_NE(read("for_abaqus/" + file), "");
    }
  EXPECT_NE(result.output.find("a power law: "), std::string::npos);
  EXPECT_NE(read("for_abaqus/abaqus_friction.inp").find("tolerance 1 %"),
            std::string::npos);
  EXPECT_EQ(run("export law.json in_si --units SI").status, 0);
  EXPECT_NE(read("in_si/abaqus_friction.inp").find("pressure Pa"),
            std::string::npos);
}

TEST_F(FrictionLaws, export_refuses_what_it_cannot_do)
{
  EXPECT_EQ(refused("export law.json"),
            "Error: 'asperity export' takes a law and a directory, as in "
            "'asperity export law.json for_abaqus'.\n");
  EXPECT_EQ(refused("export law.json out --units inch"),
            "Error: The option '--units' is 'inch'; 'mm' (mm, s, MPa, degC) or "
            "'SI' is expected.\n");
  EXPECT_EQ(
    refused("export law.json out --tolerance 200%"),
    "Error: The tolerance of friction tables is 2; a number above 0 and "
    "below 1 is expected.\n");
  law(true).save((folder / "wet.json").string());
  EXPECT_EQ(refused("export wet.json out"),
            "Error: The friction law also depends on 'Lubrication/Wetting'; a "
            "value of it is expected, 0 to 1.\n");
  EXPECT_EQ(run("export wet.json wet --set Wetting=50%").status, 0);
  EXPECT_EQ(run("export wet.json wet2 --wetting 50%").status, 0);
  EXPECT_EQ(read("wet2/tribmu.c"), read("wet/tribmu.c"));
}
