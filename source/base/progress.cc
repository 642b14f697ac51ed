#include <asperity/base/progress.h>

#include <unistd.h>

#include <cmath>
#include <ostream>
#include <sstream>

namespace asperity
{
  namespace
  {
    constexpr double seconds_between_log_lines = 10.;

    // enough to be smooth, too few to cost time
    constexpr double seconds_between_terminal_lines = 0.1;

    double
    seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }
  } // namespace

  std::string
  format_duration(const double seconds)
  {
    const long whole = std::lround(std::max(0., seconds));
    if (seconds < 9.95)
      {
        std::ostringstream out;
        out.precision(1);
        out << std::fixed << std::max(0., seconds) << " s";
        return out.str();
      }
    if (whole < 60)
      return std::to_string(whole) + " s";
    if (whole < 3600)
      return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) +
             " s";
    return std::to_string(whole / 3600) + " h " +
           std::to_string(whole % 3600 / 60) + " min";
  }

  ProgressLine::ProgressLine(std::ostream &out, const Mode mode)
    : out(out)
    , mode(mode != Mode::automatic ? mode :
           isatty(STDOUT_FILENO)   ? Mode::terminal :
                                     Mode::log)
    , start(Clock::now())
    , last_printed(start)
  {}

  ProgressLine::~ProgressLine()
  {
    finish_line();
  }

  void
  ProgressLine::update(const double fraction, const std::string &text)
  {
    if (mode == Mode::silent)
      return;
    const bool   last     = fraction >= 1.;
    const double interval = mode == Mode::terminal ?
                              seconds_between_terminal_lines :
                              seconds_between_log_lines;
    if (!last && anything_printed && seconds_since(last_printed) < interval)
      return;

    const double elapsed = seconds_since(start);
    std::string  line    = text;
    if (last)
      line += "  (" + format_duration(elapsed) + ")";
    else if (fraction > 0.)
      line +=
        "  (" + format_duration(elapsed * (1. / fraction - 1.)) + " left)";

    if (mode == Mode::terminal)
      {
        const std::size_t length = line.size();
        if (length < open_length)
          line.append(open_length - length, ' '); // over the longer old line
        out << '\r' << line << std::flush;
        open_length = length;
        if (last)
          finish_line();
      }
    else
      out << line << std::endl;
    anything_printed = true;
    last_printed     = Clock::now();
  }

  void
  ProgressLine::note(const std::string &text)
  {
    if (mode == Mode::silent)
      return;
    finish_line();
    out << text << std::endl;
  }

  void
  ProgressLine::finish_line()
  {
    if (open_length > 0)
      out << std::endl;
    open_length = 0;
  }
} // namespace asperity
