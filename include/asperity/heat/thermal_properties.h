#ifndef asperity_heat_thermal_properties_h
#define asperity_heat_thermal_properties_h

#include <cmath>

namespace asperity
{
  /** How a body conducts and stores heat, the same at all temperatures. */
  struct ThermalProperties
  {
    double conductivity;  ///< lambda [W/(m K)]
    double density;       ///< rho [kg/m^3]
    double heat_capacity; ///< c, specific [J/(kg K)]

    /** rho c [J/(m^3 K)] */
    double
    volumetric_capacity() const
    {
      return density * heat_capacity;
    }

    /** a = lambda/(rho c) [m^2/s] */
    double
    diffusivity() const
    {
      return conductivity / volumetric_capacity();
    }

    /** e = sqrt(lambda rho c) [W s^(1/2)/(m^2 K)]: of two bodies that touch,
     *  each takes the part of the frictional heat that its effusivity has of
     *  their sum. */
    double
    effusivity() const
    {
      return std::sqrt(conductivity * volumetric_capacity());
    }
  };
} // namespace asperity

#endif
