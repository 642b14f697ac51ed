#ifndef asperity_constitutive_point_pack_h
#define asperity_constitutive_point_pack_h

#include <asperity/constitutive/hencky_kinematics.h>
#include <asperity/constitutive/material_law.h>

#include <algorithm>

/** Several points of plane kinematics side by side, as FiniteStrainJ2 takes
 *  them from and gives them back to the structures of single points. */
namespace asperity
{
  /** What a law reads of its points; lanes without a point repeat the last. */
  struct PointPack
  {
    hencky::Plane<lanes::Pack>          F;
    hencky::SymmetricPlane<lanes::Pack> Cp_inverse;     ///< at the start
    lanes::Pack                         plastic_strain; ///< at the start
    lanes::Pack                         temperature;    ///< at the start [K]
    lanes::Pack                         guess; ///< of the strain's increment
  };

  /** What a law answers; the state is that of plastic points alone. */
  struct PointPackResponse
  {
    lanes::PackMask                     valid;   ///< F is regular
    lanes::PackMask                     plastic; ///< the step yields
    lanes::PackMask                     found;   ///< and the return has a root
    hencky::Plane<lanes::Pack>          P;       ///< [Pa]
    lanes::Pack                         mises;   ///< [Pa]
    hencky::SymmetricPlane<lanes::Pack> Cp_inverse{};
    lanes::Pack                         plastic_strain{};
    lanes::Pack                         temperature{}; ///< [K]
  };

  /** @param responses whose states are the guesses */
  inline PointPack
  load_points(const unsigned int          n_points,
              const dealii::Tensor<2, 3> *F,
              const MaterialState        *old,
              const MaterialResponse     *responses)
  {
    PointPack p;
    for (unsigned int lane = 0; lane < lanes::width; ++lane)
      {
        const unsigned int   q  = std::min(lane, n_points - 1);
        const auto          &Fq = F[q];
        const MaterialState &s  = old[q];
        p.F.xx[lane]            = Fq[0][0];
        p.F.xy[lane]            = Fq[0][1];
        p.F.yx[lane]            = Fq[1][0];
        p.F.yy[lane]            = Fq[1][1];
        p.F.zz[lane]            = Fq[2][2];
        p.Cp_inverse.xx[lane]   = s.Cp_inverse[0][0];
        p.Cp_inverse.yy[lane]   = s.Cp_inverse[1][1];
        p.Cp_inverse.xy[lane]   = s.Cp_inverse[0][1];
        p.Cp_inverse.zz[lane]   = s.Cp_inverse[2][2];
        p.plastic_strain[lane]  = s.plastic_strain;
        p.temperature[lane]     = s.temperature;
        p.guess[lane] = responses[q].state.plastic_strain - s.plastic_strain;
      }
    return p;
  }



  /** All but the tangent. */
  inline void
  store_points(const unsigned int       n_points,
               const PointPackResponse &r,
               const MaterialState     *old,
               MaterialResponse        *responses)
  {
    for (unsigned int q = 0; q < n_points; ++q)
      {
        MaterialResponse &response = responses[q];
        response.status            = !r.valid[q] ? LawStatus::inverted :
                                     r.found[q]  ? LawStatus::ok :
                                                   LawStatus::no_return;
        response.plastic           = r.plastic[q];
        response.mises             = r.mises[q];
        response.P[0][0]           = r.P.xx[q];
        response.P[0][1]           = r.P.xy[q];
        response.P[1][0]           = r.P.yx[q];
        response.P[1][1]           = r.P.yy[q];
        response.P[2][2]           = r.P.zz[q];
        response.state             = old[q];
        if (response.status != LawStatus::ok || !response.plastic)
          continue;
        auto &C                       = response.state.Cp_inverse;
        C[0][0]                       = r.Cp_inverse.xx[q];
        C[1][1]                       = r.Cp_inverse.yy[q];
        C[0][1]                       = r.Cp_inverse.xy[q];
        C[2][2]                       = r.Cp_inverse.zz[q];
        response.state.plastic_strain = r.plastic_strain[q];
        response.state.temperature    = r.temperature[q];
      }
  }



  /** dP_iJ/dF_kL into the responses. */
  inline void
  store_tangents(const unsigned int                       n_points,
                 const hencky::PlaneTangent<lanes::Pack> &by_F,
                 MaterialResponse                        *responses)
  {
    const auto store =
      [&](const hencky::Plane<lanes::Pack> &column, const int k, const int L) {
        for (unsigned int q = 0; q < n_points; ++q)
          {
            dealii::Tensor<4, 3> &tangent = responses[q].tangent;
            tangent[0][0][k][L]           = column.xx[q];
            tangent[0][1][k][L]           = column.xy[q];
            tangent[1][0][k][L]           = column.yx[q];
            tangent[1][1][k][L]           = column.yy[q];
            tangent[2][2][k][L]           = column.zz[q];
          }
      };
    store(by_F.xx, 0, 0);
    store(by_F.xy, 0, 1);
    store(by_F.yx, 1, 0);
    store(by_F.yy, 1, 1);
    store(by_F.zz, 2, 2);
  }
} // namespace asperity

#endif
