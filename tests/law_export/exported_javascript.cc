#include <asperity/law_export/generated_source.h>

#include "javascript.h"

using namespace asperity;
using namespace asperity_test;

// The law in JavaScript answers as the law itself, in Node.js and in a browser.

namespace
{
  /** A function that evaluates the law at points of p, v, T and a further
   * input.
   */
  std::string
  driver(const std::vector<std::vector<double>> &points)
  {
    std::string text = "const points = [";
    for (const std::vector<double> &point : points)
      {
        text += "[";
        for (const double x : point)
          text += (std::isnan(x) ? "NaN" :
                   std::isinf(x) ? (x > 0. ? "Infinity" : "-Infinity") :
                                   exact(x)) +
                  ",";
        text += "],\n";
      }
    return text + R"(];
function answers() {
  return points.map(([p, v, T, further]) => {
    const at = friction_law.evaluate(
      p, v, T, further === undefined ? undefined : [further]);
    return [at.mu, at.deviation, at.lower, at.upper, at.surface_lower,
            at.surface_upper, at.inside, at.trusted, at.k, at.tau]
      .map(Number).map(String).join(" ");
  }).join("\n");
}
)";
  }

  std::vector<std::vector<double>>
  answers(const Folder                           &folder,
          const std::string                      &engine,
          const std::string                      &law,
          const std::vector<std::vector<double>> &points)
  {
    folder.write("friction_law.js", law);
    folder.write("driver.js", driver(points));
    run_javascript(folder, engine, {"friction_law.js", "driver.js"});
    return folder.rows("answers.txt");
  }

  std::vector<std::vector<double>>
  as_rows(const std::vector<ContactPoint> &points)
  {
    std::vector<std::vector<double>> rows;
    for (const ContactPoint &point : points)
      rows.emplace_back(point.begin(), point.end());
    return rows;
  }

  void
  expect_answer(const std::vector<double> &row,
                const LawPrediction       &at,
                const double               tolerance)
  {
    ASSERT_EQ(row.size(), 10u);
    EXPECT_NEAR(row[0], at.mean, tolerance);
    EXPECT_NEAR(row[1], at.deviation, 1e-9 * std::abs(at.mean));
    EXPECT_NEAR(row[2], at.lower, 1e-9 * std::abs(at.mean));
    EXPECT_NEAR(row[3], at.upper, 1e-9 * std::abs(at.upper));
    EXPECT_NEAR(row[4], at.surface_lower, 1e-9 * std::abs(at.mean));
    EXPECT_NEAR(row[5], at.surface_upper, 1e-9 * std::abs(at.surface_upper));
  }

  /** Tests have one name each, so that a missing engine is said. */
  class Javascript : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      if (engines().empty())
        GTEST_SKIP() << "neither node nor chromium was found";
    }
  };
} // namespace

TEST_F(Javascript, agrees_with_the_law)
{
  for (const std::string &engine : engines())
    for (const LawKind &kind : law_kinds)
      {
        SCOPED_TRACE(engine + ", " + kind.name());
        const Folder          folder;
        const ContactPointLaw law(train(kind));
        const auto            all = points();
        const auto            rows =
          answers(folder, engine, js_source(law, true), as_rows(all));
        ASSERT_EQ(rows.size(), all.size());
        for (std::size_t j = 0; j < all.size(); ++j)
          {
            const ContactPoint &x = all[j];
            SCOPED_TRACE("p = " + exact(x[0]) + ", v = " + exact(x[1]) +
                         ", T = " + exact(x[2]));
            const LawPrediction at = law.predict(x);
            expect_answer(rows[j], at, accuracy(law.law(), x, at.mean));
            EXPECT_EQ(rows[j][6] != 0., law.is_inside(x));
            EXPECT_TRUE((rows[j][7] != 0.) == at.trusted ||
                        is_borderline(law.law(), at));
            EXPECT_NEAR(rows[j][8], law.shear_limit(x[2]), 1e-14 * 6e8);
            EXPECT_NEAR(rows[j][9],
                        law.shear_stress(x),
                        accuracy(law.law(), x, at.mean) * std::abs(x[0]) +
                          1e-6);
          }
      }
}

// Wetting stands behind the pressure in the law; a strain hardens the chip.
TEST_F(Javascript, takes_further_inputs_and_holds_them_without)
{
  LawKind wet, strained;
  wet.has_wetting     = true;
  strained.has_strain = strained.over_k = true;
  for (const auto &[kind, name] : {std::make_pair(wet, "Wetting"),
                                   std::make_pair(strained, "Plasticstrain")})
    {
      const Folder                     folder;
      const ContactPointLaw            law(train(kind, 60), {{name, 0.35}});
      const ContactPointLaw            other(law.law(), {{name, 0.9}});
      std::vector<std::vector<double>> held = as_rows(points()), given;
      for (std::vector<double> point : held)
        {
          point.push_back(0.9);
          given.push_back(point);
        }
      const auto rows =
                   answers(folder, engines()[0], js_source(law, true), held),
                 others =
                   answers(folder, engines()[0], js_source(law, true), given);
      ASSERT_EQ(rows.size(), held.size());
      ASSERT_EQ(others.size(), held.size());
      for (std::size_t j = 0; j < held.size(); ++j)
        {
          const ContactPoint  x  = points()[j];
          const LawPrediction at = law.predict(x), there = other.predict(x);
          // more inputs, more terms that cancel
          expect_answer(rows[j],
                        at,
                        accuracy(law.law(), x, at.mean) + 1e-11 * at.mean);
          expect_answer(others[j],
                        there,
                        accuracy(law.law(), x, there.mean) +
                          1e-11 * there.mean);
        }
    }
}

TEST_F(Javascript, agrees_with_a_law_that_was_fitted_to_measurements)
{
  FrictionLawDescription description;
  description.inputs = {{"Load/Velocity", "v", "m/min"}};
  std::vector<double> v, mu;
  for (unsigned int i = 0; i < 12; ++i)
    {
      v.push_back(0.08 * std::pow(3. / 0.08, i / 11.));
      mu.push_back(0.54 * std::pow(std::max(v[i], 0.77) / 0.77, -0.35) *
                   (1. + 0.02 * std::sin(5. * i)));
    }
  const ContactPointLaw law(
    FrictionLaw::fit_to_measurements(description, v, mu, {}));
  std::vector<ContactPoint> at;
  for (const double velocity :
       {-1., 0., 1e-9, 0.05, 0.08, 0.5, 0.77, 0.78, 2., 3., 50., 1e3, 1e4})
    at.push_back({{5e8, velocity, 500.}});
  const Folder folder;
  const auto   rows =
    answers(folder, engines()[0], js_source(law, true), as_rows(at));
  ASSERT_EQ(rows.size(), at.size());
  for (std::size_t j = 0; j < at.size(); ++j)
    {
      const LawPrediction there = law.predict(at[j]);
      expect_answer(rows[j], there, 1e-13);
      EXPECT_EQ(rows[j][7] != 0., there.trusted);
      EXPECT_TRUE(std::isinf(rows[j][8]));
    }
}

TEST_F(Javascript, without_the_factor_knows_the_box_only)
{
  const Folder          folder;
  const ContactPointLaw law(train(law_kinds[2]));
  const auto            rows =
    answers(folder, engines()[0], js_source(law, false), as_rows(points()));
  ASSERT_EQ(rows.size(), points().size());
  for (std::size_t j = 0; j < rows.size(); ++j)
    {
      EXPECT_EQ(rows[j][1], -1.);
      EXPECT_TRUE(std::isnan(rows[j][2]));
      EXPECT_EQ(rows[j][7] != 0., law.is_inside(points()[j]));
    }
}

TEST_F(Javascript, stays_finite_and_untrusted_at_absurd_points)
{
  const double infinite = std::numeric_limits<double>::infinity(),
               nan      = std::numeric_limits<double>::quiet_NaN();
  std::vector<ContactPoint> absurd;
  for (const double x : {1e300, -1e300, 5e-324, infinite, -infinite, nan})
    {
      absurd.push_back({{x, 1., 500.}});
      absurd.push_back({{5e8, x, 500.}});
      absurd.push_back({{5e8, 1., x}});
    }
  for (const LawKind &kind : law_kinds)
    {
      SCOPED_TRACE(kind.name());
      const Folder folder;
      const auto   rows = answers(folder,
                                engines()[0],
                                js_source(ContactPointLaw(train(kind)), true),
                                as_rows(absurd));
      ASSERT_EQ(rows.size(), absurd.size());
      for (std::size_t j = 0; j < rows.size(); ++j)
        {
          const bool is_number = j < absurd.size() - 3; // the last are none
          EXPECT_EQ(std::isfinite(rows[j][0]), is_number) << j;
          EXPECT_EQ(rows[j][7], 0.);
        }
    }
}

// What a law's file may say must not become code, nor end the script of a page.
TEST_F(Javascript, texts_of_the_law_stay_texts)
{
  const FrictionLaw      plain             = train(law_kinds[2]);
  FrictionLawDescription description       = plain.description();
  description.provenance["*/ throw 1; /*"] = "\r\n*/ throw 2;";
  const std::string name                   = "</script><b>\"'\\\u2028`${1}";
  description.inputs[1].name               = name;
  const ContactPointLaw law(
    FrictionLaw::train(description, plain.data().x, plain.data().y));
  const std::string text = js_source(law, false);
  EXPECT_EQ(text.find(name), std::string::npos);
  const Folder folder;
  const auto   rows = answers(folder, engines()[0], text, {{5e8, 1., 500.}});
  EXPECT_NEAR(rows.at(0).at(0), law.mean({{5e8, 1., 500.}}), 1e-12);
  folder.write("name.js",
               "function answers() { return friction_law.inputs[1].name === "
               "\"<\\/script><b>\\\"'\\\\\\u2028`${1}\" ? 1 : 0; }");
  run_javascript(folder, engines()[0], {"friction_law.js", "name.js"});
  EXPECT_EQ(folder.rows("answers.txt").at(0).at(0), 1.);
}

// mu of the sample: points over length scales, weights, and Matern 3/2.
TEST_F(Javascript, templates_compute_as_they_stand)
{
  const Folder      folder;
  const std::string templates =
    std::string(ASPERITY_SOURCE_DIR) + "/source/law_export/templates/";
  folder.run("cp '" + templates + "'*.js .");
  folder.write("driver.js", driver({{6e8, 1., 500.}}));
  run_javascript(folder,
                 engines()[0],
                 {"gaussian_process.js", "friction_law.js", "driver.js"});
  double m = 0.375;
  for (const auto &[x, y, weight] : {std::array<double, 3>{{0., 0., 0.5}},
                                     {{1., 0.25, -0.25}},
                                     {{2., 0.5, 0.125}}})
    {
      const double a = std::sqrt(3.) * std::hypot(x - 0.6, y - 0.25);
      m += weight * ((1. + a) * std::exp(-a) - 1.);
    }
  EXPECT_NEAR(folder.rows("answers.txt").at(0).at(0),
              std::exp(-2. + 0.25 * m),
              1e-14);
  run_javascript(folder,
                 engines()[0],
                 {"piecewise_power_law.js", "friction_law.js", "driver.js"});
}
