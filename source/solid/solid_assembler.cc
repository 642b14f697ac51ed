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

  /** Work space of one element; the functions' index runs fastest, so that the
   *  innermost loops vectorise. */
  struct SolidAssembler::Scratch
  {
    void
    resize(const unsigned int n_functions)
    {
      n = n_functions;
      dofs.resize(2 * n);
      displacement.resize(2 * n);
      residual.assign(2 * n, 0.);
      gradient_x.resize(n);
      gradient_y.resize(n);
      hoop.resize(n);
      for (auto &row : columns)
        row.resize(n);
    }

    unsigned int n = 0;

    std::vector<unsigned int> dofs;
    std::vector<double>       displacement, residual;
    std::vector<double>       gradient_x, gradient_y, hoop;

    /** [2 * component of P + l]: derivative of that component times weight
     *  with respect to displacement component l of each function. */
    std::array<std::vector<double>, 10> columns;

    /** Symmetric blocks K_ab, b >= a: [i][l][a * n + b]. */
    std::array<std::array<std::vector<double>, 2>, 2> block;

    std::vector<double> full; ///< row-major 2n x 2n, interleaved

    MaterialResponse response;
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
    if (kinematics == Kinematics::axisymmetric)
      for (unsigned int q = 0; q < table_.JxW.size(); ++q)
        table_.JxW[q] *= 2. * dealii::numbers::PI * table_.position[q][0];
  }



  void
  SolidAssembler::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    std::vector<unsigned int> dofs;
    for (const auto &element : table_.elements)
      {
        dofs.clear();
        for (const unsigned int a : element.functions)
          {
            dofs.push_back(displacement_dof(a, 0));
            dofs.push_back(displacement_dof(a, 1));
          }
        std::sort(dofs.begin(), dofs.end());
        for (const unsigned int row : dofs)
          pattern.add_entries(row, dofs.begin(), dofs.end(), true);
      }
  }



  namespace
  {
    // Row and column of the components of P in plane kinematics.
    constexpr unsigned int row_of[]    = {0, 0, 1, 1, 2};
    constexpr unsigned int column_of[] = {0, 1, 0, 1, 2};



    /** K_ab += w dP/dF : (Grad N_a, Grad N_b), for b >= a. */
    template <typename ScratchType>
    void
    add_tangent(const Tensor<4, 3> &A,
                const double        weight,
                const bool          axisymmetric,
                ScratchType        &s)
    {
      const unsigned int n  = s.n;
      const double      *gx = s.gradient_x.data(), *gy = s.gradient_y.data();
      for (unsigned int c = 0; c < (axisymmetric ? 5u : 4u); ++c)
        for (unsigned int l = 0; l < 2; ++l)
          {
            const Tensor<2, 3> &by_F = A[row_of[c]][column_of[c]];
            const double a_x = weight * by_F[l][0], a_y = weight * by_F[l][1];
            double      *column = s.columns[2 * c + l].data();
            for (unsigned int b = 0; b < n; ++b)
              column[b] = a_x * gx[b] + a_y * gy[b];
            if (axisymmetric && l == 0)
              for (unsigned int b = 0; b < n; ++b)
                column[b] += weight * by_F[2][2] * s.hoop[b];
          }
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int l = 0; l < 2; ++l)
          {
            const double *m_x    = s.columns[2 * (2 * i) + l].data(),
                         *m_y    = s.columns[2 * (2 * i + 1) + l].data(),
                         *m_hoop = s.columns[8 + l].data();
            double *block        = s.block[i][l].data();
            for (unsigned int a = 0; a < n; ++a)
              {
                double      *row  = block + a * n;
                const double ga_x = gx[a], ga_y = gy[a];
                for (unsigned int b = 0; b < n; ++b)
                  row[b] += ga_x * m_x[b] + ga_y * m_y[b];
                if (axisymmetric && i == 0)
                  for (unsigned int b = 0; b < n; ++b)
                    row[b] += s.hoop[a] * m_hoop[b];
              }
          }
    }
  } // namespace



  bool
  SolidAssembler::integrate(const BasisTable::Element &entry,
                            const Vector              &u,
                            const bool                 with_tangent,
                            Scratch                   &s)
  {
    const bool        axisymmetric = (kinematics == Kinematics::axisymmetric);
    const ElementView element(table_, entry);
    s.resize(element.n_functions());
    const unsigned int n = s.n;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        {
          s.dofs[2 * a + c]         = element.dof(a, c);
          s.displacement[2 * a + c] = u(s.dofs[2 * a + c]);
        }
    if (with_tangent)
      for (auto &row : s.block)
        for (auto &block : row)
          block.assign(n * n, 0.);

    for (unsigned int q = 0; q < table_.points_per_element; ++q)
      {
        const unsigned int point  = element.point(q);
        const double       weight = element.JxW(q);
        Tensor<2, 3>       F      = dealii::unit_symmetric_tensor<3>();
        for (unsigned int a = 0; a < n; ++a)
          {
            const Tensor<1, 2> &gradient = element.gradient(q, a);
            const double        u_x      = s.displacement[2 * a],
                         u_y             = s.displacement[2 * a + 1];
            s.gradient_x[a]              = gradient[0];
            s.gradient_y[a]              = gradient[1];
            F[0][0] += u_x * gradient[0];
            F[0][1] += u_x * gradient[1];
            F[1][0] += u_y * gradient[0];
            F[1][1] += u_y * gradient[1];
            if (axisymmetric)
              {
                s.hoop[a] = element.N(q, a) / table_.position[point][0];
                F[2][2] += u_x * s.hoop[a];
              }
          }
        law_->evaluate(F, old_history[point], dt, with_tangent, s.response);
        if (s.response.status != LawStatus::ok)
          return false;
        const Tensor<2, 3> &P = s.response.P;
        new_history[point]    = s.response.state;
        mises[point]          = s.response.mises;
        for (unsigned int a = 0; a < n; ++a)
          {
            s.residual[2 * a] +=
              weight * (P[0][0] * s.gradient_x[a] + P[0][1] * s.gradient_y[a] +
                        (axisymmetric ? P[2][2] * s.hoop[a] : 0.));
            s.residual[2 * a + 1] +=
              weight * (P[1][0] * s.gradient_x[a] + P[1][1] * s.gradient_y[a]);
          }
        if (with_tangent)
          add_tangent(s.response.tangent, weight, axisymmetric, s);
      }
    return true;
  }



  bool
  SolidAssembler::add(const Vector                 &u,
                      Vector                       &residual,
                      dealii::SparseMatrix<double> *tangent)
  {
    Scratch s;
    for (const auto &element : table_.elements)
      {
        if (!integrate(element, u, tangent != nullptr, s))
          return false;
        const unsigned int n = s.n;
        for (unsigned int i = 0; i < 2 * n; ++i)
          residual(s.dofs[i]) += s.residual[i];
        if (tangent == nullptr)
          continue;
        s.full.resize(4 * n * n);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int i = 0; i < 2; ++i)
              for (unsigned int l = 0; l < 2; ++l)
                s.full[(2 * a + i) * 2 * n + 2 * b + l] =
                  s.block[i][l][a * n + b];
        for (unsigned int i = 0; i < 2 * n; ++i)
          tangent->add(s.dofs[i],
                       2 * n,
                       s.dofs.data(),
                       s.full.data() + i * 2 * n,
                       false,
                       true);
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
