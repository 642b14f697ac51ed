#include <asperity/constitutive/hyperelasticity.h>

#include <cmath>

namespace asperity
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
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



  HyperelasticLaw::HyperelasticLaw(const ElasticParameters &elasticity)
    : MaterialLaw(elasticity)
    , lambda(elasticity.lame_lambda())
    , mu(elasticity.shear_modulus())
  {}



  void
  HyperelasticLaw::evaluate(const Tensor<2, 3>  &F,
                            const MaterialState &old,
                            const double,
                            const bool        with_tangent,
                            MaterialResponse &response) const
  {
    // In plane kinematics the plane must not be turned over either.
    const double J = F[2][2] > 0. ? determinant(F) : 0.;
    respond_if_regular(F, J, old, with_tangent, response);
  }



  void
  HyperelasticLaw::evaluate_general(const unsigned int   n_points,
                                    const Tensor<2, 3>  *F,
                                    const MaterialState *old,
                                    const double,
                                    const bool        with_tangent,
                                    MaterialResponse *responses) const
  {
    for (unsigned int q = 0; q < n_points; ++q)
      respond_if_regular(
        F[q], determinant(F[q]), old[q], with_tangent, responses[q]);
  }



  void
  HyperelasticLaw::respond_if_regular(const Tensor<2, 3>  &F,
                                      const double         J,
                                      const MaterialState &old,
                                      const bool           with_tangent,
                                      MaterialResponse    &response) const
  {
    const bool regular = J > 0. && std::isfinite(J);
    response.state     = old;
    response.plastic   = false;
    response.status    = regular ? LawStatus::ok : LawStatus::inverted;
    if (regular)
      respond(F, J, with_tangent, response);
  }



  StVenantKirchhoff::StVenantKirchhoff(const ElasticParameters &elasticity)
    : HyperelasticLaw(elasticity)
  {}



  void
  StVenantKirchhoff::respond(const Tensor<2, 3> &F,
                             const double,
                             const bool        with_tangent,
                             MaterialResponse &response) const
  {
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
    : HyperelasticLaw(elasticity)
  {}



  void
  NeoHooke::respond(const Tensor<2, 3> &F,
                    const double        J,
                    const bool          with_tangent,
                    MaterialResponse   &response) const
  {
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
