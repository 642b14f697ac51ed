#include <asperity/base/errors.h>
#include <asperity/topography/read_height_map.h>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

// Text as instruments and their programs write it. The matrix is always
//   1  2  3  4
//   5  6  7  8
//   9 10 11 12
// in um, its samples 0.5 um and 0.25 um apart.
namespace
{
  ReadOptions
  micrometres()
  {
    ReadOptions options;
    options.lateral_unit = 1e-6;
    options.height_unit  = 1e-6;
    options.spacing_x    = 0.5e-6;
    options.spacing_y    = 0.25e-6;
    return options;
  }

  HeightMap
  read(const std::string &text, const ReadOptions &options = micrometres())
  {
    return read_height_map(write_bytes("map.txt", text), options);
  }

  std::string
  refusal(const std::string &text, const ReadOptions &options = micrometres())
  {
    return message_of<InputError>([&]() { read(text, options); });
  }

  void
  expect_in(const std::string &part, const std::string &text)
  {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }

  /** @param missing index of the one missing point, -1 for none */
  void
  expect_the_matrix(const HeightMap &map, const int missing = -1)
  {
    ASSERT_EQ(map.nx, 4u);
    ASSERT_EQ(map.ny, 3u);
    EXPECT_NEAR(map.dx, 0.5e-6, 1e-15);
    EXPECT_NEAR(map.dy, 0.25e-6, 1e-15);
    for (int i = 0; i < 12; ++i)
      if (i == missing)
        EXPECT_TRUE(std::isnan(map.heights[i])) << i;
      else
        EXPECT_NEAR(map.heights[i], 1e-6 * (i + 1), 1e-18) << i;
  }

  /** The matrix with @p cell at the given index. */
  std::string
  matrix_with(const std::string &cell,
              const unsigned int index,
              const std::string &separator)
  {
    std::string text;
    for (unsigned int i = 0; i < 12; ++i)
      text += (i == index ? cell : std::to_string(i + 1)) +
              (i % 4 == 3 ? "\n" : separator);
    return text;
  }

  std::string
  to_utf16(const std::string &text, const bool little_endian)
  {
    std::string bytes;
    for (const char c : text)
      {
        bytes += little_endian ? c : '\0';
        bytes += little_endian ? '\0' : c;
      }
    return bytes;
  }
} // namespace

TEST(TextMaps, words_for_missing_heights_stand_in_any_cell)
{
  for (const char *word : {"***",
                           "*****",
                           "#N/A",
                           "Bad",
                           "BAD",
                           "NoData",
                           "1.#QNAN",
                           "-1.#IND",
                           "nan",
                           "-nan(ind)",
                           "NULL",
                           "---",
                           "N/A",
                           "\"nan\""})
    for (const unsigned int index : {0u, 4u, 6u, 11u})
      for (const char *separator : {" ", "\t", ";", ","})
        {
          SCOPED_TRACE(std::string(word) + separator + std::to_string(index));
          const HeightMap map = read(matrix_with(word, index, separator));
          expect_the_matrix(map, index);
          EXPECT_TRUE(map.provenance.notes.empty());
        }
  for (const char *separator : {";", "\t", ",", " "})
    for (const unsigned int index : {0u, 4u, 6u, 7u})
      expect_the_matrix(read(matrix_with("No Data", index, separator)), index);
}

TEST(TextMaps, empty_cells_are_missing_also_at_the_ends_of_rows)
{
  for (const char *separator : {";", "\t", ","})
    for (const unsigned int index : {0u, 3u, 4u, 6u, 7u, 11u})
      {
        SCOPED_TRACE(separator + std::to_string(index));
        expect_the_matrix(read(matrix_with("", index, separator)), index);
      }
  expect_the_matrix(read("1;2;3;4;\n5;6;7;8;\n9;10;11;12;\n"));
  expect_the_matrix(read("\t1\t2\t3\t4\n\t5\t6\t7\t8\n\t9\t10\t11\t12\n"));
}

TEST(TextMaps, rows_without_any_height_keep_their_place)
{
  for (const char *row : {"*** *** *** ***", "nan nan nan nan"})
    {
      const HeightMap map =
        read(std::string(row) + "\n5 6 7 8\n" + row + "\n9 10 11 12\n");
      EXPECT_EQ(map.ny, 4u);
      EXPECT_TRUE(std::isnan(map(0, 0)));
      EXPECT_NEAR(map(0, 1), 5e-6, 1e-18);
      EXPECT_TRUE(std::isnan(map(3, 2)));
    }
  EXPECT_EQ(read("1;2;3;4\n;;;\n9;10;11;12\n").ny, 3u);
}

TEST(TextMaps, encodings_of_windows_are_read)
{
  const std::string text = matrix_with("Bad", 5, "\t");
  expect_the_matrix(read("\xef\xbb\xbf" + text), 5);
  for (const bool little_endian : {true, false})
    {
      const std::string bytes = to_utf16(text, little_endian);
      expect_the_matrix(read(bytes), 5);
      expect_the_matrix(read((little_endian ? "\xff\xfe" : "\xfe\xff") + bytes),
                        5);
    }
  expect_in("UTF-32", refusal(std::string("\xff\xfe\0\0001\0\0\0", 8)));
  expect_in("UTF-16", refusal("\xff\xfe" + to_utf16(text, true).substr(0, 21)));
}

TEST(TextMaps, what_was_skipped_is_told)
{
  const std::string matrix = matrix_with("1", 0, " ");
  EXPECT_TRUE(read(matrix).provenance.notes.empty());
  const auto notes =
    read("# made today\ntitle of it\n\n" + matrix + "# end\n").provenance.notes;
  ASSERT_EQ(notes.size(), 2u);
  expect_in("1 comment and 1 title line before the first row in line 4",
            notes[0]);
  expect_in("'title of it'", notes[0]);
  expect_in("1 comment between and behind the rows", notes[1]);
}

TEST(TextMaps, damaged_rows_are_refused_with_their_cell)
{
  const std::string rest = "5 6 7 8\n9 10 11 12\n";
  expect_in("has 'oops' in line 1, column 1", refusal("oops 2 3 4\n" + rest));
  expect_in("has 'oops' in line 2, column 1",
            refusal("title\noops 1 2 3 4\n" + rest));
  expect_in("has '3x' in line 1, column 3", refusal("1 2 3x 4\n" + rest));
  expect_in("has 'oops' in line 4, column 2", refusal(rest + "\n1 oops 3 4\n"));
  expect_in("has 'Retrace' in line 3, column 1", refusal(rest + "Retrace\n"));
  expect_in("has 3 values in line 3", refusal(rest + "1 2 3\n"));
  expect_in("at most 8388608", refusal(std::string(9000000, ';')));
  expect_in("has '0x10' in line 3", refusal(rest + "1 2 3 0x10\n"));
  expect_in("is none of X3P", refusal(std::string("1 2 3\n4 5\0 6\n", 12)));
}

TEST(TextMaps, decimal_commas_are_seen_from_the_separator)
{
  expect_the_matrix(read("1;2;3;4\n5,0;6,0;7;8\n9,0;10;11;12\n"));
  expect_the_matrix(read("1 2 3 4\n5,0 6,0 7 8\n9,0 10 11 12\n"));
  EXPECT_NEAR(read("1;2;3;4\n5,25;6;7;8\n")(0, 1), 5.25e-6, 1e-18);
  expect_in("decimal sign '.' in line 1 and ',' in line 2",
            refusal("1.5;2;3;4\n5,5;6;7;8\n"));
  expect_in("'1,234.5'", refusal("1;2;3;4\n1,234.5;6;7;8\n"));
}

TEST(TextMaps, infinite_and_impossible_heights_are_missing_and_told)
{
  for (const char *word :
       {"inf", "-INF", "Infinity", "1e400", "1.#INF", "1e300", "3.4e38"})
    {
      SCOPED_TRACE(word);
      const HeightMap map = read(matrix_with(word, 6, " "));
      expect_the_matrix(map, 6);
      ASSERT_EQ(map.provenance.warnings.size(), 1u);
      expect_in("1 height is infinite or beyond 1 km",
                map.provenance.warnings[0]);
    }
  expect_in("no valid height", refusal("inf inf inf\n1e99 inf inf\n"));
  ReadOptions options = micrometres();
  options.spacing_x   = 1e-300;
  expect_in("m apart", refusal(matrix_with("1", 0, " "), options));
}

TEST(TextMaps, profile_of_two_columns)
{
  std::string rising, falling;
  for (unsigned int i = 0; i < 20; ++i)
    {
      const auto line = [](const unsigned int k) {
        return std::to_string(0.1 * k) + "\t" + std::to_string(k % 5) + "\n";
      };
      rising += line(i);
      falling += line(19 - i);
    }
  for (const std::string &text : {rising, "x\tz\n" + falling})
    {
      const HeightMap map = read(text);
      EXPECT_EQ(map.provenance.format, "text, x z");
      ASSERT_EQ(map.nx, 20u);
      ASSERT_EQ(map.ny, 1u);
      EXPECT_NEAR(map.dx, 0.1e-6, 1e-13);
      for (unsigned int i = 0; i < 20; ++i)
        EXPECT_NEAR(map(i, 0), 1e-6 * (i % 5), 1e-15);
    }
  expect_in("not equally spaced", refusal(rising + "2.5\t1\n"));
  ReadOptions options;
  expect_in("Height unit) and that of its coordinates (Lateral unit)",
            refusal(rising, options));
}

TEST(TextMaps, points_are_read_or_refused_as_what_they_are)
{
  std::string full, sparse, four, scattered;
  for (unsigned int j = 0; j < 6; ++j)
    for (unsigned int i = 0; i < 8; ++i)
      {
        const std::string z = std::to_string(10 * j + i);
        const std::string line =
          std::to_string(0.5 * i) + " " + std::to_string(0.25 * j) + " " + z;
        full += line + "\n";
        four += line + " 128\n";
        if ((i + 2 * j) % 3 == 0)
          sparse += line + "\n";
        scattered += std::to_string(0.5 * i + 0.01 * ((7 * i + 5 * j) % 11)) +
                     " " + std::to_string(0.25 * j + 0.01 * (i * j % 7)) + " " +
                     z + "\n";
      }
  for (const std::string *text : {&full, &four, &sparse})
    {
      const HeightMap map = read(*text);
      EXPECT_EQ(map.provenance.format, "text, x y z");
      ASSERT_EQ(map.nx, 8u);
      ASSERT_EQ(map.ny, 6u);
      EXPECT_NEAR(map.dx, 0.5e-6, 1e-12);
      EXPECT_NEAR(map.dy, 0.25e-6, 1e-12);
      for (unsigned int j = 0; j < 6; ++j)
        for (unsigned int i = 0; i < 8; ++i)
          {
            const bool listed = text != &sparse || (i + 2 * j) % 3 == 0;
            EXPECT_EQ(std::isnan(map(i, j)), !listed);
            EXPECT_NEAR(listed ? map(i, j) : 0.,
                        listed ? 1e-6 * (10 * j + i) : 0.,
                        1e-15);
          }
    }
  EXPECT_EQ(read(full).n_valid(), 48u);
  EXPECT_EQ(read(sparse).n_valid(), 16u);
  expect_in("4 columns", read(four).provenance.warnings.at(0));
  expect_in("do not lie on a regular grid", refusal(scattered));
  expect_in("again in line 49", refusal(full + full));
}

// Gwyddion's tables of x y z have blank lines and comments between scan lines.
TEST(TextMaps, points_in_blocks_are_one_list)
{
  std::string text = "# x y z\n";
  for (unsigned int j = 0; j < 5; ++j)
    {
      for (unsigned int i = 0; i < 6; ++i)
        text += std::to_string(i) + " " + std::to_string(j) + " " +
                std::to_string(i * j) + "\n";
      text += "\n# scan\n";
    }
  const HeightMap map = read(text);
  EXPECT_EQ(map.n_valid(), 30u);
  EXPECT_NEAR(map(5, 4), 20e-6, 1e-15);
}

TEST(TextMaps, first_of_several_channels_is_read_with_a_warning)
{
  const std::string matrix = matrix_with("1", 0, "\t");
  const std::string other  = "9\t9\t9\t9\n9\t9\t9\t9\n";
  for (const std::string &second : {matrix, other, std::string("1\t2\n3\t4\n")})
    {
      const HeightMap map =
        read("# Channel: Trace\n" + matrix + "\n# Channel: Retrace\n" + second);
      expect_the_matrix(map);
      ASSERT_EQ(map.provenance.warnings.size(), 1u);
      expect_in("line 7", map.provenance.warnings[0]);
      expect_in("Channel: Retrace", map.provenance.warnings[0]);
    }
  expect_in("blank line within its matrix (line 4)",
            refusal(matrix + "\n" + matrix));
}

TEST(TextMaps, coordinates_at_the_edges_of_a_matrix_are_no_heights)
{
  std::string text = "0";
  for (unsigned int i = 0; i < 6; ++i)
    text += "\t" + std::to_string(0.5 * (i + 3));
  for (unsigned int j = 0; j < 6; ++j)
    {
      text += "\n" + std::to_string(0.25 * (j + 3));
      for (unsigned int i = 0; i < 6; ++i)
        text += "\t" + std::to_string((7 * i + 3 * j) % 5);
    }
  expect_in("coordinates in its first row and first column", refusal(text));

  // Of one edge alone.
  std::string row, column;
  for (unsigned int j = 0; j < 7; ++j)
    {
      column += std::to_string(0.25 * j);
      for (unsigned int i = 0; i < 7; ++i)
        {
          const std::string height = std::to_string((7 * i + 3 * j) % 5);
          row += (i > 0 ? "\t" : "") +
                 (j > 0 ? height : std::to_string(0.5 * (i + 3)));
          column += "\t" + height;
        }
      row += "\n";
      column += "\n";
    }
  expect_in("coordinates in its first row;", refusal(row));
  expect_in("coordinates in its first column;", refusal(column));
}

TEST(TextMaps, heights_of_a_plane_are_no_coordinates)
{
  std::string text;
  for (unsigned int j = 0; j < 8; ++j)
    for (unsigned int i = 0; i < 8; ++i)
      text += std::to_string(0.5 * i + 0.25 * j) + (i < 7 ? "\t" : "\n");
  EXPECT_EQ(read(text).nx, 8u);
}

TEST(TextMaps, header_of_gwyddion_gives_size_and_unit)
{
  const std::string matrix = matrix_with("1", 0, "\t");
  const ReadOptions nothing;
  for (const char *micro : {"\xc2\xb5m", "um", "\xce\xbcm"})
    {
      const std::string unit(micro);
      const HeightMap   map =
        read("# Channel: Height\n# Width: 2 " + unit + "\n# Height: 0.75 " +
               unit + "\n# Value units: um\n" + matrix,
             nothing);
      expect_the_matrix(map);
      EXPECT_EQ(map.provenance.unit_source, "lines of the header");
    }
  expect_the_matrix(read("# Breite: 2,0 um\n# H\xc3\xb6he: 750 nm\n"
                         "# Einheiten: um\n" +
                           matrix,
                         nothing));
  // SPIP leaves out the nanometres.
  expect_the_matrix(read("# File Format = ASCII\n# x-pixels = 4\n# y-pixels = "
                         "3\n# x-length = 2000\n# y-length = 750\n"
                         "# z-unit = um\n" +
                           matrix,
                         nothing));
  expect_in("'Value units: V'",
            refusal("# Value units: V\n" + matrix, nothing));
  expect_in("has 5 columns (x-pixels), and holds 4",
            refusal("# x-pixels = 5\n" + matrix));
  ReadOptions other = micrometres();
  other.spacing_x   = 0.6e-6;
  expect_in("leave out the entry", refusal("# Width: 2 um\n" + matrix, other));
}

TEST(TextMaps, entries_that_are_needed_are_named_at_once)
{
  const std::string message = refusal(matrix_with("1", 0, " "), ReadOptions());
  for (const char *entry :
       {"carries no unit", "Height unit", "Spacing x", "Spacing y"})
    expect_in(entry, message);
}
