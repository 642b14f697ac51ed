#include <asperity/base/errors.h>
#include <asperity/coupling/coupling_warnings.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

using namespace asperity;

TEST(CouplingParameters, are_read_with_units)
{
  CouplingParameters       coupling;
  dealii::ParameterHandler handler;
  ParameterDeclarator      parameters(handler);
  coupling.declare(parameters);
  EXPECT_EQ(parameters.get("Coupling/Robin coefficient"), "automatic");
  parameters.read_text("subsection Coupling\n"
                       "  set Scheme = Dirichlet-Neumann\n"
                       "  set Robin coefficient = 2.5 MPa s/m\n"
                       "  set Acceleration = Aitken\n"
                       "  set Relaxation = 0.2\n"
                       "  set Displacement floor = 1 nm\n"
                       "end\n",
                       "coupling.prm");
  EXPECT_EQ(coupling.scheme, CouplingScheme::dirichlet_neumann);
  EXPECT_NEAR(*coupling.robin_coefficient, 2.5e6, 1e-6);
  EXPECT_EQ(coupling.acceleration.kind, AccelerationKind::aitken);
  EXPECT_NEAR(coupling.acceleration.relaxation, 0.2, 1e-15);
  EXPECT_NEAR(coupling.displacement_floor, 1e-9, 1e-18);
}



TEST(CouplingParameters, refuse_values_out_of_range)
{
  for (const std::string entry : {"set Robin coefficient = 0 Pa s/m",
                                  "set Relaxation = 0",
                                  "set Tolerance = -1",
                                  "set Acceleration = Newton"})
    {
      CouplingParameters       coupling;
      dealii::ParameterHandler handler;
      ParameterDeclarator      parameters(handler);
      coupling.declare(parameters);
      EXPECT_THROW(parameters.read_text("subsection Coupling\n" + entry +
                                          "\nend\n",
                                        "coupling.prm"),
                   InputError)
        << entry;
    }
}



TEST(CouplingParameters, warn_of_a_loose_tolerance)
{
  CouplingParameters coupling;
  EXPECT_EQ(loose_tolerance_warning(coupling), "");
  coupling.tolerance = 1e-4;
  EXPECT_EQ(loose_tolerance_warning(coupling), "");
  coupling.tolerance = 1e-3;
  EXPECT_EQ(loose_tolerance_warning(coupling).find(
              "With Coupling/Tolerance = 0.001 the iterations end so "
              "early"),
            0u)
    << loose_tolerance_warning(coupling);
}
