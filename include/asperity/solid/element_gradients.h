#ifndef asperity_solid_element_gradients_h
#define asperity_solid_element_gradients_h

#include <asperity/constitutive/material_law.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace asperity
{
  /**
   * Derivatives of one element's functions at its points, laid out for vector
   * instructions of the widest kind that the processor has: each stands there
   * twice, once a displacement component, since displacements, forces and rows
   * of the stiffness have both components of a function side by side. All are
   * padded by zeros to full vectors, and the points to groups of them.
   */
  class ElementGradients
  {
  public:
    /** All zero. @param axisymmetric whether there is a hoop strain */
    ElementGradients(const unsigned int n_functions,
                     const unsigned int n_points,
                     const bool         axisymmetric);

    /** Grad N_a at a point [1/m], and N_a over the radius. */
    void
    set(const unsigned int          point,
        const unsigned int          a,
        const dealii::Tensor<1, 2> &gradient,
        const double                hoop);

    unsigned int
    n_functions() const
    {
      return n;
    }

    /** Length of displacements and forces, padding included. */
    unsigned int
    size() const
    {
      return stride;
    }

    /** Deformation gradients at all points.
     *  @param u displacements [2 a + component], of which size() are read */
    void
    deform(const double *u, dealii::Tensor<2, 3> *F) const;

    /** forces += sum of weight P Grad N over the points.
     *  @param forces [2 a + component], of which size() are written */
    void
    add_forces(const double           *weights,
               const MaterialResponse *responses,
               double                 *forces) const;

    unsigned int
    n_points() const
    {
      return n_points_;
    }

    /** Of the gradient: 2, with hoop strain 3. */
    unsigned int
    n_components() const
    {
      return n_components_;
    }

    /** Gradients from a point on: [(point, component J) size() + 2 a + i]. */
    const double *
    from_point(const unsigned int point) const
    {
      return &values[point * n_components_ * stride];
    }

    /** Points whose products go well into registers together: the table is
     *  padded to a multiple of it. */
    static constexpr unsigned int group_size = 4;

  private:
    unsigned int        n;
    unsigned int        stride; ///< 2 n, padded
    unsigned int        n_points_;
    unsigned int        n_components_;
    std::vector<double> values; ///< [(q n_components + J) stride + 2 a + i]
  };
} // namespace asperity

#endif
