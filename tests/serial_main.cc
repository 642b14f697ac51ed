#include <asperity/base/environment.h>

#include <gtest/gtest.h>

// The main function of tests without MPI. BLAS keeps to one thread, since its
// waiting threads keep the cores from the tests that run beside this one.
int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
