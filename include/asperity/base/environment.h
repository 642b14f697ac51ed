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

  /**
   * Tells the programs that this process becomes or starts which kernels
   * OpenBLAS shall use, by OPENBLAS_CORETYPE, unless it is set: releases older
   * than a processor take it for one of 2004 otherwise, and a run takes a sixth
   * longer. Other BLAS libraries do not read the variable.
   */
  void
  choose_blas_kernels();

  /** Memory that this machine can still give [bytes], by /proc/meminfo, and not
   *  more than the limit of a container (cgroup v2) leaves; all of it where
   *  there is no such file; 0 if that is unknown, too. */
  double
  available_memory();

  /** True if a starter of MPI programs (mpirun, srun) has started this
   *  process, which it tells by variables of the environment. */
  bool
  is_started_by_mpirun();

  /** True for a process that no mpirun has started, and for the first rank of
   *  those that it has. Does not need MPI. */
  bool
  is_first_rank();
} // namespace asperity

#endif
