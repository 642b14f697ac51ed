#include <asperity/law_export/generated_source.h>

#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// The templates of the exported sources compile as they stand and compute with
// their sample, three runs over pressure and a further input.

namespace
{
  const std::string templates =
    std::string(ASPERITY_SOURCE_DIR) + "/source/law_export/templates/";
  const std::string kernels =
    std::string(ASPERITY_SOURCE_DIR) + "/source/surrogate";

  const char *const c_driver = R"(
#include "tribmu.h"
#include <stdio.h>
int main(void)
{
  const double w = 0.5;
  double d[4], dk;
  int inside, trusted;
  const double mu = tribmu_at(6e8, 1., 500., &w, d, &inside);
  const double sigma = tribmu_sigma(6e8, 1., 500., &trusted);
  const double k = tribmu_k(500., &dk);
  printf("%.17g %.17g %.17g %.17g %.17g %d %.17g %d %.17g %.17g %.17g\n", mu,
         d[0], d[1], d[2], d[3], inside, sigma, trusted, k, dk,
         tribmu_tau(6e8, 1., 500.));
  return 0;
}
)";

  const char *const fortran_driver = R"(
      PROGRAM DRIVER
      IMPLICIT NONE
      INTEGER INSIDE,ITRUST
      DOUBLE PRECISION XMU,D(4),SIGMA,WORK(3),XK,DXK,TRIBTA,Q(1)
      Q(1)=0.5D0
      CALL TRIBMX(6D8,1D0,500D0,Q,XMU,D,INSIDE)
      CALL TRIBSD(6D8,1D0,500D0,XMU,SIGMA,ITRUST,WORK)
      CALL TRIBK(500D0,XK,DXK)
      WRITE(*,'(1P,5E26.17E3,I3,E26.17E3,I3,3E26.17E3)') XMU,D,INSIDE,
     &  SIGMA,ITRUST,XK,DXK,TRIBTA(6D8,1D0,500D0)
      END
)";

  /** mu of the sample, from its numbers: points over length scales, weights,
   *  and Matern 3/2. */
  double
  sample_mu(const double p, const double w)
  {
    const double points[3][2] = {{0., 0.}, {1., 0.25}, {2., 0.5}};
    const double weights[3]   = {0.5, -0.25, 0.125};
    double       m            = 0.375;
    for (unsigned int j = 0; j < 3; ++j)
      {
        const double a =
          std::sqrt(3.) * std::hypot(points[j][0] - (p - 3e8) / 1e9 / 0.5,
                                     points[j][1] - w / 2.);
        m += weights[j] * ((1. + a) * std::exp(-a) - 1.);
      }
    return std::exp(-2. + 0.25 * m);
  }

  void
  expect_sample(const std::vector<double> &row)
  {
    ASSERT_EQ(row.size(), 11u);
    const double mu = sample_mu(6e8, 0.5);
    EXPECT_NEAR(row[0], mu, 1e-14);
    const double by_p =
                   (sample_mu(6.001e8, 0.5) - sample_mu(5.999e8, 0.5)) / 2e5,
                 by_w =
                   (sample_mu(6e8, 0.5001) - sample_mu(6e8, 0.4999)) / 2e-4;
    EXPECT_NEAR(row[1], by_p, 1e-6 * std::abs(by_p));
    EXPECT_EQ(row[2], 0.);
    EXPECT_EQ(row[3], 0.);
    EXPECT_NEAR(row[4], by_w, 1e-6 * std::abs(by_w));
    EXPECT_EQ(row[5], 1.);
    EXPECT_EQ(row[7], 1.);
    const double k = 6e8 * (1. - (500. - 293.15) / 1480.);
    EXPECT_NEAR(row[8], k, 1e-6);
    EXPECT_NEAR(row[9], -6e8 / 1480., 1e-6);
    EXPECT_NEAR(row[10], mu * 6e8, 1e-5);
  }
} // namespace

TEST(Templates, c_compiles_and_computes_as_it_stands)
{
  if (!has_program("gcc"))
    GTEST_SKIP() << "gcc was not found";
  const Folder folder;
  folder.write("driver.c", c_driver);
  folder.run("gcc -std=c99 -pedantic -Wall -Wextra -Werror -O1 -I'" +
             templates + "' -I'" + kernels + "' -o driver driver.c '" +
             templates + "tribmu.c' -lm && ./driver >answers.txt");
  expect_sample(folder.rows("answers.txt").at(0));
}

TEST(Templates, fortran_compiles_and_computes_as_it_stands)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  const Folder folder;
  folder.write("driver.f", fortran_driver);
  folder.run("gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -Wall "
             "-Wextra -Werror -O1 -c '" +
             templates + "tribmu.f' '" + templates +
             "gaussian_process.f' && gfortran -o driver tribmu.o "
             "gaussian_process.o driver.f && ./driver >answers.txt");
  expect_sample(folder.rows("answers.txt").at(0));
}

TEST(Templates, user_subroutines_compile_as_they_stand)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  const Folder folder;
  folder.write("aba_param.inc", "      implicit real*8(a-h,o-z)\n");
  folder.write("vaba_param.inc", "      implicit real*8(a-h,o-z)\n");
  for (const std::string name : {"tribef",
                                 "abaqus_fric_coef",
                                 "abaqus_vfriction",
                                 "deform_usr_bcc",
                                 "piecewise_power_law"})
    {
      folder.run("gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -O1 "
                 "-Wall -Wno-unused-dummy-argument -Werror -I. -c '" +
                 templates + name + ".f'");
      EXPECT_TRUE(std::filesystem::exists(folder.path / (name + ".o")));
    }
}

// Drivers of a law with one input beside p, v and T: they read points and print
// mu, its four derivatives, inside, deviation and trusted.
namespace
{
  const char *const further_c_driver = R"(
#include "tribmu.h"
#include <stdio.h>
int main(void)
{
  double p, v, T, w, d[4];
  int inside, trusted;
  while (scanf("%lf %lf %lf %lf", &p, &v, &T, &w) == 4)
    {
      const double mu = tribmu_at(p, v, T, &w, d, &inside);
      const double sigma = tribmu_sigma_at(p, v, T, &w, &trusted);
      printf("%.17g %.17g %.17g %.17g %.17g %d %.17g %d\n", mu, d[0], d[1],
             d[2], d[3], inside, sigma, trusted);
    }
  return 0;
}
)";

  const char *const further_fortran_driver = R"(
      PROGRAM DRIVER
      IMPLICIT NONE
      INTEGER I,J
      DOUBLE PRECISION P,V,T,Q(1),XMU,D(4),SIGMA,WORK(100)
   10 READ(*,*,END=20) P,V,T,Q(1)
      CALL TRIBMX(P,V,T,Q,XMU,D,I)
      CALL TRIBSX(P,V,T,Q,XMU,SIGMA,J,WORK)
      WRITE(*,'(1P,5E26.17E3,I3,E26.17E3,I3)') XMU,D,I,SIGMA,J
      GOTO 10
   20 END
)";

  /** Points p, v, T and a further input, which goes a little beyond its range.
   */
  std::vector<std::vector<double>>
  points_with_further(const std::size_t n)
  {
    std::vector<std::vector<double>> points;
    for (std::size_t j = 0; j < n; ++j)
      {
        const std::vector<double> u = evenly_spread_point(j + 300, 4);
        points.push_back({3e8 + 1e9 * u[0],
                          0.375 + (10. / 3. - 0.375) * u[1],
                          298.15 + 875. * u[2],
                          1.2 * u[3]});
      }
    return points;
  }

  /** A row of a driver, p, v, T and the further input, against the law.
   *  @param order where the law has each of them */
  void
  expect_answer(const std::vector<double>         &row,
                const std::vector<double>         &point,
                const FrictionLaw                 &law,
                const std::array<unsigned int, 4> &order)
  {
    std::vector<double> x(4);
    for (unsigned int c = 0; c < 4; ++c)
      x[order[c]] = point[c];
    const LawPrediction at = law.predict(x.data());
    EXPECT_NEAR(row[0], at.mean, 1e-11 * at.mean);
    std::array<double, 4> gradient;
    for (unsigned int c = 0; c < 4; ++c)
      gradient[c] = at.gradient[order[c]];
    for (unsigned int c = 0; c < 4; ++c)
      {
        const double scale = c < 3 ? derivative_scale(at.mean, c) : at.mean;
        EXPECT_NEAR(row[1 + c],
                    gradient[c],
                    1e-9 * (std::abs(gradient[c]) + scale));
      }
    EXPECT_EQ(row[5] == 1., law.is_inside(x.data()));
    EXPECT_NEAR(row[6], at.deviation, 1e-10 * at.mean);
  }
  void
  expect_answers(const LawKind                     &kind,
                 const std::string                 &further,
                 const std::array<unsigned int, 4> &order)
  {
    const FrictionLaw     law = train(kind, 60);
    const Folder          folder;
    const ContactPointLaw stated(law, {{further, 0.35}});
    folder.write("tribmu.h", c_header(stated));
    folder.write("tribmu.c", c_source(stated, true));
    folder.write("tribmu.f", fortran_source(stated, true));
    folder.write("driver.c", further_c_driver);
    folder.write("driver.f", further_fortran_driver);
    const auto  points = points_with_further(50);
    std::string text;
    for (const auto &point : points)
      {
        for (const double x : point)
          text += exact(x) + " ";
        text += "\n";
      }
    folder.write("points.txt", text);
    for (
      const std::string compile :
      {"gcc -std=c99 -pedantic -Wall -Wextra -Werror -O1 -o driver driver.c "
       "tribmu.c -lm",
       "gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -Wall -Wextra "
       "-Werror -O1 -c tribmu.f && gfortran -o driver tribmu.o driver.f"})
      {
        folder.run(compile);
        folder.run("./driver <points.txt >answers.txt");
        const auto rows = folder.rows("answers.txt");
        ASSERT_EQ(rows.size(), points.size());
        for (std::size_t j = 0; j < points.size(); ++j)
          expect_answer(rows[j], points[j], law, order);
      }
  }
} // namespace

TEST(ExportedSource, takes_further_inputs_as_arguments)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  LawKind kind;
  kind.has_wetting = true; // behind the pressure
  expect_answers(kind, "Wetting", {{0, 2, 3, 1}});
}

TEST(ExportedSource, sees_the_pressure_over_the_strength_of_a_strained_chip)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  LawKind kind;
  kind.over_k = kind.has_strain = true;
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    {
      kind.p_scale = scale;
      expect_answers(kind, "Plasticstrain", {{0, 1, 2, 3}});
    }
}

// What a law's file may say must not become code.
TEST(ExportedSource, texts_of_the_law_stay_comments)
{
  if (!has_program("gcc") || !has_program("gfortran"))
    GTEST_SKIP() << "gcc or gfortran was not found";
  const FrictionLaw      plain       = train(law_kinds[2]);
  FrictionLawDescription description = plain.description();
  description.provenance["x\n      SUBROUTINE UEXDB\n      CALL ABORT\nC"] =
    "y";
  description.provenance["*/ int abort_(void); /*"]   = "*/ #error";
  description.provenance["*?\?/\n/ int trigraph; /*"] = "\r\n#error\r*CARD\n";
  description.provenance["long"] = std::string(100000, 'x');
  for (unsigned int i = 0; i < 1000; ++i)
    description.provenance["key " + std::to_string(i)] = i;
  const ContactPointLaw law(
    FrictionLaw::train(description, plain.data().x, plain.data().y));
  const Folder folder;
  folder.write("tribmu.h", c_header(law));
  folder.write("tribmu.c", c_source(law, false));
  folder.write("tribmu.f", fortran_source(law, false));
  folder.run("gcc -std=c99 -trigraphs -pedantic -Wall -Wextra -Werror -c "
             "tribmu.c && ! nm tribmu.o | grep -E 'abort|trigraph'");
  folder.run("gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -Wall "
             "-Wextra -Werror -c tribmu.f -o f.o && ! nm f.o | grep -i uexdb");
  for (const char *const name : {"tribmu.h", "tribmu.c", "tribmu.f"})
    EXPECT_LT(folder.read(name).size(), 60000u) << name;
}
