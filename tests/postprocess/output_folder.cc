#include <asperity/base/errors.h>
#include <asperity/postprocess/output_folder.h>

#include <set>

#include "../files.h"

using namespace asperity;

namespace
{
  const std::vector<std::string> of_a_run = {"summary.json",
                                             "friction.csv",
                                             "friction_units.csv",
                                             "chip.pvd",
                                             "tool.pvd",
                                             "contact.pvd",
                                             "oil.pvd",
                                             "chip_000008.vtu",
                                             "oil_1000000.vtu",
                                             "friction.csv.tmp123",
                                             "chip_000008.vtu.tmp7",
                                             "checkpoint/step_10.checkpoint",
                                             "checkpoint/step_20.checkpoint",
                                             "checkpoint/step_30.checkpoint."
                                             "tmp99"};

  const std::vector<std::string> of_others = {"parameters.prm",
                                              "friction.png",
                                              "my_friction.csv",
                                              "friction.csv.bak",
                                              "summary.json.tmp",
                                              "summary_json",
                                              "chip_8a.vtu",
                                              "lid_000008.vtu",
                                              "step_10.checkpoint",
                                              "checkpoint/notes.txt",
                                              "checkpoint/summary.json",
                                              "old/summary.json"};

  /** A folder with all of these. */
  std::string
  full_folder()
  {
    const std::string folder = test_folder();
    std::filesystem::create_directories(folder + "/checkpoint");
    std::filesystem::create_directories(folder + "/old");
    // named like a result, but a folder
    std::filesystem::create_directories(folder + "/contact_000001.vtu");
    for (const auto *names : {&of_a_run, &of_others})
      for (const std::string &name : *names)
        overwrite(folder + "/" + name, "x");
    return folder;
  }

  /** Files below a folder, without the lock. */
  std::set<std::string>
  files(const std::string &folder)
  {
    std::set<std::string> names;
    for (const auto &file :
         std::filesystem::recursive_directory_iterator(folder))
      if (file.is_regular_file() && file.path().filename() != "lock")
        names.insert(file.path().lexically_relative(folder).generic_string());
    return names;
  }
} // namespace



TEST(OutputFolder, a_new_run_removes_its_own_names_and_no_others)
{
  const std::string folder = full_folder();
  OutputFolder(folder, "entry 'A'", FolderUse::run).clear(false);
  EXPECT_EQ(files(folder),
            std::set<std::string>(of_others.begin(), of_others.end()));
  EXPECT_TRUE(std::filesystem::is_directory(folder + "/contact_000001.vtu"));
}



TEST(OutputFolder, a_run_that_goes_on_loses_its_summary_and_what_was_begun)
{
  const std::string     folder = full_folder();
  std::set<std::string> expected(of_others.begin(), of_others.end());
  for (const std::string &name : of_a_run)
    if (name != "summary.json" && name.find(".tmp") == std::string::npos)
      expected.insert(name);
  OutputFolder(folder, "entry 'A'", FolderUse::run).clear(true);
  EXPECT_EQ(files(folder), expected);
}



TEST(OutputFolder, a_link_goes_and_what_it_points_to_stays)
{
  const std::string folder = test_folder();
  std::filesystem::create_directories(folder + "/run");
  overwrite(folder + "/precious.json", "x");
  std::filesystem::create_symlink("../precious.json",
                                  folder + "/run/summary.json");
  OutputFolder(folder + "/run", "entry 'A'", FolderUse::run).clear(false);
  EXPECT_EQ(files(folder), std::set<std::string>{"precious.json"});
}



TEST(OutputFolder, runs_and_campaigns_do_not_share_one)
{
  const std::string folder = test_folder();
  overwrite(folder + "/friction.csv", "step\n");
  EXPECT_EQ(message_of<InputError>([&]() {
              OutputFolder(folder, "a.prm, line 2", FolderUse::campaign);
            }),
            "a.prm, line 2: the folder '" + folder +
              "' holds the results of a run; expected a folder of its own.");
  std::filesystem::remove(folder + "/friction.csv");
  overwrite(folder + "/plan.json", "{}");
  std::filesystem::create_directories(folder + "/runs");
  EXPECT_EQ(message_of<InputError>(
              [&]() { OutputFolder(folder, "a.prm, line 2", FolderUse::run); }),
            "a.prm, line 2: the folder '" + folder +
              "' holds the results of a campaign; expected a folder of its "
              "own.");
  EXPECT_NO_THROW(OutputFolder(folder, "", FolderUse::campaign));
}
