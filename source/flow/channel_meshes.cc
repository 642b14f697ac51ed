#include <asperity/flow/channel_meshes.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace asperity
{
  namespace
  {
    using dealii::Point;
    using Mesh = dealii::Triangulation<2>;

    constexpr double length = 2.5, height = 0.41;
    constexpr double radius   = 0.05;
    constexpr double flag_end = 0.6, flag_low = 0.19, flag_high = 0.21;
    const Point<2>   centre(0.2, 0.2);

    constexpr dealii::types::manifold_id arcs = 0, blended = 1;

    void
    refine_walls(Mesh                                       &mesh,
                 const unsigned int                          n_layers,
                 const std::set<dealii::types::boundary_id> &walls)
    {
      for (unsigned int layer = 0; layer < n_layers; ++layer)
        {
          for (const auto &cell : mesh.active_cell_iterators())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && walls.count(face->boundary_id()) > 0)
                cell->set_refine_flag();
          mesh.execute_coarsening_and_refinement();
        }
    }

    /** At the flag's tip and where it leaves the cylinder. */
    void
    refine_flag_corners(Mesh &mesh, const unsigned int n_layers)
    {
      const double half = 0.5 * (flag_high - flag_low);
      const double root = centre[0] + std::sqrt(radius * radius - half * half);
      for (unsigned int layer = 0; layer < n_layers; ++layer)
        {
          for (const auto &cell : mesh.active_cell_iterators())
            for (const unsigned int v : cell->vertex_indices())
              for (const double x : {root, flag_end})
                for (const double y : {flag_low, flag_high})
                  if (cell->vertex(v).distance(Point<2>(x, y)) < 1e-9)
                    cell->set_refine_flag();
          mesh.execute_coarsening_and_refinement();
        }
    }

    /** Collects vertices by position and cells by their corners. */
    struct CoarseMesh
    {
      std::vector<Point<2>>            vertices;
      std::vector<dealii::CellData<2>> cells;

      unsigned int
      vertex(const Point<2> &x)
      {
        for (unsigned int v = 0; v < vertices.size(); ++v)
          if (vertices[v].distance(x) < 1e-9)
            return v;
        vertices.push_back(x);
        return vertices.size() - 1;
      }

      /** Corners in deal.II's order. */
      void
      add(const std::array<Point<2>, 4>   &corners,
          const dealii::types::manifold_id manifold)
      {
        dealii::CellData<2> cell;
        for (unsigned int v = 0; v < 4; ++v)
          cell.vertices[v] = vertex(corners[v]);
        cell.manifold_id = manifold;
        cells.push_back(cell);
      }

      void
      add_blocks(const std::vector<double> &x, const std::vector<double> &y)
      {
        for (unsigned int i = 0; i + 1 < x.size(); ++i)
          for (unsigned int j = 0; j + 1 < y.size(); ++j)
            {
              const bool is_flag = y[j] == flag_low && x[i + 1] <= flag_end;
              if (!is_flag)
                add({{{x[i], y[j]},
                      {x[i + 1], y[j]},
                      {x[i], y[j + 1]},
                      {x[i + 1], y[j + 1]}}},
                    dealii::numbers::flat_manifold_id);
            }
      }

      /** Cells between the cylinder and the square around it. */
      void
      add_ring()
      {
        const double sine = (flag_high - centre[1]) / radius;
        const double flag = std::asin(sine), eighth = dealii::numbers::PI / 4.;
        // Counter-clockwise from the upper edge of the flag to the lower.
        std::vector<double>   angle = {flag};
        std::vector<Point<2>> outer = {{0.3, flag_high},
                                       {0.3, 0.3},
                                       {0.2, 0.3},
                                       {0.1, 0.3},
                                       {0.1, 0.2},
                                       {0.1, 0.1},
                                       {0.2, 0.1},
                                       {0.3, 0.1},
                                       {0.3, flag_low}};
        for (unsigned int k = 1; k < 8; ++k)
          angle.push_back(k * eighth);
        angle.push_back(8. * eighth - flag);
        const auto on_arc = [&](const unsigned int k) {
          return centre +
                 radius * Point<2>(std::cos(angle[k]), std::sin(angle[k]));
        };
        for (unsigned int k = 0; k + 1 < angle.size(); ++k)
          add({{on_arc(k), outer[k], on_arc(k + 1), outer[k + 1]}}, blended);
      }
    };

    dealii::types::boundary_id
    flag_channel_boundary(const Point<2> &a, const Point<2> &b)
    {
      const auto both = [&](const unsigned int i, const double value) {
        return std::abs(a[i] - value) < 1e-9 && std::abs(b[i] - value) < 1e-9;
      };
      if (both(0, 0.))
        return channel_inlet;
      if (both(0, length))
        return channel_outlet;
      if (both(1, 0.) || both(1, height))
        return channel_walls;
      if (both(0, flag_end))
        return flag_tip;
      if (both(1, flag_low))
        return flag_bottom;
      return both(1, flag_high) ? flag_top : channel_cylinder;
    }
  } // namespace



  void
  make_channel_with_cylinder(Mesh              &mesh,
                             const unsigned int n_refinements,
                             const unsigned int n_wall_layers)
  {
    dealii::GridGenerator::channel_with_cylinder(mesh, 0.03, 2, 2., true);
    // deal.II colours inflow, outflow, cylinder, walls
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        {
          if (face->boundary_id() == 2)
            face->set_boundary_id(channel_cylinder);
          else if (face->boundary_id() == 3)
            face->set_boundary_id(channel_walls);
        }
    mesh.refine_global(n_refinements);
    refine_walls(mesh, n_wall_layers, {channel_cylinder});
  }



  void
  make_channel_with_flag(Mesh              &mesh,
                         const unsigned int n_refinements,
                         const unsigned int n_wall_layers,
                         const unsigned int n_corner_layers)
  {
    CoarseMesh coarse;
    coarse.add_ring();
    coarse.add_blocks({0., 0.1}, {0., 0.1, 0.2, 0.3, height});
    coarse.add_blocks({0.1, 0.2, 0.3}, {0., 0.1});
    coarse.add_blocks({0.1, 0.2, 0.3}, {0.3, height});
    coarse.add_blocks(
      {0.3, 0.4, 0.5, flag_end, 0.7, 0.85, 1.05, 1.3, 1.6, 2., length},
      {0., 0.1, flag_low, flag_high, 0.3, height});
    // Neighbours have to see their edges in the same direction.
    dealii::GridTools::consistently_order_cells(coarse.cells);
    mesh.create_triangulation(coarse.vertices, coarse.cells, {});
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        {
          const auto id =
            flag_channel_boundary(face->vertex(0), face->vertex(1));
          face->set_boundary_id(id);
          if (id == channel_cylinder)
            face->set_manifold_id(arcs);
        }
    mesh.set_manifold(arcs, dealii::PolarManifold<2>(centre));
    dealii::TransfiniteInterpolationManifold<2> blend;
    blend.initialize(mesh);
    mesh.set_manifold(blended, blend);
    mesh.refine_global(n_refinements);
    refine_walls(mesh,
                 n_wall_layers,
                 {channel_cylinder, flag_bottom, flag_tip, flag_top});
    refine_flag_corners(mesh, n_corner_layers);
  }
} // namespace asperity
