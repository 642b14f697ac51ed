#include <asperity/base/errors.h>
#include <asperity/base/folder_lock.h>

#include <memory>

#include "../files.h"

using namespace asperity;



TEST(FolderLock, a_folder_has_one_owner_by_whatever_name)
{
  const std::string base = test_folder(), folder = base + "/run",
                    link = base + "/link";
  std::filesystem::create_directory_symlink("run", link);
  auto              first   = std::make_unique<FolderLock>(folder, "entry 'A'");
  const std::string message = message_of<InputError>(
    [&]() { FolderLock(link, "scene.prm, line 3, entry 'B'"); });
  EXPECT_EQ(message,
            "scene.prm, line 3, entry 'B': another process writes into the "
            "folder '" +
              link + "'; expected another folder, or that it has ended.");
  EXPECT_EQ(first->warning(), "");
  first.reset();
  EXPECT_NO_THROW(FolderLock(link, "entry 'B'"));
}



TEST(FolderLock, a_folder_that_cannot_be_made_is_named)
{
  const std::string path = test_folder() + "/file";
  overwrite(path, "");
  EXPECT_EQ(message_of<InputError>([&]() { FolderLock(path, "entry 'A'"); }),
            "entry 'A': cannot write into the folder '" + path +
              "' (Not a directory); expected a place where it can be made or "
              "written.");
}
