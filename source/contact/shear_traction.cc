#include <asperity/contact/shear_traction.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    template <int dim>
    double
    largest_element(const BasisTable<dim> &table)
    {
      double largest = 0.;
      for (const auto &element : table.elements)
        {
          double measure = 0.;
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            measure += table.JxW[element.first_point + q];
          largest = std::max(largest, measure);
        }
      return dim == 2 ? largest : std::sqrt(largest);
    }

    /** The tangents of a point and how they turn. */
    template <int dim>
    void
    set_tangents(const GapPoint<dim>  &gap,
                 const Tensor<1, dim> &motion,
                 SlipPoint<dim>       &p)
    {
      const Tensor<1, dim> &n = gap.normal;
      if constexpr (dim == 2)
        p.tangent[0] = turned(n);
      else
        {
          p.tangent[0] = motion - (n * motion) * n;
          p.tangent[0] /= p.tangent[0].norm();
          p.tangent[1] = dealii::cross_product_3d(n, p.tangent[0]);
        }
      for (unsigned int k = 0; k < dim - 1; ++k)
        {
          p.turn[k] = Tensor<1, dim>();
          for (unsigned int m = 0; m < dim - 1; ++m)
            p.turn[k] += gap.normal_rotation(m) *
                         (gap.direction[m] * p.tangent[k]) * gap.direction[m];
        }
      if constexpr (dim == 3)
        {
          const double along = n * motion;
          p.spin = -along / std::sqrt(1. - along * along) * p.turn[1];
        }
    }
  } // namespace



  template <int dim>
  ShearTraction<dim>::ShearTraction(const TractionSpace<dim>    &tractions,
                                    const BasisTable<dim>       &table,
                                    const InterfaceParameters   &parameters,
                                    const double                 penalty,
                                    const double                 element_length,
                                    const std::array<double, 2> &direction)
    : tractions(tractions)
    , table(table)
    , law(parameters)
    , penalty(parameters.stick_penalty * penalty)
    , transition(parameters.transition * (element_length > 0. ?
                                            element_length :
                                            largest_element(table)))
    , mean_k(tractions.size(), 0.)
    , mean_wet(tractions.size(), 0.)
    , closed_until(table.JxW.size(), 0.)
    , start{std::vector<double>((dim - 1) * tractions.size(), 0.),
            std::vector<double>(tractions.size(), 0.),
            table.position}
    , position(table.position)
    , slip_(table.JxW.size())
    , gap(table.JxW.size())
    , pressure(tractions.size(), 0.)
    , sticks(tractions.size(), false)
  {
    for (unsigned int k = 0; k < dim - 1; ++k)
      motion[k] = direction[k];
    const std::vector<double> zero(tractions.size(), 0.);
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        mean_slip[k] = traction[k] = by_gap[k] = by_touching[k] = zero;
        by_slip[k].fill(zero);
        point_traction[k].assign(table.JxW.size(), 0.);
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::measure(const std::vector<Point<dim>>    &positions,
                              const std::vector<GapPoint<dim>> &gaps)
  {
    position = positions;
    gap      = gaps;
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        const Tensor<1, dim> &n   = gap[q].normal;
        const Tensor<1, dim>  way = position[q] - start.positions[q];
        SlipPoint<dim>       &p   = slip_[q];
        set_tangents(gap[q], motion, p);
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            p.slip[k]        = p.tangent[k] * way;
            p.by_position[k] = p.tangent[k] - (n * way) * p.turn[k];
          }
        if constexpr (dim == 3)
          {
            p.by_position[0] += p.slip[1] * p.spin;
            p.by_position[1] -= p.slip[0] * p.spin;
          }
        // Without a kink, of which Newton's method would make a stop.
        const double open = (gap[q].gap - closed_until[q]) / transition;
        const double t    = std::clamp(1. - open, 0., 1.);
        p.touching        = t * t * (3. - 2. * t);
        p.closing         = -6. * t * (1. - t) / transition;
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::return_map(const std::vector<ContactPressure> &pressures)
  {
    std::vector<double> slip(slip_.size()), touching(slip_.size());
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        for (unsigned int q = 0; q < slip_.size(); ++q)
          slip[q] = slip_[q].slip[k];
        mean_slip[k] = tractions.means(slip);
      }
    for (unsigned int q = 0; q < slip_.size(); ++q)
      touching[q] = slip_[q].touching;
    const std::vector<double> mean_touching = tractions.means(touching);
    for (unsigned int a = 0; a < pressure.size(); ++a)
      {
        pressure[a]               = pressures[a].value;
        const ShearStrength limit = law.strength(
          {pressures[a].value, mean_k[a], mean_touching[a], mean_wet[a]});
        return_to(limit, pressures[a].slope, mean_touching[a], a);
      }
    for (unsigned int k = 0; k < dim - 1; ++k)
      point_traction[k] = tractions.at_points(traction[k]);
  }



  template <int dim>
  void
  ShearTraction<dim>::return_to(const ShearStrength &limit,
                                const double         pressure_slope,
                                const double         mean_touching,
                                const unsigned int   a)
  {
    Tensor<1, dim - 1> trial, e;
    for (unsigned int k = 0; k < dim - 1; ++k)
      trial[k] =
        start.tractions[k * pressure.size() + a] + penalty * mean_slip[k][a];
    const double size = trial.norm();
    e[0]              = 1.;
    if (size > 0.)
      e = trial / size;
    sticks[a] = size < limit.value;
    // Where all points are closed or all are open none is closing.
    const bool is_closing = mean_touching > 0. && mean_touching < 1.;
    // By the trial along e nothing grows, across it what turns.
    const double turns = size > 0. ? penalty * limit.value / size : 0.;
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        traction[k][a] = sticks[a] ? trial[k] : e[k] * limit.value;
        by_gap[k][a] =
          sticks[a] ? 0. : e[k] * limit.by_pressure * pressure_slope;
        by_touching[k][a] =
          sticks[a] || !is_closing ? 0. : e[k] * limit.by_touching;
        for (unsigned int l = 0; l < dim - 1; ++l)
          {
            const double unit = k == l ? 1. : 0.;
            by_slip[k][l][a] =
              sticks[a] ? penalty * unit : turns * (unit - e[k] * e[l]);
          }
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::evaluate(const std::vector<Point<dim>>      &positions,
                               const std::vector<GapPoint<dim>>   &gaps,
                               const std::vector<ContactPressure> &pressures)
  {
    measure(positions, gaps);
    return_map(pressures);
  }



  template <int dim>
  void
  ShearTraction<dim>::add_residual(dealii::Vector<double> &residual) const
  {
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      {
        if (!tractions.is_own(e))
          continue;
        const ElementView<dim> element(table, table.elements[e]);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          for (unsigned int k = 0; k < dim - 1; ++k)
            {
              const unsigned int point = element.point(q);
              if (point_traction[k][point] != 0.)
                element.add_force(q,
                                  point_traction[k][point] * element.JxW(q) *
                                    slip_[point].tangent[k],
                                  residual);
            }
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::add_stiffness(dealii::SparseMatrix<double> &symmetric,
                                    dealii::SparseMatrix<double> &rest) const
  {
    const unsigned int           n_points = slip_.size();
    Vectors                      n(n_points), closing(n_points);
    std::array<Vectors, dim - 1> s, beyond;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        n[q]       = gap[q].normal;
        closing[q] = slip_[q].closing * n[q];
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            s[k].push_back(slip_[q].tangent[k]);
            beyond[k].push_back(slip_[q].by_position[k] - s[k][q]);
          }
      }
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        for (unsigned int l = 0; l < dim - 1; ++l)
          {
            tractions.add_stiffness(by_slip[k][l], s[k], s[l], symmetric);
            tractions.add_stiffness(by_slip[k][l], s[k], beyond[l], rest);
          }
        tractions.add_stiffness(by_gap[k], s[k], n, rest);
        tractions.add_stiffness(by_touching[k], s[k], closing, rest);
      }
    add_turning(s, n, rest);
  }



  template <int dim>
  void
  ShearTraction<dim>::add_turning(const std::array<Vectors, dim - 1> &s,
                                  const Vectors                      &n,
                                  dealii::SparseMatrix<double> &tangent) const
  {
    Vectors             turn(slip_.size()), spin(slip_.size());
    std::vector<double> minus(slip_.size());
    for (unsigned int k = 0; k < dim - 1; ++k)
      {
        for (unsigned int q = 0; q < slip_.size(); ++q)
          {
            turn[q]  = slip_[q].turn[k];
            minus[q] = -point_traction[k][q];
          }
        tractions.add_pointwise(minus, n, turn, tangent);
      }
    if constexpr (dim == 3)
      {
        for (unsigned int q = 0; q < slip_.size(); ++q)
          {
            spin[q]  = slip_[q].spin;
            minus[q] = -point_traction[1][q];
          }
        tractions.add_pointwise(minus, s[0], spin, tangent);
        tractions.add_pointwise(point_traction[0], s[1], spin, tangent);
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::set_interface(const std::vector<double> &k,
                                    const std::vector<double> &wet)
  {
    mean_k                      = tractions.means(k);
    mean_wet                    = tractions.means(wet);
    const std::vector<double> p = tractions.at_points(start.pressures);
    for (unsigned int q = 0; q < k.size(); ++q)
      {
        const double over_k = k[q] > 0. ? p[q] / k[q] : 0.;
        closed_until[q]     = over_k * over_k * transition;
      }
  }



  template <int dim>
  void
  ShearTraction<dim>::accept()
  {
    start.tractions.clear();
    for (const std::vector<double> &component : traction)
      start.tractions.insert(start.tractions.end(),
                             component.begin(),
                             component.end());
    start.pressures = pressure;
    start.positions = position;
  }



  template <int dim>
  const typename ShearTraction<dim>::History &
  ShearTraction<dim>::history() const
  {
    return start;
  }



  template <int dim>
  void
  ShearTraction<dim>::set_history(const History &history)
  {
    AssertDimension(history.tractions.size(), start.tractions.size());
    AssertDimension(history.pressures.size(), start.pressures.size());
    AssertDimension(history.positions.size(), start.positions.size());
    start = history;
  }



  // Of the members that are defined here.
  template class ShearTraction<2>;
  template class ShearTraction<3>;
} // namespace asperity
