#ifndef asperity_base_folder_lock_h
#define asperity_base_folder_lock_h

#include <string>

namespace asperity
{
  /**
   * Keeps two processes from writing into one folder, also by different names
   * of it (symbolic links). The lock (flock on the file `lock` in the folder)
   * goes with its process, however that ends; the file stays.
   */
  class FolderLock
  {
  public:
    /**
     * Makes the folder if it does not exist.
     * @param folder its path
     * @param where the entry that names it, with file and line, for messages
     * @throws InputError if the folder cannot be made or written, or if another
     *   process, or another lock of this one, holds it
     */
    FolderLock(const std::string &folder, const std::string &where);

    ~FolderLock();

    FolderLock(const FolderLock &) = delete;
    FolderLock &
    operator=(const FolderLock &) = delete;

    /** A sentence if the file system knows no locks, so that nobody watches
     *  over the folder; else empty. */
    const std::string &
    warning() const;

  private:
    int         descriptor = -1;
    std::string warning_;
  };
} // namespace asperity

#endif
