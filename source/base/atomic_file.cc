#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace asperity
{
  namespace
  {
    [[noreturn]] void
    fail(const std::string &path, const std::string &reason)
    {
      throw ComputationError("The file " + path +
                             " could not be written: " + reason + ".");
    }

    std::string
    last_system_error()
    {
      return errno != 0 ? std::strerror(errno) : "the stream failed";
    }

    /** Waits until the content of a file or folder has reached the disk. */
    void
    flush_to_disk(const std::string &path)
    {
      const int descriptor = ::open(path.c_str(), O_RDONLY);
      if (descriptor < 0)
        fail(path, last_system_error());
      const int status = ::fsync(descriptor);
      const int error  = errno;
      ::close(descriptor);
      // Some network file systems cannot flush a folder; that is no failure.
      if (status != 0 && error != EINVAL)
        fail(path, std::strerror(error));
    }
  } // namespace



  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write,
                   const Durability                           durability)
  {
    namespace fs = std::filesystem;
    const fs::path folder =
      fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      fail(path, error.message());

    // The process number keeps two runs into one folder apart.
    const std::string temporary =
      path + ".tmp" + std::to_string(static_cast<long>(::getpid()));
    try
      {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        if (!out)
          fail(path, last_system_error());
        write(out);
        out.close();
        if (!out)
          fail(path, last_system_error());
        if (durability == Durability::machine)
          flush_to_disk(temporary);
        fs::rename(temporary, path, error);
        if (error)
          fail(path, error.message());
        if (durability == Durability::machine)
          flush_to_disk(folder.string());
      }
    catch (...)
      {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
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
