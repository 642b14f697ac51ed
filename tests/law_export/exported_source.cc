#include <asperity/law_export/generated_source.h>

#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// The generated source is compiled as its users do it, and has to answer like
// the law itself: inside of the box, outside, and where logarithms end.

namespace
{
  const char *const c_driver = R"(
#include "tribmu.h"
#include <stdio.h>
int main(void)
{
  double p, v, T;
  while (scanf("%lf %lf %lf", &p, &v, &T) == 3)
    {
      double dmu[3], dk;
      int inside, trusted;
      const double mu = tribmu(p, v, T, dmu, &inside);
      const double sigma = tribmu_sigma(p, v, T, &trusted);
      const double k = tribmu_k(T, &dk);
      printf("%.17g %.17g %.17g %.17g %d %.17g %d %.17g %.17g %.17g\n", mu,
             dmu[0], dmu[1], dmu[2], inside, sigma, trusted, k, dk,
             tribmu_tau(p, v, T));
    }
  return 0;
}
)";

  const char *const fortran_driver = R"(
      PROGRAM DRIVER
      IMPLICIT NONE
      INTEGER INSIDE,ITRUST
      DOUBLE PRECISION P,V,T,XMU,DMU(3),SIGMA,WORK(1000),XK,DXK,TRIBTA
      DOUBLE PRECISION AGAIN
   10 READ(*,*,END=20) P,V,T
      CALL TRIBMU(P,V,T,XMU,DMU,INSIDE)
      CALL TRIBSD(P,V,T,AGAIN,SIGMA,ITRUST,WORK)
      IF (AGAIN.NE.XMU) STOP 1
      CALL TRIBK(T,XK,DXK)
      WRITE(*,'(1P,4E26.17E3,I3,E26.17E3,I3,3E26.17E3)') XMU,DMU,INSIDE,
     &  SIGMA,ITRUST,XK,DXK,TRIBTA(P,V,T)
      GOTO 10
   20 END
)";

  const std::string compile_c =
    "gcc -std=c99 -pedantic -Wall -Wextra -Werror -O1 -o driver driver.c "
    "tribmu.c -lm";
  const std::string compile_fortran =
    "gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -Wall -Wextra "
    "-Werror -O1 -c tribmu.f && gfortran -o driver tribmu.o driver.f";

  std::vector<std::vector<double>>
  answers_of_c(const Folder                    &folder,
               const ContactPointLaw           &law,
               const std::vector<ContactPoint> &points,
               const bool                       with_deviation = true)
  {
    folder.write("tribmu.h", c_header(law));
    folder.write("tribmu.c", c_source(law, with_deviation));
    folder.write("driver.c", c_driver);
    folder.write_points("points.txt", points);
    folder.run(compile_c);
    folder.run("./driver <points.txt >answers.txt");
    return folder.rows("answers.txt");
  }

  std::vector<std::vector<double>>
  answers_of_fortran(const Folder                    &folder,
                     const ContactPointLaw           &law,
                     const std::vector<ContactPoint> &points,
                     const bool                       with_deviation = true)
  {
    folder.write("tribmu.f", fortran_source(law, with_deviation));
    folder.write("driver.f", fortran_driver);
    folder.write_points("points.txt", points);
    folder.run(compile_fortran);
    folder.run("./driver <points.txt >answers.txt");
    return folder.rows("answers.txt");
  }

  void
  expect_same_answers(const ContactPointLaw                  &law,
                      const std::vector<ContactPoint>        &points,
                      const std::vector<std::vector<double>> &answers)
  {
    ASSERT_EQ(answers.size(), points.size());
    for (std::size_t j = 0; j < points.size(); ++j)
      {
        const ContactPoint        &x   = points[j];
        const LawPrediction        at  = law.predict(x);
        const std::vector<double> &row = answers[j];
        ASSERT_EQ(row.size(), 10u);
        SCOPED_TRACE("p = " + exact(x[0]) + ", v = " + exact(x[1]) +
                     ", T = " + exact(x[2]));
        EXPECT_NEAR(row[0], at.mean, accuracy(law.law(), x, at.mean));
        for (unsigned int c = 0; c < 3; ++c)
          EXPECT_NEAR(row[1 + c],
                      at.gradient[c],
                      1e-9 * (std::abs(at.gradient[c]) +
                              derivative_scale(at.mean, c)));
        EXPECT_EQ(row[4] != 0., law.is_inside(x));
        EXPECT_NEAR(row[5], at.deviation, 1e-10 * std::abs(at.mean));
        EXPECT_TRUE((row[6] != 0.) == at.trusted ||
                    is_borderline(law.law(), at));
        EXPECT_FALSE(row[6] != 0. && !is_in_box(x));
        EXPECT_NEAR(row[7], law.shear_limit(x[2]), 1e-14 * 6e8);
        EXPECT_NEAR(row[9],
                    std::min(at.mean * x[0], law.shear_limit(x[2])),
                    accuracy(law.law(), x, at.mean) * std::abs(x[0]) + 1e-6);
      }
  }

  /** Derivatives against central differences, which lie behind each point. */
  void
  expect_true_derivatives(const std::vector<std::vector<double>> &answers,
                          const ContactPoint                     &steps)
  {
    for (std::size_t j = 0; j < answers.size(); j += 7)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double difference =
            (answers[j + 1 + 2 * c][0] - answers[j + 2 + 2 * c][0]) /
            (2. * steps[c]);
          // The second derivatives of Matern 3/2 jump at training points.
          EXPECT_NEAR(answers[j][1 + c],
                      difference,
                      1e-4 * (std::abs(difference) +
                              derivative_scale(answers[j][0], c)));
        }
  }

  std::vector<ContactPoint>
  points_with_neighbours(const ContactPoint &steps)
  {
    std::vector<ContactPoint> result;
    for (std::size_t j = 0; j < 60; ++j)
      {
        const std::vector<double> u = evenly_spread_point(j + 500, 3);
        // a little beyond the box, too
        const ContactPoint x = {
          {2e8 + 1.2e9 * u[0], 0.2 + 3.5 * u[1], 250. + 1000. * u[2]}};
        result.push_back(x);
        for (unsigned int c = 0; c < 3; ++c)
          for (const double sign : {1., -1.})
            {
              result.push_back(x);
              result.back()[c] += sign * steps[c];
            }
      }
    return result;
  }

  const ContactPoint steps = {{1e4, 3e-5, 1e-2}};
} // namespace

TEST(ExportedC, agrees_with_the_law)
{
  if (!has_program("gcc"))
    GTEST_SKIP() << "gcc was not found";
  for (const LawKind &kind : law_kinds)
    {
      SCOPED_TRACE(kind.name());
      const Folder          folder;
      const ContactPointLaw law(train(kind));
      expect_same_answers(law, points(), answers_of_c(folder, law, points()));
      folder.write_points("points.txt", points_with_neighbours(steps));
      folder.run("./driver <points.txt >answers.txt");
      expect_true_derivatives(folder.rows("answers.txt"), steps);
    }
}

TEST(ExportedFortran, agrees_with_the_law)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  for (const LawKind &kind : law_kinds)
    {
      SCOPED_TRACE(kind.name());
      const Folder          folder;
      const ContactPointLaw law(train(kind));
      expect_same_answers(law,
                          points(),
                          answers_of_fortran(folder, law, points()));
      folder.write_points("points.txt", points_with_neighbours(steps));
      folder.run("./driver <points.txt >answers.txt");
      expect_true_derivatives(folder.rows("answers.txt"), steps);
    }
}

TEST(ExportedFortran, keeps_the_columns_and_continuation_lines_of_Fortran_77)
{
  const std::string text =
    fortran_source(ContactPointLaw(train(law_kinds[2])), true);
  std::istringstream in(text);
  unsigned int       continuations = 0;
  for (std::string line; std::getline(in, line);)
    {
      EXPECT_LE(line.size(), 72u) << line;
      if (line[0] == 'C')
        continue;
      EXPECT_EQ(line.find_first_not_of(" 0123456789"),
                line.find_first_not_of(" 0123456789", 5))
        << line;
      continuations = line[5] == '&' ? continuations + 1 : 0;
      EXPECT_LE(continuations, 19u) << line;
    }
}

TEST(ExportedSource, holds_the_wetting_at_the_value_given)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  LawKind kind;
  kind.has_wetting = true;
  const Folder          folder;
  const ContactPointLaw law(train(kind, 60), {{"Lubrication/Wetting", 0.35}});
  expect_same_answers(law, points(), answers_of_c(folder, law, points()));
  expect_same_answers(law, points(), answers_of_fortran(folder, law, points()));
  // and the wetting matters
  const ContactPointLaw wet(law.law(), {{"Wetting", 1.}});
  EXPECT_GT(law.mean(points()[0]), 1.1 * wet.mean(points()[0]));
}

TEST(ExportedSource, agrees_with_a_law_that_was_fitted_to_measurements)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  FrictionLawDescription description;
  description.inputs      = {{"Load/Velocity", "v", "m/min"}};
  description.shear_limit = {6e8, 1.3558, 293.15, 1773.15, 1., 1e4};
  std::vector<double> v, mu;
  for (unsigned int i = 0; i < 12; ++i)
    {
      v.push_back(0.08 * std::pow(3. / 0.08, i / 11.));
      mu.push_back(0.54 * std::pow(std::max(v[i], 0.77) / 0.77, -0.35) *
                   (1. + 0.02 * std::sin(5. * i)));
    }
  const ContactPointLaw law(
    FrictionLaw::fit_to_measurements(description, v, mu, {}));
  std::vector<ContactPoint> points;
  for (const double velocity :
       {-1., 0., 1e-9, 0.05, 0.08, 0.5, 0.77, 0.78, 2., 3., 50., 1e3, 1e4})
    points.push_back({{5e8, velocity, 500.}});
  points.push_back({{5e8, std::numeric_limits<double>::infinity(), 500.}});
  const Folder folder;
  for (const auto &answers : {answers_of_c(folder, law, points),
                              answers_of_fortran(folder, law, points)})
    {
      ASSERT_EQ(answers.size(), points.size());
      for (std::size_t j = 0; j < points.size(); ++j)
        {
          const LawPrediction at = law.predict(points[j]);
          SCOPED_TRACE("v = " + exact(points[j][1]));
          EXPECT_NEAR(answers[j][0], at.mean, 1e-13);
          EXPECT_NEAR(answers[j][2], at.gradient[1], 1e-12);
          EXPECT_EQ(answers[j][4] != 0., law.is_inside(points[j]));
          EXPECT_NEAR(answers[j][5], at.deviation, 1e-13);
          EXPECT_EQ(answers[j][6] != 0., at.trusted);
          EXPECT_GT(at.mean, 0.);
        }
    }
  EXPECT_GT(law.predict({{5e8, 3., 500.}}).deviation, 1e-3);
  const ContactPoint no_number = {
    {5e8, std::numeric_limits<double>::quiet_NaN(), 500.}};
  EXPECT_TRUE(std::isnan(law.predict(no_number).mean));
  EXPECT_TRUE(std::isnan(answers_of_c(folder, law, {no_number})[0][0]));
}

TEST(ExportedSource, without_the_factor_knows_the_box_only)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  const Folder                    folder;
  const std::vector<ContactPoint> all = points();
  const ContactPointLaw           law(train(law_kinds[2]));
  for (const auto &answers : {answers_of_c(folder, law, all, false),
                              answers_of_fortran(folder, law, all, false)})
    {
      ASSERT_EQ(answers.size(), all.size());
      for (std::size_t j = 0; j < answers.size(); ++j)
        {
          const double mean = law.mean(all[j]);
          EXPECT_NEAR(answers[j][0], mean, accuracy(law.law(), all[j], mean));
          EXPECT_EQ(answers[j][5], -1.);
          EXPECT_EQ(answers[j][6] != 0., law.is_inside(all[j]));
        }
    }
  EXPECT_NE(c_source(law, false).find("in the box only"), std::string::npos);
  EXPECT_NE(fortran_source(law, false).find("Written without the deviation"),
            std::string::npos);
}

TEST(ExportedSource, stays_finite_and_untrusted_at_absurd_points)
{
  if (!has_program("gcc"))
    GTEST_SKIP() << "gcc was not found";
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
      const auto   answers =
        answers_of_c(folder, ContactPointLaw(train(kind)), absurd);
      ASSERT_EQ(answers.size(), absurd.size());
      for (std::size_t j = 0; j < absurd.size(); ++j)
        {
          const bool is_number = j < absurd.size() - 3; // the last are nan
          for (unsigned int i = 0; i < 4; ++i)
            EXPECT_EQ(std::isfinite(answers[j][i]), is_number) << j << " " << i;
          EXPECT_EQ(answers[j][0] > 0., is_number);
          EXPECT_EQ(answers[j][4], 0.);
          EXPECT_EQ(answers[j][6], 0.);
        }
    }
}

TEST(ExportedSource, gives_no_shear_limit_if_it_is_unknown)
{
  if (!has_program("gcc"))
    GTEST_SKIP() << "gcc was not found";
  const FrictionLaw      known       = train(law_kinds[2]);
  FrictionLawDescription description = known.description();
  description.shear_limit            = ShearLimit();
  const ContactPointLaw law(
    FrictionLaw::train(description, known.data().x, known.data().y));
  const Folder folder;
  for (const std::vector<double> &row :
       answers_of_c(folder, law, {{{5e8, 1., 500.}}}))
    {
      EXPECT_TRUE(std::isinf(row[7]));
      EXPECT_DOUBLE_EQ(row[9], 5e8 * row[0]);
    }
}
