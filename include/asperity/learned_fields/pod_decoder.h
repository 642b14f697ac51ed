#ifndef asperity_learned_fields_pod_decoder_h
#define asperity_learned_fields_pod_decoder_h

#include <asperity/learned_fields/field_decoder.h>
#include <asperity/learned_fields/field_modes.h>
#include <asperity/learning/orthogonal_decomposition.h>

namespace asperity
{
  /**
   * The first modes of a proper orthogonal decomposition (Sirovich 1987):
   * values = mean + sum over k of z_k mode_k, z_k the inner product of
   * deviation and mode. No other basis errs less over the runs that it was made
   * of; what is a balance of every run, linear in its fields, is one of mean
   * and modes, too.
   */
  class PodDecoder : public FieldDecoder
  {
  public:
    static constexpr char decoder_name[] = "pod";

    /** @param weights of the inner product
     *  @throws InputError if there are not so many modes */
    PodDecoder(const OrthogonalDecomposition &decomposition,
               const std::vector<double>     &weights,
               const unsigned int             n_codes);

    /** As save() has written it. @throws InputError if it does not fit */
    PodDecoder(const Hdf5Content &content,
               const std::size_t  size,
               const std::string &origin);

    std::string
    name() const override;

    unsigned int
    n_codes() const override;

    std::vector<double>
    decode(const std::vector<double> &code) const override;

    std::vector<double>
    encode(const std::vector<double> &values) const override;

    const FieldModes *
    modes() const override;

    /** The code. */
    std::vector<double>
    coefficients(const std::vector<double> &code) const override;

    void
    save(Hdf5Content &content) const override;

  private:
    FieldModes          modes_;
    std::vector<double> weights;
  };
} // namespace asperity

#endif
