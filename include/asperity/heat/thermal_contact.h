#ifndef asperity_heat_thermal_contact_h
#define asperity_heat_thermal_contact_h

#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/periodic_half_space.h>
#include <asperity/isogeometric/basis_table.h>

#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /** What tool and chip exchange in a step, at the points of the chip's edge
   *  and per reference length (in three dimensions area) of it. */
  template <int dim>
  struct InterfaceHeat
  {
    /** Along the surface of the tool, in its frame [m]. */
    std::vector<dealii::Point<dim - 1>> places;

    std::vector<double> conductance; ///< h, not negative [W/(m^2 K)]
    std::vector<double> friction;    ///< q_f [W/m^2]
  };

  /**
   * The exchange of heat between a chip and a tool that touch. Frictional heat
   * arises between both and leaves by halves, and what flows over the
   * conductance h of the contact evens out their temperatures:
   *
   *   q_tool = q_f/2 + h (T_chip - T_tool),
   *   q_chip = q_f/2 - h (T_chip - T_tool),
   *
   * with the temperatures at the end of the step, solved together with the
   * conduction in both. A large h makes them equal, and leaves to each its
   * share by effusivity, h = 0 separates them.
   *
   * With the chip's and the tool's responses G_c and G_t at the points, their
   * weights W and s = sqrt(h W), the exchange h (T_chip - T_tool) = s y/W
   * follows from
   *
   *   (1 + s (G_c + G_t) s) y = s (T_chip - T_tool at y = 0),
   *
   * symmetric and positive definite for every h, by conjugate gradients. Heat
   * is conserved whatever their accuracy.
   */
  template <int dim>
  class ThermalContact
  {
  public:
    using Vector = dealii::Vector<double>;

    /**
     * @param edge of the chip; must outlive this object
     * @param tool material of the tool, a half-space with the periods of the
     *   edge
     * @param waves of its surface
     * @param offset temperature of the tool far away minus that of the chip at
     *   the start [K]
     */
    ThermalContact(const BasisTable<dim>   &edge,
                   const ThermalProperties &tool,
                   const FourierBasis<dim> &waves,
                   const double             offset);

    /** A step as solve() finds it; points are those of the edge. */
    struct Step
    {
      double              dt = 0.;     ///< [s]
      Vector              chip_change; ///< see HeatConduction::accept()
      Vector              tool_flux;   ///< see PeriodicHalfSpace::accept()
      std::vector<double> chip;        ///< rise of the chip over its start [K]
      std::vector<double> tool; ///< rise of the tool over the chip's start [K]
      std::vector<double> to_tool; ///< q_tool [W/m^2]
      unsigned int        iterations = 0;
    };

    /**
     * @param chip whose step has begun
     * @param dt of that step [s]
     * @param power of the sources in the chip, by function [W/m^(3 - dim)]
     * @throws ComputationError if the iteration does not converge
     */
    Step
    solve(const HeatConduction<dim> &chip,
          const double               dt,
          const Vector              &power,
          const InterfaceHeat<dim>  &interface) const;

    /** The step is over. */
    void
    accept(const Step &step);

    /** Heat that has gone into the tool [J/m^(3 - dim)]. */
    double
    heat_of_tool() const;

    void
    save(OutputArchive &archive) const;

    /** @throws InputError if the archive is of another tool */
    void
    load(InputArchive &archive);

  private:
    const BasisTable<dim> &edge;
    PeriodicHalfSpace<dim> tool;
    double                 offset;
  };
} // namespace asperity

#endif
