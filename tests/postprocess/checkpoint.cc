#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/postprocess/checkpoint.h>

#include "../files.h"

using namespace asperity;

namespace
{
  Checkpoint
  example()
  {
    Checkpoint checkpoint;
    checkpoint.program = "asperity 0.1.0";
    checkpoint.inputs.entries.push_back(
      {"Load/Pressure", "300 MPa", false, ""});
    checkpoint.inputs.entries.push_back(
      {"Tool/File", "a.x3p", true, "e5439f340ec51b34d51348e0885bcdf1"});
    checkpoint.state = std::string("\0any\xff bytes\n", 12);
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



TEST(Checkpoint, gives_back_what_it_got)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const Checkpoint read = Checkpoint::read(path);
  EXPECT_EQ(read.program, "asperity 0.1.0");
  ASSERT_EQ(read.inputs.entries.size(), 2u);
  EXPECT_EQ(read.inputs.entries[0].path, "Load/Pressure");
  EXPECT_EQ(read.inputs.entries[0].value, "300 MPa");
  EXPECT_FALSE(read.inputs.entries[0].is_file);
  EXPECT_TRUE(read.inputs.entries[1].is_file);
  EXPECT_EQ(read.inputs.entries[1].content, "e5439f340ec51b34d51348e0885bcdf1");
  EXPECT_EQ(read.state, example().state);
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

  // Files of version 1 begin with the same word, version and byte order.
  std::string bytes = good;
  bytes[8]          = 1;
  overwrite(path, bytes);
  EXPECT_EQ(reading_error(path),
            "The checkpoint '" + path +
              "' has format version 1, but this program reads version 4; "
              "expected one of a run of this program.");
  overwrite(path, bytes.substr(0, 32));
  EXPECT_TRUE(contains(reading_error(path), "version 1"));

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
      EXPECT_NE(reading_error(path), "") << "byte " << i;
    }
}



// A head that was made to fit: neither its length nor the counts behind it may
// ask for more memory than the file has bytes.
TEST(Checkpoint, a_hostile_file_is_damaged)
{
  const std::string path = test_folder() + "/a.checkpoint";
  example().write(path);
  const std::string good = content(path);

  std::string bytes = good;
  bytes[16 + 5]     = '\x7f'; // 10^14 bytes
  overwrite(path, bytes);
  EXPECT_TRUE(contains(reading_error(path), "cut short"));

  const std::size_t head = 56;
  for (std::size_t i = head; i < good.size(); ++i)
    {
      bytes    = good;
      bytes[i] = '\x7f';
      bytes.replace(24, 32, md5(bytes.substr(head)));
      overwrite(path, bytes);
      try
        {
          Checkpoint::read(path);
        }
      catch (const InputError &error)
        {
          EXPECT_TRUE(contains(error.what(), "is damaged")) << error.what();
        }
    }
}



TEST(CheckpointFolder, keeps_the_newest_two_and_reads_the_newest)
{
  const std::string      folder = test_folder() + "/checkpoint";
  const CheckpointFolder slots(folder);
  for (const unsigned int step : {8u, 9u, 10u, 11u})
    {
      Checkpoint checkpoint = example();
      checkpoint.state      = std::to_string(step);
      slots.write(checkpoint, step);
    }
  EXPECT_EQ(slots.steps(), (std::vector<unsigned int>{11, 10}));
  EXPECT_EQ(n_files(folder), 2u);
  const auto found = slots.read_newest();
  EXPECT_EQ(found.step, 11u);
  EXPECT_EQ(found.checkpoint.state, "11");
  EXPECT_EQ(found.path, slots.path(11));
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
