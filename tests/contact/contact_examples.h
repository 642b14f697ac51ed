#ifndef asperity_tests_contact_contact_examples_h
#define asperity_tests_contact_contact_examples_h

#include <memory>
#include <vector>

#include "contact_problem.h"

namespace example
{
  using asperity::ContactFormulation;

  /** How a contact problem is discretized. */
  struct Discretization
  {
    ContactFormulation formulation = ContactFormulation::mortar;
    unsigned int       degree      = 2;

    /** c in penalty = c E/h, h the element length at the contact. */
    double penalty_factor = 100.;

    /** Hertz and punch: half-width over h; Westergaard: wavelength over h;
     *  ironing: elements on twice the thickness. */
    double resolution = 16.;

    double                        poisson_ratio = 0.3; ///< Hertz and punch
    asperity::InterfaceParameters interface;
  };

  /**
   * A rigid tool on a block that stands for a half-plane: plane strain, 48
   * half-widths a to each side and in depth, refined towards the contact. The
   * error of the finite block is of order (a/H)^2; strains are of order 1e-3.
   * Units: E = 1, a = 1.
   */
  struct HalfPlane
  {
    std::unique_ptr<ContactProblem> problem;
    double                          element_length  = 0.;
    double                          reduced_modulus = 0.; ///< E* = E/(1 - nu^2)
    double                          force           = 0.; ///< P' aimed at [N/m]
    double                          depth = 0.; ///< first guess for press() [m]
  };

  /** Cylinder whose force makes the half-width one; K. L. Johnson, Contact
   *  Mechanics, sec. 4.2 (c): a^2 = 4 P' R/(pi E*), p0 = 2 P'/(pi a). */
  HalfPlane
  hertz(const Discretization &discretization);

  /** Flat-ended punch with sharp corners, Johnson, sec. 2.8:
   *  p = P'/(pi sqrt(a^2 - x^2)). */
  HalfPlane
  flat_punch(const Discretization &discretization);

  /** The pressure over x at the points of the contact edge. */
  double
  hertz_pressure(const HalfPlane &body, const double x);

  double
  punch_pressure(const double force, const double x);

  /** sqrt(int (p - exact)^2 / int exact^2) over |x| < limit. */
  double
  pressure_error(const ContactProblem                &problem,
                 const double                         limit,
                 const std::function<double(double)> &exact);

  /** int p f(x) / int p, the mean of a function weighted by the pressure. */
  double
  pressure_mean(const ContactProblem                &problem,
                const std::function<double(double)> &f);

  /**
   * A rigid sine wave of amplitude h = 2e-4 wavelengths on a periodic block one
   * wavelength thick (E = 1, wavelength 1); H. M. Westergaard, J. Appl. Mech. 6
   * (1939) 49-53; Johnson, sec. 13.2.
   */
  struct Westergaard
  {
    explicit Westergaard(const Discretization &discretization);

    /** Presses until the mean pressure is the exact one of a half-width. */
    bool
    press(const double half_width);

    /** Numerical half-width and mean gap. */
    double
    half_width() const;

    double
    mean_gap() const;

    /** .5 cos^2 + sin^2 ln sin of pi a/l, times 2 h. */
    static double
    exact_mean_gap(const double half_width);

    /** 2 p* cos(pi x) sqrt(sin^2(pi a) - sin^2(pi x)), x from the crest. */
    double
    exact_pressure(const double half_width, const double x) const;

    std::unique_ptr<ContactProblem> problem;
    double                          element_length = 0.;
    double full_pressure = 0.; ///< p* = pi E* h/wavelength
    double depth         = 0.;
  };

  /** Ripple of the force while a rigid tool slides over a slab. */
  struct Ironing
  {
    bool   converged       = false;
    double vertical_force  = 0.; ///< mean over one element [N/m]
    double vertical_ripple = 0.; ///< rms deviation over the mean
    double lateral_ripple  = 0.; ///< rms of the lateral over the mean vertical

    /** |int T_x dx| / int |T_x| dx over one element: energy lost. */
    double lost_work = 0.;

    std::vector<double> position, vertical, lateral; ///< [m], [N/m], [N/m]
    double              contact_fraction = 0.;       ///< at the end
    unsigned int        iterations       = 0;
  };

  enum class IroningTool
  {
    cylinder,         ///< of radius 3, pressed 0.3 deep
    wave_without_edge ///< as long as the slab, pressed 0.6 deep: all touches
  };

  /**
   * Shallow ironing after K. A. Fischer, P. Wriggers, CMAME 195 (2006)
   * 5020-5036: a neo-Hooke slab 9 x 3 (nu = 0.32), square elements, periodic in
   * x, pressed by a rigid cylinder or a wave, which then slides.
   * Nothing but the mesh varies along the slab, so that the exact force is
   * constant, and one element is a whole period of the numerical one.
   */
  Ironing
  ironing(const Discretization &discretization,
          const unsigned int    steps_per_element,
          const IroningTool     tool = IroningTool::cylinder);
} // namespace example

#endif
