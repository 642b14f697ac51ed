#include <asperity/isogeometric/element_view.h>
#include <asperity/lubricant/void_volume.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  VoidVolume::VoidVolume(const SplineSpace<2>   &space,
                         const PatchGeometry<2> &geometry,
                         const SplineCurve      &tool)
    : tool(tool)
    , length(tool.period()[0])
    , n_dofs_(2 * space.n_functions())
    , table(tabulate_edge(space,
                          geometry,
                          Edge::top,
                          dealii::QGauss<1>(space.degree() + 1),
                          true))
    , ends(tabulate_edge(space,
                         geometry,
                         Edge::top,
                         dealii::QTrapezoid<1>(),
                         true))
  {
    const dealii::QGauss<1> gauss(tool.degree() / 2 + 1);
    tool_cumulative.push_back(0.);
    for (const BezierPiece &piece : tool.bezier_pieces())
      {
        if (tool_knots.empty())
          tool_knots.push_back(piece.begin);
        tool_knots.push_back(piece.end);
        const double width = piece.end - piece.begin;
        double       sum   = 0.;
        for (unsigned int q = 0; q < gauss.size(); ++q)
          sum += gauss.weight(q) *
                 tool.value(piece.begin + width * gauss.point(q)[0])[1];
        tool_cumulative.push_back(tool_cumulative.back() + width * sum);
      }
    measure(Vector(n_dofs_));
  }



  unsigned int
  VoidVolume::n_elements() const
  {
    return table.elements.size();
  }



  unsigned int
  VoidVolume::n_dofs() const
  {
    return n_dofs_;
  }



  double
  VoidVolume::parameter(const unsigned int element) const
  {
    return ends.parameter[ends.elements[element].first_point][0];
  }



  VoidVolume::Stretch
  VoidVolume::stretch(const double begin, const double end) const
  {
    // The element that starts nearest to s in [0, L].
    const auto nearest = [&](const double s) {
      unsigned int low = 0, high = n_elements();
      while (high - low > 1)
        {
          const unsigned int middle             = (low + high) / 2;
          (parameter(middle) <= s ? low : high) = middle;
        }
      const double next = high < n_elements() ? parameter(high) : length;
      return s - parameter(low) <= next - s ? low : high;
    };
    const unsigned int first = nearest(begin);
    const unsigned int last =
      end <= length ? nearest(end) : n_elements() + nearest(end - length);
    return {first % n_elements(), last - first};
  }



  VoidVolume::Stretch
  VoidVolume::period() const
  {
    return {0, n_elements()};
  }



  void
  VoidVolume::measure(const Vector &u)
  {
    point = table.position;
    tangent.resize(point.size());
    node.resize(n_elements());
    for (const auto &entry : table.elements)
      for (unsigned int q = 0; q < table.points_per_element; ++q)
        {
          const ElementView<2> element(table, entry);
          const unsigned int   i = element.point(q);
          tangent[i]             = table.tangent[i];
          element.add_displacement(q, u, point[i]);
          element.add_stretch(q, u, tangent[i]);
        }
    for (unsigned int e = 0; e < n_elements(); ++e)
      {
        const ElementView<2> element(ends, ends.elements[e]);
        node[e] = ends.position[element.point(0)];
        element.add_displacement(0, u, node[e]);
      }
  }



  double
  VoidVolume::gap(const unsigned int element) const
  {
    return tool.value(node[element][0])[1] - node[element][1];
  }



  double
  VoidVolume::position(const unsigned int element) const
  {
    return node[element][0];
  }



  bool
  VoidVolume::is_closed(const Stretch &s) const
  {
    return s.n == n_elements();
  }



  std::pair<unsigned int, double>
  VoidVolume::end_of(const Stretch &s) const
  {
    const unsigned int end = s.first + s.n;
    return end >= n_elements() ? std::make_pair(end - n_elements(), length) :
                                 std::make_pair(end, 0.);
  }



  double
  VoidVolume::tool_integral(const double x) const
  {
    const double turns = std::floor((x - tool_knots.front()) / length);
    const double t     = x - turns * length;
    const auto   upper =
      std::upper_bound(tool_knots.begin() + 1, tool_knots.end() - 1, t);
    const unsigned int      span  = upper - tool_knots.begin() - 1;
    const double            width = t - tool_knots[span];
    const dealii::QGauss<1> gauss(tool.degree() / 2 + 1);
    double                  sum = 0.;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      sum += gauss.weight(q) *
             tool.value(tool_knots[span] + width * gauss.point(q)[0])[1];
    return turns * tool_cumulative.back() + tool_cumulative[span] + width * sum;
  }



  double
  VoidVolume::volume(const Stretch &s) const
  {
    double below_chip = 0.;
    for (unsigned int k = 0; k < s.n; ++k)
      {
        const auto &element = table.elements[(s.first + k) % n_elements()];
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int i = element.first_point + q;
            below_chip += table.JxW[i] * point[i][1] * tangent[i][0];
          }
      }
    if (is_closed(s))
      return tool_cumulative.back() - below_chip;
    const auto end = end_of(s);
    return tool_integral(node[end.first][0] + end.second) -
           tool_integral(node[s.first][0]) - below_chip;
  }



  void
  VoidVolume::add_gradient(const Stretch &s,
                           const double   factor,
                           Vector        &g) const
  {
    for (unsigned int k = 0; k < s.n; ++k)
      {
        const ElementView<2> element(
          table, table.elements[(s.first + k) % n_elements()]);
        const unsigned int n = element.n_functions();
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int i = element.point(q);
            const double       w = factor * element.JxW(q);
            for (unsigned int a = 0; a < n; ++a)
              {
                g(element.dof(a, 0)) -=
                  w * point[i][1] * element.gradient(q, a)[0];
                g(element.dof(a, 1)) -= w * tangent[i][0] * element.N(q, a);
              }
          }
      }
    if (is_closed(s))
      return;
    const auto add_end = [&](const unsigned int e, const double sign) {
      const ElementView<2> element(ends, ends.elements[e]);
      const double         Y = tool.value(node[e][0])[1];
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        g(element.dof(a, 0)) += sign * factor * Y * element.N(0, a);
    };
    add_end(end_of(s).first, 1.);
    add_end(s.first, -1.);
  }



  void
  VoidVolume::add_hessian(const Stretch                &s,
                          const double                  factor,
                          dealii::SparseMatrix<double> &K) const
  {
    for (unsigned int k = 0; k < s.n; ++k)
      {
        const ElementView<2> element(
          table, table.elements[(s.first + k) % n_elements()]);
        const unsigned int n = element.n_functions();
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const double w = factor * element.JxW(q);
            for (unsigned int a = 0; a < n; ++a)
              for (unsigned int b = 0; b < n; ++b)
                {
                  // -(y_a x_b' + x_b' y_a), both halves of the symmetric form
                  const double value =
                    -w * element.N(q, a) * element.gradient(q, b)[0];
                  const unsigned int y = element.dof(a, 1);
                  const unsigned int x = element.dof(b, 0);
                  K.add(y, x, value);
                  K.add(x, y, value);
                }
          }
      }
    if (is_closed(s))
      return;
    const auto add_end = [&](const unsigned int e, const double sign) {
      const ElementView<2> element(ends, ends.elements[e]);
      const double         slope = tool.derivatives(node[e][0], 1)[1][1];
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        for (unsigned int b = 0; b < element.n_functions(); ++b)
          K.add(element.dof(a, 0),
                element.dof(b, 0),
                sign * factor * slope * element.N(0, a) * element.N(0, b));
    };
    add_end(end_of(s).first, 1.);
    add_end(s.first, -1.);
  }



  void
  VoidVolume::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &element : table.elements)
      for (const unsigned int a : element.functions)
        for (const unsigned int b : element.functions)
          for (unsigned int c = 0; c < 4; ++c)
            pattern.add(displacement_dof<2>(a, c / 2),
                        displacement_dof<2>(b, c % 2));
  }
} // namespace asperity
