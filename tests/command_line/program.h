#ifndef asperity_tests_command_line_program_h
#define asperity_tests_command_line_program_h

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace asperity
{
  /** A folder of its own for each test, and the program run in it. */
  class Program : public testing::Test
  {
  protected:
    struct Result
    {
      int         status = -1;
      std::string output;
      std::string errors;
    };

    void
    SetUp() override
    {
      // Open MPI refuses root, and more ranks than cores, without these.
      for (const char *variable : {"OMPI_ALLOW_RUN_AS_ROOT",
                                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                                   "OMPI_MCA_rmaps_base_oversubscribe"})
        setenv(variable, "1", 1);
      // A test that was killed has left its own.
      std::filesystem::remove_all(folder);
      std::filesystem::create_directories(folder);
    }

    void
    TearDown() override
    {
      std::filesystem::remove_all(folder);
    }

    void
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(folder / name) << text;
    }

    std::string
    read(const std::string &name) const
    {
      std::ifstream in(folder / name);
      return {std::istreambuf_iterator<char>(in), {}};
    }

    /** @param launcher stands before the program, e.g. "mpirun -np 2" */
    Result
    run(const std::string &arguments, const std::string &launcher = "") const
    {
      const std::string command = "cd '" + folder.string() + "' && " +
                                  launcher + " '" + ASPERITY_PROGRAM + "' " +
                                  arguments + " >output.txt 2>errors.txt";
      const int status = std::system(command.c_str());
      Result    result;
      result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      result.output = read("output.txt");
      result.errors = read("errors.txt");
      return result;
    }

    /** The sentence that the program ends with on this input, status 2. */
    std::string
    refusal(const std::string &text) const
    {
      write("scene.prm", text);
      const Result result = run("scene.prm");
      EXPECT_EQ(result.status, 2) << result.output << result.errors;
      EXPECT_EQ(result.output, "") << "nothing is computed";
      return result.errors;
    }

    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      (std::string("asperity_") +
       testing::UnitTest::GetInstance()
         ->current_test_info()
         ->test_suite_name() +
       "." + testing::UnitTest::GetInstance()->current_test_info()->name());
  };
} // namespace asperity

#endif
