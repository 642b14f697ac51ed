#include <asperity/base/errors.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>

// The target of libFuzzer: any bytes are either refused with one sentence or
// become a map that the rest of the program can trust.
namespace
{
  void
  require(const bool condition, const char *what)
  {
    if (condition)
      return;
    std::cerr << "broken promise: " << what << std::endl;
    std::abort();
  }

  void
  check(const asperity::HeightMap &map)
  {
    require(map.heights.size() == std::size_t(map.nx) * map.ny, "size");
    require(map.nx > 1 && map.ny > 0, "at least 2 x 1 points");
    require(map.n_valid() > 0, "a valid height");
    for (const double z : map.heights)
      require(!std::isinf(z), "finite heights");
    if (!map.provenance.has_unit)
      return;
    require(map.dx > 0. && map.dx <= 1e3, "spacing along x");
    require(map.dy > 0. && map.dy <= 1e3, "spacing along y");
    for (const double z : map.heights)
      require(!(std::abs(z) > 1e3), "possible heights");
  }

  /** Read once with what a user may say of a file, and once without. */
  void
  read(const asperity::FileContent &file, const double unit)
  {
    asperity::ReadOptions options;
    options.lateral_unit = options.height_unit = unit;
    options.spacing_x = options.spacing_y = unit;
    try
      {
        check(asperity::read_height_map(file, options));
      }
    catch (const asperity::InputError &error)
      {
        const std::string sentence = error.what();
        require(!sentence.empty() && sentence.back() == '.', "a sentence");
        require(sentence.find('\n') == std::string::npos, "one line");
        require(sentence.size() < 2000, "a short sentence");
      }
  }
} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  if (size == 0)
    return 0;
  const asperity::FileContent file("fuzz",
                                   {reinterpret_cast<const char *>(data),
                                    size});
  read(file, 1e-6);
  read(file, 0.);
  return 0;
}
