#ifndef asperity_base_archive_h
#define asperity_base_archive_h

#include <boost/archive/binary_iarchive_impl.hpp>
#include <boost/archive/binary_oarchive_impl.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/collection_size_type.hpp>
#include <boost/serialization/deque.hpp>
#include <boost/serialization/split_member.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <boost/serialization/wrapper.hpp>

#include <functional>
#include <iosfwd>
#include <string>

namespace asperity
{
  /** A binary archive of Boost.Serialization; bit for bit, in the byte order of
   *  the machine. */
  class OutputArchive
    : public boost::archive::
        binary_oarchive_impl<OutputArchive, char, std::char_traits<char>>
  {
  public:
    explicit OutputArchive(std::ostream &out);
  };

  /**
   * Reads what an OutputArchive wrote. No count of items that it reads is
   * larger than the number of bytes that are left, so a hostile archive cannot
   * ask for more memory than a multiple of its own size.
   */
  class InputArchive
    : public boost::archive::
        binary_iarchive_impl<InputArchive, char, std::char_traits<char>>
  {
  public:
    /** @param size number of bytes of `in` */
    InputArchive(std::istream &in, const std::size_t size);

    using Base = boost::archive::
      binary_iarchive_impl<InputArchive, char, std::char_traits<char>>;
    using Base::load;

    /** The length of a string or vector of deal.II.
     *  @throws boost::archive::archive_exception if there are not as many bytes
     */
    void
    load(std::size_t &count);

    /** Another byte than those of false and true has the same exception. */
    void
    load(bool &value);

    /** The number of items of a container, with the same exception. */
    void
    load_override(boost::serialization::collection_size_type &count);

    template <typename T>
    void
    load_override(T &value)
    {
      Base::load_override(value);
    }

  private:
    void
    check_count(const std::size_t count);

    std::istream &in;
    std::size_t   size;
  };

  /** The bytes of what `write` puts into an archive. */
  std::string
  to_bytes(const std::function<void(OutputArchive &)> &write);

  /**
   * Gives `read` an archive of such bytes, all of which it has to take.
   * @param name of what is read, for messages
   * @throws InputError if the bytes are not what `read` expects
   */
  void
  from_bytes(const std::string                         &bytes,
             const std::string                         &name,
             const std::function<void(InputArchive &)> &read);

  /** @throws InputError that says both lengths, unless they agree
   *  @param name of the numbers that are counted */
  void
  require_length(const std::string &name,
                 const std::size_t  found,
                 const std::size_t  expected);

  /** See fixed_length(). */
  template <typename Vector>
  struct FixedLength
    : boost::serialization::wrapper_traits<const FixedLength<Vector>>
  {
    FixedLength(Vector &vector, const std::string &name)
      : vector(vector)
      , name(name)
    {}

    Vector     &vector;
    std::string name;

    template <typename Archive>
    void
    save(Archive &archive, const unsigned int) const
    {
      archive << vector;
    }

    template <typename Archive>
    void
    load(Archive &archive, const unsigned int)
    {
      Vector loaded;
      archive >> loaded;
      require_length(name, loaded.size(), vector.size());
      vector = loaded;
    }

    BOOST_SERIALIZATION_SPLIT_MEMBER()
  };

  /** For archives, as in `archive & fixed_length(u, "displacements")`: a vector
   *  whose length is known, so that another one is refused as
   *  require_length() does. */
  template <typename Vector>
  const FixedLength<Vector>
  fixed_length(Vector &vector, const std::string &name)
  {
    return FixedLength<Vector>(vector, name);
  }
} // namespace asperity

#endif
