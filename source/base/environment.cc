#include <asperity/base/environment.h>

#include <deal.II/base/mpi.h>

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace asperity
{
  void
  use_one_thread_per_rank()
  {
    // Both libraries read their variables when they are loaded, which is before
    // main(): so the variables help child processes, and the functions this
    // one. They are looked up by name since BLAS need not be OpenBLAS.
    const auto limit = [](const char *variable, const char *function) {
      if (std::getenv(variable) != nullptr)
        return;
      setenv(variable, "1", 0);
      if (void *const symbol = dlsym(RTLD_DEFAULT, function))
        reinterpret_cast<void (*)(int)>(symbol)(1);
    };
    limit("OPENBLAS_NUM_THREADS", "openblas_set_num_threads");
    limit("OMP_NUM_THREADS", "omp_set_num_threads");
    // CHOLMOD asks for four threads whatever the number is set to; a region of
    // level zero is never parallel.
    if (void *const symbol = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))
      reinterpret_cast<void (*)(int)>(symbol)(0);
  }



  namespace
  {
    bool
    is_set(const char *const variable)
    {
      return std::getenv(variable) != nullptr;
    }

    /** Starters of MPI programs tell each process of its rank. */
    bool
    is_one_of_several_ranks()
    {
      const auto variables = {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"};
      return std::any_of(variables.begin(), variables.end(), is_set);
    }
  } // namespace



  MpiSession::MpiSession(int &argc, char **&argv)
  {
    const std::vector<std::pair<const char *, const char *>> settings = {
      {"OMPI_MCA_ess_singleton_isolated", "1"}, // no daemon
      // Lone processes would share a directory and remove it for each other.
      {"OMPI_MCA_orte_create_session_dirs", "0"},
      {"OMPI_MCA_pml", "ob1"},
      {"OMPI_MCA_btl", "self"}}; // messages to oneself only
    std::vector<const char *> set_here;
    if (!is_one_of_several_ranks())
      for (const auto &[variable, value] : settings)
        if (!is_set(variable))
          {
            setenv(variable, value, 0);
            set_here.push_back(variable);
          }
    mpi =
      std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
    for (const char *const variable : set_here)
      unsetenv(variable);
  }



  MpiSession::~MpiSession() = default;
} // namespace asperity
