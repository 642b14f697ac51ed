#include <algorithm>
#include <vector>

#include "program.h"

using namespace asperity;

using FluidStructure = Program;

namespace
{
  std::string
  published(const std::string &name)
  {
    return "include " ASPERITY_SOURCE_DIR "/parameter_files/fluid_structure/" +
           name + ".prm\n";
  }

  /** A channel of a few cells and four steps. */
  const std::string small_channel =
    "subsection Fluid\n set Cells along = 10\nend\n"
    "subsection Time\n set Steps = 1 ms\n set Ends = 4 ms\nend\n";

  /** Quadrilaterals over the half channel; the rigid ends are ids 4. */
  std::string
  gmsh_channel(const unsigned int n, const bool with_lining)
  {
    std::string nodes, cells;
    for (unsigned int j = 0; j < 2; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        nodes += std::to_string(1 + i + j * (n + 1)) + " " +
                 std::to_string(0.1 * i / n) + " " + std::to_string(2e-3 * j) +
                 " 0\n";
    unsigned int n_elements = 0;
    const auto   add        = [&](const std::string               &type,
                         const unsigned int               id,
                         const std::vector<unsigned int> &corners) {
      cells += std::to_string(++n_elements) + " " + type + " 2 " +
               std::to_string(id) + " " + std::to_string(id);
      for (const unsigned int c : corners)
        cells += " " + std::to_string(c);
      cells += "\n";
    };
    const unsigned int top = n + 1;
    for (unsigned int i = 1; i <= n; ++i)
      {
        add("3", 0, {i, i + 1, top + i + 1, top + i});
        add("1", 2, {i, i + 1});
        add("1",
            i == 1 || i == n || !with_lining ? 4 : 3,
            {top + i, top + i + 1});
      }
    add("1", 1, {n + 1, top + n + 1});
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
           std::to_string(2 * (n + 1)) + "\n" + nodes +
           "$EndNodes\n$Elements\n" + std::to_string(n_elements) + "\n" +
           cells + "$EndElements\n";
  }

  std::string
  with_mesh(const std::string &file)
  {
    return published("lined_channel") + small_channel +
           "subsection Problem\n set Mesh file = " + file + "\nend\n";
  }
} // namespace



TEST_F(FluidStructure, runs_and_goes_on)
{
  const std::string output = "subsection Output\n set Output directory = out\n"
                             " set Checkpoint interval = 2\n";
  write("whole.prm",
        published("lined_channel") + small_channel + output + "end\n");
  const Result whole = run("whole.prm");
  ASSERT_EQ(whole.status, 0) << whole.errors;
  const std::string table = read("out/fluid_structure.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  for (const std::string name : {"fluid.pvd", "body.pvd", "summary.json"})
    EXPECT_FALSE(read("out/" + name).empty()) << name;

  std::filesystem::remove(folder / "out/checkpoint/step_4.checkpoint");
  write("rest.prm",
        published("lined_channel") + small_channel + output +
          " set Restart = true\nend\n");
  const Result rest = run("rest.prm");
  ASSERT_EQ(rest.status, 0) << rest.errors;
  EXPECT_NE(rest.output.find("Goes on from t = 0.002 s"), std::string::npos)
    << rest.output;
  EXPECT_EQ(read("out/fluid_structure.csv"), table);
}



TEST_F(FluidStructure, continues_on_another_mesh)
{
  write("coarse.prm",
        published("lined_channel") + small_channel +
          "subsection Output\n set Output directory = coarse\n set Checkpoint "
          "interval = 4\nend\n");
  ASSERT_EQ(run("coarse.prm").status, 0);
  const auto fine = [&](const std::string &folder) {
    return published("lined_channel") +
           "subsection Fluid\n set Cells along = 10\n set Degree = 3\nend\n"
           "subsection Time\n set Steps = 1 ms\n set Ends = 6 ms\nend\n"
           "subsection Problem\n set Continue from = " +
           folder +
           "\nend\nsubsection Output\n set Output directory = fine\nend\n";
  };
  write("fine.prm", fine("coarse"));
  const Result result = run("fine.prm");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("Goes on from t = 0.004 s"), std::string::npos)
    << result.output;
  EXPECT_NE(refusal(fine("nowhere"))
              .find("entry 'Problem/Continue from': The parameter file "
                    "'nowhere/parameters.prm'"),
            std::string::npos);
}



TEST_F(FluidStructure, check_says_what_is_not_used)
{
  write("box.prm",
        published("inflatable_box") +
          "subsection Tool\n set Kind = flat\nend\nsubsection Problem\n "
          "subsection Pulse\n  set Pressure = 1 Pa\n end\nend\n");
  const Result result = run("check box.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find(
              "Warning: The problem 'inflatable box' does not use the entries "
              "'Problem/Pulse/Pressure', 'Tool/Kind'.\n"),
            std::string::npos)
    << result.output;
}



TEST_F(FluidStructure, check_refuses_dirichlet_neumann_where_it_cannot_work)
{
  for (const std::string name : {"inflatable_box", "enclosed_domain"})
    {
      write("enclosed.prm",
            published(name) +
              "subsection Coupling\n set Scheme = Dirichlet-Neumann\nend\n");
      const Result result = run("check enclosed.prm");
      EXPECT_EQ(result.status, 2);
      EXPECT_EQ(result.errors,
                "Error: enclosed.prm: Dirichlet-Neumann coupling has no "
                "solution here, because the fluid is incompressible and "
                "enclosed, so that a prescribed motion of its walls "
                "contradicts its volume; choose Robin-Neumann.\n");
    }
}



TEST_F(FluidStructure, refuses_contradictions_with_their_place)
{
  EXPECT_EQ(refusal("subsection Problem\n set Kind = Turek-Hron\n set Speed = "
                    "1 m/s\nend\n")
              .find("Error: scene.prm, line 3"),
            0u);
  EXPECT_EQ(refusal("subsection Problem\n set Kind = Turek-Hron\nend\n"
                    "subsection Coupling\n set Scheme = Robin-Neumann\nend\n"),
            "Error: scene.prm, line 5, entry 'Coupling/Scheme': found "
            "Robin-Neumann with a steady flow, whose walls have no velocity; "
            "expected Dirichlet-Neumann.\n");
  EXPECT_EQ(refusal("subsection Problem\n set Kind = Turek-Hron\nend\n"
                    "subsection Time\n set Ends = 2, 1 s\n set Steps = 1, 1 "
                    "s\nend\n"),
            "Error: scene.prm, line 5, entry 'Time/Ends': found 1 s after 2 s; "
            "expected times that grow.\n");
}



TEST_F(FluidStructure, reads_meshes)
{
  write("mesh.msh", gmsh_channel(10, true));
  write("good.prm", with_mesh("mesh.msh"));
  const Result good = run("check good.prm");
  EXPECT_EQ(good.status, 0) << good.errors;
  EXPECT_NE(good.output.find("Fluid: 10 cells"), std::string::npos)
    << good.output;

  write("rigid.msh", gmsh_channel(10, false));
  EXPECT_NE(refusal(with_mesh("rigid.msh"))
              .find("rigid.msh: found no boundary with the id 3; expected one, "
                    "the lining."),
            std::string::npos);
  write("bad.msh", "nothing\n");
  EXPECT_NE(refusal(with_mesh("bad.msh"))
              .find("bad.msh: no mesh of quadrilaterals can be read from it"),
            std::string::npos);
  EXPECT_NE(refusal(with_mesh("missing.msh")).find("entry 'Problem/Mesh file'"),
            std::string::npos);
  write("apart.msh", gmsh_channel(12, true));
  EXPECT_NE(refusal(with_mesh("apart.msh")).find("Error: scene.prm: "),
            std::string::npos);
}
