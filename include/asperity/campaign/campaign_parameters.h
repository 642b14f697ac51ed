#ifndef asperity_campaign_campaign_parameters_h
#define asperity_campaign_campaign_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/surrogate/design.h>
#include <asperity/surrogate/friction_law.h>

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  /** One input of a campaign: an entry of the base scene and its range. */
  struct InputParameters
  {
    std::string entry; ///< "Load/Pressure"; empty: not used
    std::string from;  ///< with unit
    std::string to;
    Scale       scale = Scale::linear;
    std::string export_at; ///< with unit; empty: as the base scene has it

    void
    declare(ParameterDeclarator &parameters, const unsigned int number);

    /** The entry without blanks around its parts, as the scene calls it. */
    std::string
    path() const;
  };

  /** Which points are computed. */
  struct DesignParameters
  {
    DesignKind          kind         = DesignKind::sobol;
    unsigned int        initial_runs = 40;
    std::vector<double> grid_points;       ///< of a grid, one number an input
    unsigned int        batch        = 10; ///< of active learning; 0: none
    unsigned int        maximum_runs = 150;
    double              target_error = 0.01;
    unsigned int        test_runs    = 0;
    std::string         test_table; ///< runs.csv of another campaign, or empty
    unsigned int        seed = 1;

    void
    declare(ParameterDeclarator &parameters);

    /** Points of the first design. */
    double
    n_first_runs() const;

    /** @throws InputError if the first design is too small for a law of so many
     *  inputs, too large for any, or no design at all */
    void
    check(const ParameterDeclarator &parameters,
          const std::size_t          n_inputs) const;
  };

  /** Which result of a run the law is about. */
  enum class LawOutput
  {
    mu,    ///< mean over the window of the base scene
    mu_end ///< at the end of the run
  };

  /** What the process of the law sees of the pressure. */
  enum class PressureScale
  {
    as_it_is,
    over_strength, ///< p / k(T, eps), see LawCoordinates
    logarithm_over_strength
  };

  struct LawParameters
  {
    LawOutput  output                    = LawOutput::mu;
    KernelKind kernel                    = KernelKind::matern_3_2;
    Scale      output_scale              = Scale::logarithmic;
    double     largest_trusted_deviation = 0.05;

    PressureScale pressure_scale = PressureScale::as_it_is;

    /** At which the shear limit of the chip is taken. */
    double shear_strain = 1.;
    double shear_rate   = 1e6; ///< [1/s]

    /** sensitivity.json of the base scene, or empty. */
    std::string sensitivity;

    /** How far mu of the surface may lie below and above that of its profiles
     *  in plane strain, as shares of it; not stated if both are 0. */
    double plane_strain_below = 0., plane_strain_above = 0.;

    void
    declare(ParameterDeclarator &parameters);
  };

  struct ExportParameters
  {
    bool   write           = true;
    double table_tolerance = 0.01; ///< of linear interpolation, relative

    void
    declare(ParameterDeclarator &parameters);
  };

  /** Everything that a parameter file of a campaign says. */
  struct CampaignParameters
  {
    static constexpr unsigned int largest_number_of_inputs = 6;

    std::string base_scene;
    std::string directory = "output/campaign";

    /** Values of Tool/Topography/Profile position, separated by commas; every
     *  point is computed on each of them. Empty: the base scene's. */
    std::string profile_positions;

    bool repeat_failed_runs = false;

    std::array<InputParameters, largest_number_of_inputs> inputs;
    DesignParameters                                      design;
    LawParameters                                         law;
    ExportParameters                                      exports;

    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if entries contradict each other, or cannot give a
     *  law */
    void
    check(const ParameterDeclarator &parameters) const;

  private:
    void
    check_input(const ParameterDeclarator &parameters,
                const std::size_t          number) const;

    void
    check_profiles(const ParameterDeclarator &parameters) const;
  };
} // namespace asperity

#endif
