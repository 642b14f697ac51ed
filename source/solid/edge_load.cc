#include <asperity/isogeometric/element_view.h>
#include <asperity/solid/edge_load.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  template <int dim>
  EdgeLoad<dim>::EdgeLoad(const SplineSpace<dim>   &space,
                          const PatchGeometry<dim> &geometry,
                          const Edge                edge,
                          const Kinematics          kinematics,
                          const unsigned int        n_quadrature)
    : kinematics(kinematics)
    , table(tabulate_edge(space,
                          geometry,
                          edge,
                          dealii::QGauss<dim - 1>(n_quadrature > 0 ?
                                                    n_quadrature :
                                                    space.degree() + 1),
                          true))
  {
    Assert(dim == 2 || kinematics != Kinematics::axisymmetric,
           dealii::ExcMessage("Only plane bodies turn around an axis."));
    Stretch tangents;
    std::copy_n(table.tangent.begin(), dim - 1, tangents.begin());
    outward = area_vector(tangents) * table.normal[0] > 0. ? 1. : -1.;
  }



  template <int dim>
  Tensor<1, dim>
  EdgeLoad<dim>::area_vector(const Stretch &stretch)
  {
    if constexpr (dim == 2)
      return dealii::cross_product_2d(stretch[0]); // the turn to the right
    else
      return dealii::cross_product_3d(stretch[0], stretch[1]);
  }



  template <int dim>
  Tensor<1, dim>
  EdgeLoad<dim>::area_change(const Stretch        &stretch,
                             const Tensor<1, dim> &gradient,
                             const unsigned int    j)
  {
    Tensor<1, dim> sum;
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        Stretch changed = stretch;
        changed[k]      = Tensor<1, dim>();
        changed[k][j]   = gradient[k];
        sum += area_vector(changed);
      }
    return sum;
  }



  template <int dim>
  EdgeLoad<dim>
  EdgeLoad<dim>::dead_traction(const SplineSpace<dim>   &space,
                               const PatchGeometry<dim> &geometry,
                               const Edge                edge,
                               const Traction           &traction,
                               const Kinematics          kinematics,
                               const unsigned int        n_quadrature)
  {
    EdgeLoad load(space, geometry, edge, kinematics, n_quadrature);
    for (unsigned int q = 0; q < load.table.position.size(); ++q)
      load.traction.push_back(
        traction(load.table.position[q], load.table.normal[q]));
    return load;
  }



  template <int dim>
  EdgeLoad<dim>
  EdgeLoad<dim>::follower_pressure(const SplineSpace<dim>   &space,
                                   const PatchGeometry<dim> &geometry,
                                   const Edge                edge,
                                   const Pressure           &pressure,
                                   const Kinematics          kinematics,
                                   const unsigned int        n_quadrature)
  {
    EdgeLoad load(space, geometry, edge, kinematics, n_quadrature);
    for (const auto &X : load.table.position)
      load.pressure.push_back(pressure(X));
    return load;
  }



  template <int dim>
  void
  EdgeLoad<dim>::set_factor(const double factor)
  {
    factor_ = factor;
  }



  template <int dim>
  double
  EdgeLoad<dim>::factor() const
  {
    return factor_;
  }



  template <int dim>
  void
  EdgeLoad<dim>::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    if (pressure.empty())
      return;
    for (const auto &element : table.elements)
      for (const unsigned int a : element.functions)
        for (const unsigned int b : element.functions)
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              pattern.add(displacement_dof<dim>(a, i),
                          displacement_dof<dim>(b, j));
  }



  template <int dim>
  bool
  EdgeLoad<dim>::add(const Vector                 &u,
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



  template <int dim>
  void
  EdgeLoad<dim>::add_dead(Vector &residual) const
  {
    for (const auto &entry : table.elements)
      {
        const ElementView<dim> element(table, entry);
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



  template <int dim>
  void
  EdgeLoad<dim>::add_follower(const typename BasisTable<dim>::Element &entry,
                              const Vector                            &u,
                              Vector                                  &residual,
                              dealii::SparseMatrix<double> *tangent) const
  {
    const bool axisymmetric = (kinematics == Kinematics::axisymmetric);
    const ElementView<dim> element(table, entry);
    const unsigned int     n = element.n_functions();
    for (unsigned int q = 0; q < table.points_per_element; ++q)
      {
        const unsigned int point = element.point(q);

        // The derivatives of x along the edge.
        Stretch stretch;
        double  radius = table.position[point][0];
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            stretch[k] = table.tangent[(dim - 1) * point + k];
            element.add_stretch(q, u, stretch[k], k);
          }
        for (unsigned int a = 0; a < n; ++a)
          radius += element.N(q, a) * u(element.dof(a, 0));
        const double circumference =
          axisymmetric ? 2. * dealii::numbers::PI : 1.;
        const double weight =
          factor_ * pressure[point] * element.JxW(q) * outward * circumference;
        const double         ring      = axisymmetric ? radius : 1.;
        const Tensor<1, dim> direction = area_vector(stretch);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            residual(element.dof(a, i)) +=
              weight * ring * element.N(q, a) * direction[i];
        if (tangent == nullptr)
          continue;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              for (unsigned int j = 0; j < dim; ++j)
                {
                  const Tensor<1, dim> change =
                    area_change(stretch, element.gradient(q, b), j);
                  for (unsigned int i = 0; i < dim; ++i)
                    tangent->add(element.dof(a, i),
                                 element.dof(b, j),
                                 weight * ring * element.N(q, a) * change[i]);
                }
              if (axisymmetric)
                for (unsigned int i = 0; i < dim; ++i)
                  tangent->add(element.dof(a, i),
                               element.dof(b, 0),
                               weight * element.N(q, a) * element.N(q, b) *
                                 direction[i]);
            }
      }
  }



  template class EdgeLoad<2>;
  template class EdgeLoad<3>;
} // namespace asperity
