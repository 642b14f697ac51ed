#ifndef asperity_contact_zone_scene_heat_h
#define asperity_contact_zone_scene_heat_h

#include <asperity/contact/contact_assembler.h>
#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/thermal_contact.h>
#include <asperity/solid/solid_assembler.h>

#include <array>
#include <functional>
#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /** Heat of a scene, over a period and in two dimensions per thickness
   *  [J/m^(3 - dim)]. */
  struct HeatAmounts
  {
    double plastic  = 0.; ///< of the plastic work
    double friction = 0.; ///< of the interface
    double stored   = 0.; ///< in the chip that is modelled
    double depth    = 0.; ///< that has gone into the chip below
    double tool     = 0.; ///< that has gone into the tool

    /** |plastic + friction - stored - depth - tool| over the sum of their
     *  sizes; 0 if all are. */
    double
    balance_error() const;

    /** What has come since. */
    HeatAmounts
    since(const HeatAmounts &before) const;
  };

  /**
   * Heat in a scene whose heat model is conducting. During a step the points of
   * the chip warm adiabatically, as their law says; when it is accepted, the
   * heat of their plastic work and that of friction are conducted over the
   * step, and the points take the temperature of the field. The split is of
   * first order in time, as the conduction itself.
   *
   * The tool is a half-space in its own frame, the chip goes on as one below
   * its bottom. Where the bodies touch, heat goes over by the contact
   * conductance h; where oil fills a gap g, by 1/(1/h + g/lambda_oil); over a
   * dry gap none.
   *
   * On several ranks the chip is integrated by all, each its own cells; the
   * linear systems are solved by each of them, which costs little beside those
   * of the displacements.
   */
  template <int dim>
  class SceneHeat
  {
  public:
    using Vector = dealii::Vector<double>;

    using Periods = std::array<double, dim - 1>;

    /** The references must outlive this object.
     *  @param periods of the scene [m]
     *  @param share which cells of the chip are this process's own */
    SceneHeat(const SceneParameters       &parameters,
              const SplineSpace<dim>      &space,
              const PatchGeometry<dim>    &geometry,
              const Periods               &periods,
              SolidAssembler<dim>         &chip,
              const ContactAssembler<dim> &contact,
              const CellShare             &share = CellShare());

    /**
     * A step has been accepted: conducts its heat, and gives the points of the
     * chip their new temperatures; collective.
     * @param u at which the contact has been evaluated last [m]
     * @param dt length of the step [s]
     * @param friction frictional power at the points of the contact, per
     *   reference length or area [W/m^2]
     */
    void
    advance(const Vector              &u,
            const double               dt,
            const std::vector<double> &friction);

    /** Since the start. */
    const HeatAmounts &
    amounts() const;

    /** HeatAmounts::balance_error() of the last step alone. */
    double
    balance_error() const;

    /** At the points of the contact, at the end of the last step [K]. */
    std::vector<double>
    chip_temperature() const;

    /** The same of the tool [K]. */
    std::vector<double>
    tool_temperature() const;

    /** Flux into the tool at the points of the contact in the last step, per
     *  reference length or area of the chip [W/m^2]. */
    const std::vector<double> &
    flux_to_tool() const;

    /** Mean of the tool's surface [K]. */
    double
    mean_tool_temperature() const;

    /** Highest temperature of either body at the interface [K]. */
    double
    flash_temperature() const;

    void
    save(OutputArchive &archive) const;

    /** @throws InputError if the archive is of another scene */
    void
    load(InputArchive &archive);

    /** Takes values from another mesh to the present one. */
    using Transfer =
      std::function<std::vector<double>(const std::vector<double> &)>;

    /**
     * Takes what save() wrote on another mesh, and gives the points of the chip
     * their temperatures; collective. The next balance_error() has what this
     * changes of the heat that is stored.
     * @param of_splines for coefficients in the chip
     * @param of_points for values at the points of the contact
     */
    void
    take_over(InputArchive   &archive,
              const Transfer &of_splines,
              const Transfer &of_points);

  private:
    /** Rate at which the points have warmed by plastic work [W/m^3]. */
    Vector
    plastic_power(const double dt) const;

    InterfaceHeat<dim>
    interface(const std::vector<double> &friction) const;

    /** The points of the chip take the temperature of the field. */
    void
    warm_points();

    const HeatParameters        &parameters;
    const bool                   has_oil;
    const double                 start; ///< temperature of the chip [K]
    const ThermalProperties      material;
    SolidAssembler<dim>         &chip;
    const ContactAssembler<dim> &contact;
    HeatConduction<dim>          conduction;
    ThermalContact<dim>          exchange;

    /** Of the interface at the end of the last step. */
    std::vector<double> chip_rise, tool_rise, to_tool;

    HeatAmounts total;
    double      balance_error_ = 0.;
  };
} // namespace asperity

#endif
