#include <asperity/isogeometric/element_view.h>
#include <asperity/solid/solid_assembler.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <numeric>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  /** Work space of one element. */
  struct SolidAssembler::Scratch
  {
    void
    start(const unsigned int n, const bool axisymmetric)
    {
      displacement.resize(2 * n);
      residual.assign(2 * n, 0.);
      K.start(n, axisymmetric);
    }

    std::vector<double>           displacement, residual;
    ElementStiffness              K;
    std::vector<Tensor<2, 3>>     F; // of each point
    std::vector<MaterialResponse> responses;
  };



  namespace
  {
    /** Functions of each element in order of their index, so that rows of the
     *  matrix are filled in one sweep. */
    void
    sort_functions(BasisTable &table)
    {
      for (auto &element : table.elements)
        {
          const unsigned int        n = element.functions.size();
          std::vector<unsigned int> order(n);
          std::iota(order.begin(), order.end(), 0);
          std::sort(order.begin(),
                    order.end(),
                    [&](const auto a, const auto b) {
                      return element.functions[a] < element.functions[b];
                    });
          const auto unsorted = element;
          for (unsigned int a = 0; a < n; ++a)
            {
              element.functions[a] = unsorted.functions[order[a]];
              for (unsigned int q = 0; q < table.points_per_element; ++q)
                {
                  element.values[q * n + a] = unsorted.values[q * n + order[a]];
                  element.gradients[q * n + a] =
                    unsorted.gradients[q * n + order[a]];
                }
            }
        }
    }
  } // namespace



  SolidAssembler::SolidAssembler(std::shared_ptr<const SplineSpace> space,
                                 const PatchGeometry               &geometry,
                                 std::shared_ptr<const MaterialLaw> law,
                                 const Kinematics                   kinematics,
                                 const unsigned int n_quadrature)
    : space_(std::move(space))
    , law_(std::move(law))
    , kinematics(kinematics)
    , table_(tabulate_cells(*space_,
                            geometry,
                            dealii::QGauss<2>(n_quadrature > 0 ?
                                                n_quadrature :
                                                space_->degree() + 1)))
    , old_history(table_.JxW.size())
    , new_history(table_.JxW.size())
    , mises(table_.JxW.size(), 0.)
  {
    sort_functions(table_);
    for (const auto &entry : table_.elements)
      {
        const ElementView element(table_, entry);
        dofs.emplace_back();
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int c = 0; c < 2; ++c)
            dofs.back().push_back(element.dof(a, c));
      }
    if (kinematics == Kinematics::axisymmetric)
      for (unsigned int q = 0; q < table_.JxW.size(); ++q)
        table_.JxW[q] *= 2. * dealii::numbers::PI * table_.position[q][0];
  }



  void
  SolidAssembler::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &element_dofs : dofs)
      for (const unsigned int row : element_dofs)
        pattern.add_entries(row,
                            element_dofs.begin(),
                            element_dofs.end(),
                            true);
  }



  void
  SolidAssembler::fill_deformation(const ElementView &element, Scratch &s) const
  {
    s.F.resize(table_.points_per_element);
    for (unsigned int q = 0; q < table_.points_per_element; ++q)
      {
        double xx = 1., xy = 0., yx = 0., yy = 1., zz = 1.;
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const Tensor<1, 2> &gradient = element.gradient(q, a);
            const double        u_x      = s.displacement[2 * a],
                         u_y             = s.displacement[2 * a + 1];
            xx += u_x * gradient[0];
            xy += u_x * gradient[1];
            yx += u_y * gradient[0];
            yy += u_y * gradient[1];
            if (kinematics == Kinematics::axisymmetric)
              zz +=
                u_x * element.N(q, a) / table_.position[element.point(q)][0];
          }
        s.F[q][0][0] = xx;
        s.F[q][0][1] = xy;
        s.F[q][1][0] = yx;
        s.F[q][1][1] = yy;
        s.F[q][2][2] = zz;
      }
  }



  bool
  SolidAssembler::evaluate_law(const ElementView &element,
                               const bool         with_tangent,
                               Scratch           &s)
  {
    const unsigned int first = element.point(0);
    s.responses.resize(table_.points_per_element);
    for (unsigned int q = 0; q < s.responses.size(); ++q)
      s.responses[q].state = new_history[first + q];
    law_->evaluate_points(s.responses.size(),
                          s.F.data(),
                          &old_history[first],
                          dt,
                          with_tangent,
                          s.responses.data());
    for (unsigned int q = 0; q < s.responses.size(); ++q)
      {
        if (s.responses[q].status != LawStatus::ok)
          return false;
        new_history[first + q] = s.responses[q].state;
        mises[first + q]       = s.responses[q].mises;
      }
    return true;
  }



  bool
  SolidAssembler::integrate(const unsigned int e,
                            const Vector      &u,
                            const bool         with_tangent,
                            Scratch           &s)
  {
    const bool         axisymmetric = (kinematics == Kinematics::axisymmetric);
    const ElementView  element(table_, table_.elements[e]);
    const unsigned int n = element.n_functions();
    s.start(n, axisymmetric);
    for (unsigned int i = 0; i < 2 * n; ++i)
      s.displacement[i] = u(dofs[e][i]);
    fill_deformation(element, s);
    if (!evaluate_law(element, with_tangent, s))
      return false;

    ElementStiffness::Gradients &grad_N = s.K.gradients();
    for (unsigned int q = 0; q < table_.points_per_element; ++q)
      {
        const double        weight = element.JxW(q);
        const Tensor<2, 3> &P      = s.responses[q].P;
        for (unsigned int a = 0; a < n; ++a)
          {
            grad_N.x[a] = element.gradient(q, a)[0];
            grad_N.y[a] = element.gradient(q, a)[1];
            if (axisymmetric)
              grad_N.hoop[a] =
                element.N(q, a) / table_.position[element.point(q)][0];
            s.residual[2 * a] +=
              weight * (P[0][0] * grad_N.x[a] + P[0][1] * grad_N.y[a] +
                        P[2][2] * grad_N.hoop[a]);
            s.residual[2 * a + 1] +=
              weight * (P[1][0] * grad_N.x[a] + P[1][1] * grad_N.y[a]);
          }
        if (with_tangent)
          s.K.add(s.responses[q].tangent, weight);
      }
    return true;
  }



  bool
  SolidAssembler::add(const Vector                 &u,
                      Vector                       &residual,
                      dealii::SparseMatrix<double> *tangent)
  {
    Scratch s;
    if (tangent != nullptr)
      scatter.find(tangent->get_sparsity_pattern(), dofs);
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        if (!integrate(e, u, tangent != nullptr, s))
          return false;
        for (unsigned int i = 0; i < dofs[e].size(); ++i)
          residual(dofs[e][i]) += s.residual[i];
        if (tangent != nullptr)
          scatter.add(e, s.K, *tangent);
      }
    return true;
  }



  void
  SolidAssembler::set_time_step(const double new_dt)
  {
    dt = new_dt;
  }



  void
  SolidAssembler::accept()
  {
    old_history = new_history;
  }



  double
  SolidAssembler::largest_strain_increment() const
  {
    double largest = 0.;
    for (std::size_t q = 0; q < old_history.size(); ++q)
      largest =
        std::max(largest,
                 new_history[q].plastic_strain - old_history[q].plastic_strain);
    return largest;
  }



  void
  SolidAssembler::initialize(const MaterialState &state)
  {
    std::fill(old_history.begin(), old_history.end(), state);
    std::fill(new_history.begin(), new_history.end(), state);
  }



  const std::vector<MaterialState> &
  SolidAssembler::history() const
  {
    return old_history;
  }



  void
  SolidAssembler::set_history(const std::vector<MaterialState> &history)
  {
    AssertDimension(history.size(), old_history.size());
    old_history = history;
    new_history = history;
  }



  const std::vector<double> &
  SolidAssembler::mises_stress() const
  {
    return mises;
  }



  void
  SolidAssembler::assemble_mass(dealii::SparseMatrix<double> &mass) const
  {
    mass                 = 0.;
    const double density = law_->density();
    for (const auto &entry : table_.elements)
      {
        const ElementView element(table_, entry);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int b = 0; b < element.n_functions(); ++b)
            {
              double sum = 0.;
              for (unsigned int q = 0; q < table_.points_per_element; ++q)
                sum +=
                  density * element.N(q, a) * element.N(q, b) * element.JxW(q);
              for (unsigned int c = 0; c < 2; ++c)
                mass.add(element.dof(a, c), element.dof(b, c), sum);
            }
      }
  }



  void
  SolidAssembler::add_body_force(const Tensor<1, 2> &force,
                                 Vector             &external) const
  {
    for (const auto &entry : table_.elements)
      {
        const ElementView element(table_, entry);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          element.add_force(q, element.JxW(q) * force, external);
      }
  }



  const BasisTable &
  SolidAssembler::table() const
  {
    return table_;
  }



  const SplineSpace &
  SolidAssembler::space() const
  {
    return *space_;
  }



  const MaterialLaw &
  SolidAssembler::law() const
  {
    return *law_;
  }
} // namespace asperity
