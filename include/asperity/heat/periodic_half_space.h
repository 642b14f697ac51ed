#ifndef asperity_heat_periodic_half_space_h
#define asperity_heat_periodic_half_space_h

#include <asperity/heat/fourier_basis.h>
#include <asperity/heat/thermal_properties.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * The temperature rise at the surface of a half-space in dim dimensions,
   * periodic along it, under a flux that is constant in each time step. In the
   * Fourier function f_m of wave number kappa, which counts both directions of
   * a face, a flux of one that is switched on at t = 0 gives the rise
   *
   *   S(t) = erf(kappa sqrt(a t))/(lambda kappa),
   *   S(t) = 2 sqrt(t/(pi lambda rho c))  for kappa = 0
   *
   * (H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 1959, sections
   * 2.9 and 10.4). The heat of the present step acts through S itself. That of
   * earlier ones acts through the kernel
   * dS/dt = exp(-kappa^2 a t)/sqrt(pi lambda rho c t), in which
   *
   *   1/sqrt(pi t) = 2/pi int exp(x - t exp(2 x)) dx
   *
   * is summed by the trapezoidal rule: a sum of exponentials, whose integrals
   * over the past go on from step to step. So a step costs the same however
   * many there were, and the state has a fixed length. The relative error of
   * the kernel is below 1e-9 from `shortest_age` to `longest_age`; all else is
   * exact.
   *
   * Coefficients are those of FourierBasis.
   */
  template <int dim>
  class PeriodicHalfSpace
  {
  public:
    using Vector = dealii::Vector<double>;

    /** Ages of heat between which its effect is exact to 1e-9 [s]. */
    static constexpr double shortest_age = 1e-15, longest_age = 1e2;

    /** Cold, i.e. without rise. */
    PeriodicHalfSpace(const ThermalProperties &material,
                      const FourierBasis<dim> &basis);

    const FourierBasis<dim> &
    basis() const;

    /** S at the end of a step of length dt [s], for each function: rise per
     *  flux in this step [K m^2/W]. */
    Vector
    response(const double dt) const;

    /** Rise at the end of a step of length dt without flux in it [K]. */
    Vector
    remembered(const double dt) const;

    /** A step of length dt with this flux is over.
     *  @param flux into the half-space, coefficients [W/m^2] */
    void
    accept(const Vector &flux, const double dt);

    /** Heat that has gone into one period [J/m^(3 - dim)]. */
    double
    heat() const;

    void
    save(OutputArchive &archive) const;

    /** @throws InputError if the archive has another number of functions */
    void
    load(InputArchive &archive);

  private:
    /** a kappa^2 of a function [1/s], at which all of its terms decay beside
     *  their own rates. */
    double
    wave_rate(const unsigned int m) const;

    ThermalProperties material;
    FourierBasis<dim> basis_;

    /** Of the exponentials whose sum is 1/sqrt(pi lambda rho c t): rates [1/s]
     *  and weights [K m^2/J]. */
    std::vector<double> rates, weights;

    /** [m * rates.size() + j]: integral over the past of the
     *  flux times exp(-(rate + a kappa^2) age) [J/m^2]. */
    std::vector<double> past;
    double              heat_ = 0.;
  };
} // namespace asperity

#endif
