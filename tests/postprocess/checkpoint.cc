#include <asperity/base/errors.h>
#include <asperity/postprocess/checkpoint.h>

#include <cstring>
#include <limits>

#include "../files.h"

using namespace asperity;

namespace
{
  /** Doubles that text or single precision would change. */
  const std::vector<double> awkward = {
    0.,
    -0.,
    1. / 3.,
    4.9e-324,
    -1.7976931348623157e308,
    1. + 2.3e-16,
    std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN()};

  Checkpoint
  example()
  {
    Checkpoint checkpoint;
    checkpoint.set("displacement", awkward);
    checkpoint.set("empty", std::vector<double>());
    checkpoint.set("step", std::vector<std::int64_t>{42, INT64_MIN, INT64_MAX});
    checkpoint.set("parameters", std::string("set Degree = 2\n\0end", 19));
    return checkpoint;
  }

  std::string
  reading_error(const std::string &path)
  {
    const std::string message =
      message_of<InputError>([&]() { Checkpoint::read(path); });
    EXPECT_NE(message.find(path), std::string::npos) << message;
    return message;
  }

  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace



TEST(Checkpoint, round_trip_is_bit_exact)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const Checkpoint read = Checkpoint::read(path);
  ASSERT_EQ(read.doubles("displacement").size(), awkward.size());
  EXPECT_EQ(std::memcmp(read.doubles("displacement").data(),
                        awkward.data(),
                        awkward.size() * sizeof(double)),
            0);
  EXPECT_TRUE(read.doubles("empty").empty());
  EXPECT_EQ(read.integers("step"),
            (std::vector<std::int64_t>{42, INT64_MIN, INT64_MAX}));
  EXPECT_EQ(read.text("parameters"), std::string("set Degree = 2\n\0end", 19));
  EXPECT_TRUE(read == example());
}



TEST(Checkpoint, an_entry_that_is_missing_or_of_another_length_is_named)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const Checkpoint read = Checkpoint::read(path);
  for (const std::string &message :
       {message_of<InputError>([&]() { read.doubles("velocity"); }),
        message_of<InputError>([&]() { read.integers("velocity"); }),
        message_of<InputError>([&]() { read.text("velocity"); })})
    EXPECT_TRUE(contains(message, "'velocity'") && contains(message, path));
  const std::string message =
    message_of<InputError>([&]() { read.doubles("displacement", 9); });
  EXPECT_TRUE(contains(message, "8 numbers") && contains(message, "9 are"));
}



TEST(Checkpoint, missing_and_foreign_files_are_told_apart)
{
  const std::string folder = test_folder(), path = folder + "/a.checkpoint";
  EXPECT_TRUE(contains(reading_error(path), "could not be opened"));
  overwrite(path, "");
  EXPECT_TRUE(contains(reading_error(path), "shorter than the head"));
  overwrite(path, "step,time [s],sliding distance [m],T_x [N/m],T_y [N/m]");
  EXPECT_TRUE(contains(reading_error(path), "is not a checkpoint"));
}



TEST(Checkpoint, another_version_or_byte_order_is_refused)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const std::string good = content(path);

  std::string bytes = good;
  bytes[8]          = 2;
  overwrite(path, bytes);
  EXPECT_TRUE(contains(reading_error(path), "version 2"));

  bytes = good;
  std::swap(bytes[12], bytes[15]);
  std::swap(bytes[13], bytes[14]);
  overwrite(path, bytes);
  EXPECT_TRUE(contains(reading_error(path), "byte order"));
}



TEST(Checkpoint, cut_short_at_any_length_is_refused)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const std::string good = content(path);
  for (std::size_t length = 0; length < good.size(); ++length)
    {
      overwrite(path, good.substr(0, length));
      reading_error(path);
    }
  overwrite(path, good + "x");
  EXPECT_TRUE(contains(reading_error(path), "added to"));
}



TEST(Checkpoint, any_flipped_bit_is_refused)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const std::string good = content(path);
  for (std::size_t i = 0; i < good.size(); ++i)
    {
      std::string bytes = good;
      bytes[i]          = static_cast<char>(bytes[i] ^ (1 << (i % 8)));
      overwrite(path, bytes);
      reading_error(path);
    }
}



TEST(CheckpointFolder, keeps_the_newest_two_and_reads_the_newest)
{
  const std::string      folder = test_folder() + "/checkpoint";
  const CheckpointFolder slots(folder);
  for (const unsigned int step : {8u, 9u, 10u, 11u})
    {
      Checkpoint checkpoint = example();
      checkpoint.set("step", std::vector<std::int64_t>{step});
      slots.write(checkpoint, step);
    }
  EXPECT_EQ(slots.steps(), (std::vector<unsigned int>{11, 10}));
  EXPECT_EQ(n_files(folder), 2u);
  const auto found = slots.read_newest();
  EXPECT_EQ(found.step, 11u);
  EXPECT_EQ(found.checkpoint.integers("step").front(), 11);
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_EQ(slots.read_newest(10).step, 10u);
}



TEST(CheckpointFolder, a_damaged_newest_file_costs_steps_not_the_run)
{
  const CheckpointFolder slots(test_folder());
  slots.write(example(), 10);
  slots.write(example(), 20);
  overwrite(slots.path(20), content(slots.path(20)).substr(0, 100));
  const auto found = slots.read_newest();
  EXPECT_EQ(found.step, 10u);
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_TRUE(contains(found.warnings[0], slots.path(20)));
  EXPECT_THROW(slots.read_newest(20), InputError);
}



TEST(CheckpointFolder, a_run_that_goes_back_outdates_later_steps)
{
  const CheckpointFolder slots(test_folder());
  slots.write(example(), 10);
  slots.write(example(), 20);
  slots.write(example(), 11);
  EXPECT_EQ(slots.steps(), (std::vector<unsigned int>{11, 10}));
}



TEST(CheckpointFolder, nothing_to_restart_from_is_an_input_error)
{
  const std::string folder = test_folder();
  overwrite(folder + "/step_07.checkpoint", "");
  overwrite(folder + "/step_7.checkpoint.tmp123", "");
  const std::string message =
    message_of<InputError>([&]() { CheckpointFolder(folder).read_newest(); });
  EXPECT_TRUE(contains(message, folder));
  EXPECT_THROW(CheckpointFolder(folder + "/missing").read_newest(), InputError);
}
