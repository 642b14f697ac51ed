#include <asperity/contact/contact_assembler.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <set>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  ContactAssembler::ContactAssembler(
    std::shared_ptr<const SplineSpace>   space,
    const PatchGeometry                 &geometry,
    const Edge                           edge,
    std::shared_ptr<const RigidObstacle> obstacle,
    const ContactOptions                &options)
    : space(std::move(space))
    , obstacle(std::move(obstacle))
    , options_(options)
    , law{options.penalty}
    , table_(tabulate_edge(*this->space,
                           geometry,
                           edge,
                           dealii::QGauss<1>(options.points_per_element > 0 ?
                                               options.points_per_element :
                                               this->space->degree() + 2)))
    , edge_functions(this->space->edge_functions(edge))
    , neighbours(edge_functions.size())
    , weight(edge_functions.size(), 0.)
    , hint(table_.JxW.size(), 0.)
    , position(table_.JxW.size())
    , gap(table_.JxW.size())
    , function_pressure(edge_functions.size(), 0.)
    , point_pressure(table_.JxW.size(), 0.)
  {
    for (unsigned int q = 0; q < hint.size(); ++q)
      hint[q] = table_.position[q][0];
    multiplier.assign(options.formulation == ContactFormulation::mortar ?
                        edge_functions.size() :
                        table_.JxW.size(),
                      0.);
    slope.assign(multiplier.size(), 0.);
    std::vector<std::set<unsigned int>> overlap(edge_functions.size());
    for (const auto &entry : table_.elements)
      {
        const ElementView         element(table_, entry);
        std::vector<unsigned int> functions, columns;
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const auto found = std::lower_bound(edge_functions.begin(),
                                                edge_functions.end(),
                                                element.function(a));
            if (found == edge_functions.end() || *found != element.function(a))
              continue;
            functions.push_back(found - edge_functions.begin());
            columns.push_back(a);
            for (unsigned int q = 0; q < table_.points_per_element; ++q)
              weight[functions.back()] += element.N(q, a) * element.JxW(q);
          }
        for (const unsigned int a : functions)
          overlap[a].insert(functions.begin(), functions.end());
        element_functions.push_back(functions);
        element_columns.push_back(columns);
      }
    for (unsigned int a = 0; a < overlap.size(); ++a)
      neighbours[a].assign(overlap[a].begin(), overlap[a].end());
  }



  void
  ContactAssembler::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    const auto couple = [&](const std::vector<unsigned int> &indices) {
      for (const unsigned int a : indices)
        for (const unsigned int b : indices)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              pattern.add(displacement_dof(edge_functions[a], i),
                          displacement_dof(edge_functions[b], j));
    };
    if (options_.formulation == ContactFormulation::mortar)
      for (const auto &indices : neighbours)
        couple(indices);
    else
      for (const auto &indices : element_functions)
        couple(indices);
  }



  void
  ContactAssembler::measure(const Vector &u)
  {
    for (const auto &entry : table_.elements)
      {
        const ElementView element(table_, entry);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            const unsigned int point = element.point(q);
            dealii::Point<2>   x     = table_.position[point];
            element.add_displacement(q, u, x);
            position[point] = x;
            gap[point]      = obstacle->gap(x - offset, hint[point]);
          }
      }
  }



  void
  ContactAssembler::set_pressures()
  {
    if (options_.formulation == ContactFormulation::gauss_point)
      {
        for (unsigned int q = 0; q < gap.size(); ++q)
          {
            const ContactPressure p = law.evaluate(gap[q].gap, multiplier[q]);
            point_pressure[q]       = p.value;
            slope[q]                = p.slope;
          }
        return;
      }
    std::vector<double> weighted_gap(edge_functions.size(), 0.);
    const auto          for_each_value = [&](const auto &action) {
      for (unsigned int e = 0; e < table_.elements.size(); ++e)
        {
          const ElementView element(table_, table_.elements[e]);
          for (unsigned int q = 0; q < table_.points_per_element; ++q)
            for (unsigned int i = 0; i < element_functions[e].size(); ++i)
              action(element.point(q),
                     element_functions[e][i],
                     element.N(q, element_columns[e][i]));
        }
    };
    for_each_value([&](const unsigned int q, const unsigned int a, double N) {
      weighted_gap[a] += N * gap[q].gap * table_.JxW[q];
    });
    for (unsigned int a = 0; a < weighted_gap.size(); ++a)
      {
        const ContactPressure p =
          law.evaluate(weighted_gap[a] / weight[a], multiplier[a]);
        function_pressure[a] = p.value;
        slope[a]             = p.slope;
      }
    std::fill(point_pressure.begin(), point_pressure.end(), 0.);
    for_each_value([&](const unsigned int q, const unsigned int a, double N) {
      point_pressure[q] += N * function_pressure[a];
    });
  }



  void
  ContactAssembler::add_residual(Vector &residual) const
  {
    for (const auto &entry : table_.elements)
      {
        const ElementView element(table_, entry);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            const unsigned int point = element.point(q);
            if (point_pressure[point] != 0.)
              element.add_force(q,
                                -point_pressure[point] * element.JxW(q) *
                                  gap[point].normal,
                                residual);
          }
      }
  }



  bool
  ContactAssembler::add(const Vector &u, Vector &residual, Matrix *tangent)
  {
    measure(u);
    set_pressures();
    add_residual(residual);
    if (tangent != nullptr)
      {
        add_curvature(*tangent);
        if (options_.formulation == ContactFormulation::mortar)
          add_mortar_stiffness(*tangent);
        else
          add_point_stiffness(*tangent);
      }
    return true;
  }



  void
  ContactAssembler::set_obstacle_offset(const Tensor<1, 2> &new_offset)
  {
    offset = new_offset;
  }



  void
  ContactAssembler::augment()
  {
    multiplier = (options_.formulation == ContactFormulation::mortar) ?
                   function_pressure :
                   point_pressure;
  }



  const std::vector<double> &
  ContactAssembler::multipliers() const
  {
    return multiplier;
  }



  void
  ContactAssembler::set_multipliers(const std::vector<double> &multipliers)
  {
    AssertDimension(multipliers.size(), multiplier.size());
    multiplier = multipliers;
  }



  const std::vector<double> &
  ContactAssembler::hints() const
  {
    return hint;
  }



  void
  ContactAssembler::set_hints(const std::vector<double> &hints)
  {
    AssertDimension(hints.size(), hint.size());
    hint = hints;
  }



  double
  ContactAssembler::touching_length() const
  {
    // A mortar pressure reaches a support beyond the touching points; those
    // touch where the penalty law alone would press. A hard mortar contact
    // closes gaps in the mean over a function only, and its points open and
    // close at random; but where every function presses, all of them touch.
    const bool mortar = (options_.formulation == ContactFormulation::mortar);
    double     length = 0.;
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        const auto &functions = element_functions[e];
        const bool  inside =
          mortar &&
          std::all_of(functions.begin(), functions.end(), [&](const auto a) {
            return function_pressure[a] > 0.;
          });
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          {
            const unsigned int point = table_.elements[e].first_point + q;
            const double       p     = point_pressure[point];
            if (inside ||
                (p > 0. && law.evaluate(gap[point].gap, p).value > 0.))
              length += table_.JxW[point];
          }
      }
    return length;
  }



  ContactState
  ContactAssembler::state() const
  {
    ContactState state;
    double       length = 0.;
    for (unsigned int q = 0; q < gap.size(); ++q)
      {
        const double p = point_pressure[q];
        length += table_.JxW[q];
        state.force += p * table_.JxW[q] * gap[q].normal;
        state.max_pressure = std::max(state.max_pressure, p);
        state.mean_gap += std::max(gap[q].gap, 0.) * table_.JxW[q];
        state.max_penetration = std::max(state.max_penetration, -gap[q].gap);
      }
    const std::vector<double> &pressures =
      (options_.formulation == ContactFormulation::mortar) ? function_pressure :
                                                             point_pressure;
    for (unsigned int i = 0; i < multiplier.size(); ++i)
      state.constraint_violation =
        std::max(state.constraint_violation,
                 std::abs(pressures[i] - multiplier[i]) / options_.penalty);
    state.contact_fraction = touching_length() / length;
    state.mean_gap /= length;
    return state;
  }



  const BasisTable &
  ContactAssembler::table() const
  {
    return table_;
  }



  const std::vector<double> &
  ContactAssembler::pressure() const
  {
    return point_pressure;
  }



  const std::vector<GapPoint> &
  ContactAssembler::gaps() const
  {
    return gap;
  }



  const std::vector<dealii::Point<2>> &
  ContactAssembler::positions() const
  {
    return position;
  }



  const ContactOptions &
  ContactAssembler::options() const
  {
    return options_;
  }
} // namespace asperity
