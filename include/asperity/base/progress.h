#ifndef asperity_base_progress_h
#define asperity_base_progress_h

#include <chrono>
#include <iosfwd>
#include <string>

namespace asperity
{
  /** "7 s", "3 min 20 s", "2 h 5 min": for people, not for tables. */
  std::string
  format_duration(const double seconds);

  /**
   * One line a step: "step 12/50  t = 0.06 us  mu = 0.21  (8 s left)". On a
   * terminal the line is rewritten in place; elsewhere (log files, pipes) a
   * line is printed at most every ten seconds, and always for the last step.
   * Only the rank that prints should own one: give others a closed one.
   */
  class ProgressLine
  {
  public:
    enum class Mode
    {
      automatic, // terminal or log, as standard output is
      terminal,
      log,
      silent
    };

    /**
     * @param out where to print
     * @param mode `automatic` asks whether standard output is a terminal
     */
    explicit ProgressLine(std::ostream &out, const Mode mode = Mode::automatic);

    /** Ends the line that is still open on a terminal. */
    ~ProgressLine();

    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &
    operator=(const ProgressLine &) = delete;

    /**
     * @param fraction of the whole run that is done, in [0, 1]: it gives the
     *   estimate of the time left
     * @param text what to say of the step
     */
    void
    update(const double fraction, const std::string &text);

    /** A line of its own that stays, e.g. that a step was cut. */
    void
    note(const std::string &text);

  private:
    using Clock = std::chrono::steady_clock;

    void
    finish_line();

    std::ostream     &out;
    Mode              mode;
    Clock::time_point start;
    Clock::time_point last_printed;
    bool              anything_printed = false;
    std::size_t       open_length      = 0;
  };
} // namespace asperity

#endif
