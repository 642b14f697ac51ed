#ifndef asperity_law_export_friction_grid_h
#define asperity_law_export_friction_grid_h

#include <asperity/law_export/contact_point_law.h>

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  /** The units in which a chip-formation program reads p, v and T. */
  using SolverUnits = std::array<std::string, 3>;

  /** Its shape, and how fine it has to be. */
  struct FrictionGridOptions
  {
    SolverUnits units = {{"MPa", "mm/s", "degC"}};

    /** Largest relative error of linear interpolation between the nodes. */
    double tolerance = 0.005;

    /** Nodes altogether; beyond that the tolerance is given up. */
    std::size_t max_nodes = 20000;
  };

  /**
   * mu on a grid of p, v and T that covers the box of the training data, fine
   * enough for interpolation that is linear in each of the three (in the
   * quantities themselves, also where the law sees their logarithm). Positions
   * and values are rounded as solver decks carry them, and the error is that of
   * the rounded numbers. A coordinate that the law does not have gets one node,
   * which is not a number.
   */
  class FrictionGrid
  {
  public:
    /** Significant digits of positions and values. */
    static constexpr unsigned int n_digits = 6;

    /** @throws InputError if a unit has the wrong dimension or the tolerance is
     *  not in (0, 1) */
    FrictionGrid(const ContactPointLaw     &law,
                 const FrictionGridOptions &options);

    /** Positions of a coordinate, increasing, in the solver's units. */
    const std::vector<double> &
    nodes(const unsigned int coordinate) const;

    /** A node in SI. */
    ContactPoint
    point(const std::size_t i, const std::size_t j, const std::size_t k) const;

    double
    mu(const std::size_t i, const std::size_t j, const std::size_t k) const;

    std::size_t
    n_nodes() const;

    /** Largest |interpolated - law| / |law| on all quarters of all cells. */
    double
    interpolation_error() const;

    /** The same on the plane of one node, for programs that do not interpolate
     *  along that coordinate. */
    double
    interpolation_error(const unsigned int coordinate,
                        const std::size_t  node) const;

    /** Points at which interpolation_error() was measured. */
    std::size_t
    n_checked() const;

    bool
    tolerance_is_reached() const;

    const FrictionGridOptions &
    options() const;

  private:
    using Axes = std::array<std::vector<double>, 3>;

    double
    si(const unsigned int coordinate, const double value) const;

    /** Nodes whose error along their own coordinate stays below a limit. */
    std::vector<double>
    axis(const unsigned int coordinate, const double limit) const;

    double
    error_along(const unsigned int coordinate,
                const double       from,
                const double       to) const;

    void
    tabulate();

    /** @param point in the solver's units */
    double
    interpolate(const ContactPoint &point) const;

    /** @param quarters positions in which the interpolation is looked at */
    double
    measure(const Axes &quarters, std::size_t &n_points) const;

    /** All nodes, and the quarters of the spans between them. */
    std::vector<double>
    quarters(const unsigned int coordinate) const;

    ContactPointLaw     law;
    FrictionGridOptions options_;
    ContactPoint        factors, offsets; ///< from the solver's units to SI
    Axes                nodes_;
    std::vector<double> values; ///< p fastest, then v, then T
    double              error                 = 0.;
    std::size_t         n_checked_            = 0;
    bool                tolerance_is_reached_ = false;
  };
} // namespace asperity

#endif
