#include <asperity/isogeometric/spline_mapping.h>

#include <deal.II/fe/mapping_q1.h>

#include <algorithm>

namespace asperity
{
  std::unique_ptr<dealii::MappingQCache<2>>
  make_mapping(const SplineSpace &space, const PatchGeometry &geometry)
  {
    // Not of degree 1: FEValues (deal.II 9.4) then takes the Jacobians of a
    // cell for those of the next one whenever both have the same shape in the
    // triangulation, whatever the cached points are.
    auto mapping =
      std::make_unique<dealii::MappingQCache<2>>(std::max(2u, space.degree()));
    // deal.II's points of the parameter mesh are parameters. They lie on cell
    // faces, too, where the polynomials of this very cell are to be taken.
    mapping->initialize(
      dealii::MappingQ1<2>(),
      space.triangulation(),
      [&](const dealii::Triangulation<2>::cell_iterator &cell,
          const dealii::Point<2>                        &parameter) {
        if (!cell->is_active() || geometry.offset.empty())
          return geometry.position(space, parameter);
        const unsigned int  c = cell->active_cell_index();
        dealii::Point<2>    X = parameter;
        std::vector<double> values;
        space.evaluate(c, parameter, values);
        for (unsigned int a = 0; a < values.size(); ++a)
          X += values[a] * geometry.offset[space.cell_functions(c)[a]];
        return X;
      },
      /*function_describes_relative_displacement=*/false);
    return mapping;
  }
} // namespace asperity
