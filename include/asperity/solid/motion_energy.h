#ifndef asperity_solid_motion_energy_h
#define asperity_solid_motion_energy_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <limits>
#include <string>

namespace asperity
{
  /**
   * What the steps of generalized-alpha do to the energy of a body [J/m, in
   * three dimensions J, with forces in N]. Over a step the kinetic energy
   * should grow by the work of the forces; what is missing, with the work by
   * the trapezoidal rule, the method has taken away. Newmark's method without
   * damping takes nothing by this measure.
   */
  struct MotionEnergy
  {
    using Vector = dealii::Vector<double>;

    /** One end of a step, as seen from where the prescribed components rest. */
    struct End
    {
      /** Displacement [m], velocity [m/s], sum of the forces on the body [N/m].
       */
      Vector u, v, forces;
    };

    void
    add(const dealii::SparseMatrix<double> &mass,
        const End                          &before,
        const End                          &after);

    /** What is to be said if the method has taken away too much.
     *  @param work that of friction [J/m], beside which a loss may be small
     *  @return empty if it has not */
    std::string
    warning(const double work) const;

    /** Part of the energy that was in play.
     *  @param work see warning() */
    double
    lost_part(const double work) const;

    double lost   = 0.;
    double change = 0.; ///< largest of the kinetic energy since the start
    double start  = std::numeric_limits<double>::quiet_NaN(); ///< kinetic

    /** For archives of Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &lost &change &start;
    }
  };
} // namespace asperity

#endif
