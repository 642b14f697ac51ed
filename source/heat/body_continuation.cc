#include <asperity/base/archive.h>
#include <asperity/heat/body_continuation.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>
#include <set>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  template <int dim>
  BodyContinuation<dim>::BodyContinuation(const BasisTable<dim>   &edge,
                                          const ThermalProperties &material,
                                          const FourierBasis<dim> &waves)
    : beyond(material, waves)
  {
    std::set<unsigned int> sorted;
    for (const auto &entry : edge.elements)
      sorted.insert(entry.functions.begin(), entry.functions.end());
    functions.assign(sorted.begin(), sorted.end());
    const FourierValues<dim> f(waves, places_along(edge.position));
    // A wave carries no heat on the whole, to the last bit.
    Vector mean = f.sums(Vector(edge.JxW.begin(), edge.JxW.end()));
    mean /= waves.area();
    mean(0) = 0.;
    b.reinit(waves.size(), functions.size());
    for (const auto &entry : edge.elements)
      {
        const ElementView<dim> element(edge, entry);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const unsigned int column = std::lower_bound(functions.begin(),
                                                         functions.end(),
                                                         element.function(a)) -
                                        functions.begin();
            for (unsigned int q = 0; q < edge.points_per_element; ++q)
              for (unsigned int m = 0; m < b.m(); ++m)
                b(m, column) += (f(element.point(q), m) - mean(m)) *
                                element.N(q, a) * element.JxW(q);
          }
      }
  }



  template <int dim>
  void
  BodyContinuation<dim>::add_couplings(
    dealii::DynamicSparsityPattern &pattern) const
  {
    for (const unsigned int row : functions)
      pattern.add_entries(row, functions.begin(), functions.end(), true);
  }



  template <int dim>
  void
  BodyContinuation<dim>::begin_step(const double new_dt)
  {
    dt         = new_dt;
    response   = beyond.response(dt);
    remembered = beyond.remembered(dt);
  }



  template <int dim>
  void
  BodyContinuation<dim>::add_conductance(
    dealii::SparseMatrix<double> &matrix) const
  {
    dealii::FullMatrix<double> weighted(b), sum(functions.size());
    for (unsigned int m = 0; m < b.m(); ++m)
      for (unsigned int i = 0; i < functions.size(); ++i)
        weighted(m, i) *= beyond.basis().norm(m) / response(m);
    weighted.Tmmult(sum, b);
    for (unsigned int i = 0; i < functions.size(); ++i)
      matrix.add(functions[i],
                 functions.size(),
                 functions.data(),
                 &sum(i, 0),
                 true,
                 true);
  }



  template <int dim>
  Vector
  BodyContinuation<dim>::flux(const Vector &rise) const
  {
    Vector q(b.m());
    for (unsigned int m = 0; m < q.size(); ++m)
      {
        double theta = 0.;
        for (unsigned int i = 0; i < functions.size(); ++i)
          theta += b(m, i) * rise(functions[i]);
        q(m) = (beyond.basis().norm(m) * theta - remembered(m)) / response(m);
      }
    return q;
  }



  template <int dim>
  void
  BodyContinuation<dim>::add_power(const Vector &rise, Vector &power) const
  {
    const Vector q = flux(rise);
    for (unsigned int i = 0; i < functions.size(); ++i)
      for (unsigned int m = 0; m < q.size(); ++m)
        power(functions[i]) -= b(m, i) * q(m);
  }



  template <int dim>
  void
  BodyContinuation<dim>::accept(const Vector &rise)
  {
    beyond.accept(flux(rise), dt);
  }



  template <int dim>
  double
  BodyContinuation<dim>::heat() const
  {
    return beyond.heat();
  }



  template <int dim>
  void
  BodyContinuation<dim>::save(OutputArchive &archive) const
  {
    beyond.save(archive);
  }



  template <int dim>
  void
  BodyContinuation<dim>::load(InputArchive &archive)
  {
    beyond.load(archive);
  }



  template class BodyContinuation<2>;
  template class BodyContinuation<3>;
} // namespace asperity
