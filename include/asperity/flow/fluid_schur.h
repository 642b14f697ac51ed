#ifndef asperity_flow_fluid_schur_h
#define asperity_flow_fluid_schur_h

#include <asperity/flow/fluid_assembler.h>
#include <asperity/flow/fluid_boundary.h>
#include <asperity/solvers/saddle_point_krylov.h>

namespace asperity
{
  /** What FlowSolver needs to know of a flow to estimate the Schur complement
   *  of its tangent. */
  class FluidSchur
  {
  public:
    using Vector = dealii::Vector<double>;

    explicit FluidSchur(const FluidSpace &space);

    /** At u: mass over viscosity and of compression, inertia, Robin terms.
     *  @param is_convective see SchurEstimate */
    const SchurEstimate &
    of_tangent(const Vector                    &u,
               const FluidAssembler            &assembler,
               const FluidBoundary             &boundary,
               const std::vector<unsigned int> &held_dofs,
               const bool                       is_convective);

    /** Of a matrix whose velocity block is a mass matrix. */
    const SchurEstimate &
    of_projection(const dealii::SparseMatrix<double> &matrix,
                  const std::vector<unsigned int>    &held_dofs);

  private:
    void
    set_levels(const std::vector<unsigned int> &held_dofs);

    const FluidSpace                 &space;
    dealii::AffineConstraints<double> pressure_topology; ///< numbered from 0
    SchurEstimate                     estimate;
  };
} // namespace asperity

#endif
