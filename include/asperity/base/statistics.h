#ifndef asperity_base_statistics_h
#define asperity_base_statistics_h

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * Wall time by phase and counts of what was done (Newton iterations,
   * factorisations, ...), on this rank, in the order of first use. A phase
   * inside another one counts for both; sum only phases of one level.
   */
  class Statistics
  {
  public:
    /** Adds the time until it goes out of scope to its phase. */
    class Scope
    {
    public:
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;
      ~Scope();

    private:
      friend class Statistics;
      Scope(Statistics &statistics, const std::size_t phase);

      Statistics                           &statistics;
      const std::size_t                     phase;
      std::chrono::steady_clock::time_point start;
    };

    /** `const auto timing = statistics.time("assembly");` */
    [[nodiscard]] Scope
    time(const std::string &phase);

    void
    add_seconds(const std::string &phase, const double seconds);

    void
    count(const std::string &what, const unsigned long n = 1);

    /** Zero for a phase that has not run. */
    double
    seconds(const std::string &phase) const;

    unsigned long
    count_of(const std::string &what) const;

    /**
     * {"seconds": {phase: wall time}, "calls": {phase: number}, "counts":
     * {what: number}}, for `summary.json`.
     */
    nlohmann::ordered_json
    to_json() const;

    /** A short table, the phases with their share of @p total_seconds. */
    std::string
    table(const double total_seconds) const;

  private:
    struct Phase
    {
      std::string   name;
      double        seconds = 0.;
      unsigned long calls   = 0;
    };

    std::size_t
    index_of(const std::string &phase);

    std::vector<Phase>                                 phases;
    std::vector<std::pair<std::string, unsigned long>> counts;
  };
} // namespace asperity

#endif
