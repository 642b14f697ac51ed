#include <asperity/base/errors.h>
#include <asperity/lubricant/film_edge.h>

#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    /** The starts of equal parts of [0, 1], each followed by Gauss points in
     *  the part; the starts have no weight. */
    dealii::Quadrature<1>
    starts_and_gauss_points(const unsigned int n_parts,
                            const unsigned int n_gauss)
    {
      const dealii::QGauss<1>       gauss(n_gauss);
      std::vector<dealii::Point<1>> points;
      std::vector<double>           weights;
      for (unsigned int part = 0; part < n_parts; ++part)
        {
          points.emplace_back(double(part) / n_parts);
          weights.push_back(0.);
          for (unsigned int q = 0; q < n_gauss; ++q)
            {
              points.emplace_back((part + gauss.point(q)[0]) / n_parts);
              weights.push_back(gauss.weight(q) / n_parts);
            }
        }
      return dealii::Quadrature<1>(points, weights);
    }
  } // namespace



  FilmEdge::FilmEdge(const SplineSpace<2>   &space,
                     const PatchGeometry<2> &geometry,
                     const SplineCurve      &tool,
                     const FilmGap          &gap,
                     const unsigned int      cells_per_span)
    : tool(tool)
    , film_gap(gap)
    , cells_per_span(cells_per_span)
    , n_gauss(space.degree() + 1)
    , table(tabulate_edge(space,
                          geometry,
                          Edge::top,
                          starts_and_gauss_points(cells_per_span, n_gauss),
                          true))
    , x(table.position.size())
    , stretch(x.size())
    , thickness(x.size())
    , thickness_slope(x.size())
    , tool_slope(x.size())
  {
    if (!space.is_periodic(0) || !tool.is_periodic())
      throw InputError("A lubricant film needs a chip and a tool that are "
                       "periodic in x.");
    if (!(gap.residual > 0.))
      throw InputError("The residual film must be thicker than zero.");
  }



  unsigned int
  FilmEdge::n_cells() const
  {
    return table.elements.size() * cells_per_span;
  }



  double
  FilmEdge::period() const
  {
    return tool.period()[0];
  }



  ElementView<2>
  FilmEdge::element_of(const unsigned int cell) const
  {
    return {table, table.elements[cell / cells_per_span]};
  }



  unsigned int
  FilmEdge::first_point(const unsigned int cell) const
  {
    return element_of(cell).point(0) + (cell % cells_per_span) * (n_gauss + 1);
  }



  unsigned int
  FilmEdge::local_point(const unsigned int cell, const unsigned int point) const
  {
    return point - element_of(cell).point(0);
  }



  bool
  FilmEdge::measure(const dealii::Vector<double> &u,
                    const Tensor<1, 2>           &tool_offset)
  {
    for (const auto &entry : table.elements)
      for (unsigned int q = 0; q < table.points_per_element; ++q)
        {
          const ElementView<2> element(table, entry);
          const unsigned int   i = element.point(q);
          x[i]                   = table.position[i];
          stretch[i]             = table.tangent[i];
          element.add_displacement(q, u, x[i]);
          element.add_stretch(q, u, stretch[i]);
          const auto        seen = x[i] - tool_offset;
          const auto        at   = tool.locate(seen[0]);
          const DistanceJet Y    = tool.jet(at, seen[0], seen[1]);
          thickness[i]           = film_gap.value(Y.ry);
          thickness_slope[i]     = film_gap.slope(Y.ry);
          tool_slope[i]          = Y.y1 / tool.parameter_scale(at.piece);
          if (!(stretch[i][0] > 0.))
            return false;
        }
    for (unsigned int cell = 1; cell < n_cells(); ++cell)
      if (!(position(cell) > position(cell - 1)))
        return false;
    return position(0) + period() > position(n_cells() - 1);
  }



  double
  FilmEdge::parameter(const unsigned int cell) const
  {
    return table.parameter[first_point(cell)][0];
  }



  double
  FilmEdge::reference_length(const unsigned int cell) const
  {
    double length = 0.;
    for (unsigned int k = 1; k <= n_gauss; ++k)
      length += table.JxW[first_point(cell) + k];
    return length;
  }



  double
  FilmEdge::volume(const unsigned int cell) const
  {
    double volume = 0.;
    for (unsigned int k = 1; k <= n_gauss; ++k)
      {
        const unsigned int i = first_point(cell) + k;
        volume += table.JxW[i] * thickness[i] * stretch[i][0];
      }
    return volume;
  }



  SparseGradient
  FilmEdge::volume_gradient(const unsigned int cell) const
  {
    const ElementView<2> element = element_of(cell);
    SparseGradient       gradient;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      {
        double by_x = 0., by_y = 0.;
        for (unsigned int k = 1; k <= n_gauss; ++k)
          {
            const unsigned int i  = first_point(cell) + k;
            const unsigned int q  = local_point(cell, i);
            const double       N  = element.N(q, a);
            const double       dN = element.gradient(q, a)[0];
            const double       moved =
              table.JxW[i] * thickness_slope[i] * stretch[i][0] * N;
            by_x += moved * tool_slope[i] + table.JxW[i] * thickness[i] * dN;
            by_y -= moved;
          }
        gradient.emplace_back(element.dof(a, 0), by_x);
        gradient.emplace_back(element.dof(a, 1), by_y);
      }
    return gradient;
  }



  double
  FilmEdge::position(const unsigned int face) const
  {
    return x[first_point(face)][0];
  }



  SparseGradient
  FilmEdge::position_gradient(const unsigned int face) const
  {
    const ElementView<2> element = element_of(face);
    const unsigned int   q       = local_point(face, first_point(face));
    SparseGradient       gradient;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      gradient.emplace_back(element.dof(a, 0), element.N(q, a));
    return gradient;
  }



  double
  FilmEdge::gap(const unsigned int face) const
  {
    return thickness[first_point(face)];
  }



  SparseGradient
  FilmEdge::gap_gradient(const unsigned int face) const
  {
    const unsigned int i = first_point(face);
    SparseGradient     gradient;
    for (const auto &[dof, N] : position_gradient(face))
      {
        gradient.emplace_back(dof, thickness_slope[i] * tool_slope[i] * N);
        gradient.emplace_back(dof + 1, -thickness_slope[i] * N);
      }
    return gradient;
  }



  SparseGradient
  FilmEdge::area_vector(const unsigned int cell) const
  {
    const ElementView<2> element = element_of(cell);
    SparseGradient       area;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      {
        Tensor<1, 2> sum;
        for (unsigned int k = 1; k <= n_gauss; ++k)
          {
            const unsigned int i = first_point(cell) + k;
            const double       weight =
              table.JxW[i] * element.N(local_point(cell, i), a);
            sum[0] -= weight * stretch[i][1];
            sum[1] += weight * stretch[i][0];
          }
        for (unsigned int c = 0; c < 2; ++c)
          area.emplace_back(element.dof(a, c), sum[c]);
      }
    return area;
  }



  std::vector<unsigned int>
  FilmEdge::cell_dofs(const unsigned int cell) const
  {
    std::vector<unsigned int> dofs;
    const ElementView<2>      element = element_of(cell);
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        dofs.push_back(element.dof(a, c));
    return dofs;
  }
} // namespace asperity
