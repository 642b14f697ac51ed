#include <asperity/base/errors.h>
#include <asperity/base/input_record.h>
#include <asperity/base/md5.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** "300 MPa", "the file 'a.x3p' (MD5 ...)". */
    std::string
    describe(const RecordedEntry &entry)
    {
      if (!entry.is_file)
        return entry.value.empty() ? "empty" : entry.value;
      return entry.value.empty() ? "no file" :
                                   "the file " + quoted_name(entry.value) +
                                     " (MD5 " + entry.content + ")";
    }

    bool
    agree(const RecordedEntry &a, const RecordedEntry &b)
    {
      return a.is_file && b.is_file ? a.content == b.content :
                                      a.value == b.value;
    }
  } // namespace



  InputRecord::InputRecord(const ParameterDeclarator &parameters)
  {
    for (const ParameterEntry &declared : parameters.entries())
      {
        RecordedEntry entry;
        entry.path    = declared.path();
        entry.value   = declared.value;
        entry.is_file = declared.is_file;
        if (entry.is_file && !entry.value.empty())
          entry.content = md5_of_file(entry.value);
        entries.push_back(entry);
      }
  }



  std::string
  InputRecord::change_since(
    const InputRecord                              &earlier,
    const std::function<bool(const std::string &)> &may_differ) const
  {
    for (const RecordedEntry &then : earlier.entries)
      {
        if (may_differ(then.path))
          continue;
        const auto now = std::find_if(entries.begin(),
                                      entries.end(),
                                      [&then](const RecordedEntry &entry) {
                                        return entry.path == then.path;
                                      });
        if (now == entries.end())
          return "entry " + quoted_name(then.path) + " was " + describe(then) +
                 " and is unknown to this program";
        if (!agree(*now, then))
          return "entry " + quoted_name(then.path) + " was " + describe(then) +
                 " and is " + describe(*now);
      }
    return "";
  }



  std::string
  InputRecord::changed_file() const
  {
    InputRecord now = *this;
    for (RecordedEntry &entry : now.entries)
      if (entry.is_file && !entry.value.empty())
        entry.content = md5_of_file(entry.value);
    return now.change_since(*this, [](const std::string &) { return false; });
  }
} // namespace asperity
