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
  template <int dim>
  struct SolidAssembler<dim>::Scratch
  {
    std::vector<double>           displacement, residual;
    ElementStiffness<dim>         K;
    std::vector<Tensor<2, 3>>     F; // of each point
    std::vector<MaterialResponse> responses;
  };



  namespace
  {
    /** Functions of each element in order of their index, so that rows of the
     *  matrix are filled in one sweep. */
    template <int dim>
    void
    sort_functions(BasisTable<dim> &table)
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



  template <int dim>
  SolidAssembler<dim>::SolidAssembler(
    std::shared_ptr<const SplineSpace<dim>> space,
    const PatchGeometry<dim>               &geometry,
    std::shared_ptr<const MaterialLaw>      law,
    const Kinematics                        kinematics,
    const unsigned int                      n_quadrature,
    const CellShare                        &share)
    : space_(std::move(space))
    , law_(std::move(law))
    , kinematics(kinematics)
    , share(share)
    , table_(tabulate_cells(
        *space_,
        geometry,
        dealii::QGauss<dim>(n_quadrature > 0 ? n_quadrature :
                                               space_->degree() + 1),
        [&share](const unsigned int cell) { return share.is_own(cell); }))
    , old_history(table_.JxW.size())
    , new_history(table_.JxW.size())
    , mises(table_.JxW.size(), 0.)
  {
    sort_functions(table_);
    tabulate_elements();
    if (kinematics == Kinematics::axisymmetric)
      for (unsigned int q = 0; q < table_.JxW.size(); ++q)
        table_.JxW[q] *= 2. * dealii::numbers::PI * table_.position[q][0];
  }



  template <int dim>
  void
  SolidAssembler<dim>::tabulate_elements()
  {
    for (auto &entry : table_.elements)
      {
        const ElementView<dim> element(table_, entry);
        const unsigned int     n = element.n_functions();
        dofs.emplace_back();
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            dofs.back().push_back(element.dof(a, c));
        gradients.emplace_back(n,
                               table_.points_per_element,
                               kinematics == Kinematics::axisymmetric);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          for (unsigned int a = 0; a < n; ++a)
            gradients.back().set(q,
                                 a,
                                 element.gradient(q, a),
                                 element.N(q, a) /
                                   table_.position[element.point(q)][0]);
        // They would stand twice in memory, a third of all that a patch takes.
        if (dim == 3)
          std::vector<Tensor<1, dim>>().swap(entry.gradients);
      }
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_couplings(
    dealii::DynamicSparsityPattern &pattern) const
  {
    for (const auto &element_dofs : dofs)
      for (const unsigned int row : element_dofs)
        pattern.add_entries(row,
                            element_dofs.begin(),
                            element_dofs.end(),
                            true);
  }



  template <int dim>
  bool
  SolidAssembler<dim>::evaluate_law(const ElementView<dim> &element,
                                    const bool              with_tangent,
                                    Scratch                &s)
  {
    const unsigned int first = element.point(0);
    s.responses.resize(table_.points_per_element);
    for (unsigned int q = 0; q < s.responses.size(); ++q)
      s.responses[q].state = new_history[first + q];
    const auto evaluate =
      dim == 2 ? &MaterialLaw::evaluate_points : &MaterialLaw::evaluate_general;
    (law_.get()->*evaluate)(s.responses.size(),
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
        if (!stress_.empty())
          stress_[first + q] = s.responses[q].P;
      }
    return true;
  }



  template <int dim>
  bool
  SolidAssembler<dim>::integrate(const unsigned int e,
                                 const Vector      &u,
                                 const bool         with_tangent,
                                 Scratch           &s)
  {
    const ElementView<dim>       element(table_, table_.elements[e]);
    const ElementGradients<dim> &grad_N = gradients[e];
    s.displacement.assign(grad_N.size(), 0.);
    s.residual.assign(grad_N.size(), 0.);
    for (unsigned int i = 0; i < dofs[e].size(); ++i)
      s.displacement[grad_N.index(i / dim, i % dim)] = u(dofs[e][i]);
    s.F.resize(table_.points_per_element);
    grad_N.deform(s.displacement.data(), s.F.data());
    if (!evaluate_law(element, with_tangent, s))
      return false;
    const double *const weights = &table_.JxW[element.point(0)];
    grad_N.add_forces(weights, s.responses.data(), s.residual.data());
    if (with_tangent)
      s.K.integrate(grad_N, weights, s.responses.data());
    return true;
  }



  template <int dim>
  bool
  SolidAssembler<dim>::add(const Vector                 &u,
                           Vector                       &residual,
                           dealii::SparseMatrix<double> *tangent)
  {
    Scratch s;
    if (tangent != nullptr)
      scatter.find(tangent->get_sparsity_pattern(), dofs);
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        if (!share.is_own(e))
          continue;
        if (!integrate(e, u, tangent != nullptr, s))
          return false;
        for (unsigned int i = 0; i < dofs[e].size(); ++i)
          residual(dofs[e][i]) +=
            s.residual[gradients[e].index(i / dim, i % dim)];
        if (tangent != nullptr)
          scatter.add(e, s.K, *tangent);
      }
    return true;
  }



  template <int dim>
  void
  SolidAssembler<dim>::set_time_step(const double new_dt)
  {
    dt = new_dt;
  }



  template <int dim>
  void
  SolidAssembler<dim>::accept()
  {
    share.ranks.share(share.owner, new_history);
    share.ranks.share(share.owner, mises);
    if (!stress_.empty())
      share.ranks.share(share.owner, stress_);
    old_history = new_history;
  }



  template <int dim>
  double
  SolidAssembler<dim>::largest_strain_increment() const
  {
    double largest = 0.;
    for (std::size_t q = 0; q < old_history.size(); ++q)
      largest =
        std::max(largest,
                 new_history[q].plastic_strain - old_history[q].plastic_strain);
    return share.ranks.largest(largest);
  }



  template <int dim>
  void
  SolidAssembler<dim>::initialize(const MaterialState &state)
  {
    std::fill(old_history.begin(), old_history.end(), state);
    std::fill(new_history.begin(), new_history.end(), state);
  }



  template <int dim>
  const std::vector<MaterialState> &
  SolidAssembler<dim>::history() const
  {
    return old_history;
  }



  template <int dim>
  void
  SolidAssembler<dim>::set_history(const std::vector<MaterialState> &history)
  {
    AssertDimension(history.size(), old_history.size());
    old_history = history;
    new_history = history;
  }



  template <int dim>
  std::vector<Tensor<2, 3>>
  SolidAssembler<dim>::deformation(const Vector &u) const
  {
    std::vector<Tensor<2, 3>> F(table_.JxW.size());
    std::vector<Tensor<2, 3>> of_element;
    std::vector<double>       displacement;
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        const ElementGradients<dim> &grad_N = gradients[e];
        displacement.assign(grad_N.size(), 0.);
        for (unsigned int i = 0; i < dofs[e].size(); ++i)
          displacement[grad_N.index(i / dim, i % dim)] = u(dofs[e][i]);
        of_element.resize(table_.points_per_element);
        grad_N.deform(displacement.data(), of_element.data());
        std::copy(of_element.begin(),
                  of_element.end(),
                  F.begin() + table_.elements[e].first_point);
      }
    share.ranks.share(share.owner, F);
    return F;
  }



  template <int dim>
  const std::vector<double> &
  SolidAssembler<dim>::mises_stress() const
  {
    return mises;
  }



  template <int dim>
  void
  SolidAssembler<dim>::assemble_mass(dealii::SparseMatrix<double> &mass) const
  {
    mass                 = 0.;
    const double density = law_->density();
    for (const auto &entry : table_.elements)
      {
        const ElementView<dim> element(table_, entry);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int b = 0; b < element.n_functions(); ++b)
            {
              double sum = 0.;
              for (unsigned int q = 0; q < table_.points_per_element; ++q)
                sum +=
                  density * element.N(q, a) * element.N(q, b) * element.JxW(q);
              for (unsigned int c = 0; c < dim; ++c)
                mass.add(element.dof(a, c), element.dof(b, c), sum);
            }
      }
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_body_force(const Tensor<1, dim> &force,
                                      Vector               &external) const
  {
    for (const auto &entry : table_.elements)
      {
        const ElementView<dim> element(table_, entry);
        for (unsigned int q = 0; q < table_.points_per_element; ++q)
          element.add_force(q, element.JxW(q) * force, external);
      }
  }



  template <int dim>
  const BasisTable<dim> &
  SolidAssembler<dim>::table() const
  {
    return table_;
  }



  template <int dim>
  const ElementGradients<dim> &
  SolidAssembler<dim>::element_gradients(const unsigned int element) const
  {
    return gradients[element];
  }



  template <int dim>
  const SplineSpace<dim> &
  SolidAssembler<dim>::space() const
  {
    return *space_;
  }



  template <int dim>
  const MaterialLaw &
  SolidAssembler<dim>::law() const
  {
    return *law_;
  }



  template class SolidAssembler<2>;
  template class SolidAssembler<3>;
} // namespace asperity
