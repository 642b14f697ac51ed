#ifndef asperity_contact_zone_lubrication_parameters_h
#define asperity_contact_zone_lubrication_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/constitutive/lubricant_parameters.h>
#include <asperity/coupling/coupling_parameters.h>
#include <asperity/coupling/gap_flow.h>

#include <string>

namespace asperity
{
  /** The rungs of the lubricant ladder. */
  enum class LubricantModel
  {
    automatic, ///< as the scene audit says
    none,
    pocket,
    reynolds,
    stokes,
    navier_stokes
  };

  /** As in parameter files. */
  std::string
  name(const LubricantModel model);

  /** Whether the oil is a flow in the whole gap, coupled to the chip by
   *  PartitionedStep. */
  bool
  fills_gap(const LubricantModel model);

  /** What the oil is counted by. */
  enum class OilAmount
  {
    void_at_start, ///< part of the void at the start, its gap included
    void_at_touch, ///< part of the void at first touch
    film_thickness ///< volume over area
  };

  /** The mesh of an oil that fills the gap, see GapFlow. */
  struct FilmMeshParameters
  {
    unsigned int columns_per_span = 1; ///< of the chip's edge
    unsigned int rows             = 2;

    void
    declare(ParameterDeclarator &parameters);
  };

  /** How the flow of an oil that fills the gap is computed, see GapFlow. */
  struct FlowParameters
  {
    MeshUpdateKind  mesh_update = MeshUpdateKind::columns;
    double          stiffening  = 1.; ///< of the elastic mesh update
    FluidTimeScheme time_scheme = FluidTimeScheme::bdf2;
    FluidElement    element     = FluidElement::taylor_hood;
    FlowSolverKind  solver      = FlowSolverKind::direct;
    GapEnd          left, right;
    double          initial_pressure = 0.; ///< [Pa]

    bool compressible = false; ///< by the density law of the oil

    void
    declare(ParameterDeclarator &parameters);

  private:
    void
    declare_ends(ParameterDeclarator &parameters);
  };

  /** How much oil there is, and how it is modelled. */
  struct LubricationParameters
  {
    LubricantModel model   = LubricantModel::none;
    OilAmount      amount  = OilAmount::void_at_start;
    double         wetting = 1.;    ///< w, oil over void
    double         film    = 50e-9; ///< of OilAmount::film_thickness [m]

    /** Gap under which surfaces seal [m]; 0: one connected void. */
    double sealing_gap = 0.;

    /** Intervals of x, from and to by turns, in each of which lies a pocket
     * that holds oil at the start; models that fill the gap, with a sealing gap
     *  [m]. */
    std::vector<double> pockets;

    /** Film that stays where surfaces touch [m]; models with flow. */
    double residual_film = 5e-9;

    LubricantParameters oil;

    // Models that fill the gap
    FilmMeshParameters mesh;
    FlowParameters     flow;
    CouplingParameters coupling = default_coupling();

    void
    declare(ParameterDeclarator &parameters);

    /** Of a model that fills the gap. */
    GapFlowOptions
    gap_flow() const;

    /** Relations between entries.
     *  @throws InputError naming the entry that contradicts another */
    void
    check(const ParameterDeclarator &parameters) const;

  private:
    void
    declare_amount(ParameterDeclarator &parameters);

    /** Whether there is oil, and as much as the model takes. */
    void
    check_amount(const ParameterDeclarator &parameters) const;

    /** Whether intervals begin before they end, and do not overlap. */
    void
    check_pockets(const ParameterDeclarator &parameters) const;

    /** Whether the flow has a density law where it needs one. */
    void
    check_flow(const ParameterDeclarator &parameters) const;

    /** Whether the ends of a gap that the oil fills go together. */
    void
    check_ends(const ParameterDeclarator &parameters) const;

    /** Columns of more steps, or such that nearly depend on newer ones, mislead
     *  the quasi-Newton iteration where asperities come into contact. */
    static CouplingParameters
    default_coupling();
  };
} // namespace asperity

#endif
