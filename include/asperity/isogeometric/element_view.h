#ifndef asperity_isogeometric_element_view_h
#define asperity_isogeometric_element_view_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/force_term.h>

namespace asperity
{
  /**
   * One element of a BasisTable in the words of an integrand: q counts its
   * points, a its functions. It owns nothing; the table must outlive it. Its
   * members are pointers, so that a loop over it costs what one over arrays
   * costs.
   */
  template <int dim>
  class ElementView
  {
  public:
    ElementView(const BasisTable<dim>                   &table,
                const typename BasisTable<dim>::Element &element)
      : n_functions_(element.functions.size())
      , first_point(element.first_point)
      , functions(element.functions.data())
      , values(element.values.data())
      , gradients(element.gradients.data())
      , weights(table.JxW.data() + element.first_point)
    {}

    unsigned int
    n_functions() const
    {
      return n_functions_;
    }

    /** Index of a function in the space. */
    unsigned int
    function(const unsigned int a) const
    {
      return functions[a];
    }

    /** Index of a function's displacement component, see displacement_dof().
     */
    unsigned int
    dof(const unsigned int a, const unsigned int component) const
    {
      return displacement_dof<dim>(functions[a], component);
    }

    /** Index of a point in the arrays of the table. */
    unsigned int
    point(const unsigned int q) const
    {
      return first_point + q;
    }

    /** N_a [-] */
    double
    N(const unsigned int q, const unsigned int a) const
    {
      return values[q * n_functions_ + a];
    }

    /** Gradient of N_a with respect to the reference position [1/m]; in the
     *  table of an edge its components are along the tangents and along
     *  the outward normal. */
    const dealii::Tensor<1, dim> &
    gradient(const unsigned int q, const unsigned int a) const
    {
      return gradients[q * n_functions_ + a];
    }

    /** Weight of a point times the reference measure [m^dim, edges:
     *  m^(dim - 1)]. */
    double
    JxW(const unsigned int q) const
    {
      return weights[q];
    }

    /** x += sum_a N_a u_a, term by term: from the reference position it gives
     *  the current one.
     *  @param u numbered by displacement_dof() [m] */
    void
    add_displacement(const unsigned int            q,
                     const dealii::Vector<double> &u,
                     dealii::Tensor<1, dim>       &x) const
    {
      for (unsigned int a = 0; a < n_functions_; ++a)
        for (unsigned int c = 0; c < dim; ++c)
          x[c] += N(q, a) * u(dof(a, c));
    }

    /** t += sum_a dN_a/dS u_a on the table of an edge, S the reference arc
     *  length along one of its tangents: from this reference tangent it gives
     *  the current one. */
    void
    add_stretch(const unsigned int            q,
                const dealii::Vector<double> &u,
                dealii::Tensor<1, dim>       &t,
                const unsigned int            direction = 0) const
    {
      for (unsigned int a = 0; a < n_functions_; ++a)
        for (unsigned int c = 0; c < dim; ++c)
          t[c] += gradient(q, a)[direction] * u(dof(a, c));
    }

    /** r_a += N_a f: nodal loads of a force at a point [N/m or N]. */
    void
    add_force(const unsigned int            q,
              const dealii::Tensor<1, dim> &f,
              dealii::Vector<double>       &r) const
    {
      for (unsigned int a = 0; a < n_functions_; ++a)
        for (unsigned int c = 0; c < dim; ++c)
          r(dof(a, c)) += N(q, a) * f[c];
    }

  private:
    unsigned int                  n_functions_;
    unsigned int                  first_point;
    const unsigned int           *functions;
    const double                 *values;
    const dealii::Tensor<1, dim> *gradients;
    const double                 *weights;
  };
} // namespace asperity

#endif
