#ifndef asperity_solid_deformable_body_h
#define asperity_solid_deformable_body_h

#include <asperity/isogeometric/force_term.h>

namespace asperity
{
  /** A body with mass and memory, as a time step sees it. */
  class DeformableBody : public ForceTerm
  {
  public:
    /** Length of the step that the next calls evaluate [s]. */
    virtual void
    set_time_step(const double dt) = 0;

    /** The end of the step becomes the start of the next one. */
    virtual void
    accept() = 0;

    /** Consistent mass matrix, integral of rho0 N_a N_b, all components. */
    virtual void
    assemble_mass(dealii::SparseMatrix<double> &mass) const = 0;
  };
} // namespace asperity

#endif
