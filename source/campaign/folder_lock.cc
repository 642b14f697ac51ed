#include <asperity/campaign/folder_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace asperity
{
  FolderLock::~FolderLock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }



  FolderLock::Status
  FolderLock::acquire(const std::string &folder)
  {
    descriptor =
      ::open((folder + "/lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor < 0)
      return Status::not_writable;
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? Status::locked :
                                                         Status::taken;
  }
} // namespace asperity
