#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>

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



TEST(AtomicFile, decimals_read_back_as_the_same_double)
{
  EXPECT_EQ(shortest_decimal(0.1), "0.1");
  EXPECT_EQ(shortest_decimal(100000.), "100000");
  EXPECT_EQ(shortest_decimal(2.5e-7), "2.5e-07");
  for (const double value : {1. / 3., 2e18, -4.9e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(shortest_decimal(value).c_str(), nullptr), value);
}
