#include <asperity/constitutive/hyperelasticity.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    // Row and column in the 3x3 matrix of each component of a PlaneTensor.
    constexpr int row_of[5]    = {0, 0, 1, 1, 2};
    constexpr int column_of[5] = {0, 1, 0, 1, 2};



    /** det F, or 0 if it is not positive and finite or F33 is not positive. */
    double
    positive_determinant(const PlaneTensor &F)
    {
      const double J2 = F[0] * F[3] - F[1] * F[2];
      const double J  = J2 * F[4];
      return (J2 > 0. && F[4] > 0. && std::isfinite(J)) ? J : 0.;
    }



    /** sqrt(3/2) |dev(P F^T)|. */
    double
    mises_kirchhoff(const PlaneTensor &P, const PlaneTensor &F)
    {
      const double xx    = P[0] * F[0] + P[1] * F[1];
      const double yy    = P[2] * F[2] + P[3] * F[3];
      const double xy    = P[0] * F[2] + P[1] * F[3];
      const double zz    = P[4] * F[4];
      const double mean  = (xx + yy + zz) / 3.;
      const double norm2 = (xx - mean) * (xx - mean) +
                           (yy - mean) * (yy - mean) +
                           (zz - mean) * (zz - mean) + 2. * xy * xy;
      return std::sqrt(1.5 * norm2);
    }
  } // namespace



  StVenantKirchhoff::StVenantKirchhoff(const ElasticParameters &elasticity)
    : MaterialLaw(elasticity)
    , lambda(elasticity.lame_lambda())
    , mu(elasticity.shear_modulus())
  {}



  void
  StVenantKirchhoff::evaluate(const PlaneTensor   &F,
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

    const double E11        = 0.5 * (F[0] * F[0] + F[2] * F[2] - 1.);
    const double E22        = 0.5 * (F[1] * F[1] + F[3] * F[3] - 1.);
    const double E12        = 0.5 * (F[0] * F[1] + F[2] * F[3]);
    const double E33        = 0.5 * (F[4] * F[4] - 1.);
    const double volumetric = lambda * (E11 + E22 + E33);
    const double S[3][3]    = {{volumetric + 2. * mu * E11, 2. * mu * E12, 0.},
                               {2. * mu * E12, volumetric + 2. * mu * E22, 0.},
                               {0., 0., volumetric + 2. * mu * E33}};
    response.P              = {{F[0] * S[0][0] + F[1] * S[1][0],
                                F[0] * S[0][1] + F[1] * S[1][1],
                                F[2] * S[0][0] + F[3] * S[1][0],
                                F[2] * S[0][1] + F[3] * S[1][1],
                                F[4] * S[2][2]}};
    response.mises          = mises_kirchhoff(response.P, F);

    if (with_tangent)
      {
        // dP_iJ/dF_kL = delta_ik S_JL + lambda F_iJ F_kL
        //               + mu (F_iL F_kJ + (F F^T)_ik delta_JL)
        const double f[3][3] = {{F[0], F[1], 0.},
                                {F[2], F[3], 0.},
                                {0., 0., F[4]}};
        double       b[3][3];
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k)
            b[i][k] = f[i][0] * f[k][0] + f[i][1] * f[k][1] + f[i][2] * f[k][2];
        for (int p = 0; p < 5; ++p)
          for (int q = 0; q < 5; ++q)
            {
              const int i = row_of[p], J = column_of[p];
              const int k = row_of[q], L = column_of[q];
              response.tangent[p][q] =
                (i == k ? S[J][L] : 0.) + lambda * F[p] * F[q] +
                mu * (f[i][L] * f[k][J] + (J == L ? b[i][k] : 0.));
            }
      }
  }



  std::string
  StVenantKirchhoff::name() const
  {
    return "St. Venant-Kirchhoff";
  }



  NeoHooke::NeoHooke(const ElasticParameters &elasticity)
    : MaterialLaw(elasticity)
    , lambda(elasticity.lame_lambda())
    , mu(elasticity.shear_modulus())
  {}



  void
  NeoHooke::evaluate(const PlaneTensor   &F,
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

    const double J2 = F[0] * F[3] - F[1] * F[2];
    // F^{-T}
    const double G[3][3] = {{F[3] / J2, -F[2] / J2, 0.},
                            {-F[1] / J2, F[0] / J2, 0.},
                            {0., 0., 1. / F[4]}};
    const double a       = lambda * std::log(J) - mu;
    for (int p = 0; p < 5; ++p)
      response.P[p] = mu * F[p] + a * G[row_of[p]][column_of[p]];
    response.mises = mises_kirchhoff(response.P, F);

    // dP_iJ/dF_kL = mu delta_ik delta_JL + lambda G_iJ G_kL - a G_iL G_kJ
    if (with_tangent)
      for (int p = 0; p < 5; ++p)
        for (int q = 0; q < 5; ++q)
          {
            const int i = row_of[p], j = column_of[p];
            const int k = row_of[q], l = column_of[q];
            response.tangent[p][q] = (p == q ? mu : 0.) +
                                     lambda * G[i][j] * G[k][l] -
                                     a * G[i][l] * G[k][j];
          }
  }



  std::string
  NeoHooke::name() const
  {
    return "neo-Hooke";
  }
} // namespace asperity
