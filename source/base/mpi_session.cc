#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

namespace asperity
{
  namespace
  {
    MpiSession *session = nullptr;

    /** Variables of Open MPI for the life of this object, where they are not
     *  set. */
    class SettingsOfLoneProcess
    {
    public:
      SettingsOfLoneProcess()
      {
        const std::vector<std::pair<const char *, const char *>> settings = {
          {"OMPI_MCA_ess_singleton_isolated", "1"}, // no daemon
          // Lone processes would share a directory and remove it for each
          // other.
          {"OMPI_MCA_orte_create_session_dirs", "0"},
          {"OMPI_MCA_pml", "ob1"},
          {"OMPI_MCA_btl", "self"}}; // messages to oneself only
        for (const auto &[variable, value] : settings)
          if (std::getenv(variable) == nullptr)
            {
              setenv(variable, value, 0);
              set_here.push_back(variable);
            }
      }

      ~SettingsOfLoneProcess()
      {
        for (const char *const variable : set_here)
          unsetenv(variable);
      }

    private:
      std::vector<const char *> set_here;
    };

    /** Lets ranks that wait for a message leave the core to others where there
     *  are more of them than cores. */
    void
    yield_where_crowded()
    {
      const char *const n_here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
      if (n_here != nullptr && std::strtoul(n_here, nullptr, 10) >
                                 dealii::MultithreadInfo::n_cores())
        setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    }
  } // namespace



  MpiSession::MpiSession(int &argc, char **&argv)
    : argc(argc)
    , argv(argv)
  {
    session = this;
    if (is_started_by_mpirun())
      start();
  }



  MpiSession::~MpiSession()
  {
    session = nullptr;
  }



  void
  MpiSession::start()
  {
    using dealii::Utilities::MPI::MPI_InitFinalize;
    if (session == nullptr)
      throw ComputationError("MPI is needed, but main() has made no session.");
    if (session->mpi)
      return;
    std::unique_ptr<SettingsOfLoneProcess> settings;
    if (is_started_by_mpirun())
      yield_where_crowded();
    else
      settings = std::make_unique<SettingsOfLoneProcess>();
    session->mpi =
      std::make_unique<MPI_InitFinalize>(session->argc, session->argv, 1);
    if (n_ranks() > 1)
      MPI_Comm_dup(MPI_COMM_WORLD, &session->errors);
  }



  unsigned int
  MpiSession::n_ranks()
  {
    return session != nullptr && session->mpi ?
             dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) :
             1;
  }



  bool
  MpiSession::all_ranks_meet(const double seconds)
  {
    if (n_ranks() == 1)
      return true;
    // A rank that is here may have to meet others which wait for it elsewhere,
    // so this is no message that they could take for theirs.
    MPI_Request request;
    MPI_Ibarrier(session->errors, &request);
    const double deadline = MPI_Wtime() + seconds;
    int          met      = 0;
    while (met == 0 && MPI_Wtime() < deadline)
      {
        MPI_Test(&request, &met, MPI_STATUS_IGNORE);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    return met != 0;
  }
} // namespace asperity
