#include <asperity/law_export/solver_templates.h>

#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// The user subroutines are called as the chip-formation programs document it,
// in MPa, mm/s and degC; only the files that these programs include are ours.

namespace
{
  const char *const fric_coef_driver = R"(
      program driver
      implicit none
      double precision fCoef(2,2), fDeriv(2,20,2), props(1), slip(2,6)
      double precision press(2), temp(2), field(2,1), rData(20)
      integer iData(6)
      character*80 name
      name = ' '
      iData = 0
      rData = 0
      props = 0
      field = 0
   10 read(*,*,end=20) press(1), slip(1,1), temp(1)
      press(2) = press(1)
      slip(2,:) = slip(1,1)
      slip(1,2:) = 0
      temp(2) = temp(1)
      fCoef = 0
      fDeriv = 0
      call fric_coef(fCoef, fDeriv, 2, 1, 1, 1, iData, rData, name, name,
     &  name, props, slip, press, temp, field)
      if (fCoef(2,1).ne.fCoef(1,1)) stop 1
      write(*,'(1P,4E26.17E3)') fCoef(1,1), fDeriv(1,2,1),
     &  fDeriv(1,1,1), fDeriv(1,3,1)
      goto 10
   20 end
)";

  // A contact point with an area of 0.5 mm^2 in a time step of 1e-6 s that
  // slides in two directions; the master surface is 20 degC warmer.
  const char *const vfriction_driver = R"(
      program driver
      include 'vaba_param.inc'
      dimension fT(2,1), state(1,1,1), props(1), dSlip(3,1), stick(1)
      dimension prev(3,1), fN(1), area(1), dN(3,1), dS(3,1), sS(1,1)
      dimension sM(1,1), cS(3,1,1), cM(3,1,1), vS(3,1,1), vM(3,1,1)
      dimension tS(1), tM(1), fS(1,1), fM(1,1), rData(4)
      integer jFlags(3), jS(1,1), jM(1,1)
      double precision P, V, T, xStick
      character*80 name
      name = ' '
      jFlags = 1
      jS = 1
      jM = 1
      rData = 1e-6
   10 read(*,*,end=20) P, V, T
      fN(1) = P*0.5d0
      area(1) = 0.5
      dSlip(1,1) = V*0.6d-6
      dSlip(2,1) = V*0.8d-6
      dSlip(3,1) = 0
      tS(1) = T - 10
      tM(1) = T + 10
      do 15 i = 1, 2
        xStick = 1d9
        if (i.eq.2) xStick = 1d-3
        stick(1) = xStick
        call vfriction(fT, state, 1, 1, 1, 1, 1, 1, 2, 3, 1, 1, 1, 1,
     &    jFlags, rData, name, name, name, jS, jM, props, dSlip, stick,
     &    prev, fN, area, dN, dS, sS, sM, cS, cM, vS, vM, tS, tM, fS, fM)
        write(*,'(1P,2E26.17E3)') fT(1,1), fT(2,1)
   15 continue
      goto 10
   20 end
)";

  const char *const usrbcc_driver = R"(
      PROGRAM DRIVER
      IMPLICIT REAL*8 (A-H,O-Z), INTEGER*4 (I-N)
      DIMENSION NBCD(2,2),RZ(2,2),DRZ(2,2),USRNOD(1,1),TEMO(2),TEMC(2)
      COMMON /UFHCOM/ TMPENV,TMPSLF,SLDVEL,PRESS
   10 READ(*,*,END=20) PRESS,SLDVEL,TMPENV
      TMPSLF=TMPENV+30
      TMPENV=TMPENV-30
      CALL USRBCC(X,1,1,1,NBCD,1,RZ,DRZ,USRNOD,1,ENVTEM,TEMO,TEMC,
     &  0D0,1,1,2,2)
      CALL USRBCC(Y,1,1,1,NBCD,1,RZ,DRZ,USRNOD,1,ENVTEM,TEMO,TEMC,
     &  0D0,1,2,2,2)
      WRITE(*,'(1P,2E26.17E3)') X,Y
      GOTO 10
   20 END
)";

  const std::string compiler =
    "gfortran -std=legacy -ffixed-form -ffixed-line-length-72 -O1 -Wall "
    "-Wno-unused-dummy-argument -Wno-unused-parameter "
    "-Wno-maybe-uninitialized -Wno-conversion -Werror ";
  const std::string compile_test_driver =
    "gfortran -std=legacy -ffixed-form -ffixed-line-length-132 -O1 -c "
    "driver.f";

  /** Some points in MPa, mm/s and degC, and the same in SI; sliding, and
   *  sticking at pressures beyond the box. */
  struct Points
  {
    Points()
    {
      for (std::size_t j = 0; j < 100; ++j)
        {
          const std::vector<double> u = evenly_spread_point(j, 3);
          solver.push_back(
            {{100. + 6000. * u[0], 100. + 4000. * u[1], 20. + 1300. * u[2]}});
          const ContactPoint &x = solver.back();
          si.push_back({{1e6 * x[0], 1e-3 * x[1], x[2] + 273.15}});
        }
    }

    std::vector<ContactPoint> solver, si;
  };

  double
  effective_mu(const ContactPointLaw &law, const ContactPoint &x)
  {
    return std::min(law.mean(x), law.shear_limit(x[2]) / x[0]);
  }

  std::vector<std::vector<double>>
  answers(const Folder      &folder,
          const Points      &points,
          const std::string &routine,
          const std::string &driver,
          const std::string &implicit)
  {
    folder.write("routine.f", routine);
    folder.write("driver.f", driver);
    for (const std::string file : {"aba_param.inc", "vaba_param.inc"})
      folder.write(file, "      implicit " + implicit + "(a-h,o-z)\n");
    folder.write_points("points.txt", points.solver);
    folder.run(compiler + "-c routine.f");
    folder.run(compile_test_driver);
    folder.run("gfortran -o driver driver.o routine.o");
    folder.run("./driver <points.txt >answers.txt");
    return folder.rows("answers.txt");
  }
} // namespace

TEST(SolverTemplates, abaqus_fric_coef_limits_mu_and_knows_its_derivatives)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  const Folder          folder;
  const Points          points;
  const ContactPointLaw law(train(law_kinds[2]));
  const std::string     routine = abaqus_fric_coef(law);
  EXPECT_LT(routine.find("NOT RUN IN THAT PROGRAM"), 200u);
  const auto rows =
    answers(folder, points, routine, fric_coef_driver, "real*8");
  ASSERT_EQ(rows.size(), points.si.size());
  unsigned int       n_sticking = 0;
  const ContactPoint step       = {{1e4, 1e-5, 1e-2}};
  const ContactPoint factor     = {{1e6, 1e-3, 1.}};
  for (std::size_t j = 0; j < rows.size(); ++j)
    {
      const ContactPoint &x  = points.si[j];
      const double        mu = effective_mu(law, x);
      n_sticking += mu < law.mean(x) ? 1 : 0;
      EXPECT_NEAR(rows[j][0], mu, accuracy(law.law(), points.si[j], mu));
      for (unsigned int c = 0; c < 3; ++c)
        {
          ContactPoint before = x, behind = x;
          before[c] -= step[c];
          behind[c] += step[c];
          const double difference =
            (effective_mu(law, behind) - effective_mu(law, before)) /
            (2. * step[c]);
          EXPECT_NEAR(rows[j][1 + c],
                      difference * factor[c],
                      1e-5 * (std::abs(difference) + derivative_scale(mu, c)) *
                        factor[c])
            << j << ", " << c;
        }
    }
  EXPECT_GT(n_sticking, 10u);
  EXPECT_LT(n_sticking, 90u);
}

TEST(SolverTemplates, abaqus_vfriction_gives_the_force)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  const Points          points;
  const ContactPointLaw law(train(law_kinds[2]));
  const std::string     routine = abaqus_vfriction(law);
  EXPECT_LT(routine.find("NOT RUN IN THAT PROGRAM"), 200u);
  for (const std::string implicit : {"real*8", "real*4"})
    {
      const Folder folder;
      const double accuracy = implicit == "real*8" ? 1e-7 : 1e-5;
      const auto   rows =
        answers(folder, points, routine, vfriction_driver, implicit);
      ASSERT_EQ(rows.size(), 2 * points.si.size());
      for (std::size_t j = 0; j < points.si.size(); ++j)
        {
          const double force =
            effective_mu(law, points.si[j]) * 0.5 * points.solver[j][0];
          // 1e-6 s has been rounded to single precision in both
          EXPECT_NEAR(rows[2 * j][0], -force, accuracy * force);
          EXPECT_EQ(rows[2 * j][1], 0.);
          EXPECT_NEAR(rows[2 * j + 1][0], -1e-3, 1e-9)
            << "no more than the force that makes it stick";
        }
    }
}

TEST(SolverTemplates, deform_usrbcc_gives_the_coefficient)
{
  if (!has_program("gfortran"))
    GTEST_SKIP() << "gfortran was not found";
  const Folder          folder;
  const Points          points;
  const ContactPointLaw law(train(law_kinds[2]));
  const std::string     routine = deform_usr_bcc(law);
  EXPECT_LT(routine.find("NOT RUN IN THAT PROGRAM"), 200u);
  const auto rows = answers(folder, points, routine, usrbcc_driver, "real*8");
  ASSERT_EQ(rows.size(), points.si.size());
  for (std::size_t j = 0; j < rows.size(); ++j)
    {
      const double mu = effective_mu(law, points.si[j]);
      EXPECT_NEAR(rows[j][0], mu, accuracy(law.law(), points.si[j], mu));
      EXPECT_EQ(rows[j][1], 0.) << "nothing but friction is its matter";
    }
}
