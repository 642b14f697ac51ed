#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/spline_sheet.h>

#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;

  SplineSheet::SplineSheet(const std::array<KnotVector, 2> &knot_vectors,
                           const std::vector<double>       &coefficients)
    : knot_vectors(knot_vectors)
    , coefficients_(coefficients)
  {
    for (const KnotVector &knots : knot_vectors)
      if (!knots.is_periodic())
        throw InputError("A sheet was given open knots, but periodic ones are "
                         "expected in both directions.");
    const std::size_t n =
      std::size_t(knot_vectors[0].n_basis()) * knot_vectors[1].n_basis();
    if (coefficients.size() != n)
      throw InputError("A sheet has " + std::to_string(coefficients.size()) +
                       " coefficients, but its basis expects " +
                       std::to_string(n) + ".");
  }



  const KnotVector &
  SplineSheet::knot_vector(const unsigned int direction) const
  {
    return knot_vectors[direction];
  }



  unsigned int
  SplineSheet::degree(const unsigned int direction) const
  {
    return knot_vectors[direction].degree();
  }



  double
  SplineSheet::period(const unsigned int direction) const
  {
    return knot_vectors[direction].back() - knot_vectors[direction].front();
  }



  const std::vector<double> &
  SplineSheet::coefficients() const
  {
    return coefficients_;
  }



  double
  SplineSheet::value(const Point<2> &place) const
  {
    return jet(place).height;
  }



  SheetJet
  SplineSheet::jet(const Point<2> &place) const
  {
    std::array<std::vector<unsigned int>, 2>        functions;
    std::array<std::vector<std::vector<double>>, 2> basis;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const KnotVector  &knots   = knot_vectors[d];
        const double       wrapped = knots.wrap(place[d]);
        const unsigned int span    = knots.find_span(wrapped);
        functions[d]               = knots.span_functions(span);
        basis[d]                   = knots.evaluate(span, wrapped, 2);
      }
    SheetJet           jet;
    const unsigned int n = knot_vectors[0].n_basis();
    for (unsigned int b = 0; b < functions[1].size(); ++b)
      {
        double along_x[3] = {};
        for (unsigned int a = 0; a < functions[0].size(); ++a)
          for (unsigned int k = 0; k < 3; ++k)
            along_x[k] +=
              basis[0][k][a] *
              coefficients_[std::size_t(functions[1][b]) * n + functions[0][a]];
        jet.height += basis[1][0][b] * along_x[0];
        jet.gradient[0] += basis[1][0][b] * along_x[1];
        jet.gradient[1] += basis[1][1][b] * along_x[0];
        jet.hessian[0][0] += basis[1][0][b] * along_x[2];
        jet.hessian[0][1] += basis[1][1][b] * along_x[1];
        jet.hessian[1][1] += basis[1][2][b] * along_x[0];
      }
    return jet;
  }



  std::vector<SheetPiece>
  SplineSheet::bezier_pieces() const
  {
    const auto         Cx = bezier_extraction(knot_vectors[0]);
    const auto         Cy = bezier_extraction(knot_vectors[1]);
    const unsigned int nx = degree(0) + 1, ny = degree(1) + 1;

    std::vector<SheetPiece> pieces;
    pieces.reserve(Cx.size() * Cy.size());
    std::vector<double> along_x(nx * ny); // Bernstein in x, B-spline in y
    for (unsigned int v = 0; v < Cy.size(); ++v)
      for (unsigned int u = 0; u < Cx.size(); ++u)
        {
          const auto columns = knot_vectors[0].span_functions(u);
          const auto rows    = knot_vectors[1].span_functions(v);
          for (unsigned int b = 0; b < ny; ++b)
            for (unsigned int k = 0; k < nx; ++k)
              {
                along_x[b * nx + k] = 0.;
                for (unsigned int a = 0; a < nx; ++a)
                  along_x[b * nx + k] +=
                    Cx[u](a, k) *
                    coefficients_[std::size_t(rows[b]) * Cx.size() +
                                  columns[a]];
              }
          SheetPiece piece;
          for (unsigned int d = 0; d < 2; ++d)
            {
              const unsigned int span = (d == 0 ? u : v);
              piece.begin[d]          = knot_vectors[d].breakpoints()[span];
              piece.end[d]            = knot_vectors[d].breakpoints()[span + 1];
            }
          piece.heights.resize(nx * ny);
          for (unsigned int l = 0; l < ny; ++l)
            for (unsigned int k = 0; k < nx; ++k)
              for (unsigned int b = 0; b < ny; ++b)
                piece.heights[l * nx + k] += Cy[v](b, l) * along_x[b * nx + k];
          pieces.push_back(piece);
        }
    return pieces;
  }



  double
  SplineSheet::mean() const
  {
    // The integral of a B-spline is the length of its support over degree + 1.
    std::array<std::vector<double>, 2> weights;
    for (unsigned int d = 0; d < 2; ++d)
      for (unsigned int i = 0; i < knot_vectors[d].n_basis(); ++i)
        weights[d].push_back((knot_vectors[d].knots()[i + degree(d) + 1] -
                              knot_vectors[d].knots()[i]) /
                             (degree(d) + 1) / period(d));
    double sum = 0.;
    for (unsigned int j = 0; j < weights[1].size(); ++j)
      for (unsigned int i = 0; i < weights[0].size(); ++i)
        sum += weights[0][i] * weights[1][j] *
               coefficients_[std::size_t(j) * weights[0].size() + i];
    return sum;
  }



  SplineSheet
  SplineSheet::mapped(const double factor, const double offset) const
  {
    SplineSheet result = *this;
    for (double &coefficient : result.coefficients_)
      coefficient = factor * coefficient + offset;
    return result;
  }



  SplineSheet
  extrude(const SplineCurve &curve,
          const double       width,
          const unsigned int n_spans_y)
  {
    const KnotVector &knots    = curve.knot_vector();
    bool              is_graph = curve.is_periodic() && !curve.is_rational() &&
                    curve.period()[0] == knots.back() - knots.front() &&
                    curve.period()[1] == 0.;
    const std::vector<double> positions = knots.greville();
    for (unsigned int i = 0; i < positions.size() && is_graph; ++i)
      is_graph = std::abs(curve.control_points()[i][0] - positions[i]) <=
                 1e-12 * curve.period()[0];
    if (!is_graph)
      throw InputError("A sheet is to be made of a curve that is no periodic "
                       "graph, but a curve whose parameter is x is expected.");
    std::vector<double> coefficients;
    for (unsigned int j = 0; j < n_spans_y; ++j)
      for (const Point<2> &point : curve.control_points())
        coefficients.push_back(point[1]);
    return SplineSheet(
      {{knots,
        KnotVector::uniform_periodic(curve.degree(), n_spans_y, 0., width)}},
      coefficients);
  }
} // namespace asperity
