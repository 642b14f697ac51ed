#include "program.h"

// A limit on the size of files stands for a disk that is full.

using namespace asperity;

using FullDisk = Program;

namespace
{
  const std::string small_scene = "subsection Mesh\n"
                                  "  set Spans = 40\n"
                                  "  set Refinement levels = 1\n"
                                  "end\n"
                                  "subsection Protocol\n"
                                  "  set Ramp steps = 6\n"
                                  "  set Slide steps = 24\n"
                                  "  set Inertia = quasi-static\n"
                                  "end\n"
                                  "subsection Output\n"
                                  "  set Output directory = results\n"
                                  "  set Picture interval = 2\n"
                                  "  set Subdivisions = 6\n"
                                  "end\n";

  /** In blocks of 512 bytes. */
  std::string
  limit(const unsigned int blocks)
  {
    return "trap '' XFSZ; ulimit -f " + std::to_string(blocks) + ";";
  }
} // namespace

TEST_F(FullDisk, parameters_that_cannot_be_written_are_named_and_not_cut_off)
{
  write("scene.prm", small_scene);
  const Result result = run("scene.prm", limit(8));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(
    result.errors,
    "Error: The file 'results/parameters.prm' could not be written: file "
    "too large.\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "results/parameters.prm"));
}

TEST_F(FullDisk, pictures_that_cannot_be_written_are_named_with_the_reason)
{
  write("scene.prm", small_scene);
  const Result result = run("scene.prm", limit(200));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errors.find(
              "Error: The file 'results/chip_000002.vtu' could "
              "not be written: file too large."),
            0u)
    << result.errors;
  EXPECT_LT(result.errors.size(), 200u);
  EXPECT_FALSE(std::filesystem::exists(folder / "results/chip_000002.vtu"));
}

TEST_F(FullDisk, what_cannot_be_printed_is_a_failure)
{
  for (const std::string arguments : {"--help", "parameters"})
    {
      const std::string command = "'" ASPERITY_PROGRAM "' " + arguments +
                                  " >/dev/full 2>'" +
                                  (folder / "errors.txt").string() + "'";
      const int status = std::system(command.c_str());
      EXPECT_EQ(WEXITSTATUS(status), 1) << arguments;
      EXPECT_EQ(read("errors.txt"),
                "Error: The standard output could not be written; is the disk "
                "full?\n");
    }
}
