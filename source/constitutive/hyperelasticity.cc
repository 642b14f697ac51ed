#include <asperity/constitutive/hyperelasticity.h>

#include <cmath>

namespace asperity
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    /** det F, or 0 if it is not positive and finite or F33 is not positive. */
    double
    positive_determinant(const Tensor<2, 3> &F)
    {
      const double J = determinant(F);
      return (J > 0. && F[2][2] > 0. && std::isfinite(J)) ? J : 0.;
    }



    /** sqrt(3/2) |dev(P F^T)|. */
    double
    mises_kirchhoff(const Tensor<2, 3> &P, const Tensor<2, 3> &F)
    {
      const SymmetricTensor<2, 3> tau = symmetrize(P * transpose(F));
      return std::sqrt(1.5) * deviator(tau).norm();
    }



    /** Calls entry(i, J, k, L) for each component of dP_iJ/dF_kL. */
    template <class Entry>
    void
    fill(Tensor<4, 3> &tangent, const Entry &entry)
    {
      for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
          for (int k = 0; k < 3; ++k)
            for (int L = 0; L < 3; ++L)
              tangent[i][J][k][L] = entry(i, J, k, L);
    }
  } // namespace



  StVenantKirchhoff::StVenantKirchhoff(const ElasticParameters &elasticity)
    : MaterialLaw(elasticity)
    , lambda(elasticity.lame_lambda())
    , mu(elasticity.shear_modulus())
  {}



  void
  StVenantKirchhoff::evaluate(const Tensor<2, 3>  &F,
                              const MaterialState &old,
                              const double,
                              const bool        with_tangent,
                              MaterialResponse &response) const
  {
    response.state   = old;
    response.plastic = false;
    response.status =
      positive_determinant(F) > 0. ? LawStatus::ok : LawStatus::inverted;
    if (response.status != LawStatus::ok)
      return;

    const Tensor<2, 3> I = dealii::unit_symmetric_tensor<3>();
    const Tensor<2, 3> E = 0.5 * (transpose(F) * F - I);
    const Tensor<2, 3> S = lambda * trace(E) * I + 2. * mu * E;
    response.P           = F * S;
    response.mises       = mises_kirchhoff(response.P, F);

    const Tensor<2, 3> b = F * transpose(F);
    if (with_tangent)
      fill(response.tangent,
           [&](const int i, const int J, const int k, const int L) {
             return I[i][k] * S[J][L] + lambda * F[i][J] * F[k][L] +
                    mu * (F[i][L] * F[k][J] + b[i][k] * I[J][L]);
           });
  }



  std::string
  StVenantKirchhoff::name() const
  {
    return StVenantKirchhoffParameters::name;
  }



  std::unique_ptr<MaterialLaw>
  StVenantKirchhoffParameters::make_law(const ElasticParameters &elasticity,
                                        const HeatingParameters &) const
  {
    return std::make_unique<StVenantKirchhoff>(elasticity);
  }



  NeoHooke::NeoHooke(const ElasticParameters &elasticity)
    : MaterialLaw(elasticity)
    , lambda(elasticity.lame_lambda())
    , mu(elasticity.shear_modulus())
  {}



  void
  NeoHooke::evaluate(const Tensor<2, 3>  &F,
                     const MaterialState &old,
                     const double,
                     const bool        with_tangent,
                     MaterialResponse &response) const
  {
    const double J   = positive_determinant(F);
    response.state   = old;
    response.plastic = false;
    response.status  = J > 0. ? LawStatus::ok : LawStatus::inverted;
    if (response.status != LawStatus::ok)
      return;

    const Tensor<2, 3> I = dealii::unit_symmetric_tensor<3>();
    const Tensor<2, 3> G = transpose(invert(F));
    const double       a = lambda * std::log(J) - mu;
    response.P           = mu * F + a * G;
    response.mises       = mises_kirchhoff(response.P, F);

    if (with_tangent)
      fill(response.tangent,
           [&](const int i, const int J, const int k, const int L) {
             return mu * I[i][k] * I[J][L] + lambda * G[i][J] * G[k][L] -
                    a * G[i][L] * G[k][J];
           });
  }



  std::string
  NeoHooke::name() const
  {
    return NeoHookeParameters::name;
  }



  std::unique_ptr<MaterialLaw>
  NeoHookeParameters::make_law(const ElasticParameters &elasticity,
                               const HeatingParameters &) const
  {
    return std::make_unique<NeoHooke>(elasticity);
  }
} // namespace asperity
