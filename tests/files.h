#ifndef tests_files_h
#define tests_files_h

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/** An empty folder of the running test. */
inline std::string
test_folder()
{
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
    std::filesystem::path(ASPERITY_BINARY_DIR) / "test_output" /
    (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

inline std::string
content(const std::string &path)
{
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void
overwrite(const std::string &path, const std::string &text)
{
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

inline unsigned int
n_files(const std::string &folder)
{
  unsigned int n = 0;
  for (const auto &file : std::filesystem::directory_iterator(folder))
    n += file.is_regular_file();
  return n;
}

/** The message of the error of this type that a call throws. */
template <typename Error, typename Call>
std::string
message_of(const Call &call)
{
  try
    {
      call();
    }
  catch (const Error &error)
    {
      return error.what();
    }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

#endif
