#ifndef asperity_base_parameters_h
#define asperity_base_parameters_h

#include <asperity/base/quantity.h>

#include <functional>
#include <iosfwd>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace asperity
{
  struct ParameterLine;

  /** The values a number may take, in SI units; infinite ends are open. */
  struct Range
  {
    double minimum         = -std::numeric_limits<double>::infinity();
    double maximum         = std::numeric_limits<double>::infinity();
    bool   minimum_allowed = true;
    bool   maximum_allowed = true;

    static Range
    any();
    /** value > 0 */
    static Range
    positive();
    /** value >= 0 */
    static Range
    non_negative();
    static Range
    at_least(const double minimum);
    static Range
    above(const double minimum);
    /** Both ends belong to it. */
    static Range
    between(const double minimum, const double maximum);

    bool
    contains(const double value) const;

    /** "> 0 MPa", "0 to 1", "-90 deg to 90 deg", or "any". */
    std::string
    description(const std::string &unit = "1") const;
  };

  /** Whether an entry has a default. */
  enum class Need
  {
    optional,
    mandatory
  };

  /** One declared parameter, as the reference lists it. */
  struct ParameterEntry
  {
    std::string subsection; // nested ones joined by '/', empty at the top
    std::string key;
    std::string default_text; // empty if mandatory
    std::string kind;         // "stress", "integer", "one of: a, b", ...
    std::string range;
    std::string sentence;
    Need        need    = Need::optional;
    bool        is_file = false; // relative to the file that names it

    /** Parses the text into the variable and returns the value in its own
     *  words: "0.3 GPa" and "300 MPa" of a stress in MPa are "300 MPa".
     *  @throws InputError (half sentence) */
    std::function<std::string(const std::string &)> assign;

    /** What assign() returned last; empty if nothing has been assigned. */
    std::string value;

    bool given = false; // by a file or by set()

    /** "name.prm, line 7" once an input file has given it, else empty. */
    std::string origin;

    /** "Load/Pressure" */
    std::string
    path() const;
  };

  /**
   * Declares parameters on a dealii::ParameterHandler, one statement each: key,
   * variable, unit, range and a sentence that carries symbol and unit. The
   * value that the variable has when it is declared is the default: it stands
   * in the parameter struct and nowhere else. Afterwards the same object reads
   * input files strictly, and writes the complete file and the reference.
   *
   * Each room's parameter struct has a member
   * @code
   *   void LoadParameters::declare(ParameterDeclarator &parameters)
   *   {
   *     const auto section = parameters.subsection("Load");
   *     parameters.quantity("Pressure", pressure, "MPa", Range::positive(),
   *                         "Nominal contact pressure p (force over period).");
   *     parameters.choice("Inertia", inertia,
   *                       {{"quasi-static", Inertia::none},
   *                        {"dynamic", Inertia::full}},
   *                       "Whether the chip's mass resists.");
   *   }
   * @endcode
   * The variables must outlive the declarator. A sentence is one or more
   * sentences in plain English; choices state what each of them does.
   *
   * Every declaring function throws std::logic_error if the entry is declared
   * twice or its default is no value that it accepts: mistakes of the
   * programmer.
   */
  class ParameterDeclarator
  {
  public:
    explicit ParameterDeclarator(dealii::ParameterHandler &handler);

    ParameterDeclarator(const ParameterDeclarator &) = delete;
    ParameterDeclarator &
    operator=(const ParameterDeclarator &) = delete;

    /** Leaves the subsection when it goes out of scope. */
    class Subsection
    {
    public:
      Subsection(const Subsection &) = delete;
      Subsection &
      operator=(const Subsection &) = delete;
      ~Subsection();

    private:
      friend class ParameterDeclarator;
      explicit Subsection(ParameterDeclarator &declarator);
      ParameterDeclarator &declarator;
    };

    /** A subsection may be entered again later, also by another room. */
    [[nodiscard]] Subsection
    subsection(const std::string &name);

    /** A number with a unit, SI in the variable; the reference shows @p unit.
     */
    void
    quantity(const std::string &key,
             double            &variable,
             const std::string &unit,
             const Range       &range,
             const std::string &sentence,
             const Need         need = Need::optional);

    /** The word `automatic` leaves the variable empty. */
    void
    quantity(const std::string     &key,
             std::optional<double> &variable,
             const std::string     &unit,
             const Range           &range,
             const std::string     &sentence);

    /** A number without a unit. */
    void
    number(const std::string &key,
           double            &variable,
           const Range       &range,
           const std::string &sentence,
           const Need         need = Need::optional);

    void
    number(const std::string     &key,
           std::optional<double> &variable,
           const Range           &range,
           const std::string     &sentence);

    void
    integer(const std::string &key,
            unsigned int      &variable,
            const Range       &range,
            const std::string &sentence,
            const Need         need = Need::optional);

    void
    integer(const std::string           &key,
            std::optional<unsigned int> &variable,
            const Range                 &range,
            const std::string           &sentence);

    /** true or false */
    void
    flag(const std::string &key, bool &variable, const std::string &sentence);

    /** One of several words, each standing for a value of an enum. */
    template <typename Enum>
    void
    choice(const std::string                               &key,
           Enum                                            &variable,
           const std::vector<std::pair<std::string, Enum>> &choices,
           const std::string                               &sentence,
           const Need need = Need::optional);

    /** Any text; an output directory, too (relative to where one stands). */
    void
    text(const std::string &key,
         std::string       &variable,
         const std::string &sentence,
         const Need         need = Need::optional);

    /**
     * An input file, named relative to the parameter file that names it; the
     * variable holds a path that can be opened. A file that cannot be read is
     * an error; an empty text means no file (unless mandatory).
     */
    void
    file(const std::string &key,
         std::string       &variable,
         const std::string &sentence,
         const Need         need = Need::optional);

    /** Values separated by commas: "10 um, 20 um" or "10, 20 um" or empty. */
    void
    list(const std::string   &key,
         std::vector<double> &variable,
         const std::string   &unit,
         const Range         &range,
         const std::string   &sentence);

    /**
     * Reads a parameter file in deal.II's format, strictly. A line `include
     * other.prm` (relative to the including file) may stand at the top level;
     * later lines override what it sets.
     *
     * @throws InputError with one sentence for unknown entries, wrong values
     * and missing mandatory entries, and as read_parameter_lines()
     */
    void
    read_file(const std::string &file_name);

    /** As read_file(); @p name is how messages call the text.
     *  @throws InputError as read_file() */
    void
    read_text(const std::string &text, const std::string &name);

    /** Sets one entry by its path, "Load/Pressure".
     *  @throws InputError if there is none, or for a wrong value */
    void
    set(const std::string &path, const std::string &text);

    /** The current text of an entry. @throws InputError if there is none */
    std::string
    get(const std::string &path) const;

    /**
     * "name.prm, line 7, entry 'Load/Pressure'" for messages about relations
     * between entries; names only the entry if no file has given it.
     *
     * @throws InputError if there is no such entry
     */
    std::string
    where(const std::string &path) const;

    /** Every entry with its current value and sentence, ready to be read. */
    void
    write_prm(std::ostream &out) const;

    /** The reference: a table for each subsection. */
    void
    write_markdown(std::ostream &out) const;

    const std::vector<ParameterEntry> &
    entries() const;

  private:
    void
    declare(ParameterEntry entry, const std::string &default_text);

    void
    declare_choice(const std::string                      &key,
                   const std::vector<std::string>         &names,
                   const std::function<void(std::size_t)> &assign,
                   const std::string                      &default_name,
                   const std::string                      &sentence,
                   const Need                              need);

    void
    apply(const std::vector<ParameterLine> &lines, const std::string &name);

    ParameterEntry &
    find(const std::vector<std::string> &subsections,
         const std::string              &key,
         const std::string              &origin);

    void
    assign(ParameterEntry &entry, const std::string &text);

    void
    check_mandatory_entries(const std::string &name) const;

    const ParameterEntry &
    entry_at(const std::string &path) const;

    dealii::ParameterHandler          &handler;
    std::vector<std::string>           current_path;
    std::vector<ParameterEntry>        declared;
    std::map<std::string, std::size_t> index_of_path;
  };



  template <typename Enum>
  void
  ParameterDeclarator::choice(
    const std::string                               &key,
    Enum                                            &variable,
    const std::vector<std::pair<std::string, Enum>> &choices,
    const std::string                               &sentence,
    const Need                                       need)
  {
    static_assert(std::is_enum<Enum>::value, "A choice sets an enum.");
    std::vector<std::string> names;
    std::string              default_name;
    for (const auto &[name, value] : choices)
      {
        names.push_back(name);
        if (value == variable && need == Need::optional)
          default_name = name;
      }
    declare_choice(
      key,
      names,
      [&variable, choices](const std::size_t i) {
        variable = choices[i].second;
      },
      default_name,
      sentence,
      need);
  }
} // namespace asperity

#endif
