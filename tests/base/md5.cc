#include <asperity/base/errors.h>
#include <asperity/base/md5.h>

#include "../files.h"

using namespace asperity;



// Test suite of RFC 1321.
TEST(Md5, agrees_with_its_standard)
{
  EXPECT_EQ(md5(""), "d41d8cd98f00b204e9800998ecf8427e");
  EXPECT_EQ(md5("message digest"), "f96b697d7cb7938d525a2f31aaf161d0");
  std::string digits;
  for (unsigned int i = 0; i < 8; ++i)
    digits += "1234567890";
  EXPECT_EQ(md5(digits), "57edf4a22be3c955ac49da2e2107b67a");
}



TEST(Md5, of_a_file_is_that_of_its_bytes)
{
  const std::string path = test_folder() + "/file";
  // around a block, and around the pieces in which files are read
  for (const std::size_t size : {0, 1, 55, 56, 64, 65535, 65536, 65537, 200000})
    {
      std::string bytes(size, '\0');
      for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<char>(i * i % 251);
      overwrite(path, bytes);
      EXPECT_EQ(md5_of_file(path), md5(bytes)) << size;
    }
  const std::string message =
    message_of<InputError>([&]() { md5_of_file(path + ".other"); });
  EXPECT_NE(message.find(path + ".other"), std::string::npos) << message;
}
