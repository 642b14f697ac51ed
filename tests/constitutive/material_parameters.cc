#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;

TEST(MaterialParameters, are_read_with_units)
{
  MaterialParameters       material;
  dealii::ParameterHandler handler;
  ParameterDeclarator      parameters(handler);
  material.declare(parameters);
  parameters.read_text("subsection Material\n"
                       "  set Law = Voce\n"
                       "  set Density = 7.85 g/cm^3\n"
                       "  set Young's modulus = 206.9 GPa\n"
                       "  set Poisson's ratio = 0.3\n"
                       "  subsection Voce\n"
                       "    set Yield stress = 450 MPa\n"
                       "  end\n"
                       "  subsection Johnson-Cook\n"
                       "    set Melting temperature = 1500 degC\n"
                       "  end\n"
                       "end\n",
                       "steel.prm");
  EXPECT_NEAR(material.elasticity.density, 7850., 1e-9);
  EXPECT_NEAR(material.elasticity.young_modulus, 206.9e9, 1e-3);
  EXPECT_NEAR(material.constants<VoceParameters>().yield_stress, 450e6, 1e-6);
  EXPECT_NEAR(material.constants<JohnsonCookParameters>().melting_temperature,
              1773.15,
              1e-9);
  const auto law = material.make_law();
  EXPECT_EQ(law->name(), "Voce");
  EXPECT_NEAR(law->density(), 7850., 1e-9);
  EXPECT_NEAR(law->poisson_ratio(), 0.3, 1e-15);
}



TEST(MaterialParameters, refuse_values_out_of_range)
{
  for (const std::string entry : {"set Density = -1 kg/m^3",
                                  "set Young's modulus = 0 GPa",
                                  "set Poisson's ratio = 0.5",
                                  "set Heat fraction = 2",
                                  "set Law = Johnson",
                                  "set Density = 3 MPa"})
    {
      MaterialParameters       material;
      dealii::ParameterHandler handler;
      ParameterDeclarator      parameters(handler);
      material.declare(parameters);
      EXPECT_THROW(parameters.read_text("subsection Material\n" + entry +
                                          "\nend\n",
                                        "steel.prm"),
                   InputError)
        << entry;
    }
}
