#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/xml.h>
#include <asperity/topography/zip_archive.h>

// Sensofar's format: a ZIP archive of index.xml and one raw image a layer.
namespace asperity
{
  namespace
  {
    const std::string format = "PLUX";

    // Heights of at least this many micrometres mark a missing point
    // (1000001 in Sensofar's older PLU files).
    constexpr double missing_micrometres = 1e6;

    const boost::property_tree::ptree &
    find_general(const FileContent                 &file,
                 const boost::property_tree::ptree &document)
    {
      for (const auto &[name, root] : document)
        if (const auto general = root.get_child_optional("GENERAL"))
          return *general;
      file.fail(format, "has an index.xml without the element GENERAL");
    }
  } // namespace

  HeightMap
  read_plux(const FileContent &file, const ReadOptions &)
  {
    const ZipArchive  archive(file, format);
    const std::string index = archive.find("index.xml");
    const std::string layer = archive.find("LAYER_0.raw");
    if (index.empty() || layer.empty())
      file.fail(format, "lacks index.xml or LAYER_0.raw");
    const auto document =
      parse_xml(file, format, archive.read(index, std::size_t(1) << 26));
    const auto &general = find_general(file, document);
    const auto  text    = [&](const std::string &key) {
      return general.get<std::string>(key, "");
    };
    HeightMap map = allocate_map(
      file,
      format,
      parse_integer(file, format, "IMAGE_SIZE_X", text("IMAGE_SIZE_X")),
      parse_integer(file, format, "IMAGE_SIZE_Y", text("IMAGE_SIZE_Y")),
      archive.stated_size(layer),
      sizeof(float));
    map.dx = 1e-6 * parse_number(file, format, "FOV_X", text("FOV_X"));
    map.dy = 1e-6 * parse_number(file, format, "FOV_Y", text("FOV_Y"));
    if (map.dx <= 0. || map.dy <= 0.)
      file.fail(format, "has a pixel size (FOV_X, FOV_Y) that is not positive");

    const std::size_t need = map.heights.size() * sizeof(float);
    const std::string raw  = archive.read(layer, need);
    if (raw.size() < need)
      file.fail(format,
                "is cut off: its heights need " + std::to_string(need) +
                  " bytes, and " + quoted_name(layer) + " has " +
                  std::to_string(raw.size()));
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      {
        float micrometres;
        std::memcpy(&micrometres,
                    raw.data() + i * sizeof(float),
                    sizeof(float));
        if (std::isfinite(micrometres) && micrometres < missing_micrometres)
          map.heights[i] = 1e-6 * micrometres;
      }
    map.provenance.unit_source = "PLUX fixes micrometres";
    map.provenance.description = "Sensofar";
    return map;
  }
} // namespace asperity
