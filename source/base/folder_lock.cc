#include <asperity/base/errors.h>
#include <asperity/base/folder_lock.h>
#include <asperity/base/text.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace asperity
{
  FolderLock::FolderLock(const std::string &folder, const std::string &where)
  {
    std::error_code ignored; // the next call says what is wrong
    std::filesystem::create_directories(folder, ignored);
    descriptor =
      ::open((folder + "/lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor < 0)
      throw InputError(where + ": cannot write into the folder " +
                       quoted_name(folder) + " (" + std::strerror(errno) +
                       "); expected a place where it can be made or written.");
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      return;
    const int error = errno;
    if (error != EWOULDBLOCK)
      {
        // Some network file systems cannot lock; nobody could run on them.
        warning_ = "The folder " + quoted_name(folder) + " cannot be locked (" +
                   std::strerror(error) +
                   "); make sure that nothing else is run into it.";
        return;
      }
    ::close(descriptor);
    throw InputError(where + ": another process writes into the folder " +
                     quoted_name(folder) +
                     "; expected another folder, or that it has "
                     "ended.");
  }



  FolderLock::~FolderLock()
  {
    ::close(descriptor);
  }



  const std::string &
  FolderLock::warning() const
  {
    return warning_;
  }
} // namespace asperity
