#include <asperity/solid/edge_load.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  EdgeLoad::EdgeLoad(const SplineSpace   &space,
                     const PatchGeometry &geometry,
                     const Edge           edge,
                     const Kinematics     kinematics,
                     const unsigned int   n_quadrature)
    : kinematics(kinematics)
    , table(tabulate_edge(
        space,
        geometry,
        edge,
        dealii::QGauss<1>(n_quadrature > 0 ? n_quadrature : space.degree() + 1),
        true))
    , outward((edge == Edge::bottom || edge == Edge::right) ? 1. : -1.)
  {}



  EdgeLoad
  EdgeLoad::dead_traction(const SplineSpace   &space,
                          const PatchGeometry &geometry,
                          const Edge           edge,
                          const Traction      &traction,
                          const Kinematics     kinematics,
                          const unsigned int   n_quadrature)
  {
    EdgeLoad load(space, geometry, edge, kinematics, n_quadrature);
    for (unsigned int q = 0; q < load.table.position.size(); ++q)
      load.traction.push_back(
        traction(load.table.position[q], load.table.normal[q]));
    return load;
  }



  EdgeLoad
  EdgeLoad::follower_pressure(const SplineSpace   &space,
                              const PatchGeometry &geometry,
                              const Edge           edge,
                              const Pressure      &pressure,
                              const Kinematics     kinematics,
                              const unsigned int   n_quadrature)
  {
    EdgeLoad load(space, geometry, edge, kinematics, n_quadrature);
    for (const auto &X : load.table.position)
      load.pressure.push_back(pressure(X));
    return load;
  }



  void
  EdgeLoad::set_factor(const double factor)
  {
    factor_ = factor;
  }



  double
  EdgeLoad::factor() const
  {
    return factor_;
  }



  void
  EdgeLoad::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    if (pressure.empty())
      return;
    for (const auto &element : table.elements)
      for (const unsigned int a : element.functions)
        for (const unsigned int b : element.functions)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              pattern.add(2 * a + i, 2 * b + j);
  }



  bool
  EdgeLoad::add(const Vector                 &u,
                Vector                       &residual,
                dealii::SparseMatrix<double> *tangent)
  {
    if (factor_ == 0.)
      return true;
    if (pressure.empty())
      add_dead(residual);
    else
      for (const auto &element : table.elements)
        add_follower(element, u, residual, tangent);
    return true;
  }



  void
  EdgeLoad::add_dead(Vector &residual) const
  {
    for (const auto &element : table.elements)
      {
        const unsigned int n = element.functions.size();
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int point  = element.first_point + q;
            double             weight = factor_ * table.JxW[point];
            if (kinematics == Kinematics::axisymmetric)
              weight *= 2. * dealii::numbers::PI * table.position[point][0];
            for (unsigned int a = 0; a < n; ++a)
              for (unsigned int c = 0; c < 2; ++c)
                residual(2 * element.functions[a] + c) -=
                  weight * element.values[q * n + a] * traction[point][c];
          }
      }
  }



  void
  EdgeLoad::add_follower(const BasisTable::Element    &element,
                         const Vector                 &u,
                         Vector                       &residual,
                         dealii::SparseMatrix<double> *tangent) const
  {
    const bool         axisymmetric = (kinematics == Kinematics::axisymmetric);
    const unsigned int n            = element.functions.size();
    for (unsigned int q = 0; q < table.points_per_element; ++q)
      {
        const unsigned int  point = element.first_point + q;
        const double       *N     = &element.values[q * n];
        const Tensor<1, 2> *dN    = &element.gradients[q * n];

        // The derivative of x along the edge. Before deformation it is the
        // unit tangent, a turn of the normal.
        const Tensor<1, 2> &normal = table.normal[point];
        Tensor<1, 2>        stretch;
        stretch[0]    = -outward * normal[1];
        stretch[1]    = outward * normal[0];
        double radius = table.position[point][0];
        for (unsigned int a = 0; a < n; ++a)
          {
            for (unsigned int c = 0; c < 2; ++c)
              stretch[c] += dN[a][0] * u(2 * element.functions[a] + c);
            radius += N[a] * u(2 * element.functions[a]);
          }
        const double circumference =
          axisymmetric ? 2. * dealii::numbers::PI : 1.;
        const double weight = factor_ * pressure[point] * table.JxW[point] *
                              outward * circumference;
        const double ring         = axisymmetric ? radius : 1.;
        const double direction[2] = {stretch[1], -stretch[0]};
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            residual(2 * element.functions[a] + i) +=
              weight * ring * N[a] * direction[i];
        if (tangent == nullptr)
          continue;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              const unsigned int row    = 2 * element.functions[a];
              const unsigned int column = 2 * element.functions[b];
              const double       turn   = weight * ring * N[a] * dN[b][0];
              tangent->add(row, column + 1, turn);
              tangent->add(row + 1, column, -turn);
              if (axisymmetric)
                for (unsigned int i = 0; i < 2; ++i)
                  tangent->add(row + i,
                               column,
                               weight * N[a] * N[b] * direction[i]);
            }
      }
  }
} // namespace asperity
