#ifndef asperity_coupling_coupling_parameters_h
#define asperity_coupling_coupling_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/coupling/acceleration.h>

#include <optional>

namespace asperity
{
  enum class CouplingScheme
  {
    robin_neumann,
    dirichlet_neumann
  };

  /** See PartitionedStep. */
  struct CouplingParameters
  {
    CouplingScheme scheme = CouplingScheme::robin_neumann;

    /** alpha [Pa s/m]; automatic: RobinCoefficient. */
    std::optional<double> robin_coefficient;

    AccelerationParameters acceleration;

    /** Of the changes of displacement and force and of the jump of velocity,
     *  each relative, see CouplingResidual. */
    double tolerance = 1e-5;

    unsigned int maximum_iterations = 50;

    /** Degree of the polynomial in time through the forces of the last steps
     *  that a step starts from. */
    unsigned int predictor_degree = 1;

    /** Smaller scales than these are not compared with (root mean square over
     *  the components): what is at rest has no scale of its own. */
    double displacement_floor = 0.; ///< [m]
    double force_floor        = 0.; ///< [N/m]
    double velocity_floor     = 0.; ///< [m/s]

    void
    declare(ParameterDeclarator &parameters);
  };
} // namespace asperity

#endif
