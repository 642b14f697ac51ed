#include <asperity/base/archive.h>
#include <asperity/base/errors.h>

#include <cstring>
#include <limits>

#include "../files.h"

using namespace asperity;

namespace
{
  struct Part
  {
    std::string         name;
    std::vector<double> values;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &name &values;
    }
  };

  std::string
  bytes_of(const std::vector<Part> &parts)
  {
    return to_bytes([&](OutputArchive &archive) { archive << parts; });
  }

  std::vector<Part>
  parts_in(const std::string &bytes)
  {
    std::vector<Part> parts;
    from_bytes(bytes, "The file x", [&](InputArchive &archive) {
      archive >> parts;
    });
    return parts;
  }

  const std::vector<Part> example = {
    {"pocket A",
     {0.,
      -0.,
      1. / 3.,
      4.9e-324,
      -1.7976931348623157e308,
      std::numeric_limits<double>::quiet_NaN()}},
    {std::string("a\0b", 3), {}}};
} // namespace



TEST(Archive, gives_back_what_it_got_bit_for_bit)
{
  const std::vector<Part> parts = parts_in(bytes_of(example));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].name, example[0].name);
  ASSERT_EQ(parts[0].values.size(), example[0].values.size());
  EXPECT_EQ(std::memcmp(parts[0].values.data(),
                        example[0].values.data(),
                        parts[0].values.size() * sizeof(double)),
            0);
  EXPECT_EQ(parts[1].name, example[1].name);
}



TEST(Archive, cut_short_or_added_to_is_damaged)
{
  const std::string bytes = bytes_of(example);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_EQ(message_of<InputError>([&]() {
                parts_in(bytes.substr(0, length));
              }).find("The file x is damaged: "),
              0u)
      << length;
  EXPECT_EQ(message_of<InputError>([&]() { parts_in(bytes + "x"); }),
            "The file x is damaged: it holds more than is expected of it.");
}



// Whatever a byte says, memory stays within a small multiple of the archive:
// without a bound most counts below ask for terabytes.
TEST(Archive, a_count_beyond_its_end_is_damage)
{
  const std::string good = bytes_of(example);
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const char value : {'\x7f', '\xff'})
      {
        std::string bytes = good;
        bytes[i]          = value;
        try
          {
            parts_in(bytes);
          }
        catch (const InputError &error)
          {
            EXPECT_EQ(std::string(error.what()).find("The file x is damaged"),
                      0u);
          }
      }
}



TEST(Archive, a_truth_value_is_zero_or_one)
{
  std::string bytes = to_bytes([](OutputArchive &archive) { archive << true; });
  bool        value = false;
  const auto  read  = [&]() {
    from_bytes(bytes, "The file x", [&](InputArchive &archive) {
      archive >> value;
    });
  };
  read();
  EXPECT_TRUE(value);
  bytes.back() = '\x7f';
  EXPECT_EQ(message_of<InputError>(read),
            "The file x is damaged: it does not hold what is expected of it.");
}



TEST(Archive, a_vector_of_another_length_is_refused)
{
  const std::string bytes =
    to_bytes([](OutputArchive &archive) { archive << std::vector<double>(3); });
  std::vector<double> two(2), three(3);
  EXPECT_EQ(message_of<InputError>([&]() {
              from_bytes(bytes, "The file x", [&](InputArchive &archive) {
                archive >> fixed_length(two, "unknowns of a body");
              });
            }),
            "The checkpoint holds 3 unknowns of a body, but 2 are expected.");
  EXPECT_NO_THROW(from_bytes(bytes, "The file x", [&](InputArchive &archive) {
    archive >> fixed_length(three, "unknowns of a body");
  }));
}
