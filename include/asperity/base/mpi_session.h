#ifndef asperity_base_mpi_session_h
#define asperity_base_mpi_session_h

#include <mpi.h>

#include <memory>

namespace dealii::Utilities::MPI
{
  class MPI_InitFinalize;
}

namespace asperity
{
  /**
   * MPI for the life of this object, with one thread a rank: from the beginning
   * where mpirun has started the process, since the ranks have to meet, and
   * else from the first start(), which most commands never call. A process that
   * no mpirun has started needs neither the daemon that Open MPI would start
   * for it nor a network; without them it is ready in half the time. What the
   * user has set stays as it is, and child processes see nothing of this.
   *
   * There is at most one such object, made by main().
   */
  class MpiSession
  {
  public:
    MpiSession(int &argc, char **&argv);
    ~MpiSession();

    MpiSession(const MpiSession &) = delete;
    MpiSession &
    operator=(const MpiSession &) = delete;

    /** Starts MPI unless it has started: to be called before what cannot do
     *  without. @throws ComputationError if main() has made no session. */
    static void
    start();

    /** How many ranks mpirun has started; 1 without it. */
    static unsigned int
    n_ranks();

    /** Whether all ranks call this within so many seconds of each other, as
     *  they do with an error that all of them find. */
    static bool
    all_ranks_meet(const double seconds);

  private:
    int    &argc;
    char **&argv;

    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    MPI_Comm errors = MPI_COMM_NULL; ///< for nothing else, of several ranks
  };
} // namespace asperity

#endif
