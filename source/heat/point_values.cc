#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/element_view.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  template <int dim>
  Vector
  values_at_points(const BasisTable<dim> &table, const Vector &coefficients)
  {
    Vector values(table.JxW.size());
    for (const auto &entry : table.elements)
      {
        const ElementView<dim> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            double value = 0.;
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              value += element.N(q, a) * coefficients(element.function(a));
            values(element.point(q)) = value;
          }
      }
    return values;
  }



  template <int dim>
  void
  add_point_values(const BasisTable<dim> &table,
                   const Vector          &values,
                   Vector                &result)
  {
    for (const auto &entry : table.elements)
      {
        const ElementView<dim> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          if (const double value = values(element.point(q)); value != 0.)
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              result(element.function(a)) += element.N(q, a) * value;
      }
  }



  template Vector
  values_at_points(const BasisTable<2> &, const Vector &);
  template Vector
  values_at_points(const BasisTable<3> &, const Vector &);
  template void
  add_point_values(const BasisTable<2> &, const Vector &, Vector &);
  template void
  add_point_values(const BasisTable<3> &, const Vector &, Vector &);
} // namespace asperity
