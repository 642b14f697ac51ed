#include <asperity/base/md5.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/zip_archive.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstdio>
#include <sstream>

namespace asperity
{
  void
  write_x3p(const HeightMap &map, const std::string &file)
  {
    const std::string bytes(reinterpret_cast<const char *>(map.heights.data()),
                            map.heights.size() * sizeof(double));
    using Tree = boost::property_tree::ptree;
    Tree       root;
    const auto axis =
      [&](const std::string &name, const char *type, const double increment) {
        char number[32];
        std::snprintf(number, sizeof(number), "%.17g", increment);
        const std::string path = "Record1.Axes." + name + ".";
        root.put(path + "AxisType", type);
        root.put(path + "DataType", "D");
        root.put(path + "Increment", number);
        root.put(path + "Offset", "0");
      };
    root.put("<xmlattr>.xmlns:p", "http://www.opengps.eu/2008/ISO5436_2");
    root.put("Record1.Revision", "ISO5436 - 2000");
    root.put("Record1.FeatureType", map.ny == 1 ? "PRF" : "SUR");
    axis("CX", "I", map.dx);
    axis("CY", "I", map.dy);
    axis("CZ", "A", 1.);
    root.put("Record2.Date", "1970-01-01T00:00:00");
    root.put("Record2.Instrument.Manufacturer", "not available");
    root.put("Record2.Instrument.Model", "not available");
    root.put("Record2.Instrument.Serial", "not available");
    root.put("Record2.Instrument.Version", "not available");
    root.put("Record2.CalibrationDate", "1970-01-01T00:00:00");
    root.put("Record2.ProbingSystem.Type", "NonContacting");
    root.put("Record2.ProbingSystem.Identification", "not available");
    root.put("Record2.Comment", map.provenance.description);
    root.put("Record3.MatrixDimension.SizeX", map.nx);
    root.put("Record3.MatrixDimension.SizeY", map.ny);
    root.put("Record3.MatrixDimension.SizeZ", 1);
    root.put("Record3.DataLink.PointDataLink", "bindata/data.bin");
    root.put("Record3.DataLink.MD5ChecksumPointData", md5(bytes));
    root.put("Record4.ChecksumFile", "md5checksum.hex");

    Tree document;
    document.put_child("p:ISO5436_2", root);
    std::ostringstream xml;
    boost::property_tree::xml_parser::write_xml(xml, document);
    write_zip(file,
              {{"main.xml", xml.str()},
               {"bindata/data.bin", bytes},
               {"md5checksum.hex", md5(xml.str()) + " *main.xml\n"}});
  }
} // namespace asperity
