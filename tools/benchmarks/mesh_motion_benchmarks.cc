// How far a mesh of the gap of the reference scene R0 can slide: the elastic
// mesh update with several stiffening exponents, and the column mesh. Writes
//   mesh_motion.csv   (smallest scaled Jacobian over sliding distance)
// into the directory given as the first argument (default: the current one),
// and the tables of README.md to the screen; mesh_motion_chart.py draws it.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/mesh_motion/column_layout.h>
#include <asperity/mesh_motion/column_mesh.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>
#include <asperity/mesh_motion/mesh_quality.h>

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/fe/mapping_q_eulerian.h>

#include <mesh_motion/example_surfaces.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

namespace
{
  using namespace asperity;
  using namespace example;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  /** The flat chip has slid over the resting tool by a distance [m]. */
  SplineCurve
  slid_chip(const double distance)
  {
    SplineCurve           chip   = flat(0.);
    std::vector<Point<2>> points = chip.control_points();
    for (Point<2> &p : points)
      p[0] += distance;
    chip.set_control_points(points);
    return chip;
  }



  /** The gap of R0, meshed by columns; `opening` widens it [m]. */
  struct Gap
  {
    SplineCurve  tool;
    ColumnMesh   mesh;
    Tensor<1, 2> shift;

    explicit Gap(const unsigned int n_columns, const double opening = 0.)
      : tool(surface(tool_height))
      , mesh(flat(0.),
             tool,
             {columns_on_spans(flat(0.).knot_vector(),
                               n_columns,
                               film_density(flat(0.), tool, Tensor<1, 2>())),
              graded_rows(6),
              0.005 * um})
    {
      shift[1] = opening;
      mesh.update(flat(0.), shift);
    }
  };



  /** Quality after sliding; the elastic mesh starts as that of columns. */
  class ElasticGap
  {
  public:
    ElasticGap(const unsigned int n_columns,
               const double       exponent,
               const double       opening = 0.)
      : gap(n_columns, opening)
      , start(gap.mesh.displacement())
      , mapping(2, gap.mesh.dofs(), start)
      , update(gap.mesh.dofs(), mapping, options(exponent))
      , watch(gap.mesh.dofs(), mapping)
    {}

    /** The chip's nodes go with it, the tool's rest. */
    Vector
    displacement(const double distance) const
    {
      Vector boundary(start.size());
      for (const auto &node : gap.mesh.chip_nodes())
        boundary(node.dof_x) = distance;
      return update.update(boundary);
    }

    double
    quality(const double distance) const
    {
      return watch.quality(displacement(distance)).smallest_scaled_jacobian;
    }

    /** Sliding distance [m] to the first inverted cell. After a small rise the
     *  quality falls all the way, so bisection finds the first one. */
    double
    distance_to_inversion() const
    {
      double good = 0., bad = period;
      while (bad - good > 1e-5 * um)
        {
          const double middle                 = 0.5 * (good + bad);
          (quality(middle) > 0. ? good : bad) = middle;
        }
      return good;
    }

  private:
    static ElasticMeshOptions
    options(const double exponent)
    {
      ElasticMeshOptions result;
      result.stiffening_exponent = exponent;
      result.prescribed = {ColumnMesh::chip_wall, ColumnMesh::tool_wall};
      result.periodic   = {{ColumnMesh::left_side, ColumnMesh::right_side}};
      return result;
    }

    Gap                                 gap;
    const Vector                        start;
    dealii::MappingQEulerian<2, Vector> mapping;
    ElasticMeshUpdate                   update;
    MeshWatch                           watch;
  };



  double
  seconds_since(const std::chrono::steady_clock::time_point &start)
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         start)
      .count();
  }



  void
  tabulate_elastic_distances()
  {
    std::cout << "| exponent | 80 columns | 160 columns | 320 columns "
                 "| gap + 0.1 um | gap + 0.5 um |\n"
                 "| --- | --- | --- | --- | --- | --- |\n";
    for (const double exponent : {0., 0.5, 1., 1.5, 2.})
      {
        std::cout << "| " << exponent;
        for (const unsigned int n_columns : {80, 160, 320})
          std::cout << " | "
                    << ElasticGap(n_columns, exponent).distance_to_inversion() /
                         um;
        for (const double opening : {0.1, 0.5})
          std::cout
            << " | "
            << ElasticGap(160, exponent, opening * um).distance_to_inversion() /
                 um;
        std::cout << " |" << std::endl;
      }
  }



  void
  write_row(std::ofstream     &file,
            const std::string &mesh,
            const double       distance,
            const double       quality)
  {
    file << mesh << ',' << distance / um << ',' << quality << '\n';
  }



  void
  write_elastic_curves(std::ofstream &file)
  {
    for (const double exponent : {0., 1., 2.})
      {
        const ElasticGap gap(160, exponent);
        for (double distance = 1e-4 * um; distance < 1. * um; distance *= 1.1)
          write_row(file,
                    "elastic with exponent " + std::to_string(int(exponent)),
                    distance,
                    gap.quality(distance));
      }
  }



  /** Two and a half periods, in steps that are no fraction of the period. */
  void
  slide_columns(std::ofstream &file)
  {
    std::cout << "| columns | positions | smallest scaled Jacobian | largest "
                 "aspect ratio | return after 2 periods, um | us a step |\n"
                 "| --- | --- | --- | --- | --- | --- |\n";
    for (const unsigned int n_columns : {80, 160, 320})
      {
        Gap             gap(n_columns);
        const MeshWatch watch(gap.mesh.dofs(), dealii::MappingQ1<2>());
        double          smallest = 1., aspect = 1., seconds = 0.;
        unsigned int    n = 0;
        for (double distance = 1e-4 * um; distance < 2.5 * period;
             distance += distance < 1. * um ? 0.1 * distance : 0.0173 * um)
          {
            const SplineCurve       chip   = slid_chip(distance);
            const auto              start  = std::chrono::steady_clock::now();
            const ConvergenceReport report = gap.mesh.update(chip, gap.shift);
            if (!report.converged)
              {
                std::cout << report.reason << std::endl;
                return;
              }
            seconds += seconds_since(start);
            const MeshQuality quality = watch.quality(gap.mesh.displacement());
            smallest = std::min(smallest, quality.smallest_scaled_jacobian);
            aspect   = std::max(aspect, quality.largest_aspect_ratio);
            ++n;
            if (n_columns == 160)
              write_row(file,
                        "columns",
                        distance,
                        quality.smallest_scaled_jacobian);
          }
        gap.mesh.update(flat(0.), gap.shift);
        const Vector before = gap.mesh.displacement();
        gap.mesh.update(slid_chip(2. * period), gap.shift);
        double difference = 0.;
        for (const auto &node : gap.mesh.tool_nodes())
          difference = std::max(difference,
                                std::abs(gap.mesh.displacement()(node.dof_y) -
                                         before(node.dof_y)));
        std::cout << "| " << gap.mesh.chip_nodes().size() / 2 << " | " << n
                  << " | " << smallest << " | " << aspect << " | "
                  << difference / um << " | " << 1e6 * seconds / n << " |"
                  << std::endl;
      }
  }



  /** Sliding to and fro, 100 times over the given amplitude [m]. */
  void
  tabulate_cycles(const double amplitude)
  {
    for (const double exponent : {0., 1., 2.})
      {
        const ElasticGap gap(160, exponent);
        const Vector     start = gap.displacement(0.);
        double           drift = 0.;
        const auto       clock = std::chrono::steady_clock::now();
        for (unsigned int k = 1; k <= 2000; ++k)
          {
            Vector d =
              gap.displacement(amplitude * std::sin(2. * M_PI * k / 20.));
            if (k % 20 == 0)
              {
                d -= start;
                drift = std::max(drift, d.linfty_norm());
              }
          }
        std::cout << "exponent " << exponent << ": largest drift "
                  << drift / amplitude << " of the amplitude, "
                  << seconds_since(clock) / 2000. * 1e6 << " us an update"
                  << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession mpi(argc, argv);
  const std::string          directory = argc > 1 ? argv[1] : ".";
  std::ofstream              file(directory + "/mesh_motion.csv");
  file << "mesh,distance_um,scaled_jacobian\n";
  std::cout << "Sliding distance to the first inverted cell [um]\n";
  tabulate_elastic_distances();
  std::cout << "\nColumn mesh over 2.5 periods\n";
  slide_columns(file);
  std::cout << "\nElastic mesh, 100 cycles of sliding\n";
  tabulate_cycles(0.02 * um);
  write_elastic_curves(file);
}
