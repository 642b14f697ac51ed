#include <asperity/contact/sheet_obstacle.h>

namespace asperity
{
  SheetObstacle::SheetObstacle(const SplineSheet &sheet)
    : sheet(sheet)
  {}



  GapPoint<3>
  SheetObstacle::gap(const dealii::Point<3> &x, dealii::Point<2> &hint) const
  {
    for (unsigned int i = 0; i < 50; ++i)
      {
        const SheetJet s = sheet.jet(hint);
        dealii::Tensor<1, 2> d;
        d[0] = hint[0] - x[0]; d[1] = hint[1] - x[1];
        const double h = s.height - x[2];
        const dealii::Tensor<1, 2> g = d + h * s.gradient;
        dealii::SymmetricTensor<2, 2> H;
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int b = a; b < 2; ++b)
            H[a][b] = (a == b ? 1. : 0.) + s.gradient[a] * s.gradient[b] + h * s.hessian[a][b];
        const dealii::Tensor<1, 2> step = invert(H) * g;
        hint -= step;
        if (step.norm() < 1e-14 * sheet.period(0)) break;
      }
    const SheetJet s = sheet.jet(hint);
    GapPoint<3> gap;
    gap.normal[0] = s.gradient[0]; gap.normal[1] = s.gradient[1]; gap.normal[2] = -1.;
    const double size = gap.normal.norm();
    gap.normal /= size;
    dealii::Tensor<1, 3> foot; foot[0] = hint[0]; foot[1] = hint[1]; foot[2] = s.height;
    gap.gap = (x - dealii::Point<3>(foot)) * gap.normal;
    // shape
    dealii::Tensor<1, 3> e1, e2;
    e1[0] = 1.; e1[2] = s.gradient[0]; e2[1] = 1.; e2[2] = s.gradient[1];
    dealii::Tensor<1, 3> a = e1 / e1.norm(), b = e2 - (e2 * a) * a; b /= b.norm();
    // second form in a,b
    dealii::Tensor<2, 2> J; // e_i = J_ij {a,b}
    J[0][0] = e1 * a; J[0][1] = e1 * b; J[1][0] = e2 * a; J[1][1] = e2 * b;
    const dealii::Tensor<2, 2> Ji = invert(J);
    dealii::SymmetricTensor<2, 2> II;
    for (unsigned int p = 0; p < 2; ++p) for (unsigned int q = p; q < 2; ++q) {
      double v = 0; for (unsigned int i = 0; i < 2; ++i) for (unsigned int j = 0; j < 2; ++j) v += Ji[p][i] * s.hessian[i][j] / size * Ji[q][j];
      II[p][q] = v; }
    // outward normal -z: bulging towards the body (down) is positive hessian
    const auto eig = eigenvectors(II, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned int k = 0; k < 2; ++k) {
      gap.curvature[k] = eig[k].first;
      gap.direction[k] = eig[k].second[0] * a + eig[k].second[1] * b; }
    return gap;
  }
} // namespace asperity
