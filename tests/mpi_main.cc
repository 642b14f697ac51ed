#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <gtest/gtest.h>

// The main function of the rooms that build on deal.II's parallel classes. MPI
// starts only for tests that run: ctest also asks for their names.
int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests))
    return RUN_ALL_TESTS();
  const asperity::MpiSession mpi(argc, argv);
  return RUN_ALL_TESTS();
}
