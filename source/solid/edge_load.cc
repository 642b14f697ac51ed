#include <asperity/isogeometric/element_view.h>
#include <asperity/solid/edge_load.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  EdgeLoad::EdgeLoad(const SplineSpace<2>   &space,
                     const PatchGeometry<2> &geometry,
                     const Edge              edge,
                     const Kinematics        kinematics,
                     const unsigned int      n_quadrature)
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
  EdgeLoad::dead_traction(const SplineSpace<2>   &space,
                          const PatchGeometry<2> &geometry,
                          const Edge              edge,
                          const Traction         &traction,
                          const Kinematics        kinematics,
                          const unsigned int      n_quadrature)
  {
    EdgeLoad load(space, geometry, edge, kinematics, n_quadrature);
    for (unsigned int q = 0; q < load.table.position.size(); ++q)
      load.traction.push_back(
        traction(load.table.position[q], load.table.normal[q]));
    return load;
  }



  EdgeLoad
  EdgeLoad::follower_pressure(const SplineSpace<2>   &space,
                              const PatchGeometry<2> &geometry,
                              const Edge              edge,
                              const Pressure         &pressure,
                              const Kinematics        kinematics,
                              const unsigned int      n_quadrature)
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
              pattern.add(displacement_dof<2>(a, i), displacement_dof<2>(b, j));
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
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int point  = element.point(q);
            double             weight = factor_ * element.JxW(q);
            if (kinematics == Kinematics::axisymmetric)
              weight *= 2. * dealii::numbers::PI * table.position[point][0];
            element.add_force(q, -weight * traction[point], residual);
          }
      }
  }



  void
  EdgeLoad::add_follower(const BasisTable<2>::Element &entry,
                         const Vector                 &u,
                         Vector                       &residual,
                         dealii::SparseMatrix<double> *tangent) const
  {
    const bool axisymmetric = (kinematics == Kinematics::axisymmetric);
    const ElementView<2> element(table, entry);
    const unsigned int   n = element.n_functions();
    for (unsigned int q = 0; q < table.points_per_element; ++q)
      {
        const unsigned int point = element.point(q);

        // The derivative of x along the edge.
        Tensor<1, 2> stretch = table.tangent[point];
        double       radius  = table.position[point][0];
        element.add_stretch(q, u, stretch);
        for (unsigned int a = 0; a < n; ++a)
          radius += element.N(q, a) * u(element.dof(a, 0));
        const double circumference =
          axisymmetric ? 2. * dealii::numbers::PI : 1.;
        const double weight =
          factor_ * pressure[point] * element.JxW(q) * outward * circumference;
        const double ring         = axisymmetric ? radius : 1.;
        const double direction[2] = {stretch[1], -stretch[0]};
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            residual(element.dof(a, i)) +=
              weight * ring * element.N(q, a) * direction[i];
        if (tangent == nullptr)
          continue;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              const double turn =
                weight * ring * element.N(q, a) * element.gradient(q, b)[0];
              tangent->add(element.dof(a, 0), element.dof(b, 1), turn);
              tangent->add(element.dof(a, 1), element.dof(b, 0), -turn);
              if (axisymmetric)
                for (unsigned int i = 0; i < 2; ++i)
                  tangent->add(element.dof(a, i),
                               element.dof(b, 0),
                               weight * element.N(q, a) * element.N(q, b) *
                                 direction[i]);
            }
      }
  }
} // namespace asperity
