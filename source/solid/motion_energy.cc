#include <asperity/base/quantity.h>
#include <asperity/solid/motion_energy.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Part that is worth a word. */
    constexpr double largest_loss = 0.035;

    double
    kinetic(const dealii::SparseMatrix<double> &mass,
            const dealii::Vector<double>       &v)
    {
      return 0.5 * mass.matrix_norm_square(v);
    }
  } // namespace



  void
  MotionEnergy::add(const dealii::SparseMatrix<double> &mass,
                    const End                          &before,
                    const End                          &after)
  {
    const double old_energy = kinetic(mass, before.v),
                 new_energy = kinetic(mass, after.v);
    if (std::isnan(start))
      start = old_energy;
    Vector way = after.u, force = after.forces;
    way -= before.u;
    force += before.forces;
    lost += 0.5 * (way * force) - (new_energy - old_energy);
    change = std::max(change, std::abs(new_energy - start));
  }



  double
  MotionEnergy::lost_part(const double work) const
  {
    return lost == 0. ? 0. : lost / (change + work);
  }



  std::string
  MotionEnergy::warning(const double work) const
  {
    if (lost_part(work) <= largest_loss)
      return "";
    return "The time steps have taken away " +
           format_quantity(100. * lost_part(work), "1", 2) +
           " % of the energy of the chip's motion, friction and load, where less "
           "than 3.5 % is expected: they are too long for what its mass does in "
           "an impact; raise Protocol/Ramp steps and Slide steps, or leave the "
           "mass out (Protocol/Inertia = quasi-static).";
  }
} // namespace asperity
