#ifndef asperity_heat_body_continuation_h
#define asperity_heat_body_continuation_h

#include <asperity/heat/periodic_half_space.h>
#include <asperity/isogeometric/basis_table.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * What follows beyond an edge (in three dimensions a face) of a body that is
   * modelled only down to there: a half-space of the same material, periodic
   * along the edge, at first of the same temperature. With b_ma = int f_m N_a
   * dS along the edge and the coefficients theta_m = norm(m) sum_a b_ma T_a of
   * the body's temperature there, the flux q_m that makes both equal at the end
   * of a step is
   *
   *   q_m = (theta_m - remembered_m)/S_m,
   *
   * so that the edge neither reflects heat nor keeps it, up to the waves that
   * are left out. The edge counts as straight, normal to the last axis.
   */
  template <int dim>
  class BodyContinuation
  {
  public:
    using Vector = dealii::Vector<double>;

    /** @param edge its table may go, and has one period of the waves
     *  @param waves in the half-space; without any the mean alone */
    BodyContinuation(const BasisTable<dim>   &edge,
                     const ThermalProperties &material,
                     const FourierBasis<dim> &waves);

    /** The functions of the edge are all coupled. */
    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    /** Sets the length of the step [s]. */
    void
    begin_step(const double dt);

    /** Adds the derivative of minus add_power() to a matrix
     *  [W/(m^(3 - dim) K)]. */
    void
    add_conductance(dealii::SparseMatrix<double> &matrix) const;

    /** Adds the heat that comes out of the half-space in the step, by function
     *  of the body [W/m^(3 - dim)].
     *  @param rise coefficients of the body's temperature rise at the end of
     *    the step [K] */
    void
    add_power(const Vector &rise, Vector &power) const;

    /** The step is over, with this rise at its end. */
    void
    accept(const Vector &rise);

    /** Heat that has gone into the half-space [J/m^(3 - dim)]. */
    double
    heat() const;

    void
    save(OutputArchive &archive) const;

    /** @throws InputError if the archive is of another edge */
    void
    load(InputArchive &archive);

  private:
    /** q_m [W/m^2], into the half-space. */
    Vector
    flux(const Vector &rise) const;

    PeriodicHalfSpace<dim>     beyond;
    std::vector<unsigned int>  functions; ///< of the edge
    dealii::FullMatrix<double> b;         ///< see above [m^(dim - 1)]

    double dt = 0.;
    Vector response, remembered; ///< of the half-space in this step
  };
} // namespace asperity

#endif
