#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/element_view.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  Vector
  values_at_points(const BasisTable<2> &table, const Vector &coefficients)
  {
    Vector values(table.JxW.size());
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
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



  void
  add_point_values(const BasisTable<2> &table,
                   const Vector        &values,
                   Vector              &result)
  {
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          if (const double value = values(element.point(q)); value != 0.)
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              result(element.function(a)) += element.N(q, a) * value;
      }
  }
} // namespace asperity
