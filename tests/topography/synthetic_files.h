#ifndef asperity_tests_topography_synthetic_files_h
#define asperity_tests_topography_synthetic_files_h

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

#include "topography_test_tools.h"

// Files of each format, byte by byte from its description. All hold the map
// of 3 x 2 points 0.5 um and 0.25 um apart with the heights (in um)
//   1  2  3
//  -4  x  6      x: missing
namespace asperity_test
{
  inline std::string
  padded(std::string text, const std::size_t length, const char pad = ' ')
  {
    text.resize(length, pad);
    return text;
  }

  inline std::string
  sdf_binary(const int data_type)
  {
    std::string bytes = "bISO-1.0" + padded("MAKER", 10) +
                        padded("010120200000", 12) + padded("", 12);
    append<std::uint16_t>(bytes, 3);
    append<std::uint16_t>(bytes, 2);
    append<double>(bytes, 0.5e-6);
    append<double>(bytes, 0.25e-6);
    append<double>(bytes, data_type == 7 ? 1e-6 : 1e-9);
    append<double>(bytes, -1.);
    bytes += '\0';
    bytes += static_cast<char>(data_type);
    bytes += '\0';
    for (const int um : {1, 2, 3, -4, 0, 6})
      if (data_type == 5)
        append<std::int16_t>(bytes, um == 0 ? INT16_MIN : 1000 * um);
      else if (data_type == 6)
        append<std::int32_t>(bytes, um == 0 ? INT32_MIN : 1000 * um);
      else
        append<double>(bytes, um == 0 ? asperity::missing_height : um);
    return bytes;
  }

  inline std::string
  sdf_ascii()
  {
    return "aISO-1.0\nManufacID = MAKER\nNumPoints = 3\nNumProfiles = 2\n"
           "Xscale = 0.5e-6\nYscale = 0.25e-6\nZscale = 1e-6\nCompression = 0\n"
           "DataType = 7\nCheckType = 0\n*\n1 2 3\n-4 BAD 6\n*\ntrailer *\n*";
  }

  /** 32 bits: heights of nm, lateral units um; else 16 bits of 10 nm. */
  inline std::string
  sur(const int bits, const bool compressed, const std::string &comment = "hi")
  {
    const double dz  = bits == 32 ? 1. : 10.; // in nm
    std::string  raw = "";
    for (const int um : {1, 2, 3, -4, 0, 6})
      {
        const int value = um == 0 ? -100000 : static_cast<int>(1000 * um / dz);
        if (bits == 32)
          append<std::int32_t>(raw, value);
        else
          append<std::int16_t>(raw, um == 0 ? -402 : value);
      }
    std::string h = compressed ? "DSCOMPRESSED" : "DIGITAL SURF";
    for (const int value : {0, 1, 1, 2})
      append<std::uint16_t>(h, value);
    h += padded("object", 30) + padded("operator", 30);
    for (const int value : {0, 0, 0, 1, 1}) // special: has missing points
      append<std::uint16_t>(h, value);
    h += std::string(8, '\0');
    append<std::uint16_t>(h, bits);
    append<std::int32_t>(h, bits == 32 ? -99998 : -400); // zmin
    append<std::int32_t>(h, 6000);
    append<std::int32_t>(h, 3);
    append<std::int32_t>(h, 2);
    append<std::uint32_t>(h, 6);
    append<float>(h, 0.5f);
    append<float>(h, 0.25f);
    append<float>(h, static_cast<float>(dz));
    for (const char *name : {"X", "Y", "Z"})
      h += padded(name, 16);
    for (const char *unit : {"\xb5m", "um", "nm"}) // step units
      h += padded(unit, 16);
    for (const char *unit : {"mm", "mm", "um"}) // display units do not count
      h += padded(unit, 16);
    h += std::string(334 - h.size(), '\0');
    append<std::uint16_t>(h, comment.size());
    append<std::uint16_t>(h, 3);
    h += std::string(512 - h.size(), '\0');
    h += comment + "prv";
    if (!compressed)
      return h + raw;

    // Two streams that have to be joined.
    append<std::uint32_t>(h, 2);
    std::string packed;
    for (const auto &part : {raw.substr(0, 7), raw.substr(7)})
      {
        std::string block(100, '\0');
        uLongf      length = block.size();
        compress(reinterpret_cast<Bytef *>(block.data()),
                 &length,
                 reinterpret_cast<const Bytef *>(part.data()),
                 part.size());
        append<std::uint32_t>(h, part.size());
        append<std::uint32_t>(h, length);
        packed += block.substr(0, length);
      }
    return h + packed;
  }

  inline std::string
  gsf(const std::string &title)
  {
    std::string bytes = "Gwyddion Simple Field 1.0\nXRes = 3\nYRes = 2\n"
                        "XReal = 1.5\nYReal=0.5\nXYUnits = \xc2\xb5m\n"
                        "ZUnits = nm\nTitle = " +
                        title + "\n";
    bytes += std::string(4 - bytes.size() % 4, '\0');
    for (const int um : {1, 2, 3, -4, 0, 6})
      append<float>(bytes, um == 0 ? NAN : 1000.f * um);
    return bytes;
  }

  inline std::string
  al3d()
  {
    std::string bytes("AliconaImaging\0\r\n", 17);
    const auto  tag = [&bytes](const std::string &key,
                              const std::string &value) {
      bytes += padded(key, 20, '\0') + padded(value, 30, '\0') + "\r\n";
    };
    tag("Version", "1");
    tag("TagCount", "6");
    tag("Cols", "3");
    tag("Rows", "2");
    tag("PixelSizeXMeter", "5e-07");
    tag("PixelSizeYMeter", "2.5e-07");
    tag("DepthImageOffset", "460");
    tag("InvalidPixelValue", "3.000000028082e+15");
    bytes.resize(460, '\0');
    const float rows[] = {1, 2, 3, -4, 3e15f, 6};
    for (unsigned int i = 0; i < 6; ++i)
      {
        append<float>(bytes, i == 4 ? 3.000000028082e15f : 1e-6f * rows[i]);
        if (i % 3 == 2)
          append<float>(bytes, 99.f); // rows are padded to eight bytes
      }
    return bytes;
  }

  /** Entries of a PLUX archive. */
  inline std::vector<std::pair<std::string, std::string>>
  plux_entries()
  {
    std::string raw;
    for (const int um : {1, 2, 3, -4, 0, 6})
      append<float>(raw, um == 0 ? 1000001.f : um);
    return {{"index.xml",
             "<?xml version=\"1.0\"?><xml><GENERAL><IMAGE_SIZE_X>3"
             "</IMAGE_SIZE_X><IMAGE_SIZE_Y>2</IMAGE_SIZE_Y><FOV_X>0.5</FOV_X>"
             "<FOV_Y>0.25</FOV_Y></GENERAL></xml>"},
            {"LAYER_0.raw", raw}};
  }

  /** main.xml of an X3P file whose z axis is described by @p axis_z. */
  inline std::string
  x3p_main(const std::string &axis_z,
           const std::string &record3,
           const std::string &root = "p:ISO5436_2")
  {
    const auto axis = [](const std::string &increment) {
      return "<AxisType>I</AxisType><DataType>D</DataType><Increment>" +
             increment + "</Increment><Offset/>";
    };
    return "\xef\xbb\xbf<?xml version=\"1.0\"?><" + root +
           "><Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR"
           "</FeatureType><Axes><CX>" +
           axis("5.0e-007") + "</CX><CY>" + axis("2.5E-7") + "</CY><CZ>" +
           axis_z +
           "</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>3</SizeX>"
           "<SizeY>2</SizeY><SizeZ>1</SizeZ></MatrixDimension>" +
           record3 + "</Record3></" + root + ">";
  }

  inline std::string
  x3p_link(const bool with_valid)
  {
    return std::string("<DataLink><PointDataLink>bindata/data.bin"
                       "</PointDataLink>") +
           (with_valid ?
              "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>" :
              "") +
           "</DataLink>";
  }
} // namespace asperity_test

#endif
