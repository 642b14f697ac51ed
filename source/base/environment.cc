#include <asperity/base/environment.h>

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string>

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



  void
  choose_blas_kernels()
  {
#if defined(__x86_64__) && defined(__GNUC__)
    const bool wide =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
    if (wide)
      setenv("OPENBLAS_CORETYPE", "SkylakeX", 0);
    else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      setenv("OPENBLAS_CORETYPE", "Haswell", 0);
#endif
  }



  namespace
  {
    /** What a container may still take [bytes]; infinite without a limit. */
    double
    memory_of_container()
    {
      double limit = 0., current = 0.;
      if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit &&
          std::ifstream("/sys/fs/cgroup/memory.current") >> current)
        return std::max(0., limit - current);
      return std::numeric_limits<double>::infinity(); // "max", or no file
    }
  } // namespace



  double
  available_memory()
  {
    const double  limit = memory_of_container();
    std::ifstream file("/proc/meminfo"); // name: number kB
    std::string   name, unit;
    double        number = 0.;
    while (file >> name >> number)
      {
        if (name == "MemAvailable:")
          return std::min(limit, 1024. * number);
        std::getline(file, unit);
      }
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    return pages > 0 && size > 0 ? std::min(limit, double(pages) * size) : 0.;
  }



  namespace
  {
    /** The rank that a starter of MPI programs has given to this process; null
     *  without one. */
    const char *
    rank_by_environment()
    {
      for (const char *const variable :
           {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const char *const rank = std::getenv(variable))
          return rank;
      return nullptr;
    }
  } // namespace



  bool
  is_started_by_mpirun()
  {
    return rank_by_environment() != nullptr;
  }



  bool
  is_first_rank()
  {
    const char *const rank = rank_by_environment();
    return rank == nullptr || std::strcmp(rank, "0") == 0;
  }
} // namespace asperity
