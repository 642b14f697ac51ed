#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/lubricant/sheet_void.h>

#include <deal.II/base/quadrature.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Points by which edges, where the tool may have knots, are integrated
     *  beside those that the polynomials of the chip ask for. */
    constexpr unsigned int further_points = 3;

    /** Equidistant nodes of an element, along x fastest. */
    dealii::Quadrature<2>
    nodes_of_element(const unsigned int n)
    {
      std::vector<Point<2>> points;
      for (unsigned int l = 0; l < n; ++l)
        for (unsigned int k = 0; k < n; ++k)
          points.emplace_back(k / (n - 1.), l / (n - 1.));
      return {points, std::vector<double>(points.size(), 1.)};
    }
  } // namespace



  SheetVoid::SheetVoid(const SplineSpace<3>              &space,
                       const PatchGeometry<3>            &geometry,
                       const SplineSheet                 &tool,
                       const std::array<unsigned int, 2> &size)
    : tool(tool)
    , integral(tool)
    , whole_tool(tool.mean() * tool.period(0) * tool.period(1))
    , n_dofs_(3 * space.n_functions())
    , size_(size)
    , n_nodes(space.degree() + 1)
    , face_rule(n_nodes, (3 * space.degree() + 1) / 2)
    , edge_rule(n_nodes, n_nodes + further_points)
  {
    if (size[0] > 0)
      tabulate(space, geometry);
    else
      {
        table = tabulate_edge(
          space, geometry, Edge::top, nodes_of_element(n_nodes), true);
        const auto last = table.points_per_element - 1;
        for (unsigned int d = 0; d < 2; ++d)
          size_[d] = std::lround(tool.period(d) / (table.parameter[last][d] -
                                                   table.parameter[0][d]));
      }
    for (unsigned int d = 0; d < 2; ++d)
      width[d] = tool.period(d) / size_[d];
    AssertDimension(n_elements(), table.elements.size());
    entry.resize(n_elements());
    for (unsigned int i = 0; i < table.elements.size(); ++i)
      {
        const Point<3> &begin = table.parameter[table.elements[i].first_point];
        entry[std::lround(begin[0] / width[0]) +
              std::lround(begin[1] / width[1]) * size_[0]] = i;
      }
    measure(Vector(n_dofs_));
  }



  void
  SheetVoid::tabulate(const SplineSpace<3>   &space,
                      const PatchGeometry<3> &geometry)
  {
    const auto   hierarchy   = space.hierarchy();
    const double height      = hierarchy->knots(0, 2).back();
    const auto   nodes       = nodes_of_element(n_nodes);
    table.points_per_element = nodes.size();
    std::vector<double> values;
    for (unsigned int e = 0; e < n_elements(); ++e)
      {
        const Point<3> centre((e % size_[0] + 0.5) * tool.period(0) / size_[0],
                              (e / size_[0] + 0.5) * tool.period(1) / size_[1],
                              height);
        const unsigned int     cell = space.find_cell(centre);
        BasisTable<3>::Element element;
        element.cell        = cell;
        element.first_point = table.parameter.size();
        const auto rows     = trace_rows(*hierarchy, cell, Edge::top);
        for (const unsigned int row : rows)
          element.functions.push_back(space.cell_functions(cell)[row]);
        for (const Point<2> &node : nodes.get_points())
          {
            const Point<3> x((e % size_[0] + node[0]) * tool.period(0) /
                               size_[0],
                             (e / size_[0] + node[1]) * tool.period(1) /
                               size_[1],
                             height);
            hierarchy->evaluate(cell, x, values);
            for (const unsigned int row : rows)
              element.values.push_back(values[row]);
            table.parameter.push_back(x);
            table.position.push_back(geometry.position(space, x));
          }
        table.elements.push_back(element);
      }
    table.JxW.assign(table.parameter.size(), 0.);
  }



  const std::array<unsigned int, 2> &
  SheetVoid::size() const
  {
    return size_;
  }



  unsigned int
  SheetVoid::n_elements() const
  {
    return size_[0] * size_[1];
  }



  unsigned int
  SheetVoid::n_dofs() const
  {
    return n_dofs_;
  }



  unsigned int
  SheetVoid::element_at(const Point<2> &parameter) const
  {
    std::array<unsigned int, 2> at;
    for (unsigned int d = 0; d < 2; ++d)
      at[d] = std::min(static_cast<unsigned int>(parameter[d] / width[d]),
                       size_[d] - 1);
    return at[0] + at[1] * size_[0];
  }



  void
  SheetVoid::measure(const Vector &u)
  {
    position = table.position;
    for (const auto &of_table : table.elements)
      {
        const ElementView<3> element(table, of_table);
        for (unsigned int k = 0; k < table.points_per_element; ++k)
          element.add_displacement(k, u, position[element.point(k)]);
      }
  }



  double
  SheetVoid::gap(const unsigned int element) const
  {
    const Point<3> &node = position[table.elements[entry[element]].first_point];
    return tool.value(Point<2>(node[0], node[1])) - node[2];
  }



  std::array<double, 3>
  SheetVoid::weights_of_edges(const unsigned int               e,
                              const std::vector<unsigned int> &region,
                              const std::vector<double>       &factors) const
  {
    const unsigned int i = e % size_[0], j = e / size_[0];
    const unsigned int before_x = i > 0 ? e - 1 : e + size_[0] - 1,
                       before_y =
                         j > 0 ? e - size_[0] : e + (size_[1] - 1) * size_[0];
    const double here = factors[region[e]], at_x = factors[region[before_x]],
                 at_y = factors[region[before_y]];
    // counterclockwise around each
    return {{at_x - here, here - at_y, i > 0 ? 0. : at_x}};
  }



  template <typename Add>
  void
  SheetVoid::for_all_parts(const std::vector<unsigned int> &region,
                           const std::vector<double>       &factors,
                           const bool                       with_hessian,
                           const Add                       &add) const
  {
    const bool is_whole = factors.size() == 1;
    for (unsigned int e = 0; e < n_elements(); ++e)
      {
        if (factors[region[e]] != 0.)
          add(below_chip(e, with_hessian), -factors[region[e]], e);
        if (is_whole)
          continue;
        const auto weights = weights_of_edges(e, region, factors);
        for (unsigned int edge = 0; edge < 3; ++edge)
          if (weights[edge] != 0.)
            add(along_edge(e, edge % 2, edge == 2, with_hessian),
                weights[edge],
                e);
      }
  }



  std::vector<double>
  SheetVoid::volumes(const std::vector<unsigned int> &region,
                     const unsigned int               n) const
  {
    std::vector<double> volumes;
    for (unsigned int of = 0; of < n; ++of)
      {
        std::vector<double> factors(n, 0.);
        factors[of] = 1.;
        double sum  = n == 1 ? whole_tool : 0.;
        for_all_parts(region,
                      factors,
                      false,
                      [&](const Part &part, const double weight, unsigned int) {
                        sum += weight * part.value;
                      });
        volumes.push_back(sum);
      }
    return volumes;
  }



  void
  SheetVoid::add_gradient(const std::vector<unsigned int> &region,
                          const unsigned int               of,
                          const double                     factor,
                          Vector                          &g) const
  {
    const unsigned int  n = *std::max_element(region.begin(), region.end()) + 1;
    std::vector<double> factors(n, 0.);
    factors[of] = factor;
    for_all_parts(
      region,
      factors,
      false,
      [&](const Part &part, const double weight, const unsigned int e) {
        const ElementView<3> element(table, table.elements[entry[e]]);
        for (unsigned int k = 0; k < table.points_per_element; ++k)
          for (unsigned int a = 0; a < element.n_functions(); ++a)
            for (unsigned int c = 0; c < 3; ++c)
              g(element.dof(a, c)) +=
                weight * part.gradient(3 * k + c) * element.N(k, a);
      });
  }



  void
  SheetVoid::add_hessian(const std::vector<unsigned int> &region,
                         const std::vector<double>       &factors,
                         dealii::SparseMatrix<double>    &K) const
  {
    const unsigned int n_points = table.points_per_element;
    for_all_parts(
      region,
      factors,
      true,
      [&](const Part &part, const double weight, const unsigned int e) {
        const ElementView<3>       element(table, table.elements[entry[e]]);
        const unsigned int         n = 3 * element.n_functions();
        dealii::FullMatrix<double> N(3 * n_points, n), HN(3 * n_points, n),
          local(n, n);
        std::vector<unsigned int> dofs;
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int c = 0; c < 3; ++c)
            {
              dofs.push_back(element.dof(a, c));
              for (unsigned int k = 0; k < n_points; ++k)
                N(3 * k + c, 3 * a + c) = element.N(k, a);
            }
        part.hessian.mmult(HN, N);
        N.Tmmult(local, HN);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            K.add(dofs[a], dofs[b], weight * local(a, b));
      });
  }



  void
  SheetVoid::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &element : table.elements)
      for (const unsigned int a : element.functions)
        for (const unsigned int b : element.functions)
          for (unsigned int c = 0; c < 9; ++c)
            pattern.add(displacement_dof<3>(a, c / 3),
                        displacement_dof<3>(b, c % 3));
  }
} // namespace asperity
