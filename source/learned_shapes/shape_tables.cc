#include "shape_tables.h"

#include <asperity/base/atomic_file.h>
#include <asperity/base/version.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

namespace asperity
{
  namespace
  {
    std::string
    cell(const double x)
    {
      return "," + shortest_decimal(x);
    }

    void
    write_reconstruction(const Reconstruction &shape, std::ostream &out)
    {
      if (shape.empty != 0.)
        out << ",,,,,,,false";
      else
        out << cell(shape.chamfer) << cell(shape.chamfer_squared)
            << cell(shape.largest) << cell(shape.measure)
            << cell(shape.true_measure) << cell(shape.euler)
            << (shape.closed != 0. ? ",true" : ",false");
    }

    const char *const reconstruction_columns =
      ",chamfer,chamfer_squared,largest_distance,measure,true_measure,"
      "euler_number,closed";



    /** Of those that have a surface. */
    template <typename Pick>
    std::vector<double>
    collect(const std::vector<Reconstruction> &shapes,
            const std::size_t                  begin,
            const std::size_t                  end,
            const Pick                        &pick)
    {
      std::vector<double> result;
      for (std::size_t i = begin; i < end; ++i)
        if (shapes[i].empty == 0.)
          result.push_back(pick(shapes[i]));
      return result;
    }

    std::size_t
    n_whole(const std::vector<Reconstruction> &shapes,
            const std::size_t                  begin,
            const std::size_t                  end)
    {
      return std::count_if(shapes.begin() + begin,
                           shapes.begin() + end,
                           [](const Reconstruction &shape) {
                             return shape.is_whole();
                           });
    }

    struct GroupStatistics
    {
      GroupStatistics(const std::vector<Reconstruction> &shapes,
                      const std::size_t                  begin,
                      const std::size_t                  end)
        : n(end - begin)
        , n_whole(asperity::n_whole(shapes, begin, end))
        , chamfer(collect(shapes,
                          begin,
                          end,
                          [](const Reconstruction &s) { return s.chamfer; }))
        , squared(
            collect(shapes,
                    begin,
                    end,
                    [](const Reconstruction &s) { return s.chamfer_squared; }))
        , measure(collect(shapes, begin, end, [](const Reconstruction &s) {
          return std::abs(s.measure / s.true_measure - 1.);
        }))
      {}

      std::size_t n, n_whole;
      Statistics  chamfer, squared, measure;

      nlohmann::ordered_json
      json() const
      {
        const auto of = [](const Statistics &s) {
          return nlohmann::ordered_json{{"mean", s.mean},
                                        {"median", s.median},
                                        {"largest", s.largest}};
        };
        return {{"shapes", n},
                {"whole", n_whole},
                {"chamfer", of(chamfer)},
                {"chamfer_squared", of(squared)},
                {"measure_error", of(measure)}};
      }
    };

    /** Trained, held out, interpolated, calculated. */
    std::vector<std::pair<std::string, GroupStatistics>>
    groups(const std::size_t n_trained, const ShapeResults &results)
    {
      std::vector<Reconstruction> between, calculated;
      for (const InterpolatedShape &shape : results.interpolation)
        between.push_back(shape.shape);
      for (const ShapeArithmetic &shape : results.arithmetic)
        calculated.push_back(shape.shape);
      const auto &shapes = results.shapes;
      return {{"trained", {shapes, 0, n_trained}},
              {"held out", {shapes, n_trained, shapes.size()}},
              {"interpolated", {between, 0, between.size()}},
              {"calculated", {calculated, 0, calculated.size()}}};
    }



    template <int dim>
    void
    write_shapes(const ShapeStudy<dim> &study,
                 const ShapeResults    &results,
                 std::ostream          &out)
    {
      const unsigned int n_code = study.model().decoder().shape().n_code;
      out << "shape,kind,trained" << reconstruction_columns
          << ",place_x,place_y";
      for (unsigned int c = 0; c < n_code; ++c)
        out << ",z_" << c;
      out << "\n";
      for (std::size_t i = 0; i < study.recipes().size(); ++i)
        {
          out << '"' << study.recipes()[i].name << "\","
              << name_of(study.recipes()[i].base)
              << (i < study.n_trained() ? ",true" : ",false");
          write_reconstruction(results.shapes[i], out);
          out << cell(results.places[2 * i]) << cell(results.places[2 * i + 1]);
          for (const float z : study.code(i))
            out << cell(z);
          out << "\n";
        }
    }



    template <int dim>
    void
    write_interpolation(const ShapeStudy<dim> &study,
                        const ShapeResults    &results,
                        std::ostream          &out)
    {
      out << "first,second,part" << reconstruction_columns << "\n";
      for (const InterpolatedShape &shape : results.interpolation)
        {
          out << '"' << study.recipes()[shape.first].name << "\",\""
              << study.recipes()[shape.second].name << '"' << cell(shape.part);
          write_reconstruction(shape.shape, out);
          out << "\n";
        }
    }



    template <int dim>
    void
    write_arithmetic(const ShapeStudy<dim> &study,
                     const ShapeResults    &results,
                     std::ostream          &out)
    {
      out << "deformed,minus,plus,expected" << reconstruction_columns << "\n";
      for (const ShapeArithmetic &shape : results.arithmetic)
        {
          for (const std::size_t i :
               {shape.deformed, shape.from, shape.to, shape.expected})
            out << (i == shape.deformed ? "\"" : ",\"")
                << study.recipes()[i].name << '"';
          write_reconstruction(shape.shape, out);
          out << "\n";
        }
    }



    /** The surfaces of some codes, those that have one. */
    template <int dim>
    void
    draw(const ShapeStudy<dim>                 &study,
         const std::vector<std::vector<float>> &codes,
         const std::string                     &path)
    {
      std::vector<BoundaryMesh<dim>> surfaces;
      std::vector<double>            numbers;
      for (std::size_t i = 0; i < codes.size(); ++i)
        if (auto surface = study.surface(codes[i]); surface)
          {
            surfaces.push_back(std::move(*surface));
            numbers.push_back(static_cast<double>(i));
          }
      write_atomically(path, [&](std::ostream &out) {
        write_surfaces(surfaces, numbers, "shape", out);
      });
    }
  } // namespace



  Statistics::Statistics(std::vector<double> numbers)
  {
    if (numbers.empty())
      return;
    std::sort(numbers.begin(), numbers.end());
    const std::size_t n = numbers.size();
    mean    = std::accumulate(numbers.begin(), numbers.end(), 0.) / n;
    median  = 0.5 * (numbers[(n - 1) / 2] + numbers[n / 2]);
    largest = numbers.back();
  }



  template <int dim>
  void
  write_results(const ShapeStudy<dim> &study,
                const ShapeResults    &results,
                const std::string     &directory)
  {
    study.model().write(directory + "/model.asperity");
    write_atomically(directory + "/shapes.csv", [&](std::ostream &out) {
      write_shapes(study, results, out);
    });
    write_atomically(directory + "/interpolation.csv", [&](std::ostream &out) {
      write_interpolation(study, results, out);
    });
    write_atomically(directory + "/arithmetic.csv", [&](std::ostream &out) {
      write_arithmetic(study, results, out);
    });
    std::vector<std::vector<float>> codes;
    for (std::size_t i = 0; i < study.recipes().size(); ++i)
      codes.push_back(study.code(i));
    draw(study, codes, directory + "/shapes.vtu");
    codes.clear();
    for (const InterpolatedShape &shape : results.interpolation)
      codes.push_back(shape.code);
    if (!codes.empty())
      draw(study, codes, directory + "/interpolation.vtu");
    nlohmann::ordered_json summary = {{"program", version_line()},
                                      {"dimension", dim},
                                      {"loss", results.loss}};
    for (const auto &[name, group] : groups(study.n_trained(), results))
      summary[name] = group.json();
    write_atomically(directory + "/summary.json", [&](std::ostream &out) {
      out << summary.dump(2) << "\n";
    });
  }



  template <int dim>
  void
  print_results(const ShapeStudy<dim> &study,
                const ShapeResults    &results,
                std::ostream          &out)
  {
    const auto old = out.precision(3);
    for (const auto &[name, group] : groups(study.n_trained(), results))
      {
        if (group.n == 0)
          continue;
        out << group.n << ' ' << name << ": " << group.n_whole
            << " whole and water-tight";
        if (name != "interpolated")
          out << "; Chamfer distance " << group.chamfer.mean << " on average, "
              << group.chamfer.median << " median; "
              << (dim == 2 ? "area" : "volume") << " off by "
              << 100. * group.measure.mean << " %";
        out << "\n";
      }
    out.precision(old);
  }



  template <int dim>
  void
  write_surfaces(const std::vector<BoundaryMesh<dim>> &surfaces,
                 const std::vector<double>            &numbers,
                 const std::string                    &name,
                 std::ostream                         &out)
  {
    std::size_t n_points = 0, n_cells = 0;
    for (const auto &surface : surfaces)
      {
        n_points += surface.vertices().size();
        n_cells += surface.simplices().size();
      }
    const auto begin_array = [&out](const std::string &type,
                                    const std::string &array,
                                    const std::string &further = "") {
      out << "<DataArray type=\"" << type << "\" Name=\"" << array << "\""
          << further << " format=\"ascii\">\n";
    };
    const char *const end_array = "</DataArray>\n";
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
           "version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
        << "<Piece NumberOfPoints=\"" << n_points << "\" NumberOfCells=\""
        << n_cells << "\">\n<Points>\n";
    begin_array("Float32", "Points", " NumberOfComponents=\"3\"");
    for (const auto &surface : surfaces)
      for (const auto &p : surface.vertices())
        out << static_cast<float>(p[0]) << ' ' << static_cast<float>(p[1])
            << ' ' << (dim == 3 ? static_cast<float>(p[dim - 1]) : 0.f) << "\n";
    out << end_array << "</Points>\n<Cells>\n";
    begin_array("Int64", "connectivity");
    std::size_t first = 0;
    for (const auto &surface : surfaces)
      {
        for (const auto &simplex : surface.simplices())
          for (unsigned int k = 0; k < dim; ++k)
            out << first + simplex[k] << (k + 1 < dim ? " " : "\n");
        first += surface.vertices().size();
      }
    out << end_array;
    begin_array("Int64", "offsets");
    for (std::size_t i = 1; i <= n_cells; ++i)
      out << dim * i << "\n";
    out << end_array;
    begin_array("UInt8", "types"); // of lines and triangles
    for (std::size_t i = 0; i < n_cells; ++i)
      out << (dim == 2 ? 3 : 5) << "\n";
    out << end_array << "</Cells>\n<CellData>\n";
    begin_array("Float32", name);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      for (std::size_t k = 0; k < surfaces[i].simplices().size(); ++k)
        out << numbers[i] << "\n";
    out << end_array
        << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }



  template void
  write_results(const ShapeStudy<2> &,
                const ShapeResults &,
                const std::string &);
  template void
  write_results(const ShapeStudy<3> &,
                const ShapeResults &,
                const std::string &);
  template void
  print_results(const ShapeStudy<2> &, const ShapeResults &, std::ostream &);
  template void
  print_results(const ShapeStudy<3> &, const ShapeResults &, std::ostream &);
} // namespace asperity
