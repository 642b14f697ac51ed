#ifndef asperity_tests_mesh_motion_column_examples_h
#define asperity_tests_mesh_motion_column_examples_h

#include <asperity/mesh_motion/column_layout.h>
#include <asperity/mesh_motion/column_mesh.h>

#include "example_surfaces.h"

namespace asperity
{
  namespace example
  {
    inline ColumnLayout
    layout_of(const SplineCurve &chip,
              const unsigned int n_columns = 80,
              const double       film      = 0.005 * um)
    {
      return {columns_on_spans(chip.knot_vector(), n_columns),
              graded_rows(4, 2.),
              film};
    }



    inline dealii::Tensor<1, 2>
    shift(const double x, const double y = 0.)
    {
      return dealii::Point<2>(x, y);
    }
  } // namespace example
} // namespace asperity

#endif
