#include <asperity/base/atomic_file.h>
#include <asperity/postprocess/field_picture.h>
#include <asperity/postprocess/polyline.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "lagrange_values.h"
#include "vtu_patches.h"

namespace asperity
{
  namespace
  {
    /** A field of a picture at the Gauss points. */
    struct PointField
    {
      std::string         name;
      std::vector<double> values;
    };

    const std::vector<double> &
    field_of(const FieldSnapshots                   &about,
             const std::vector<std::vector<double>> &values,
             const std::string                      &name)
    {
      const std::size_t f = about.find(name);
      if (f == about.fields.size() || f >= values.size())
        throw ComputationError("The fields have no " + quoted_name(name) +
                               ", so that there is no picture.");
      return values[f];
    }

    /** sqrt(3/2 s : s), s the deviator of xx, yy, zz, xy. */
    double
    equivalent(const double *stress)
    {
      const double mean = (stress[0] + stress[1] + stress[2]) / 3.;
      double       sum  = 2. * stress[3] * stress[3];
      for (unsigned int i = 0; i < 3; ++i)
        sum += (stress[i] - mean) * (stress[i] - mean);
      return std::sqrt(1.5 * sum);
    }

    std::vector<double>
    component(const std::vector<double> &values,
              const unsigned int         n,
              const unsigned int         i)
    {
      std::vector<double> result;
      for (std::size_t at = i; at < values.size(); at += n)
        result.push_back(values[at]);
      return result;
    }

    std::vector<PointField>
    point_fields(const FieldSnapshots                   &about,
                 const std::vector<std::vector<double>> &values)
    {
      std::vector<PointField> result;
      result.push_back({field_names::plastic_strain,
                        field_of(about, values, field_names::plastic_strain)});
      result.push_back({"temperature [degC]",
                        field_of(about, values, field_names::temperature)});
      for (double &T : result.back().values)
        T -= 273.15;
      const std::vector<double> &stress =
        field_of(about, values, field_names::stress);
      const char *const names[] = {"xx", "yy", "zz", "xy"};
      for (unsigned int i = 0; i < 4; ++i)
        result.push_back({std::string("stress ") + names[i] + " [Pa]",
                          component(stress, 4, i)});
      result.push_back({"von Mises stress [Pa]", {}});
      for (std::size_t at = 0; at < stress.size(); at += 4)
        result.back().values.push_back(equivalent(&stress[at]));
      return result;
    }

    /** Through the Gauss points of a cell, limited to their range. */
    void
    fill_row(const double              *values,
             const unsigned int         n_gauss,
             const unsigned int         n_lines,
             const std::vector<double> &lagrange,
             const unsigned int         row,
             dealii::Table<2, float>   &data)
    {
      const auto [low, high] =
        std::minmax_element(values, values + n_gauss * n_gauss);
      for (unsigned int i = 0; i < n_lines * n_lines; ++i)
        {
          double value = 0.;
          for (unsigned int g = 0; g < n_gauss * n_gauss; ++g)
            value += lagrange[i % n_lines * n_gauss + g % n_gauss] *
                     lagrange[i / n_lines * n_gauss + g / n_gauss] * values[g];
          data(row, i) = std::clamp(value, *low, *high);
        }
    }

    /** "traction [Pa] x" */
    std::string
    column_name(const FieldKind &kind, const unsigned int i)
    {
      return kind.n_components == 1 ? kind.name :
                                      kind.name + " " + "xyz"[i % 3];
    }
  } // namespace



  void
  write_chip_fields(std::ostream                           &out,
                    const FieldSnapshots                   &about,
                    const std::vector<std::vector<double>> &values,
                    const FieldMoment                      &moment)
  {
    const FieldPlaces         &places = about.places;
    const std::vector<double> &u =
      field_of(about, values, field_names::displacement);
    const std::vector<PointField> fields = point_fields(about, values);
    internal::PatchRows<2>        rows;
    rows.add_vector("displacement [m]");
    for (const PointField &field : fields)
      rows.add_scalar(field.name);

    const unsigned int n_lines = places.n_subdivisions + 1,
                       n_nodes = n_lines * n_lines,
                       n_gauss = places.n_gauss * places.n_gauss;
    const std::vector<double> lagrange =
      internal::lagrange_values(places.n_subdivisions, places.n_gauss);
    std::vector<dealii::DataOutBase::Patch<2, 2>> patches;
    for (unsigned int cell = 0; cell < places.n_cells(); ++cell)
      {
        patches.push_back(rows.make_patch<2>(places.n_subdivisions, n_nodes));
        dealii::Table<2, float> &data = patches.back().data;
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            {
              const std::size_t node = cell * n_nodes + i;
              data(c, i) =
                u[2 * node + c] + (c == 0 ? moment.sliding_distance : 0.);
              data(rows.n_fields() + c, i) =
                places.nodes[3 * node + c] + data(c, i);
            }
        for (std::size_t f = 0; f < fields.size(); ++f)
          fill_row(&fields[f].values[cell * n_gauss],
                   places.n_gauss,
                   n_lines,
                   lagrange,
                   2 + f,
                   data);
      }
    rows.write<2>(patches, moment.time, moment.step, out);
  }



  void
  write_edge_fields(std::ostream                           &out,
                    const FieldSnapshots                   &about,
                    const std::vector<std::vector<double>> &values,
                    const FieldMoment                      &moment)
  {
    const std::vector<double> &u =
      field_of(about, values, field_names::edge_displacement);
    Polyline line;
    for (std::size_t q = 0; q < about.places.n_places(PlaceKind::edge); ++q)
      line.points.emplace_back(about.places.edge[3 * q] + u[2 * q] +
                                 moment.sliding_distance,
                               about.places.edge[3 * q + 1] + u[2 * q + 1]);
    for (std::size_t f = 0; f < about.fields.size(); ++f)
      {
        const FieldKind &kind = about.fields[f];
        if (kind.places != PlaceKind::edge)
          continue;
        if (kind.n_components == 1)
          {
            line.scalars.emplace_back(kind.name, values[f]);
            continue;
          }
        line.vectors.push_back({kind.name, {}});
        for (std::size_t at = 0; at < values[f].size(); at += 2)
          line.vectors.back().second.push_back(
            dealii::Tensor<1, 2>({values[f][at], values[f][at + 1]}));
      }
    write_polyline(out, line, moment.time, moment.step);
  }



  std::vector<std::string>
  edge_columns(const FieldSnapshots &about)
  {
    std::vector<std::string> columns = {"x [m]", "y [m]", "weight [m]"};
    for (const FieldKind &kind : about.fields)
      for (unsigned int i = 0;
           kind.places == PlaceKind::edge && i < kind.n_components;
           ++i)
        columns.push_back(column_name(kind, i));
    return columns;
  }



  void
  write_edge_table(std::ostream                           &out,
                   const FieldSnapshots                   &about,
                   const std::vector<std::vector<double>> &values)
  {
    out << join(edge_columns(about), ",") << "\n";
    for (std::size_t q = 0; q < about.places.n_places(PlaceKind::edge); ++q)
      {
        std::vector<std::string> row;
        for (unsigned int i = 0; i < 3; ++i)
          row.push_back(shortest_decimal(about.places.edge[3 * q + i]));
        for (std::size_t f = 0; f < about.fields.size(); ++f)
          for (unsigned int i = 0; about.fields[f].places == PlaceKind::edge &&
                                   i < about.fields[f].n_components;
               ++i)
            row.push_back(shortest_decimal(
              values[f][q * about.fields[f].n_components + i]));
        out << join(row, ",") << "\n";
      }
  }
} // namespace asperity
