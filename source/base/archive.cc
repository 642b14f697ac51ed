#include <asperity/base/archive.h>
#include <asperity/base/errors.h>

#include <boost/archive/archive_exception.hpp>
#include <boost/archive/impl/archive_serializer_map.ipp>
#include <boost/archive/impl/basic_binary_iarchive.ipp>
#include <boost/archive/impl/basic_binary_iprimitive.ipp>
#include <boost/archive/impl/basic_binary_oarchive.ipp>
#include <boost/archive/impl/basic_binary_oprimitive.ipp>

#include <new>
#include <sstream>
#include <stdexcept>

// What Boost's own archives are compiled from, as its manual asks for archives
// that derive from its implementations.
namespace boost
{
  namespace archive
  {
    template class detail::archive_serializer_map<asperity::OutputArchive>;
    template class basic_binary_oprimitive<asperity::OutputArchive,
                                           char,
                                           std::char_traits<char>>;
    template class basic_binary_oarchive<asperity::OutputArchive>;
    template class binary_oarchive_impl<asperity::OutputArchive,
                                        char,
                                        std::char_traits<char>>;
    template class detail::archive_serializer_map<asperity::InputArchive>;
    template class basic_binary_iprimitive<asperity::InputArchive,
                                           char,
                                           std::char_traits<char>>;
    template class basic_binary_iarchive<asperity::InputArchive>;
    template class binary_iarchive_impl<asperity::InputArchive,
                                        char,
                                        std::char_traits<char>>;
  } // namespace archive
} // namespace boost

namespace asperity
{
  OutputArchive::OutputArchive(std::ostream &out)
    : binary_oarchive_impl(out, 0)
  {
    init(0);
  }



  InputArchive::InputArchive(std::istream &in, const std::size_t size)
    : Base(in, 0)
    , in(in)
    , size(size)
  {
    init(0);
  }



  void
  InputArchive::load(std::size_t &count)
  {
    load_binary(&count, sizeof(count));
    check_count(count);
  }



  void
  InputArchive::load(bool &value)
  {
    unsigned char byte = 0;
    load_binary(&byte, 1);
    if (byte > 1)
      throw boost::archive::archive_exception(
        boost::archive::archive_exception::input_stream_error);
    value = (byte == 1);
  }



  void
  InputArchive::load_override(boost::serialization::collection_size_type &count)
  {
    Base::load_override(count);
    check_count(count);
  }



  void
  InputArchive::check_count(const std::size_t count)
  {
    if (count > size - static_cast<std::size_t>(in.tellg()))
      throw boost::archive::archive_exception(
        boost::archive::archive_exception::input_stream_error);
  }



  std::string
  to_bytes(const std::function<void(OutputArchive &)> &write)
  {
    std::ostringstream out(std::ios::binary);
    {
      OutputArchive archive(out);
      write(archive);
    }
    return out.str();
  }



  void
  from_bytes(const std::string                         &bytes,
             const std::string                         &name,
             const std::function<void(InputArchive &)> &read)
  {
    const auto refuse = [&name](const std::string &reason) {
      throw InputError(name + " is damaged: " + reason + ".");
    };
    // Boost takes the end of a header that is cut short for a version.
    if (bytes.size() < to_bytes([](OutputArchive &) {}).size())
      refuse("it does not hold what is expected of it");
    std::istringstream in(bytes, std::ios::binary);
    try
      {
        InputArchive archive(in, bytes.size());
        read(archive);
      }
    catch (const boost::archive::archive_exception &)
      {
        refuse("it does not hold what is expected of it");
      }
    catch (const std::length_error &)
      {
        refuse("a part of it is impossibly long");
      }
    catch (const std::bad_alloc &)
      {
        refuse("a part of it is impossibly long");
      }
    if (static_cast<std::size_t>(in.tellg()) != bytes.size())
      refuse("it holds more than is expected of it");
  }



  void
  require_length(const std::string &name,
                 const std::size_t  found,
                 const std::size_t  expected)
  {
    if (found != expected)
      throw InputError("The checkpoint holds " + std::to_string(found) + " " +
                       name + ", but " + std::to_string(expected) +
                       " are expected.");
  }
} // namespace asperity
