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
    double
    largest_element(const BasisTable<2> &table)
    {
      double largest = 0.;
      for (const auto &element : table.elements)
        {
          double length = 0.;
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            length += table.JxW[element.first_point + q];
          largest = std::max(largest, length);
        }
      return largest;
    }

    Tensor<1, 2>
    turned(const Tensor<1, 2> &v)
    {
      Tensor<1, 2> result;
      result[0] = -v[1];
      result[1] = v[0];
      return result;
    }
  } // namespace



  ShearTraction::ShearTraction(const TractionSpace       &tractions,
                               const BasisTable<2>       &table,
                               const InterfaceParameters &parameters,
                               const double               penalty)
    : tractions(tractions)
    , table(table)
    , law(parameters)
    , penalty(parameters.stick_penalty * penalty)
    , transition(parameters.transition * largest_element(table))
    , mean_k(tractions.size(), 0.)
    , mean_wet(tractions.size(), 0.)
    , closed_until(table.JxW.size(), 0.)
    , start{std::vector<double>(tractions.size(), 0.),
            std::vector<double>(tractions.size(), 0.),
            table.position}
    , position(table.position)
    , slip_(table.JxW.size())
    , gap(table.JxW.size())
    , pressure(tractions.size(), 0.)
    , mean_slip(tractions.size(), 0.)
    , traction(tractions.size(), 0.)
    , by_slip(tractions.size(), 0.)
    , by_gap(tractions.size(), 0.)
    , by_touching(tractions.size(), 0.)
    , point_traction(table.JxW.size(), 0.)
  {}



  void
  ShearTraction::measure(const std::vector<Point<2>> &positions,
                         const std::vector<GapPoint> &gaps)
  {
    position = positions;
    gap      = gaps;
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        const Tensor<1, 2> &n   = gap[q].normal;
        const Tensor<1, 2>  way = position[q] - start.positions[q];
        SlipPoint          &p   = slip_[q];
        p.tangent               = turned(n);
        p.slip                  = p.tangent * way;
        p.rotation              = gap[q].normal_rotation();
        p.by_way                = 1. - p.rotation * (n * way);
        const double open       = (gap[q].gap - closed_until[q]) / transition;
        p.touching              = std::clamp(1. - open, 0., 1.);
        p.closing = open > 0. && open < 1. ? -1. / transition : 0.;
      }
  }



  void
  ShearTraction::return_map(const std::vector<ContactPressure> &pressures)
  {
    std::vector<double> slip(slip_.size()), touching(slip_.size());
    for (unsigned int q = 0; q < slip_.size(); ++q)
      {
        slip[q]     = slip_[q].slip;
        touching[q] = slip_[q].touching;
      }
    mean_slip                               = tractions.means(slip);
    const std::vector<double> mean_touching = tractions.means(touching);
    for (unsigned int a = 0; a < traction.size(); ++a)
      {
        pressure[a]               = pressures[a].value;
        const double        trial = start.tractions[a] + penalty * mean_slip[a];
        const ShearStrength limit = law.strength(
          {pressures[a].value, mean_k[a], mean_touching[a], mean_wet[a]});
        const bool   sticks = std::abs(trial) < limit.value;
        const double sign   = sticks ? 0. : std::copysign(1., trial);
        traction[a]         = sticks ? trial : sign * limit.value;
        by_slip[a]          = sticks ? penalty : 0.;
        by_gap[a]           = sign * limit.by_pressure * pressures[a].slope;
        by_touching[a]      = sign * limit.by_touching;
      }
    point_traction = tractions.at_points(traction);
  }



  void
  ShearTraction::evaluate(const std::vector<Point<2>>        &positions,
                          const std::vector<GapPoint>        &gaps,
                          const std::vector<ContactPressure> &pressures)
  {
    measure(positions, gaps);
    return_map(pressures);
  }



  void
  ShearTraction::add_residual(dealii::Vector<double> &residual) const
  {
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int point = element.point(q);
            if (point_traction[point] != 0.)
              element.add_force(q,
                                point_traction[point] * element.JxW(q) *
                                  slip_[point].tangent,
                                residual);
          }
      }
  }



  void
  ShearTraction::add_stiffness(dealii::SparseMatrix<double> &symmetric,
                               dealii::SparseMatrix<double> &rest) const
  {
    const unsigned int     n_points = slip_.size();
    TractionSpace::Vectors s(n_points), beyond(n_points), n(n_points),
      closing(n_points);
    std::vector<double> turning(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
      {
        s[q]       = slip_[q].tangent;
        n[q]       = gap[q].normal;
        beyond[q]  = (slip_[q].by_way - 1.) * s[q];
        closing[q] = slip_[q].closing * n[q];
        // s' = -rotation (s . dx) n
        turning[q] = -point_traction[q] * slip_[q].rotation;
      }
    tractions.add_stiffness(by_slip, s, s, symmetric);
    tractions.add_stiffness(by_slip, s, beyond, rest);
    tractions.add_stiffness(by_gap, s, n, rest);
    tractions.add_stiffness(by_touching, s, closing, rest);
    tractions.add_pointwise(turning, n, s, rest);
  }



  void
  ShearTraction::set_interface(const std::vector<double> &k,
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



  void
  ShearTraction::accept()
  {
    start = {traction, pressure, position};
  }



  const ShearTraction::History &
  ShearTraction::history() const
  {
    return start;
  }



  void
  ShearTraction::set_history(const History &history)
  {
    AssertDimension(history.tractions.size(), start.tractions.size());
    AssertDimension(history.pressures.size(), start.pressures.size());
    AssertDimension(history.positions.size(), start.positions.size());
    start = history;
  }



  const std::vector<double> &
  ShearTraction::at_points() const
  {
    return point_traction;
  }



  const std::vector<SlipPoint> &
  ShearTraction::slip() const
  {
    return slip_;
  }



  void
  ShearTraction::sum_up(Tensor<1, 2> &force, double &sticking_part) const
  {
    const std::vector<double> sticks = sticking();
    double                    stuck = 0., all = 0.;
    for (unsigned int q = 0; q < point_traction.size(); ++q)
      {
        const double load = point_traction[q] * table.JxW[q];
        force -= load * slip_[q].tangent;
        stuck += sticks[q] * std::abs(load);
        all += std::abs(load);
      }
    sticking_part = all > 0. ? stuck / all : 0.;
  }



  std::vector<double>
  ShearTraction::dissipation() const
  {
    std::vector<double> work(traction.size());
    for (unsigned int a = 0; a < work.size(); ++a)
      work[a] = traction[a] *
                (mean_slip[a] - (traction[a] - start.tractions[a]) / penalty);
    return tractions.at_points(work);
  }



  std::vector<double>
  ShearTraction::sticking() const
  {
    std::vector<double> sticks(traction.size());
    for (unsigned int a = 0; a < sticks.size(); ++a)
      sticks[a] = by_slip[a] != 0. && traction[a] != 0. ? 1. : 0.;
    return tractions.at_points(sticks);
  }
} // namespace asperity
