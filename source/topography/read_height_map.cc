#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/text_table.h>
#include <asperity/topography/zip_archive.h>

#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    // Far beyond any instrument, and near enough for squares and ratios of
    // heights and slopes to stay finite.
    constexpr double largest_height   = 1e3;
    constexpr double smallest_spacing = 1e-13;
    constexpr double largest_spacing  = 1e3;

    HeightMap
    read_archive(const FileContent &file, const ReadOptions &options)
    {
      const ZipArchive archive(file, "X3P or PLUX");
      if (!archive.find("main.xml").empty())
        return read_x3p(file, options);
      if (!archive.find("index.xml").empty())
        return read_plux(file, options);
      file.fail("ZIP archive",
                "has neither main.xml (X3P) nor index.xml (PLUX) in it");
    }

    HeightMap
    read_by_content(const FileContent &file, const ReadOptions &options)
    {
      if (file.starts_with("PK\x03\x04"))
        return read_archive(file, options);
      for (const char *magic : {"aISO-1.0", "bISO-1.0", "aBCR-1.0", "bBCR-1.0"})
        if (file.starts_with(magic))
          return read_sdf(file, options);
      if (file.starts_with("DIGITAL SURF") || file.starts_with("DSCOMPRESSED"))
        return read_sur(file, options);
      if (file.starts_with("AliconaImaging"))
        return read_al3d(file, options);
      if (file.starts_with("Gwyddion Simple Field"))
        return read_gsf(file, options);
      if (!decode_text(file).empty())
        return read_text(file, options);
      file.fail("unknown format",
                "is none of X3P, SDF, SUR, AL3D, PLUX, GSF and text; open it "
                "in Gwyddion and export it as GSF, or as X3P from the "
                "instrument's program");
    }

    /** Heights that no surface has become missing points, and are reported. */
    void
    discard_impossible_heights(HeightMap &map)
    {
      // Without a unit any number may be a height.
      const double largest = map.provenance.has_unit ?
                               largest_height :
                               std::numeric_limits<double>::max();
      std::size_t  n       = 0;
      for (double &z : map.heights)
        if (std::abs(z) > largest)
          {
            z = missing_height;
            ++n;
          }
      if (n > 0)
        map.provenance.warnings.push_back(
          std::to_string(n) + (n == 1 ? " height is" : " heights are") +
          " infinite or beyond 1 km and count as missing.");
    }

    void
    check_spacing(const FileContent &file, const HeightMap &map)
    {
      if (!map.provenance.has_unit)
        return;
      for (const double spacing : {map.dx, map.dy})
        if (!(spacing >= smallest_spacing && spacing <= largest_spacing))
          file.fail(
            map.provenance.format,
            "has samples " + format_number(spacing) +
              " m apart; a spacing between 0.1 pm and 1 km is expected");
    }
  } // namespace

  bool
  has_height_map_signature(const FileContent &file)
  {
    for (const char *magic : {"PK\x03\x04",
                              "aISO-1.0",
                              "bISO-1.0",
                              "aBCR-1.0",
                              "bBCR-1.0",
                              "DIGITAL SURF",
                              "DSCOMPRESSED",
                              "AliconaImaging",
                              "Gwyddion Simple Field"})
      if (file.starts_with(magic))
        return true;
    return false;
  }

  HeightMap
  read_height_map(const FileContent &file, const ReadOptions &options)
  {
    HeightMap map = read_by_content(file, options);
    discard_impossible_heights(map);
    if (map.n_valid() == 0)
      file.fail(map.provenance.format, "holds no valid height");
    check_spacing(file, map);
    map.provenance.description = printable(map.provenance.description);
    return map;
  }

  HeightMap
  read_height_map(const std::string &file, const ReadOptions &options)
  {
    return read_height_map(FileContent(file), options);
  }
} // namespace asperity
