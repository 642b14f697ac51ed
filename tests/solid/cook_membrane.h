#ifndef asperity_tests_solid_cook_membrane_h
#define asperity_tests_solid_cook_membrane_h

#include "loaded_solid.h"

namespace loaded_solid
{
  /** Voce hardening of Simo and Armero (1992). */
  inline MaterialParameters
  cook_material()
  {
    MaterialParameters material;
    material.elasticity.young_modulus = 206.9e9;
    material.elasticity.poisson_ratio = 0.29;
    material.choose(VoceParameters{0.45e9, 0.715e9, 16.93, 0.12924e9});
    return material;
  }

  constexpr double cook_traction = 0.3125e9; ///< [Pa]

  /**
   * Cook's membrane in plane strain with Voce hardening (J. C. Simo,
   * F. Armero, Int. J. Numer. Methods Eng. 33 (1992) 1413): the tapered panel
   * (0, 0), (48, 44), (48, 60), (0, 44) mm, clamped on the left, a dead shear
   * traction of 0.3125 GPa on the right.
   * @return vertical displacement [m] of the upper right corner
   */
  inline double
  cook_membrane(const unsigned int degree,
                const unsigned int n,
                const unsigned int n_steps)
  {
    Body body(
      make_space(degree, equal_spans(n), equal_spans(n)),
      [](const Point<2> &xi) {
        return Point<2>(48e-3 * xi[0],
                        44e-3 * xi[0] + (44e-3 - 28e-3 * xi[0]) * xi[1]);
      },
      cook_material().make_law());
    body.clamp(Edge::left);
    Tensor<1, 2> shear;
    shear[1] = cook_traction;
    body.add_traction(Edge::right,
                      [shear](const Point<2> &, const Tensor<1, 2> &) {
                        return shear;
                      });
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        body.set_load_factor(double(step) / n_steps);
        body.solve(1e-1); // of 5e6 N/m
      }
    return body.displacement({1., 1.})[1];
  }
} // namespace loaded_solid

#endif
