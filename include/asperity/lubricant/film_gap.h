#ifndef asperity_lubricant_film_gap_h
#define asperity_lubricant_film_gap_h

namespace asperity
{
  /**
   * The thickness of the film at a gap g between the surfaces, which is
   * negative where they penetrate: g itself, but never less than a residual
   * film h_r. A parabola joins both branches with continuous slope on
   * 0 < g < 2 h_r, where it exceeds max(g, h_r) by at most h_r/4.
   *
   * The residual film stands for what unresolved roughness keeps open. The
   * thinner it is, the higher the pressure that drives the oil away from a
   * contact, and the shorter the steps that Newton's method needs.
   */
  struct FilmGap
  {
    double residual = 1e-8; ///< h_r > 0 [m]

    double
    value(const double gap) const
    {
      if (gap <= 0.)
        return residual;
      if (gap >= 2. * residual)
        return gap;
      return residual + 0.25 * gap * gap / residual;
    }

    /** dh/dg */
    double
    slope(const double gap) const
    {
      if (gap <= 0.)
        return 0.;
      if (gap >= 2. * residual)
        return 1.;
      return 0.5 * gap / residual;
    }
  };
} // namespace asperity

#endif
