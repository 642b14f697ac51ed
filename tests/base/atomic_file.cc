#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>

#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "../files.h"

using namespace asperity;



TEST(AtomicFile, a_failed_write_leaves_the_old_file_and_no_other)
{
  const std::string folder = test_folder(), path = folder + "/a/file";
  write_atomically(path, [](std::ostream &out) { out << "old"; });
  EXPECT_THROW(write_atomically(path,
                                [](std::ostream &out) {
                                  out << "new";
                                  throw ComputationError("no");
                                }),
               ComputationError);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(n_files(folder + "/a"), 1u);
}



TEST(AtomicFile, a_path_that_cannot_be_written_is_named)
{
  const std::string folder = test_folder();
  overwrite(folder + "/file", "");
  const std::string message = message_of<ComputationError>(
    [&]() { write_atomically(folder + "/file/below", [](std::ostream &) {}); });
  EXPECT_NE(message.find(folder + "/file/below"), std::string::npos);
}



TEST(AtomicFile, names_the_file_and_the_reason_when_a_write_fails)
{
  // A limit on the size of files stands for a disk that is full.
  const std::string folder = test_folder(), path = folder + "/file";
  rlimit            before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto   old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit       = {1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message = message_of<ComputationError>([&]() {
    write_atomically(path,
                     [](std::ostream &out) { out << std::string(2000, 'x'); });
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(message,
            "The file '" + path + "' could not be written: file too large.");
  EXPECT_EQ(n_files(folder), 0u) << "no part of it is left";
}



TEST(AtomicFile, reasons_stand_inside_of_a_sentence)
{
  EXPECT_EQ(reason_of_failure(ENOSPC), "no space left on device");
}



TEST(AtomicFile, decimals_read_back_as_the_same_double)
{
  EXPECT_EQ(shortest_decimal(0.1), "0.1");
  EXPECT_EQ(shortest_decimal(100000.), "100000");
  EXPECT_EQ(shortest_decimal(2.5e-7), "2.5e-07");
  for (const double value : {1. / 3., 2e18, -4.9e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(shortest_decimal(value).c_str(), nullptr), value);
}
