#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace asperity
{
  namespace
  {
    [[noreturn]] void
    fail(const std::string &path, const std::string &reason)
    {
      throw ComputationError("The file " + quoted_name(path) +
                             " could not be written: " + reason + ".");
    }

    /** A file of the system that is closed in every case. */
    class Descriptor
    {
    public:
      Descriptor(const std::string &path, const int flags)
        : number(::open(path.c_str(), flags, 0666))
      {}

      ~Descriptor()
      {
        if (number >= 0)
          ::close(number);
      }

      Descriptor(const Descriptor &) = delete;
      Descriptor &
      operator=(const Descriptor &) = delete;

      /** Some systems tell of a full disk only now. */
      bool
      close()
      {
        const int status = ::close(number);
        number           = -1;
        return status == 0;
      }

      int number;
    };

    bool
    write_all(const int descriptor, const std::string &bytes)
    {
      for (std::size_t done = 0; done < bytes.size();)
        {
          const auto n =
            ::write(descriptor, bytes.data() + done, bytes.size() - done);
          if (n < 0 && errno != EINTR)
            return false;
          done += std::max<ssize_t>(n, 0);
        }
      return true;
    }

    /** Waits until the content of a file or folder has reached the disk. */
    bool
    flush_to_disk(const int descriptor)
    {
      // Some network file systems cannot flush a folder; that is no failure.
      return ::fsync(descriptor) == 0 || errno == EINVAL;
    }

    void
    write_file(const std::string &path,
               const std::string &bytes,
               const Durability   durability)
    {
      Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
      const bool done =
        file.number >= 0 && write_all(file.number, bytes) &&
        (durability == Durability::process || flush_to_disk(file.number)) &&
        file.close();
      if (!done)
        throw std::system_error(errno, std::generic_category());
    }
  } // namespace



  std::string
  reason_of_failure(const int error_number)
  {
    std::string reason = std::generic_category().message(error_number);
    // "No space left on device" inside of a sentence, but "I/O error".
    if (reason.size() > 1 &&
        std::islower(static_cast<unsigned char>(reason[1])))
      reason[0] =
        static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
    return error_number == 0 ? "the stream failed" : reason;
  }



  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write,
                   const Durability                           durability)
  {
    namespace fs = std::filesystem;
    // In memory first: a stream into a file would forget why it has failed.
    std::ostringstream content;
    write(content);

    const fs::path folder =
      fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      fail(path, reason_of_failure(error.value()));

    // The process number keeps two runs into one folder apart.
    const std::string temporary =
      path + ".tmp" + std::to_string(static_cast<long>(::getpid()));
    try
      {
        write_file(temporary, content.str(), durability);
        fs::rename(temporary, path);
        if (durability == Durability::machine)
          {
            const Descriptor opened(folder.string(), O_RDONLY | O_CLOEXEC);
            if (opened.number < 0 || !flush_to_disk(opened.number))
              throw std::system_error(errno, std::generic_category());
          }
      }
    catch (const std::system_error &failure)
      {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        fail(path, reason_of_failure(failure.code().value()));
      }
  }



  std::string
  shortest_decimal(const double value)
  {
    std::array<char, 64> text;

    const bool whole = value == std::trunc(value) && std::abs(value) < 1e15;
    const auto end =
      whole ? std::to_chars(text.data(),
                            text.data() + text.size(),
                            value,
                            std::chars_format::fixed) :
              std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), end.ptr);
  }
} // namespace asperity
