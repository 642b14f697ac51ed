#include <asperity/base/archive.h>
#include <asperity/heat/body_continuation.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>
#include <set>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  BodyContinuation::BodyContinuation(const BasisTable<2>     &edge,
                                     const ThermalProperties &material,
                                     const double             period,
                                     const unsigned int       n_waves)
    : beyond(material, period, n_waves)
  {
    std::set<unsigned int> sorted;
    for (const auto &entry : edge.elements)
      sorted.insert(entry.functions.begin(), entry.functions.end());
    functions.assign(sorted.begin(), sorted.end());
    std::vector<double> x;
    for (const auto &position : edge.position)
      x.push_back(position[0]);
    dealii::LAPACKFullMatrix<double> f = beyond.basis().values(x);
    // A wave carries no heat on the whole, to the last bit.
    for (unsigned int m = 1; m < f.n(); ++m)
      {
        double mean = 0.;
        for (unsigned int q = 0; q < f.m(); ++q)
          mean += edge.JxW[q] * f(q, m) / period;
        for (unsigned int q = 0; q < f.m(); ++q)
          f(q, m) -= mean;
      }
    b.reinit(f.n(), functions.size());
    for (const auto &entry : edge.elements)
      {
        const ElementView<2> element(edge, entry);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const unsigned int column = std::lower_bound(functions.begin(),
                                                         functions.end(),
                                                         element.function(a)) -
                                        functions.begin();
            for (unsigned int q = 0; q < edge.points_per_element; ++q)
              for (unsigned int m = 0; m < f.n(); ++m)
                b(m, column) +=
                  f(element.point(q), m) * element.N(q, a) * element.JxW(q);
          }
      }
  }



  void
  BodyContinuation::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const unsigned int row : functions)
      pattern.add_entries(row, functions.begin(), functions.end(), true);
  }



  void
  BodyContinuation::begin_step(const double new_dt)
  {
    dt         = new_dt;
    response   = beyond.response(dt);
    remembered = beyond.remembered(dt);
  }



  void
  BodyContinuation::add_conductance(dealii::SparseMatrix<double> &matrix) const
  {
    for (unsigned int i = 0; i < functions.size(); ++i)
      for (unsigned int j = 0; j < functions.size(); ++j)
        {
          double sum = 0.;
          for (unsigned int m = 0; m < b.m(); ++m)
            sum += beyond.basis().norm(m) / response(m) * b(m, i) * b(m, j);
          matrix.add(functions[i], functions[j], sum);
        }
  }



  Vector
  BodyContinuation::flux(const Vector &rise) const
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



  void
  BodyContinuation::add_power(const Vector &rise, Vector &power) const
  {
    const Vector q = flux(rise);
    for (unsigned int i = 0; i < functions.size(); ++i)
      for (unsigned int m = 0; m < q.size(); ++m)
        power(functions[i]) -= b(m, i) * q(m);
  }



  void
  BodyContinuation::accept(const Vector &rise)
  {
    beyond.accept(flux(rise), dt);
  }



  double
  BodyContinuation::heat() const
  {
    return beyond.heat();
  }



  void
  BodyContinuation::save(OutputArchive &archive) const
  {
    beyond.save(archive);
  }



  void
  BodyContinuation::load(InputArchive &archive)
  {
    beyond.load(archive);
  }
} // namespace asperity
