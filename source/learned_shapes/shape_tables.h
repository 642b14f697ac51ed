#ifndef source_learned_shapes_shape_tables_h
#define source_learned_shapes_shape_tables_h

#include <asperity/learned_shapes/shape_study.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** What has been found about a set of learned shapes. */
  struct ShapeResults
  {
    double                         loss = 0.;
    std::vector<Reconstruction>    shapes; ///< of all recipes
    std::vector<InterpolatedShape> interpolation;
    std::vector<ShapeArithmetic>   arithmetic;
    std::vector<double>            places; ///< of the codes' picture
  };

  /** Mean, median and largest of some numbers; zeros if there are none. */
  struct Statistics
  {
    explicit Statistics(std::vector<double> numbers);

    double mean = 0., median = 0., largest = 0.;
  };

  /** Writes model.asperity, shapes.csv, interpolation.csv, arithmetic.csv,
   *  summary.json and pictures (VTU) into a folder. */
  template <int dim>
  void
  write_results(const ShapeStudy<dim> &study,
                const ShapeResults    &results,
                const std::string     &directory);

  /** A few lines for people. */
  template <int dim>
  void
  print_results(const ShapeStudy<dim> &study,
                const ShapeResults    &results,
                std::ostream          &out);

  /** Surfaces as VTU, each with its number as a field. */
  template <int dim>
  void
  write_surfaces(const std::vector<BoundaryMesh<dim>> &surfaces,
                 const std::vector<double>            &numbers,
                 const std::string                    &name,
                 std::ostream                         &out);
} // namespace asperity

#endif
