#ifndef asperity_campaign_task_counter_h
#define asperity_campaign_task_counter_h

#include <mpi.h>

#include <cstddef>
#include <functional>

namespace asperity
{
  /**
   * Hands out the numbers 0, 1, ..., n - 1 to the ranks of a communicator, each
   * number once, to the rank that asks first: whoever is done early takes more,
   * and no rank is set aside to serve the others. The counter is a window of
   * rank 0's memory that the others increase by one-sided communication.
   */
  class TaskCounter
  {
  public:
    /** Collective. */
    explicit TaskCounter(const MPI_Comm communicator);

    /** Collective. */
    ~TaskCounter();

    TaskCounter(const TaskCounter &) = delete;
    TaskCounter &
    operator=(const TaskCounter &) = delete;

    /** The next number. */
    std::size_t
    next();

  private:
    MPI_Win        window = MPI_WIN_NULL;
    unsigned long *value  = nullptr;
  };

  /**
   * Collective: calls @p task for each number below @p n on one of the ranks,
   * and returns when all are done.
   */
  void
  for_each_task(const std::size_t                             n,
                const MPI_Comm                                communicator,
                const std::function<void(const std::size_t)> &task);
} // namespace asperity

#endif
