#include <asperity/lubricant/sheet_void.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  SheetVoid::Rule::Rule(const unsigned int n_nodes, const unsigned int n_points)
  {
    const dealii::QGauss<1> gauss(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
      {
        weight.push_back(gauss.weight(q));
        value.emplace_back();
        derivative.emplace_back();
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            const dealii::Polynomials::LagrangeEquidistant lagrange(n_nodes - 1,
                                                                    k);
            std::vector<double>                            of_point(2);
            lagrange.value(gauss.point(q)[0], of_point);
            value.back().push_back(of_point[0]);
            derivative.back().push_back(of_point[1]);
          }
      }
  }



  SheetVoid::Part
  SheetVoid::below_chip(const unsigned int element,
                        const bool         with_hessian) const
  {
    const unsigned int n = table.points_per_element;
    const Point<3>    *x =
      position.data() + table.elements[entry[element]].first_point;
    Part part;
    part.gradient.reinit(3 * n);
    if (with_hessian)
      part.hessian.reinit(3 * n, 3 * n);
    std::vector<double> L(n), L_s(n), L_t(n);
    for (unsigned int r = 0; r < face_rule.weight.size(); ++r)
      for (unsigned int q = 0; q < face_rule.weight.size(); ++q)
        {
          Tensor<1, 3> at, along_s, along_t;
          for (unsigned int k = 0; k < n; ++k)
            {
              const unsigned int i = k % n_nodes, j = k / n_nodes;
              L[k]   = face_rule.value[q][i] * face_rule.value[r][j];
              L_s[k] = face_rule.derivative[q][i] * face_rule.value[r][j];
              L_t[k] = face_rule.value[q][i] * face_rule.derivative[r][j];
              at += L[k] * x[k];
              along_s += L_s[k] * x[k];
              along_t += L_t[k] * x[k];
            }
          const double w = face_rule.weight[q] * face_rule.weight[r],
                       J = along_s[0] * along_t[1] - along_t[0] * along_s[1];
          part.value += w * at[2] * J;
          for (unsigned int k = 0; k < n; ++k)
            {
              const double J_x = L_s[k] * along_t[1] - L_t[k] * along_s[1],
                           J_y = along_s[0] * L_t[k] - along_t[0] * L_s[k];
              part.gradient(3 * k) += w * at[2] * J_x;
              part.gradient(3 * k + 1) += w * at[2] * J_y;
              part.gradient(3 * k + 2) += w * J * L[k];
              if (!with_hessian)
                continue;
              for (unsigned int l = 0; l < n; ++l)
                {
                  const double z_x = w * L[l] * J_x, z_y = w * L[l] * J_y,
                               x_y = w * at[2] *
                                     (L_s[k] * L_t[l] - L_t[k] * L_s[l]);
                  part.hessian(3 * k, 3 * l + 2) += z_x;
                  part.hessian(3 * l + 2, 3 * k) += z_x;
                  part.hessian(3 * k + 1, 3 * l + 2) += z_y;
                  part.hessian(3 * l + 2, 3 * k + 1) += z_y;
                  part.hessian(3 * k, 3 * l + 1) += x_y;
                  part.hessian(3 * l + 1, 3 * k) += x_y;
                }
            }
        }
    return part;
  }



  SheetVoid::Part
  SheetVoid::along_edge(const unsigned int element,
                        const unsigned int edge,
                        const bool         of_period,
                        const bool         with_hessian) const
  {
    const unsigned int n    = table.points_per_element,
                       step = edge == 0 ? n_nodes : 1; // between its nodes
    const Point<3> *x =
      position.data() + table.elements[entry[element]].first_point;
    Part part;
    part.gradient.reinit(3 * n);
    if (with_hessian)
      part.hessian.reinit(3 * n, 3 * n);
    for (unsigned int q = 0; q < edge_rule.weight.size(); ++q)
      {
        Point<2> at;
        double   dy = 0.;
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            at[0] += edge_rule.value[q][k] * x[k * step][0];
            at[1] += edge_rule.value[q][k] * x[k * step][1];
            dy += edge_rule.derivative[q][k] * x[k * step][1];
          }
        const SheetIntegral::Values of =
          of_period ? integral.over_period(at[1]) : integral.at(at);
        const SheetJet Z = of_period ? SheetJet() : tool.jet(at);
        part.value += edge_rule.weight[q] * of.P * dy;
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            const unsigned int a = 3 * k * step;
            const double       N = edge_rule.value[q][k],
                         D       = edge_rule.derivative[q][k];
            part.gradient(a) += edge_rule.weight[q] * Z.height * dy * N;
            part.gradient(a + 1) +=
              edge_rule.weight[q] * (of.P_y * dy * N + of.P * D);
            if (!with_hessian)
              continue;
            for (unsigned int l = 0; l < n_nodes; ++l)
              {
                const unsigned int b = 3 * l * step;
                const double       M = edge_rule.value[q][l],
                             E       = edge_rule.derivative[q][l];
                const double x_y =
                  edge_rule.weight[q] *
                  (Z.gradient[1] * dy * N * M + Z.height * N * E);
                part.hessian(a, b) +=
                  edge_rule.weight[q] * Z.gradient[0] * dy * N * M;
                part.hessian(a, b + 1) += x_y;
                part.hessian(b + 1, a) += x_y;
                part.hessian(a + 1, b + 1) +=
                  edge_rule.weight[q] *
                  (of.P_yy * dy * N * M + of.P_y * (N * E + D * M));
              }
          }
      }
    return part;
  }
} // namespace asperity
