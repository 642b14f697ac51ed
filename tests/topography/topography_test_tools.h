#ifndef asperity_tests_topography_topography_test_tools_h
#define asperity_tests_topography_topography_test_tools_h

#include <asperity/topography/height_map.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace asperity_test
{
  /** The measured surfaces, which are no part of the repository. */
  inline std::string
  measured(const std::string &name)
  {
    return std::string(ASPERITY_SOURCE_DIR) + "/../shared/surfaces/" + name;
  }

  inline bool
  is_there(const std::string &file)
  {
    return std::filesystem::exists(file);
  }

  /** A file of the given bytes in a folder of the tests' own. */
  inline std::string
  write_bytes(const std::string &name, const std::string &bytes)
  {
    // A folder a process: ctest runs several tests at once.
    const auto folder = std::filesystem::path(ASPERITY_BINARY_DIR) /
                        "test_topography" / std::to_string(getpid());
    std::filesystem::create_directories(folder);
    const std::string file = (folder / name).string();
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

  inline std::string
  read_bytes(const std::string &file)
  {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /** Append a number as the machine (little-endian) stores it. */
  template <typename T>
  void
  append(std::string &bytes, const T value)
  {
    bytes.append(reinterpret_cast<const char *>(&value), sizeof(T));
  }

  /** A map of the given size with z = f(x, y). */
  inline asperity::HeightMap
  make_map(const unsigned int                           nx,
           const unsigned int                           ny,
           const double                                 dx,
           const double                                 dy,
           const std::function<double(double, double)> &f)
  {
    asperity::HeightMap map;
    map.nx = nx;
    map.ny = ny;
    map.dx = dx;
    map.dy = dy;
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        map.heights.push_back(f(i * dx, j * dy));
    return map;
  }

  /** The message of the exception that @p call has to throw. */
  template <typename Exception, typename Call>
  std::string
  message_of(const Call &call)
  {
    try
      {
        call();
      }
    catch (const Exception &error)
      {
        return error.what();
      }
    ADD_FAILURE() << "No exception was thrown.";
    return "";
  }
} // namespace asperity_test

#define SKIP_WITHOUT(file)            \
  if (!asperity_test::is_there(file)) \
  GTEST_SKIP() << file << " is not here"

#endif
