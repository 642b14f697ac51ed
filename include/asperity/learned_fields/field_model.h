#ifndef asperity_learned_fields_field_model_h
#define asperity_learned_fields_field_model_h

#include <asperity/learned_fields/field_data.h>
#include <asperity/learned_fields/field_decoder.h>
#include <asperity/learned_fields/field_modes.h>
#include <asperity/postprocess/field_picture.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** What decoded fields say of a time. */
  struct FieldMomentPrediction
  {
    double T_x = 0., T_y = 0.; ///< force of the tractions [N/m]
    double mu = 0.;            ///< T_x over T_y, as of a run

    /** Standard deviation of mu: of the codes and of the decoder. */
    double mu_deviation = 0.;

    /** |T_y| against the load p L, over it. */
    double load_residual = 0.;

    /** Tractions against the stress in the chip, see imbalance_of_stress(),
     *  over p L; 0 with inertia. */
    double stress_residual = 0.;

    /** Shear T_x/L against mu p with the mu of a law that learnt it from the
     *  runs, over p. */
    double shear_residual = 0.;
  };

  /** What is measured of a prediction in order to trust it, each over its limit
   *  so that 1 is at the edge. */
  struct FieldTrust
  {
    double load = 0., stress = 0., shear = 0.; ///< residuals

    /** Deviation of the codes over that of the runs. */
    double codes = 0.;

    /** 1 plus the distance from the box of the data in widths of it, or 0
     *  inside. */
    double box = 0.;

    /** The largest: up to 1 the fields are trusted. */
    double
    score() const;
  };

  /** A contact zone that was not computed: its code, which
   *  FieldDecoder::decode() makes fields of, and what they say. */
  struct FieldPrediction
  {
    std::vector<double>                code, deviation; ///< of the code
    std::vector<FieldMomentPrediction> moments;         ///< one a time
    FieldTrust                         trust;
  };

  /** What the largest residuals of held-out runs were, beyond which fields are
   *  not trusted, and what the decoder alone errs in mu. */
  struct FieldLimits
  {
    /** By how much residuals may be larger than any of a held-out run. */
    static constexpr double margin = 1.5;

    double load = 0., stress = 0., shear = 0., codes = 0.;
    double mu = 0.; ///< deviation of the decoder's mu with the best codes
  };

  /**
   * The fields of the contact zone as a function of the inputs x of a campaign:
   * a decoder of latent codes z, and for each component of z a Gaussian process
   * z_k(x) (behind a FrictionLaw, which has the scales of inputs, and
   * deviations that cross-validation has calibrated).
   */
  class FieldModel
  {
  public:
    /**
     * Trains the processes on the codes of the runs that are not held out, and
     * takes the limits of trust from those that are.
     * @param decoder trained on the first
     * @param codes the best ones of all runs
     */
    FieldModel(const FieldData                        &data,
               std::shared_ptr<const FieldDecoder>     decoder,
               const std::vector<std::vector<double>> &codes);

    /** Without decoding fields if the decoder has modes.
     *  @param x inputs, SI */
    FieldPrediction
    predict(const std::vector<double> &x) const;

    /** What the fields of a code say of mu and balance at x, without the
     *  deviation of mu. */
    std::vector<FieldMomentPrediction>
    judge(const std::vector<double> &code, const std::vector<double> &x) const;

    /** Of the fields of a code, as forces_of() would have it. */
    std::vector<FieldForces>
    forces(const std::vector<double> &code) const;

    const FieldLayout &
    layout() const;

    const FieldDecoder &
    decoder() const;

    /** The law of mu at the last time, which knows the inputs. */
    const FrictionLaw &
    mu_law() const;

    /** When and where the chip is at a time. */
    FieldMoment
    moment(const unsigned int time, const std::vector<double> &x) const;

    const FieldLimits &
    limits() const;

    /** @throws ComputationError if the file cannot be written */
    void
    save(const std::string &path) const;

    /** @throws InputError if the file is missing, damaged, or no model */
    static FieldModel
    load(const std::string &path);

  private:
    /** Without laws and limits. */
    FieldModel(const FieldLayout                  &layout,
               const std::vector<FieldTime>       &times,
               std::shared_ptr<const FieldDecoder> decoder);

    /** Codes of the runs to learn from become laws. */
    void
    train_laws(const FieldData                        &data,
               const std::vector<std::vector<double>> &codes);

    void
    set_limits(const FieldData                        &data,
               const std::vector<std::vector<double>> &codes);

    FieldTrust
    trust(const FieldPrediction     &prediction,
          const std::vector<double> &x) const;

    /** Load at a time [Pa]. */
    double
    load_at(const unsigned int time, const std::vector<double> &x) const;

    FieldLayout                         layout_;
    std::vector<FieldTime>              times;
    std::shared_ptr<const FieldDecoder> decoder_;
    std::optional<ForcesOfModes>        forces_of_modes;
    std::vector<FrictionLaw>            code_laws;
    std::vector<FrictionLaw>            mu_laws; ///< one a time
    std::vector<double>                 spread;  ///< of each code over the runs
    FieldLimits                         limits_;
  };
} // namespace asperity

#endif
