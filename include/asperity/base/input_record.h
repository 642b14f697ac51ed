#ifndef asperity_base_input_record_h
#define asperity_base_input_record_h

#include <functional>
#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

  /** What an entry of a parameter file said when a computation began. */
  struct RecordedEntry
  {
    std::string path;  ///< "Load/Pressure"
    std::string value; ///< in its own words, see ParameterEntry::value
    bool        is_file = false;
    std::string content; ///< of a file: MD5, empty if none is named

    /** For archives of Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &path &value &is_file &content;
    }
  };

  /**
   * All inputs of a computation: its entries by value and the files that it
   * reads by content. A state on disk carries the record of the inputs that it
   * was computed from, lest it be continued with others.
   */
  struct InputRecord
  {
    std::vector<RecordedEntry> entries;

    InputRecord() = default;

    /** Of all entries that are declared, with defaults.
     *  @throws InputError if a file that is named cannot be read */
    explicit InputRecord(const ParameterDeclarator &parameters);

    /**
     * The first entry that differs from that of an earlier record, as "entry
     * 'Load/Pressure' was 300 MPa and is 900 MPa"; empty if all agree. Files
     * agree if their contents do, wherever they lie. Entries that the earlier
     * record lacks have come with a newer program and do not count.
     * @param may_differ entries, by their paths, that are not compared
     */
    std::string
    change_since(
      const InputRecord                              &earlier,
      const std::function<bool(const std::string &)> &may_differ) const;

    /** As change_since(), of files that are named and have been written to
     *  since this record was made. */
    std::string
    changed_file() const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &entries;
    }
  };
} // namespace asperity

#endif
