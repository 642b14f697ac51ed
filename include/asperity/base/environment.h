#ifndef asperity_base_environment_h
#define asperity_base_environment_h

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
} // namespace asperity

#endif
