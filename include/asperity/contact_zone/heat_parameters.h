#ifndef asperity_contact_zone_heat_parameters_h
#define asperity_contact_zone_heat_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/heat/thermal_properties.h>

#include <optional>
#include <string>

namespace asperity
{
  /** What becomes of the heat of a scene. */
  enum class HeatModel
  {
    automatic,  ///< conducting where the interface has a shear law
    isothermal, ///< temperatures stay
    adiabatic,  ///< plastic work heats the point where it is done
    conducting  ///< heat spreads in the chip and goes into the tool
  };

  /** As in parameter files. */
  std::string
  name(const HeatModel model);

  /** The subsection "Heat". Density and heat capacity of the chip are those of
   *  its material. */
  struct HeatParameters
  {
    HeatModel         model             = HeatModel::automatic;
    double            chip_conductivity = 45.; ///< [W/(m K)]
    ThermalProperties tool              = {88., 15250., 292.};

    /** Far away from the contact [K]; automatic: that of the chip. */
    std::optional<double> tool_temperature;

    double contact_conductance = 1e9;  ///< h where they touch [W/(m^2 K)]
    double oil_conductivity    = 0.14; ///< [W/(m K)]

    void
    declare(ParameterDeclarator &parameters);

    /** @param heats whether plastic work heats the chip, as its material says
     *  @throws InputError if the model and the material contradict each other
     */
    void
    check(const ParameterDeclarator &parameters, const bool heats) const;
  };
} // namespace asperity

#endif
