#include <asperity/base/mpi_session.h>
#include <asperity/campaign/task_counter.h>

#include <exception>

namespace asperity
{
  TaskCounter::TaskCounter(const MPI_Comm communicator)
  {
    MpiSession::start();
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    MPI_Win_allocate(rank == 0 ? sizeof(unsigned long) : 0,
                     sizeof(unsigned long),
                     MPI_INFO_NULL,
                     communicator,
                     &value,
                     &window);
    if (rank == 0)
      {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
        *value = 0;
        MPI_Win_unlock(0, window);
      }
    MPI_Barrier(communicator);
  }



  TaskCounter::~TaskCounter()
  {
    // An error on one rank ends all of them; the others will not come here.
    if (std::uncaught_exceptions() == 0)
      MPI_Win_free(&window);
  }



  std::size_t
  TaskCounter::next()
  {
    const unsigned long one    = 1;
    unsigned long       result = 0;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
    MPI_Fetch_and_op(&one, &result, MPI_UNSIGNED_LONG, 0, 0, MPI_SUM, window);
    MPI_Win_unlock(0, window);
    return result;
  }



  void
  for_each_task(const std::size_t                             n,
                const MPI_Comm                                communicator,
                const std::function<void(const std::size_t)> &task)
  {
    TaskCounter counter(communicator);
    for (std::size_t i = counter.next(); i < n; i = counter.next())
      task(i);
    MPI_Barrier(communicator);
  }
} // namespace asperity
