#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene.h>
#include <asperity/isogeometric/space_transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>

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
    /** Upper bound of the number of elements: each row is as fine as its upper
     *  edge.
     *  @param columns of the coarsest mesh */
    template <int dim>
    double
    largest_number_of_elements(const MeshParameters      &mesh,
                               const unsigned int         columns,
                               const std::vector<double> &rows)
    {
      const auto columns_in_one = [](const unsigned int level) {
        return 1u << (level * (dim - 1));
      };
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
              finer +=
                columns_in_one(l) * std::min<double>(1u << l, rows_of_level);
            }
          sum += columns * finer;
        }
      return sum;
    }

    double
    height_at(const Surface &surface, const Point<2> &p)
    {
      return surface.height(p[0]);
    }

    double
    height_at(const SheetSurface &surface, const Point<3> &p)
    {
      return surface.sheet.value(Point<2>(p[0], p[1]));
    }

    KnotVector
    periodic_knots(const MeshParameters &mesh,
                   const double          period,
                   const unsigned int    n)
    {
      std::vector<double> columns(n + 1);
      for (unsigned int i = 0; i <= n; ++i)
        columns[i] = period * i / n;
      return KnotVector(mesh.degree, columns, true, mesh.knot_multiplicity());
    }
  } // namespace



  template <int dim>
  void
  Scene<dim>::build_mesh(const SceneParameters &parameters)
  {
    const MeshParameters &mesh   = parameters.mesh;
    const double          height = parameters.geometry.height;
    const unsigned int    n      = mesh.spans >> mesh.refinement;
    const unsigned int    n_across =
      dim == 3 ? mesh.n_spans_across(length, width) >> mesh.refinement : 1;
    const std::vector<double> rows =
      graded_rows(height,
                  way_through(length / n, width / n_across),
                  mesh.grading);
    const double largest =
      largest_number_of_elements<dim>(mesh, n * n_across, rows);
    choose_solver(parameters,
                  mesh.is_bounded() ?
                    std::min<double>(largest, 1. * mesh.most_unknowns / dim) :
                    largest);
    std::array<KnotVector, dim> knots;
    knots[0] = periodic_knots(mesh, length, n);
    knots[dim - 1] =
      KnotVector(mesh.degree, rows, false, mesh.knot_multiplicity());
    if constexpr (dim == 3)
      knots[1] = periodic_knots(mesh, width, n_across);
    space = std::make_shared<SplineSpace<dim>>(knots);
    for (unsigned int level = 1; level <= mesh.n_even_levels(); ++level)
      space->refine_to_level(
        level, [&](const Point<dim> &, const Point<dim> &upper) {
          return is_in_strip(mesh, level, height - upper[dim - 1]);
        });
    if (mesh.is_bounded() && n_dofs() > mesh.most_unknowns)
      throw InputError("Entry 'Mesh/Maximum unknowns': found " +
                       std::to_string(mesh.most_unknowns) + ", but the " +
                       std::to_string(mesh.n_even_levels()) +
                       " levels that are along the whole contact edge have " +
                       std::to_string(n_dofs()) +
                       " unknowns; expected at least as many, or 0 for no "
                       "bound, or more Adaptive levels.");
    if (mesh.adaptive_levels > 0)
      suit_solver(parameters);
    if (parameters.chip.kind == SurfaceKind::flat)
      return;
    // The offset of the chip's top decays into the depth, so that the coarse
    // rows need not resolve it.
    geometry = PatchGeometry<dim>::from_map(*space, [&](const Point<dim> &p) {
      const double eta    = p[dim - 1] / height;
      Point<dim>   raised = p;
      raised[dim - 1] +=
        (height_at(chip_surface, p) - height) * std::pow(eta, 4);
      return raised;
    });
  }



  namespace
  {
    /** With these cells, whose numbers follow from them alone. */
    template <int dim>
    std::shared_ptr<SplineSpace<dim>>
    space_like(const SplineHierarchy<dim> &hierarchy)
    {
      std::array<KnotVector, dim> knots;
      for (unsigned int d = 0; d < dim; ++d)
        knots[d] = hierarchy.knots(0, d);
      auto space = std::make_shared<SplineSpace<dim>>(knots);
      space->refine_like(hierarchy);
      return space;
    }

    template <int dim>
    bool
    are_cells_of(const SplineHierarchy<dim>        &hierarchy,
                 const std::vector<CellIndex<dim>> &cells)
    {
      bool are = hierarchy.n_cells() == cells.size();
      for (unsigned int cell = 0; are && cell < cells.size(); ++cell)
        are = hierarchy.cell_index(cell) == cells[cell];
      return are;
    }

    /** Whether cells of at most this level cover the parameter box once. */
    template <int dim>
    bool
    do_tile(const std::array<KnotVector, dim> &knots,
            const unsigned int                 finest,
            const std::vector<CellIndex<dim>> &cells)
    {
      using Key         = std::array<unsigned int, dim + 1>;
      const auto key_of = [](const CellIndex<dim> &cell) {
        Key key;
        key[dim] = cell.level;
        std::copy(cell.spans.begin(), cell.spans.end(), key.begin());
        return key;
      };
      std::set<Key> keys;
      std::uint64_t covered = 0, all = 1;
      for (const KnotVector &direction : knots)
        all *= std::uint64_t(direction.n_spans()) << finest;
      for (const CellIndex<dim> &cell : cells)
        {
          if (cell.level > finest || !keys.insert(key_of(cell)).second)
            return false;
          for (unsigned int d = 0; d < dim; ++d)
            if (cell.spans[d] >= knots[d].n_spans() << cell.level)
              return false;
          covered += std::uint64_t(1) << (dim * (finest - cell.level));
        }
      for (const CellIndex<dim> &cell : cells)
        for (unsigned int levels = 1; levels <= cell.level; ++levels)
          if (keys.count(key_of(cell.ancestor(levels))) > 0)
            return false;
      return covered == all;
    }
  } // namespace



  template <int dim>
  AdaptedMesh
  Scene<dim>::adapt_mesh(
    const SceneParameters                                   &parameters,
    const std::vector<typename SplineSpace<dim>::CellLevel> &wanted)
  {
    Assert(geometry.offset.empty() && n_lubricant_unknowns == 0 &&
             gap_flow == nullptr,
           dealii::ExcNotImplemented());
    const auto         before = space->hierarchy();
    const unsigned int most   = parameters.mesh.most_unknowns;
    const auto         wished = space_like(*before);
    AdaptedMesh        mesh;
    wished->adapt(wanted.front());
    while (most > 0 && dim * wished->n_functions() > most &&
           mesh.number + 1 < wanted.size())
      wished->adapt(wanted[++mesh.number]);
    mesh.has_changed = wished->n_cells() != before->n_cells() ||
                       !is_refinement(*before, *wished->hierarchy());
    if (!mesh.has_changed)
      return mesh;
    space = space_like(*wished->hierarchy());
    rebuild(parameters);
    return mesh;
  }



  template <int dim>
  void
  Scene<dim>::set_mesh(const SceneParameters             &parameters,
                       const std::vector<CellIndex<dim>> &cells)
  {
    const auto before = space->hierarchy();
    if (are_cells_of<dim>(*before, cells))
      return;
    std::array<KnotVector, dim> knots;
    for (unsigned int d = 0; d < dim; ++d)
      knots[d] = before->knots(0, d);
    if (!do_tile<dim>(knots, parameters.mesh.refinement, cells))
      throw InputError("The cells of the mesh do not tile the chip; expected "
                       "those of a checkpoint of this scene.");
    space = space_like(SplineHierarchy<dim>(knots, cells));
    if (!are_cells_of<dim>(*space->hierarchy(), cells))
      throw InputError("The cells of the mesh have other numbers; expected "
                       "those of a checkpoint of this program.");
    rebuild(parameters);
  }



  template <int dim>
  void
  Scene<dim>::rebuild(const SceneParameters &parameters)
  {
    const EquilibriumCost cost = equilibrium->cost();
    suit_solver(parameters);
    build_share(parameters);
    build_chip(parameters);
    build_contact(parameters);
    build_lubricant(parameters);
    build_heat(parameters);
    build_boundaries();
    build_equilibrium();
    equilibrium->add_cost(cost);
  }



  template void
  Scene<2>::build_mesh(const SceneParameters &);
  template void
  Scene<3>::build_mesh(const SceneParameters &);
  template AdaptedMesh
  Scene<2>::adapt_mesh(const SceneParameters &,
                       const std::vector<SplineSpace<2>::CellLevel> &);
  template AdaptedMesh
  Scene<3>::adapt_mesh(const SceneParameters &,
                       const std::vector<SplineSpace<3>::CellLevel> &);
  template void
  Scene<2>::set_mesh(const SceneParameters &,
                     const std::vector<CellIndex<2>> &);
  template void
  Scene<2>::rebuild(const SceneParameters &);
  template void
  Scene<3>::set_mesh(const SceneParameters &,
                     const std::vector<CellIndex<3>> &);
  template void
  Scene<3>::rebuild(const SceneParameters &);
} // namespace asperity
