#include <asperity/base/errors.h>
#include <asperity/coupling/interface.h>
#include <asperity/isogeometric/edge_trace.h>
#include <asperity/splines/closest_point.h>

#include <cmath>
#include <limits>

namespace asperity
{
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  std::vector<EdgePoint>
  find_on_edges(const SplineSpace<2>        &space,
                const PatchGeometry<2>      &geometry,
                const std::vector<Edge>     &edges,
                const std::vector<Point<2>> &positions,
                const double                 tolerance)
  {
    std::vector<EdgePoint> places(positions.size());
    std::vector<double>    distance(positions.size(),
                                 std::numeric_limits<double>::infinity());
    for (const Edge edge : edges)
      {
        const ClosestPoint closest(
          EdgeTrace(*space.hierarchy(), edge).curve(geometry.offset));
        for (unsigned int i = 0; i < positions.size(); ++i)
          {
            const Projection projection = closest.project(positions[i]);
            if (std::abs(projection.distance) < distance[i])
              {
                distance[i] = std::abs(projection.distance);
                places[i]   = {edge, projection.parameter};
              }
          }
      }
    for (unsigned int i = 0; i < positions.size(); ++i)
      if (!(distance[i] <= tolerance))
        throw InputError("The fluid's wall node at (" +
                         std::to_string(positions[i][0]) + ", " +
                         std::to_string(positions[i][1]) + ") m is " +
                         std::to_string(distance[i]) +
                         " m away from the solid's edges; expected at most " +
                         std::to_string(tolerance) + " m.");
    return places;
  }



  namespace
  {
    Point<2>
    patch_parameter(const SplineHierarchy<2> &hierarchy, const EdgePoint &place)
    {
      const unsigned int along =
        (place.edge == Edge::left || place.edge == Edge::right) ? 1 : 0;
      const KnotVector &across = hierarchy.knots(0, 1 - along);
      Point<2>          parameter;
      parameter[along] = place.parameter;
      parameter[1 - along] =
        (place.edge == Edge::left || place.edge == Edge::bottom) ?
          across.front() :
          across.back();
      return parameter;
    }
  } // namespace



  Interface::Interface(const SplineSpace<2>         &space,
                       const PatchGeometry<2>       &geometry,
                       const std::vector<EdgePoint> &points)
    : n_dofs(2 * space.n_functions())
  {
    std::vector<double> N;
    for (const EdgePoint &place : points)
      {
        const Point<2> parameter = patch_parameter(*space.hierarchy(), place);
        const unsigned int cell  = space.find_cell(parameter);
        const auto        &functions = space.cell_functions(cell);
        space.evaluate(cell, parameter, N);
        Row row;
        for (unsigned int a = 0; a < N.size(); ++a)
          if (N[a] != 0.)
            row.emplace_back(functions[a], N[a]);
        rows.push_back(row);
        positions.push_back(geometry.position(space, parameter));
      }
  }



  unsigned int
  Interface::n_points() const
  {
    return rows.size();
  }



  Vector
  Interface::interpolate(const Vector &u) const
  {
    AssertDimension(u.size(), n_dofs);
    Vector values(2 * n_points());
    for (unsigned int i = 0; i < n_points(); ++i)
      for (const auto &[a, N] : rows[i])
        for (unsigned int c = 0; c < 2; ++c)
          values(2 * i + c) += N * u(displacement_dof<2>(a, c));
    return values;
  }



  void
  Interface::add_loads(const Vector &force, Vector &loads) const
  {
    AssertDimension(force.size(), 2 * n_points());
    AssertDimension(loads.size(), n_dofs);
    for (unsigned int i = 0; i < n_points(); ++i)
      for (const auto &[a, N] : rows[i])
        for (unsigned int c = 0; c < 2; ++c)
          loads(displacement_dof<2>(a, c)) += N * force(2 * i + c);
  }



  const std::vector<Point<2>> &
  Interface::reference_positions() const
  {
    return positions;
  }



  InterfaceLoad::InterfaceLoad(const Interface &interface)
    : interface(interface)
    , force(2 * interface.n_points())
  {}



  void
  InterfaceLoad::set_force(const Vector &new_force)
  {
    force = new_force;
    force *= -1.;
  }



  void
  InterfaceLoad::add_couplings(dealii::DynamicSparsityPattern &) const
  {
    // A dead load has no tangent.
  }



  bool
  InterfaceLoad::add(const Vector &,
                     Vector &residual,
                     dealii::SparseMatrix<double> *)
  {
    interface.add_loads(force, residual);
    return true;
  }
} // namespace asperity
