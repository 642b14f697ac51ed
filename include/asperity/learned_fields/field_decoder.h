#ifndef asperity_learned_fields_field_decoder_h
#define asperity_learned_fields_field_decoder_h

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  struct Hdf5Content;
  class FieldLayout;
  struct FieldModes;

  /**
   * Turns a latent code z, a few numbers, into the fields of a run at all
   * places and times, and back: what a basis (POD) and a network have in
   * common.
   */
  class FieldDecoder
  {
  public:
    virtual ~FieldDecoder() = default;

    /** As in `asperity reduce --decoder`. */
    virtual std::string
    name() const = 0;

    /** Length of z. */
    virtual unsigned int
    n_codes() const = 0;

    /** @return the vector of a FieldLayout, SI */
    virtual std::vector<double>
    decode(const std::vector<double> &code) const = 0;

    /** The code whose fields are nearest to these. */
    virtual std::vector<double>
    encode(const std::vector<double> &values) const = 0;

    /** Of which the fields are a linear combination; none of a network. */
    virtual const FieldModes *
    modes() const
    {
      return nullptr;
    }

    /** Of the modes, to which decode() adds up; empty without modes. */
    virtual std::vector<double>
    coefficients(const std::vector<double> & /*code*/) const
    {
      return {};
    }

    /** Adds tables and texts from which load_decoder() makes it again. */
    virtual void
    save(Hdf5Content &content) const = 0;
  };

  /** @param origin the file, for messages
   *  @throws InputError if there is none, or it does not fit the layout */
  std::unique_ptr<FieldDecoder>
  load_decoder(const Hdf5Content &content,
               const FieldLayout &layout,
               const std::string &origin);
} // namespace asperity

#endif
