#ifndef asperity_surrogate_friction_law_h
#define asperity_surrogate_friction_law_h

#include <asperity/surrogate/gaussian_process.h>
#include <asperity/surrogate/law_coordinates.h>
#include <asperity/surrogate/piecewise_power_law.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** What a law says at one point; SI. */
  struct LawPrediction
  {
    double              mean      = 0.;
    double              deviation = 0.; ///< standard, of the fitted function
    std::vector<double> gradient;       ///< d mean / d x, one an input

    /** Another run would give a value between them with a probability of 95 %:
     *  the deviation and the noise of a run (of mesh and time steps, and of
     * what the process cannot follow) on the profiles that were computed. */
    double lower = 0., upper = 0.;

    /** The mean over the whole surface lies between them with a probability of
     *  95 %: [lower, upper], widened by
     *  FrictionLawDescription::topography_error. */
    double surface_lower = 0., surface_upper = 0.;

    /** Inside the box of the training data, with a deviation of at most
     *  FrictionLaw::largest_trusted_deviation times the mean. */
    bool trusted = false;
  };

  /** How far choices of one kind, which a user makes by hand or does not know
   *  better, may move the output, as shares of it. */
  struct ChoiceSpread
  {
    /** The kind of what profiles err against a patch of the surface, which
     *  patches tell and no variation of the scene. */
    static constexpr const char *plane_strain = "plane strain";

    std::string kind; ///< "preparation", "profile", "scene", "constants"
    double      below = 0., above = 0.; ///< not negative
  };

  /** All that makes a law, before it is trained. */
  struct FrictionLawDescription
  {
    std::vector<LawInput> inputs;
    std::string           output       = "mu";
    Scale                 output_scale = Scale::logarithmic;
    KernelKind            kernel       = KernelKind::matern_5_2;

    double largest_trusted_deviation = 0.05; ///< relative to the mean

    /** Profiles of the surface over which the output is a mean. */
    unsigned int n_profiles = 1;

    /** Relative standard deviation S between these profiles; 0 if there was
     *  only one. */
    double topography_scatter = 0.;

    /** Half width of the 95 % interval of the mean over the whole surface, from
     *  the scatter between the K profiles alone, relative to the mean: S /
     *  sqrt(K) times Student's quantile for K - 1 degrees of freedom; 0, that
     *  is unknown, for one profile. All points share this error, so that it is
     *  no part of LawPrediction::deviation. Set by training. */
    double topography_error = 0.;

    /** Relative leave-one-out error, mean of |error| / value; set by training.
     */
    double leave_one_out_error = 0.;

    /** What training has multiplied the deviations of the likelihood by, so
     *  that the 95 % interval holds 95 % of the training points, each predicted
     *  by the others; in the hyperparameters already. */
    double calibration = 1.;

    ShearLimit shear_limit;

    /** Whether the process sees p / k instead of p, see LawCoordinates. */
    bool pressure_over_strength = false;

    /** Found by varying one scene, see Friction law/Sensitivity file; taken to
     *  be the same shares everywhere. Empty: not known. */
    std::vector<ChoiceSpread> choices;

    /** What makes the friction, see mechanisms_sentence(); empty: not known. */
    std::vector<std::string> mechanisms;

    /** What training has to say about the data and the hyperparameters, one
     *  sentence each; set by training. */
    std::vector<std::string> warnings;

    nlohmann::ordered_json provenance; ///< versions, files, date, design
  };

  /** Whether an output of runs, "mu" or "mu_end", is a friction coefficient. */
  bool
  is_friction_coefficient(const std::string &output);

  /** What a law was trained on; SI. */
  struct LawData
  {
    std::vector<double> x;               ///< n x d
    std::vector<double> y;               ///< n
    std::vector<double> known_deviation; ///< n, or empty
  };

  /**
   * mu (or another result) as a function of the scene's inputs: a Gaussian
   * process that was trained on runs, or a piecewise power law that was fitted
   * to measurements, behind the scales of inputs and output. With a logarithmic
   * output the process is fitted to ln(mu): mean = exp(m), deviation = mean s,
   * and the interval is exp(m -+ 1.96 sqrt(s^2 + noise variance)). The values
   * that the process sees are centred and scaled to unit variance.
   */
  class FrictionLaw
  {
  public:
    /** Part of an input's range by which a point may miss the box and still be
     *  inside: what a conversion of units may cost it. */
    static constexpr double edge_tolerance = 1e-9;

    /** Training takes n^2 numbers of memory and n^3 operations. */
    static constexpr unsigned int largest_number_of_runs = 5000;

    /**
     * Trains the hyperparameters by maximum likelihood, and the size of the
     * deviations by leave-one-out errors (from 20 points without a known
     * deviation on).
     * @param x n x d inputs in SI @param y n values
     * @param known_deviation standard deviation of each value, or empty
     * @throws InputError if values are not positive on a logarithmic scale, not
     *   finite, or fewer than d + 2, or if a point lies outside of the box
     */
    static FrictionLaw
    train(const FrictionLawDescription &description,
          const std::vector<double>    &x,
          const std::vector<double>    &y,
          const std::vector<double>    &known_deviation = {});

    /**
     * Fits the piecewise power law over the velocity, the description's only
     * input, to measurements. The interval's deviations are enlarged by
     * Student's quantile over 1.96, since the measurements are few.
     * @param description its scales, kernel and range are replaced
     * @param v velocities [m/s], @param mu values
     * @param deviation standard deviation of each value, or empty
     * @throws InputError as fit_piecewise_power_law(), or if there are fewer
     *   than three measurements or one velocity only
     */
    static FrictionLaw
    fit_to_measurements(const FrictionLawDescription &description,
                        const std::vector<double>    &v,
                        const std::vector<double>    &mu,
                        const std::vector<double>    &deviation,
                        const PiecewisePowerOptions  &options = {});

    /** Inputs outside of the box are answered, but not trusted; those for which
     *  the logarithm does not exist are clamped to the box. */
    LawPrediction
    predict(const double *x) const;

    double
    mean(const double *x) const;

    /** @param x n x d inputs */
    void
    means(const std::size_t n, const double *x, double *result) const;

    bool
    is_inside(const double *x) const;

    const FrictionLawDescription &
    description() const;

    const LawData &
    data() const;

    /** @throws InputError if the law was fitted to measurements */
    const GaussianProcess &
    process() const;

    /** The piecewise power law that was fitted to measurements, or null. */
    const PiecewisePowerRegression *
    fitted() const;

    /** What the process or the formula sees of the inputs. */
    const LawCoordinates &
    coordinates() const;

    /** value of the process or the formula = (g(y) - offset) / factor */
    double
    offset() const;

    double
    factor() const;

    nlohmann::ordered_json
    to_json() const;

    /** @throws InputError naming @p origin if the document is no law, or not as
     *  it was written: its checksum says so */
    static FrictionLaw
    from_json(const nlohmann::ordered_json &document,
              const std::string            &origin);

    /** @throws InputError if the file is missing, is no law, or was changed */
    static FrictionLaw
    load(const std::string &path);

    void
    save(const std::string &path) const;

  private:
    /** Checks everything but the numbers that training finds. */
    FrictionLaw(const FrictionLawDescription &description,
                const LawData                &data,
                const std::string            &origin);

    /** The description, range and calibration included, is there already. */
    void
    set_fitted(const PiecewisePowerLaw &law);

    /** The training data as the process sees them. */
    TrainingData
    scaled_data() const;

    /** Mean of |error| / value of each training point predicted by the others.
     */
    double
    left_out_error() const;

    /** @throws InputError if numbers of a file are damaged, as far as its error
     *  of cross-validation tells */
    void
    require_agreement(const TrainingData &data,
                      const std::string  &origin) const;

    /** The output that belongs to a value of the process. */
    double
    unscaled(const double value) const;

    FrictionLawDescription            description_;
    LawData                           data_;
    std::shared_ptr<const Regression> regression;
    double                            offset_ = 0., factor_ = 1.;
    LawCoordinates                    coordinates_;
  };
} // namespace asperity

#endif
