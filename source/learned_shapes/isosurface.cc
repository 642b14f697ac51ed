#include <asperity/base/errors.h>
#include <asperity/learned_shapes/isosurface.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/table.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace asperity
{
  using namespace dealii;

  namespace
  {
    /** Gives points that lie within a tolerance one number. */
    template <int dim>
    class PointNumbers
    {
    public:
      explicit PointNumbers(const double tolerance)
        : tolerance(tolerance)
      {}

      unsigned int
      number(const Point<dim> &point)
      {
        // a point near the edge of its box may have its like in the next one
        std::array<long, dim> box;
        for (unsigned int c = 0; c < (1u << dim); ++c)
          {
            for (unsigned int d = 0; d < dim; ++d)
              box[d] = std::lround(point[d] / (4. * tolerance) +
                                   (c >> d & 1u ? 0.25 : -0.25));
            const auto found = numbers.find(box);
            if (found != numbers.end() &&
                points[found->second].distance(point) < tolerance)
              return found->second;
          }
        for (unsigned int c = 0; c < (1u << dim); ++c)
          {
            for (unsigned int d = 0; d < dim; ++d)
              box[d] = std::lround(point[d] / (4. * tolerance) +
                                   (c >> d & 1u ? 0.25 : -0.25));
            numbers.emplace(box, points.size());
          }
        points.push_back(point);
        return points.size() - 1;
      }

      std::vector<Point<dim>> points;

    private:
      double                                        tolerance;
      std::map<std::array<long, dim>, unsigned int> numbers;
    };



    /** A function as it is taken in n cells along each edge of the cube: by its
     *  values at their corners, linear along each coordinate between them. */
    template <int dim>
    using GridFunction = Functions::InterpolatedUniformGridData<dim>;

    template <int dim>
    GridFunction<dim>
    on_grid(const BatchFunction &function,
            const double         half_box,
            const unsigned int   n)
    {
      TableIndices<dim>                          size;
      std::array<std::pair<double, double>, dim> box;
      std::array<unsigned int, dim>              cells;
      for (unsigned int d = 0; d < dim; ++d)
        {
          size[d]  = n + 1;
          box[d]   = {-half_box, half_box};
          cells[d] = n;
        }
      // the last index of a table runs fastest where it is filled
      const std::size_t   n_nodes = std::lround(std::pow(n + 1, dim));
      std::vector<double> coordinates(dim * n_nodes);
      for (std::size_t i = 0; i < n_nodes; ++i)
        for (std::size_t d = dim, rest = i; d-- > 0; rest /= n + 1)
          coordinates[dim * i + d] =
            half_box * (2. * (rest % (n + 1)) / n - 1.);
      const std::vector<double> values = function(coordinates);
      Table<dim, double>        table;
      table.reinit(size);
      table.fill(values.begin());
      return {box, cells, table};
    }



    /** Cuts it at zero, in cells that are cut into parts. */
    template <int dim>
    void
    march(const GridFunction<dim>        &function,
          const double                    half_box,
          const unsigned int              n,
          const unsigned int              n_subdivisions,
          std::vector<Point<dim>>        &points,
          std::vector<CellData<dim - 1>> &cells)
    {
      Triangulation<dim> grid;
      GridGenerator::subdivided_hyper_cube(grid, n, -half_box, half_box);
      const FE_Q<dim>      fe(1);
      const MappingQ1<dim> mapping;
      DoFHandler<dim>      dof_handler(grid);
      dof_handler.distribute_dofs(fe);
      Vector<double> values(dof_handler.n_dofs());
      VectorTools::interpolate(mapping, dof_handler, function, values);
      GridTools::MarchingCubeAlgorithm<dim, Vector<double>>(mapping,
                                                            fe,
                                                            n_subdivisions)
        .process(dof_handler, values, 0., points, cells);
    }



    /** Turns the simplices so that the function grows across them; that of the
     *  grid, since at a sharp tip the other one may already fall again. */
    template <int dim>
    void
    turn_outwards(const GridFunction<dim>                          &function,
                  const double                                      step,
                  const std::vector<Point<dim>>                    &points,
                  std::vector<typename BoundaryMesh<dim>::Simplex> &simplices)
    {
      for (auto &simplex : simplices)
        {
          Point<dim> middle;
          for (const unsigned int v : simplex)
            middle += points[v] / double(dim);
          Tensor<1, dim> normal;
          if constexpr (dim == 2)
            {
              const auto along = points[simplex[1]] - points[simplex[0]];
              normal           = Tensor<1, 2>({along[1], -along[0]});
            }
          else
            normal = cross_product_3d(points[simplex[1]] - points[simplex[0]],
                                      points[simplex[2]] - points[simplex[0]]);
          normal *= step / normal.norm();
          if (function.value(middle - normal) > function.value(middle + normal))
            std::swap(simplex[0], simplex[1]);
        }
    }



    /** The surface on a grid of which each cell is cut into parts. */
    template <int dim>
    BoundaryMesh<dim>
    cut(const BatchFunction &function,
        const double         half_box,
        const unsigned int   n,
        const unsigned int   n_subdivisions)
    {
      const double                   h = 2. * half_box / n / n_subdivisions;
      std::vector<Point<dim>>        points;
      std::vector<CellData<dim - 1>> cells;
      const GridFunction<dim> values = on_grid<dim>(function, half_box, n);
      march(values, half_box, n, n_subdivisions, points, cells);

      PointNumbers<dim>                                numbers(1e-6 * h);
      std::vector<typename BoundaryMesh<dim>::Simplex> simplices;
      for (const CellData<dim - 1> &cell : cells)
        {
          typename BoundaryMesh<dim>::Simplex simplex;
          for (unsigned int k = 0; k < dim; ++k)
            simplex[k] = numbers.number(points[cell.vertices[k]]);
          // where the surface passes through a node, simplices may be points
          if (std::set<unsigned int>(simplex.begin(), simplex.end()).size() ==
              dim)
            simplices.push_back(simplex);
        }
      if (simplices.empty())
        throw InputError("The function has no zero in the box.");
      turn_outwards(values, 1e-3 * h, numbers.points, simplices);
      return {numbers.points, simplices};
    }
  } // namespace



  template <int dim>
  BoundaryMesh<dim>
  isosurface(const BatchFunction &function,
             const double         half_box,
             const unsigned int   n)
  {
    // deal.II leaves out a cell in which two opposite corners are inside and
    // the others are not, as at a sharp tip: smaller parts of it, in which the
    // function is bilinear, have no such corners.
    BoundaryMesh<dim> result = cut<dim>(function, half_box, n, 1);
    for (unsigned int parts = 2; parts <= 4 && !result.is_closed(); parts *= 2)
      result = cut<dim>(function, half_box, n, parts);
    return result;
  }



  template BoundaryMesh<2>
  isosurface<2>(const BatchFunction &, const double, const unsigned int);
  template BoundaryMesh<3>
  isosurface<3>(const BatchFunction &, const double, const unsigned int);
} // namespace asperity
