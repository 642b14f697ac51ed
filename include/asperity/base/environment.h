#ifndef asperity_base_environment_h
#define asperity_base_environment_h

#include <memory>

namespace dealii::Utilities::MPI
{
  class MPI_InitFinalize;
}

namespace asperity
{
  /**
   * Makes BLAS and OpenMP use one thread, unless OPENBLAS_NUM_THREADS or
   * OMP_NUM_THREADS say otherwise. The matrices of a scene are too small for
   * more, and the threads of several ranks (or of several runs of a campaign)
   * would fight for the cores. Call it first in main().
   */
  void
  use_one_thread_per_rank();

  /**
   * MPI for the life of this object, with one thread a rank. A process that no
   * mpirun has started needs neither the daemon that Open MPI would start for
   * it nor a network; without them it is ready in half the time. What the user
   * has set stays as it is, and child processes see nothing of this.
   */
  class MpiSession
  {
  public:
    MpiSession(int &argc, char **&argv);
    ~MpiSession();

  private:
    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  };
} // namespace asperity

#endif
