#include <asperity/base/command_options.h>
#include <asperity/base/errors.h>

#include <gtest/gtest.h>

using asperity::CommandOptions;
using asperity::InputError;

namespace
{
  std::string
  refusal(const std::vector<std::string> &arguments)
  {
    try
      {
        CommandOptions(arguments, {"-p", "--oil", "--set"});
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(CommandOptions, words_values_and_settings_are_told_apart)
{
  const CommandOptions options({"predict",
                                "-p",
                                "450MPa",
                                "law.json",
                                "--set",
                                "a = 1",
                                "-",
                                "--set",
                                "b = -2"},
                               {"-p", "-v", "--set"});
  EXPECT_EQ(options.words, (std::vector<std::string>{"law.json", "-"}));
  EXPECT_EQ(options.values.size(), 1u);
  EXPECT_EQ(options.values.at("-p"), "450MPa");
  EXPECT_EQ(options.settings, (std::vector<std::string>{"a = 1", "b = -2"}));
}

TEST(CommandOptions, what_is_no_option_of_the_command_is_refused)
{
  EXPECT_EQ(refusal({"new", "map.x3p", "-q", "1"}),
            "'asperity new' has no option '-q'; its options are -p, --oil, "
            "--set.");
  EXPECT_EQ(refusal({"new", "map.x3p", "--oil"}),
            "The option '--oil' of 'asperity new' needs a value behind it.");
  EXPECT_EQ(refusal({"new", "-p", "1 MPa", "-p", "2 MPa"}),
            "The option '-p' of 'asperity new' is given twice.");
}
