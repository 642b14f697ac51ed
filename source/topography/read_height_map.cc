#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/zip_archive.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** No NUL and hardly any control character in the first bytes. */
    bool
    looks_like_text(const std::string &bytes)
    {
      const std::size_t n = std::min<std::size_t>(bytes.size(), 4096);
      for (std::size_t i = 0; i < n; ++i)
        {
          const auto c = static_cast<unsigned char>(bytes[i]);
          if (c < 9 || (c > 13 && c < 32) || c == 127)
            return false;
        }
      return true;
    }

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
      if (looks_like_text(file.bytes()))
        return read_text(file, options);
      file.fail("unknown format",
                "is none of X3P, SDF, SUR, AL3D, PLUX, GSF and text; open it "
                "in Gwyddion and export it as GSF, or as X3P from the "
                "instrument's program");
    }
  } // namespace

  HeightMap
  read_height_map(const FileContent &file, const ReadOptions &options)
  {
    HeightMap map = read_by_content(file, options);
    if (map.n_valid() == 0)
      file.fail(map.provenance.format, "holds no valid height");
    return map;
  }

  HeightMap
  read_height_map(const std::string &file, const ReadOptions &options)
  {
    return read_height_map(FileContent(file), options);
  }
} // namespace asperity
