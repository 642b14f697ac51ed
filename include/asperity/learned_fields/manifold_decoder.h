#ifndef asperity_learned_fields_manifold_decoder_h
#define asperity_learned_fields_manifold_decoder_h

#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/learning/auto_decoder.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * Many modes, of which the first n have the code z as coefficients and the
   * others those that a network says of z (Barnett et al. 2023):
   *
   *   values = mean + sum over k <= n of z_k mode_k
   *                 + sum over k > n of f_k(z) mode_k.
   *
   * The fields of runs over few inputs are a curved surface of that dimension,
   * which a plane through it, as the first n modes alone are, misses.
   */
  class ManifoldDecoder : public FieldDecoder
  {
  public:
    static constexpr char decoder_name[] = "manifold";

    /** @param network from z to the coefficients of the further modes, without
     *    a code of its own
     *  @throws InputError if it does not fit the modes */
    ManifoldDecoder(const PodDecoder &modes, const AutoDecoder &network);

    /** As save() has written it. @throws InputError if it does not fit */
    ManifoldDecoder(const Hdf5Content &content,
                    const std::size_t  size,
                    const std::string &origin);

    std::string
    name() const override;

    unsigned int
    n_codes() const override;

    std::vector<double>
    decode(const std::vector<double> &code) const override;

    /** Coefficients of the first modes. */
    std::vector<double>
    encode(const std::vector<double> &values) const override;

    const FieldModes *
    modes() const override;

    /** The code, and what the network says of it. */
    std::vector<double>
    coefficients(const std::vector<double> &code) const override;

    void
    save(Hdf5Content &content) const override;

  private:
    void
    check(const std::string &origin) const;

    PodDecoder  linear;
    AutoDecoder network;
  };
} // namespace asperity

#endif
