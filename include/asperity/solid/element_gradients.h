#ifndef asperity_solid_element_gradients_h
#define asperity_solid_element_gradients_h

#include <asperity/constitutive/material_law.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace asperity
{
  /**
   * Derivatives of one element's functions at its points, laid out for vector
   * instructions of the widest kind that the processor has. Two layouts of
   * displacements, forces and rows of the stiffness:
   *
   * - dim = 2: both components of a function side by side, [2 a + i], and each
   *   derivative twice;
   * - dim = 3: one component after the other, [i row_length() + a], and each
   *   derivative once.
   *
   * All are padded by zeros to full vectors, and the points to groups of them.
   */
  template <int dim>
  class ElementGradients
  {
  public:
    /** All zero. @param axisymmetric whether there is a hoop strain, in two
     *  dimensions */
    ElementGradients(const unsigned int n_functions,
                     const unsigned int n_points,
                     const bool         axisymmetric = false);

    /** Grad N_a at a point [1/m], and N_a over the radius. */
    void
    set(const unsigned int            point,
        const unsigned int            a,
        const dealii::Tensor<1, dim> &gradient,
        const double                  hoop = 0.);

    unsigned int
    n_functions() const
    {
      return n;
    }

    /** Length of displacements and forces, padding included. */
    unsigned int
    size() const
    {
      return dim == 2 ? row_length_ : dim * row_length_;
    }

    /** Where a component of a function stands in displacements and forces. */
    unsigned int
    index(const unsigned int a, const unsigned int i) const
    {
      return dim == 2 ? 2 * a + i : i * row_length_ + a;
    }

    /** Deformation gradients at all points.
     *  @param u displacements, of which size() are read */
    void
    deform(const double *u, dealii::Tensor<2, 3> *F) const;

    /** forces += sum of weight P Grad N over the points.
     *  @param forces of which size() are written */
    void
    add_forces(const double           *weights,
               const MaterialResponse *responses,
               double                 *forces) const;

    unsigned int
    n_points() const
    {
      return n_points_;
    }

    /** Of the gradient: dim, with hoop strain 3. */
    unsigned int
    n_components() const
    {
      return n_components_;
    }

    /** Numbers of one component of the gradient at one point. */
    unsigned int
    row_length() const
    {
      return row_length_;
    }

    /** Gradients from a point on: [(point, component J) row_length() + ...]. */
    const double *
    from_point(const unsigned int point) const
    {
      return &values[point * n_components_ * row_length_];
    }

    /** Points whose products go well into registers together: the table is
     *  padded to a multiple of it. */
    static constexpr unsigned int group_size = 4;

  private:
    unsigned int        n;
    unsigned int        row_length_; ///< padded
    unsigned int        n_points_;
    unsigned int        n_components_;
    std::vector<double> values; ///< [(q n_components + J) row_length + ...]
  };
} // namespace asperity

#endif
