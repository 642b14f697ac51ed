#ifndef asperity_campaign_folder_lock_h
#define asperity_campaign_folder_lock_h

#include <string>

namespace asperity
{
  /** Keeps two processes from working in one folder. The lock goes with its
   *  process, however that ends. */
  class FolderLock
  {
  public:
    enum class Status
    {
      locked,
      taken, ///< by another process, or by another lock of this one
      not_writable
    };

    FolderLock() = default;
    ~FolderLock();

    FolderLock(const FolderLock &) = delete;
    FolderLock &
    operator=(const FolderLock &) = delete;

    /** @param folder one that exists */
    Status
    acquire(const std::string &folder);

  private:
    int descriptor = -1;
  };
} // namespace asperity

#endif
