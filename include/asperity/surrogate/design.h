#ifndef asperity_surrogate_design_h
#define asperity_surrogate_design_h

#include <asperity/surrogate/friction_law.h>

#include <cstdint>
#include <vector>

namespace asperity
{
  /** Where the runs of a campaign lie in the box of its inputs. */
  enum class DesignKind
  {
    grid,            ///< all combinations of equidistant values
    sobol,           ///< low-discrepancy sequence
    latin_hypercube, ///< one point in each of n slices of every input
    random           ///< uniform and independent, for test runs
  };

  /**
   * The coordinate z of an input, (g(x) - g(lower)) / (g(upper) - g(lower)),
   * which is what the Gaussian process sees.
   */
  double
  unit_coordinate(const LawInput &input, const double x);

  /** Its inverse; z = 0 and 1 give the ends of the range exactly. */
  double
  from_unit_coordinate(const LawInput &input, const double z);

  /** Row by row. @param unit n x d coordinates in [0, 1] @return SI values
   *  @throws InputError if the box of an input is empty or not finite, or holds
   *    values that have no logarithm on a logarithmic scale */
  std::vector<double>
  map_to_box(const std::vector<LawInput> &inputs,
             const std::vector<double>   &unit);

  /** The inverse of map_to_box(). */
  std::vector<double>
  map_to_unit(const std::vector<LawInput> &inputs,
              const std::vector<double>   &x);

  /**
   * All combinations of equidistant coordinates, ends included; the last input
   * varies fastest. An input with one value stands at the middle of its range.
   * @throws InputError for no values, or for more than a million points
   */
  std::vector<double>
  unit_grid(const std::vector<unsigned int> &n_values);

  /**
   * Points number first, ..., first + n - 1 of Sobol's sequence with the
   * direction numbers of Bratley and Fox (1988, Algorithm 659), as the GNU
   * Scientific Library makes it: in the order of Antonov and Saleev, without
   * the origin, so that point 1 is the middle of the cube.
   * @throws InputError for more than 40 inputs
   */
  std::vector<double>
  unit_sobol(const std::size_t  n,
             const unsigned int n_inputs,
             const std::size_t  first = 1);

  /**
   * In every input one point in each of n slices, at random within its slice;
   * of a number of such squares the one whose closest two points are farthest
   * apart (maximin, Johnson, Moore and Ylvisaker 1990).
   */
  std::vector<double>
  unit_latin_hypercube(const std::size_t   n,
                       const unsigned int  n_inputs,
                       const std::uint64_t seed);

  std::vector<double>
  unit_random(const std::size_t   n,
              const unsigned int  n_inputs,
              const std::uint64_t seed);

  /** Corners of the unit cube, the last input varies fastest. */
  std::vector<double>
  unit_corners(const unsigned int n_inputs);

  /**
   * A design in the box of the inputs, each on its scale.
   * @param n number of points; for a grid the number of values of each input,
   *   which makes n^d points
   * @param seed for the random kinds: the same seed gives the same points on
   *   every machine; grids and Sobol points do not depend on it
   * @return n x d SI values, one point after the other
   * @throws InputError as the functions above, or if there are no inputs
   */
  std::vector<double>
  design_points(const DesignKind             kind,
                const unsigned int           n,
                const std::vector<LawInput> &inputs,
                const std::uint64_t          seed);

  /** A grid with its own number of values for each input. */
  std::vector<double>
  grid_points(const std::vector<unsigned int> &n_values,
              const std::vector<LawInput>     &inputs);
} // namespace asperity

#endif
