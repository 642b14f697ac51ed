#include <asperity/base/archive.h>
#include <asperity/heat/periodic_half_space.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <numeric>

namespace asperity
{
  using dealii::numbers::PI;
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Spacing of the trapezoidal rule. Its relative error is that of the
     *  first wave that it does not see,
     *  2 |Gamma(1/2 + i pi/h)|/Gamma(1/2) = sqrt(8) exp(-pi^2/(2 h)) = 5e-10.
     */
    constexpr double spacing = 0.22;

    /** Of rate times age: larger products count as none, exp(-25) = 1e-11. */
    constexpr double largest_exponent = 25.;

    /** Of rate times age: terms below are taken together as one that does not
     *  decay, with the error of the cube of the root. */
    constexpr double smallest_exponent = 1e-6;
  } // namespace



  template <int dim>
  PeriodicHalfSpace<dim>::PeriodicHalfSpace(const ThermalProperties &material,
                                            const FourierBasis<dim> &basis)
    : material(material)
    , basis_(basis)
  {
    const double slowest = std::sqrt(smallest_exponent / longest_age),
                 fastest = std::sqrt(largest_exponent / shortest_age);
    const unsigned int n = std::ceil(std::log(fastest / slowest) / spacing) + 1;
    const double       factor = 2. / PI * spacing / material.effusivity();
    // The geometric series of all slower terms.
    rates.push_back(0.);
    weights.push_back(factor * slowest / std::expm1(spacing));
    for (unsigned int j = 0; j < n; ++j)
      {
        const double root = slowest * std::exp(j * spacing);
        rates.push_back(root * root);
        weights.push_back(factor * root);
      }
    past.assign(basis_.size() * rates.size(), 0.);
  }



  template <int dim>
  const FourierBasis<dim> &
  PeriodicHalfSpace<dim>::basis() const
  {
    return basis_;
  }



  template <int dim>
  Vector
  PeriodicHalfSpace<dim>::response(const double dt) const
  {
    Vector S(basis_.size());
    S(0) = 2. * std::sqrt(dt / PI) / material.effusivity();
    for (unsigned int m = 1; m < S.size(); ++m)
      {
        const double kappa = basis_.wave_number(m);
        S(m) = std::erf(kappa * std::sqrt(material.diffusivity() * dt)) /
               (material.conductivity * kappa);
      }
    return S;
  }



  template <int dim>
  double
  PeriodicHalfSpace<dim>::wave_rate(const unsigned int m) const
  {
    const double kappa = basis_.wave_number(m);
    return material.diffusivity() * kappa * kappa;
  }



  template <int dim>
  Vector
  PeriodicHalfSpace<dim>::remembered(const double dt) const
  {
    std::vector<double> factors(weights);
    for (unsigned int j = 0; j < factors.size(); ++j)
      factors[j] *= std::exp(-rates[j] * dt);
    Vector rise(basis_.size());
    for (unsigned int m = 0; m < rise.size(); ++m)
      {
        const double *integrals = past.data() + m * factors.size();
        rise(m) =
          std::exp(-wave_rate(m) * dt) *
          std::inner_product(factors.begin(), factors.end(), integrals, 0.);
      }
    return rise;
  }



  template <int dim>
  void
  PeriodicHalfSpace<dim>::accept(const Vector &flux, const double dt)
  {
    const unsigned int  n = rates.size();
    std::vector<double> change(n);
    for (unsigned int j = 0; j < n; ++j)
      change[j] = std::expm1(-rates[j] * dt);
    for (unsigned int m = 0; m < basis_.size(); ++m)
      {
        const double r           = wave_rate(m);
        const double wave_change = std::expm1(-r * dt);
        double      *integrals   = past.data() + m * n;
        for (unsigned int j = 0; j < n; ++j)
          {
            // exp(-(r_j + r) dt) - 1, without cancellation; int exp = -that
            // over the rate.
            const double both =
              change[j] + wave_change + change[j] * wave_change;
            const double rate = rates[j] + r;
            integrals[j] +=
              both * integrals[j] + flux(m) * (rate > 0. ? -both / rate : dt);
          }
      }
    heat_ += flux(0) * dt * basis_.area();
  }



  template <int dim>
  double
  PeriodicHalfSpace<dim>::heat() const
  {
    return heat_;
  }



  template <int dim>
  void
  PeriodicHalfSpace<dim>::save(OutputArchive &archive) const
  {
    archive << past << heat_;
  }



  template <int dim>
  void
  PeriodicHalfSpace<dim>::load(InputArchive &archive)
  {
    archive >> fixed_length(past, "heat in a half-space") >> heat_;
  }



  template class PeriodicHalfSpace<2>;
  template class PeriodicHalfSpace<3>;
} // namespace asperity
