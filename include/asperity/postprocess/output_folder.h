#ifndef asperity_postprocess_output_folder_h
#define asperity_postprocess_output_folder_h

#include <asperity/base/folder_lock.h>

#include <string>

namespace asperity
{
  /** What a folder of results is for; one is not written into the other, since
   *  both have a summary.json. */
  enum class FolderUse
  {
    run,
    campaign
  };

  /**
   * The folder of a run or of a campaign, which nobody else writes into while
   * this object lives.
   */
  class OutputFolder
  {
  public:
    /**
     * Makes and locks the folder.
     * @param where the entry that names it, with file and line, for messages
     * @throws InputError as FolderLock does, and if the folder holds results of
     *   the other use
     */
    OutputFolder(const std::string &directory,
                 const std::string &where,
                 const FolderUse    use);

    /**
     * Before a run writes its first file: removes what an earlier run has left,
     * lest the results of two be mixed. A run that goes on from a checkpoint
     * keeps tables, pictures and checkpoints; its summary.json and files that a
     * killed run has begun go anyway. Only files by the names that the program
     * gives are touched, and no folders.
     */
    void
    clear(const bool goes_on) const;

    /** As FolderLock::warning(). */
    const std::string &
    warning() const;

  private:
    std::string directory;
    FolderLock  lock;
  };
} // namespace asperity

#endif
