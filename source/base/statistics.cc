#include <asperity/base/statistics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace asperity
{
  Statistics::Scope::Scope(Statistics &statistics, const std::size_t phase)
    : statistics(statistics)
    , phase(phase)
    , start(std::chrono::steady_clock::now())
  {}

  Statistics::Scope::~Scope()
  {
    Phase &timed = statistics.phases[phase];
    timed.seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
    ++timed.calls;
  }

  Statistics::Scope
  Statistics::time(const std::string &phase)
  {
    return Scope(*this, index_of(phase));
  }

  void
  Statistics::add_seconds(const std::string &phase, const double seconds)
  {
    Phase &timed = phases[index_of(phase)];
    timed.seconds += seconds;
    ++timed.calls;
  }

  void
  Statistics::count(const std::string &what, const unsigned long n)
  {
    for (auto &[name, number] : counts)
      if (name == what)
        {
          number += n;
          return;
        }
    counts.push_back({what, n});
  }

  double
  Statistics::seconds(const std::string &phase) const
  {
    for (const Phase &timed : phases)
      if (timed.name == phase)
        return timed.seconds;
    return 0.;
  }

  unsigned long
  Statistics::count_of(const std::string &what) const
  {
    for (const auto &[name, number] : counts)
      if (name == what)
        return number;
    return 0;
  }

  std::size_t
  Statistics::index_of(const std::string &phase)
  {
    const auto found =
      std::find_if(phases.begin(), phases.end(), [&](const Phase &timed) {
        return timed.name == phase;
      });
    if (found != phases.end())
      return found - phases.begin();
    phases.push_back({phase, 0., 0});
    return phases.size() - 1;
  }

  nlohmann::ordered_json
  Statistics::to_json() const
  {
    auto seconds = nlohmann::ordered_json::object();
    auto calls   = nlohmann::ordered_json::object();
    auto number  = nlohmann::ordered_json::object();
    for (const Phase &timed : phases)
      {
        seconds[timed.name] = timed.seconds;
        calls[timed.name]   = timed.calls;
      }
    for (const auto &[name, n] : counts)
      number[name] = n;
    return {{"seconds", seconds}, {"calls", calls}, {"counts", number}};
  }

  std::string
  Statistics::table(const double total_seconds) const
  {
    std::size_t width = 0;
    for (const Phase &timed : phases)
      width = std::max(width, timed.name.size());
    for (const auto &[name, n] : counts)
      width = std::max(width, name.size());

    std::ostringstream out;
    out << std::fixed;
    for (const Phase &timed : phases)
      {
        out << "  " << std::left << std::setw(static_cast<int>(width))
            << timed.name << std::right << std::setprecision(2) << std::setw(10)
            << timed.seconds << " s";
        if (total_seconds > 0.)
          out << std::setprecision(0) << std::setw(5)
              << 100. * timed.seconds / total_seconds << " %";
        out << std::setw(9) << timed.calls << " x\n";
      }
    for (const auto &[name, n] : counts)
      out << "  " << std::left << std::setw(static_cast<int>(width)) << name
          << std::right << std::setw(10) << n << '\n';
    return out.str();
  }
} // namespace asperity
