#include "flow_snapshots.h"

#include <asperity/postprocess/hdf5_file.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace learned_flows
{
  Vector
  to_vector(const std::vector<double> &values)
  {
    Vector result(values.size());
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }



  void
  FlowSnapshots::write(const std::string &path) const
  {
    Hdf5Content content;
    Hdf5Table   table{solutions.size(), solutions.front().size(), {}};
    for (const auto &solution : solutions)
      table.values.insert(table.values.end(), solution.begin(), solution.end());
    content.tables["solutions"] = table;
    content.tables["inputs"]    = {inputs.size(), 1, inputs};
    content.write(path);
  }



  FlowSnapshots
  FlowSnapshots::read(const std::string &path)
  {
    const Hdf5Content content = Hdf5Content::read(path, "snapshots of a flow");
    const Hdf5Table  &table   = content.tables.at("solutions");
    FlowSnapshots     result;
    result.inputs = content.table("inputs", 1, path).values;
    for (std::size_t i = 0; i < table.n_rows; ++i)
      {
        const auto begin = table.values.begin() + i * table.n_columns;
        result.solutions.emplace_back(begin, begin + table.n_columns);
      }
    return result;
  }



  std::vector<double>
  LearnedFlow::weights() const
  {
    const FluidSpace               &space = flow().space();
    const dealii::FiniteElement<2> &fe    = space.dofs().get_fe();
    const dealii::QGaussLobatto<2>  lobatto(space.degree() + 1);
    const std::vector<Point<2>>     points = fe.get_unit_support_points();
    std::vector<double>             of_points(points.size(), 1e-12);
    for (unsigned int i = 0; i < points.size(); ++i)
      if (fe.system_to_component_index(i).first < 2)
        for (unsigned int q = 0; q < lobatto.size(); ++q)
          if (points[i].distance(lobatto.point(q)) < 1e-8)
            of_points[i] = lobatto.weight(q);
    dealii::FEValues<2> values(flow().mapping(),
                               fe,
                               dealii::Quadrature<2>(points, of_points),
                               dealii::update_JxW_values);
    std::vector<double> result(space.dofs().n_dofs(), 0.);
    std::vector<dealii::types::global_dof_index> dofs(points.size());
    for (const auto &cell : space.cells())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < points.size(); ++i)
          result[dofs[i]] += values.JxW(i);
      }
    return result;
  }



  template <typename Function>
  void
  LearnedFlow::for_each_node(const std::vector<double> *solution,
                             const Function            &f) const
  {
    const FluidSpace               &space  = flow().space();
    const dealii::FiniteElement<2> &fe     = space.dofs().get_fe();
    const auto                      points = fe.get_unit_support_points();
    dealii::FEValues<2>             values(flow().mapping(),
                               fe,
                               dealii::Quadrature<2>(points),
                               dealii::update_quadrature_points |
                                 dealii::update_values);
    const dealii::FEValuesExtractors::Scalar     pressure(2);
    std::vector<dealii::types::global_dof_index> dofs(points.size());
    std::vector<double>                          pressures(points.size(), 0.);
    const Vector                                 all =
      to_vector(solution == nullptr ? std::vector<double>() : *solution);
    for (const auto &cell : space.cells())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        if (solution != nullptr)
          values[pressure].get_function_values(all, pressures);
        for (unsigned int i = 0; i < points.size(); ++i)
          f(dofs[i],
            fe.system_to_component_index(i).first,
            values.quadrature_point(i),
            pressures[i]);
      }
  }



  LearnedFlow::VelocityNodes
  LearnedFlow::velocity_nodes() const
  {
    // A node's two unknowns have one place.
    std::map<unsigned int, Point<2>>              of_u;
    std::map<std::pair<long, long>, unsigned int> v_at;
    const auto                                    key = [](const Point<2> &x) {
      return std::make_pair(std::lround(1e9 * x[0]), std::lround(1e9 * x[1]));
    };
    for_each_node(nullptr,
                  [&](const unsigned int dof,
                      const unsigned int component,
                      const Point<2>    &x,
                      const double) {
                    if (component == 0)
                      of_u[dof] = x;
                    else if (component == 1)
                      v_at[key(x)] = dof;
                  });
    VelocityNodes nodes;
    for (const auto &[dof, x] : of_u)
      {
        nodes.positions.push_back(x[0]);
        nodes.positions.push_back(x[1]);
        nodes.u.push_back(dof);
        nodes.v.push_back(v_at.at(key(x)));
      }
    return nodes;
  }



  LearnedFlow::PressureNodes
  LearnedFlow::pressure_nodes() const
  {
    std::map<unsigned int, Point<2>> places;
    for_each_node(nullptr,
                  [&](const unsigned int dof,
                      const unsigned int component,
                      const Point<2>    &x,
                      const double) {
                    if (component == 2)
                      places[dof] = x;
                  });
    PressureNodes nodes;
    for (const auto &[dof, x] : places)
      {
        nodes.positions.push_back(x[0]);
        nodes.positions.push_back(x[1]);
        nodes.p.push_back(dof);
      }
    return nodes;
  }



  std::vector<double>
  LearnedFlow::pressure_at_velocity_nodes(
    const std::vector<double> &solution) const
  {
    std::map<unsigned int, double> pressures; // by the first unknown of a node
    for_each_node(&solution,
                  [&](const unsigned int dof,
                      const unsigned int component,
                      const Point<2> &,
                      const double p) {
                    if (component == 0)
                      pressures[dof] = p;
                  });
    std::vector<double> result;
    for (const auto &[dof, p] : pressures)
      result.push_back(p);
    return result;
  }
} // namespace learned_flows
