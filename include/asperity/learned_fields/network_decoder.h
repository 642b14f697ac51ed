#ifndef asperity_learned_fields_network_decoder_h
#define asperity_learned_fields_network_decoder_h

#include <asperity/learned_fields/field_decoder.h>
#include <asperity/learned_fields/field_layout.h>
#include <asperity/learning/auto_decoder.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * One of the two functions that a NetworkDecoder learns: of the fields in the
   * chip, or of those on its edge. Positions are those of one period: waves
   * cos(2 pi m x/L), sin(2 pi m x/L) with m = 1, 2, 4, ... (Tancik et al.
   * 2020), the share of the time, and in the chip the height y and the
   * logarithm of the depth, since strain is near the edge.
   */
  class NetworkPart
  {
  public:
    /** @param is_edge or the chip */
    NetworkPart(const FieldLayout &layout, const bool is_edge);

    unsigned int
    n_outputs() const;

    unsigned int
    n_coordinates() const;

    /** Of all places of a kind at all times. */
    std::vector<double>
    positions(const PlaceKind kind) const;

    /** A run as it is learnt: all outputs at the Gauss points, at which fields
     *  of the nodes are interpolated. */
    FieldSample
    sample(const std::string &name, const std::vector<double> &values) const;

    /** Of positions to [-1, 1], in which waves are by themselves: at their
     *  zeros they differ by rounding, which is not to be scaled. */
    Scaling
    position_scaling(const std::vector<FieldSample> &samples) const;

    /** Writes what a network says into the vector of a run. */
    void
    fill(const AutoDecoder        &network,
         const std::vector<float> &code,
         std::vector<double>      &values) const;

  private:
    /** Where an output of a field begins. */
    struct Output
    {
      std::size_t  field;
      unsigned int first;
    };

    /** The places at which the part is learnt. */
    PlaceKind
    learnt_at() const;

    /** Of a field of nodes at a Gauss point of a cell. */
    double
    at_gauss_point(const std::vector<double> &values,
                   const std::size_t          offset,
                   const std::size_t          point,
                   const unsigned int         n_components,
                   const unsigned int         component) const;

    const FieldLayout  *layout;
    bool                is_edge;
    double              height; ///< of the chip [m]
    std::vector<Output> outputs;
    unsigned int        n = 0;

    /** [Gauss point of a line * (subdivisions + 1) + node] */
    std::vector<double> lagrange;
  };

  /**
   * Two networks f(z, x) (Park et al. 2019), one of the chip and one of its
   * edge, each with its part of the code: what they learn is a function of the
   * position, which knows nothing of the mesh.
   */
  class NetworkDecoder : public FieldDecoder
  {
  public:
    static constexpr char decoder_name[] = "network";

    NetworkDecoder(const FieldLayout &layout,
                   const AutoDecoder &chip,
                   const AutoDecoder &edge);

    /** As save() has written it. @throws InputError if it does not fit */
    NetworkDecoder(const FieldLayout &layout,
                   const Hdf5Content &content,
                   const std::string &origin);

    std::string
    name() const override;

    unsigned int
    n_codes() const override;

    std::vector<double>
    decode(const std::vector<double> &code) const override;

    /** By descent from the nearest code of the training, see infer_code(). */
    std::vector<double>
    encode(const std::vector<double> &values) const override;

    /** That of the training. */
    std::vector<double>
    code_of(const std::size_t run) const;

    void
    save(Hdf5Content &content) const override;

  private:
    FieldLayout layout;
    AutoDecoder chip, edge;
  };
} // namespace asperity

#endif
