#include <asperity/topography/zip_archive.h>

#include <fstream>
#include <iostream>

#include "../../tests/topography/synthetic_files.h"

// Writes one small file of each format into a folder, for the fuzzer to change.
using namespace asperity_test;

int
main(int argc, char **argv)
{
  if (argc != 2)
    {
      std::cerr << "usage: write_seeds FOLDER\n";
      return 2;
    }
  const std::string folder = std::string(argv[1]) + "/";
  const auto write = [&](const std::string &name, const std::string &bytes) {
    std::ofstream(folder + name, std::ios::binary) << bytes;
  };
  for (const int type : {5, 6, 7})
    write("binary_" + std::to_string(type) + ".sdf", sdf_binary(type));
  write("ascii.sdf", sdf_ascii());
  for (const int bits : {16, 32})
    {
      write("plain_" + std::to_string(bits) + ".sur", sur(bits, false));
      write("packed_" + std::to_string(bits) + ".sur", sur(bits, true));
    }
  write("map.gsf", gsf("title"));
  write("map.al3d", al3d());
  asperity::write_zip(folder + "map.plux", plux_entries());
  const std::string axis = "<AxisType>A</AxisType><DataType>D</DataType>";
  asperity::write_zip(folder + "binary.x3p",
                      {{"main.xml", x3p_main(axis, x3p_link(true))},
                       {"bindata/data.bin", std::string(48, '\1')},
                       {"bindata/valid.bin", "\x2f"}});
  asperity::write_zip(
    folder + "list.x3p",
    {{"main.xml",
      x3p_main(axis,
               "<DataList><Datum>1e-6</Datum><Datum>2e-6</Datum><!-- x -->"
               "<Datum>3e-6</Datum><Datum>-4e-6</Datum><Datum/>"
               "<Datum>6e-6</Datum></DataList>")}});
  write("matrix.txt", "# Width: 1.6 um\n# Value units: nm\n1 2 3\n-4 Bad 6\n");
  write("comma.csv", "title\n1,0;2,0;3,0\n;5;6,0\n");
  write("points.xyz", "x y z\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n");
  write("profile.txt", "0.0\t1\n0.1\t2\n0.2\t3\n0.3\t***\n0.4\t5\n0.5\t6\n");
  write("channels.txt", "# Channel: A\n1 2 3\n4 5 6\n\n# Channel: B\n7 8 9\n");
  return 0;
}
