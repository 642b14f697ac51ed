#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene.h>
#include <asperity/isogeometric/space_transfer.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;

  std::vector<double>
  graded_rows(const double height, const double top, const double grading)
  {
    // Rows top, top g, top g^2, ... until they reach the bottom, then scaled to
    // fit. A chip that is flatter than its elements are long has one row.
    std::vector<double> rows = {top};
    double              sum  = top;
    for (double row = top * grading; sum + 0.5 * row < height; row *= grading)
      {
        rows.push_back(row);
        sum += row;
      }
    std::vector<double> levels(1, height);
    for (const double row : rows)
      levels.push_back(levels.back() - row * height / sum);
    levels.back() = 0.;
    std::reverse(levels.begin(), levels.end());
    return levels;
  }



  bool
  is_in_strip(const MeshParameters &mesh,
              const unsigned int    level,
              const double          depth)
  {
    return depth < mesh.strip * (1u << (mesh.refinement - level)) * (1. - 1e-9);
  }



  namespace
  {
    /** Bezier elements whose tables, tangent and factors take about 2 GB. */
    constexpr double largest_mesh = 1e5;

    /** Upper bound of the number of elements: each row is as fine as its upper
     *  edge. */
    double
    largest_number_of_elements(const MeshParameters      &mesh,
                               const std::vector<double> &rows)
    {
      double sum = 0.;
      for (std::size_t i = 1; i < rows.size(); ++i)
        {
          const double depth = rows.back() - rows[i];
          unsigned int level = 0;
          while (level < mesh.refinement && is_in_strip(mesh, level + 1, depth))
            ++level;
          // Finer rows within this one end with their strips.
          double finer = 1.;
          for (unsigned int l = 1; l <= level; ++l)
            {
              const double rows_of_level =
                mesh.strip * (1u << (mesh.refinement - l)) /
                  ((rows[i] - rows[i - 1]) / (1u << l)) +
                2.;
              finer += (1u << l) * std::min<double>(1u << l, rows_of_level);
            }
          sum += (mesh.spans >> mesh.refinement) * finer;
        }
      return sum;
    }

    /** Before memory runs out. */
    void
    check_size(const MeshParameters &mesh, const std::vector<double> &rows)
    {
      const double n = largest_number_of_elements(mesh, rows);
      if (n > largest_mesh)
        throw InputError("Mesh: these entries make a mesh of about " +
                         format_quantity(n, "1", 2) +
                         " elements; expected at most " +
                         format_quantity(largest_mesh, "1") +
                         ": fewer Spans, a larger Row grading, a smaller Strip "
                         "depth, or a smaller Chip height.");
    }
  } // namespace



  void
  Scene::build_mesh(const SceneParameters &parameters)
  {
    const MeshParameters &mesh   = parameters.mesh;
    const double          height = parameters.geometry.height;
    const unsigned int    n      = mesh.spans >> mesh.refinement;
    std::vector<double>   columns(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      columns[i] = length * i / n;
    const std::vector<double> rows =
      graded_rows(height, length / n, mesh.grading);
    check_size(mesh, rows);
    space =
      std::make_shared<SplineSpace<2>>(KnotVector(mesh.degree, columns, true),
                                       KnotVector(mesh.degree, rows));
    for (unsigned int level = 1; level <= mesh.n_even_levels(); ++level)
      space->refine_to_level(
        level, [&](const Point<2> &, const Point<2> &upper) {
          return is_in_strip(mesh, level, height - upper[1]);
        });
    if (parameters.chip.kind == SurfaceKind::flat)
      return;
    // The offset of the chip's top decays into the depth, so that the coarse
    // rows need not resolve it.
    geometry = PatchGeometry<2>::from_map(*space, [&](const Point<2> &p) {
      const double eta = p[1] / height;
      return Point<2>(p[0],
                      p[1] + (chip_surface.height(p[0]) - height) *
                               std::pow(eta, 4));
    });
  }



  bool
  Scene::adapt_mesh(const SceneParameters           &parameters,
                    const SplineSpace<2>::CellLevel &wanted)
  {
    Assert(geometry.offset.empty() && !lubricant && !heat,
           dealii::ExcNotImplemented());
    const auto before = space->hierarchy();
    space->adapt(wanted);
    if (space->n_cells() == before->n_cells() &&
        is_refinement(*before, *space->hierarchy()))
      return false;
    const EquilibriumCost cost = equilibrium->cost();
    build_chip(parameters);
    build_contact(parameters);
    build_boundaries();
    build_equilibrium(parameters.solver.linear_solver);
    equilibrium->add_cost(cost);
    initial_unknowns_.reinit(n_unknowns());
    return true;
  }
} // namespace asperity
