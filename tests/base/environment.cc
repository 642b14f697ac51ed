#include <asperity/base/environment.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cstdlib>

using namespace asperity;

TEST(MpiSession, takes_its_settings_back_and_keeps_those_of_the_user)
{
  setenv("OMPI_MCA_pml", "ob1", 1);
  char   name[]      = "test";
  char  *arguments[] = {name, nullptr};
  int    argc        = 1;
  char **argv        = arguments;
  {
    const MpiSession mpi(argc, argv);
    EXPECT_EQ(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), 1u);
    EXPECT_EQ(std::getenv("OMPI_MCA_ess_singleton_isolated"), nullptr);
    EXPECT_EQ(std::getenv("OMPI_MCA_orte_create_session_dirs"), nullptr);
    EXPECT_EQ(std::getenv("OMPI_MCA_btl"), nullptr);
    EXPECT_STREQ(std::getenv("OMPI_MCA_pml"), "ob1");
  }
  unsetenv("OMPI_MCA_pml");
}
