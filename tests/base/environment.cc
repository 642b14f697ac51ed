#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

using namespace asperity;

namespace
{
  bool
  mpi_runs()
  {
    int started = 0;
    MPI_Initialized(&started);
    return started != 0;
  }
} // namespace



TEST(Environment, knows_the_rank_that_mpirun_has_given)
{
  EXPECT_FALSE(is_started_by_mpirun());
  EXPECT_TRUE(is_first_rank());
  setenv("OMPI_COMM_WORLD_RANK", "0", 1);
  EXPECT_TRUE(is_started_by_mpirun());
  EXPECT_TRUE(is_first_rank());
  setenv("OMPI_COMM_WORLD_RANK", "10", 1);
  EXPECT_FALSE(is_first_rank());
  unsetenv("OMPI_COMM_WORLD_RANK");
}



TEST(Environment, has_some_memory_left_and_no_more_than_there_is)
{
  EXPECT_GT(available_memory(), 1e6);
  EXPECT_LE(available_memory(),
            double(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE));
}



TEST(MpiSession, takes_its_settings_back_and_keeps_those_of_the_user)
{
  setenv("OMPI_MCA_pml", "ob1", 1);
  char   name[]      = "test";
  char  *arguments[] = {name, nullptr};
  int    argc        = 1;
  char **argv        = arguments;
  {
    const MpiSession mpi(argc, argv);
    EXPECT_FALSE(mpi_runs()) << "nothing has asked for it";
    EXPECT_EQ(MpiSession::n_ranks(), 1u);
    MpiSession::start();
    EXPECT_TRUE(mpi_runs());
    EXPECT_EQ(MpiSession::n_ranks(), 1u);
    EXPECT_EQ(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), 1u);
    EXPECT_EQ(std::getenv("OMPI_MCA_ess_singleton_isolated"), nullptr);
    EXPECT_EQ(std::getenv("OMPI_MCA_orte_create_session_dirs"), nullptr);
    EXPECT_EQ(std::getenv("OMPI_MCA_btl"), nullptr);
    EXPECT_STREQ(std::getenv("OMPI_MCA_pml"), "ob1");
  }
  unsetenv("OMPI_MCA_pml");
  EXPECT_THROW(MpiSession::start(), ComputationError) << "no session";
}

TEST(Environment, leaves_a_choice_of_blas_kernels_alone)
{
  const char *const variable = "OPENBLAS_CORETYPE";
  const char *const before   = std::getenv(variable);
  const std::string saved    = before != nullptr ? before : "";
  setenv(variable, "Prescott", 1);
  choose_blas_kernels();
  EXPECT_STREQ(std::getenv(variable), "Prescott");
  unsetenv(variable);
  choose_blas_kernels();
  if (const char *const chosen = std::getenv(variable))
    {
      EXPECT_TRUE(std::string(chosen) == "SkylakeX" ||
                  std::string(chosen) == "Haswell");
    }
  unsetenv(variable);
  if (before != nullptr)
    setenv(variable, saved.c_str(), 1);
}
