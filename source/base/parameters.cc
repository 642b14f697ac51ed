#include <asperity/base/errors.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

namespace asperity
{
  namespace
  {
    // Longer keys are nobody's misspelling of an entry.
    constexpr std::size_t longest_name = 200;
  } // namespace

  std::string
  ParameterEntry::path() const
  {
    return subsection.empty() ? key : subsection + "/" + key;
  }

  ParameterDeclarator::ParameterDeclarator(dealii::ParameterHandler &handler)
    : handler(handler)
  {}

  ParameterDeclarator::Subsection::Subsection(ParameterDeclarator &declarator)
    : declarator(declarator)
  {}

  ParameterDeclarator::Subsection::~Subsection()
  {
    declarator.handler.leave_subsection();
    declarator.current_path.pop_back();
  }

  ParameterDeclarator::Subsection
  ParameterDeclarator::subsection(const std::string &name)
  {
    handler.enter_subsection(name);
    current_path.push_back(name);
    return Subsection(*this);
  }

  void
  ParameterDeclarator::declare(ParameterEntry     entry,
                               const std::string &default_text)
  {
    entry.subsection       = join(current_path, "/");
    entry.default_text     = entry.need == Need::mandatory ? "" : default_text;
    const std::string path = entry.path();
    if (index_of_path.count(path) != 0)
      throw std::logic_error("The parameter " + quoted_name(path) +
                             " is declared twice.");
    if (entry.need == Need::optional)
      try
        {
          // also makes the default exactly what its text says
          entry.value = entry.assign(entry.default_text);
        }
      catch (const InputError &error)
        {
          throw std::logic_error("The default of parameter " +
                                 quoted_name(path) +
                                 " is wrong: " + error.what());
        }
    handler.declare_entry(entry.key,
                          entry.default_text,
                          dealii::Patterns::Anything(),
                          entry.sentence,
                          entry.need == Need::mandatory);
    index_of_path[path] = declared.size();
    declared.push_back(std::move(entry));
  }

  void
  ParameterDeclarator::read_file(const std::string &file_name)
  {
    apply(read_parameter_lines(file_name), file_name);
  }

  void
  ParameterDeclarator::read_text(const std::string &text,
                                 const std::string &name)
  {
    std::istringstream input(text);
    apply(read_parameter_lines(input, name), name);
  }

  void
  ParameterDeclarator::apply(const std::vector<ParameterLine> &lines,
                             const std::string                &name)
  {
    for (const ParameterLine &line : lines)
      {
        ParameterEntry &entry =
          find(line.subsections, line.key, line.origin() + ": ");
        std::string value = line.value;
        // No number or choice has a '#' in it: there it starts a comment.
        if (entry.kind != "text" && !entry.is_file)
          value = trim(value.substr(0, value.find('#')));
        if (entry.is_file && !value.empty())
          value = (std::filesystem::path(line.file).parent_path() / value)
                    .lexically_normal()
                    .string();
        entry.origin = line.origin();
        assign(entry, value);
      }
    check_mandatory_entries(name);
  }

  ParameterEntry &
  ParameterDeclarator::find(const std::vector<std::string> &subsections,
                            const std::string              &key,
                            const std::string              &origin)
  {
    const std::string section = join(subsections, "/");
    const auto        found =
      index_of_path.find(section.empty() ? key : section + "/" + key);
    if (found != index_of_path.end())
      return declared[found->second];

    // The key counts more than its subsection: an entry in the wrong place
    // and a misspelt one are both found.
    const ParameterEntry *nearest          = nullptr;
    unsigned int          nearest_distance = 0;
    if (key.size() <= longest_name && section.size() <= longest_name)
      for (const ParameterEntry &entry : declared)
        {
          const unsigned int distance =
            100 * edit_distance(entry.key, key) +
            std::min(99u, edit_distance(entry.subsection, section));
          if (nearest == nullptr || distance < nearest_distance)
            {
              nearest          = &entry;
              nearest_distance = distance;
            }
        }
    const auto place = [](const std::string &name) {
      return name.empty() ? std::string("at the top level") :
                            "in subsection " + quoted_text(name);
    };
    std::string message = origin + "There is no entry " + quoted_text(key) +
                          " " + place(section) + "; ";
    if (nearest != nullptr &&
        nearest_distance / 100 <= std::max<std::size_t>(2, key.size() / 2))
      message += "did you mean " + quoted_name(nearest->key) + " " +
                 place(nearest->subsection) + "?";
    else
      message += "'asperity parameters' lists all entries.";
    throw InputError(message);
  }

  void
  ParameterDeclarator::assign(ParameterEntry &entry, const std::string &text)
  {
    // A written parameter file may be read from elsewhere.
    const std::string lasting =
      entry.is_file && !text.empty() ?
        std::filesystem::absolute(text).lexically_normal().string() :
        text;
    try
      {
        entry.value = entry.assign(text);
        if (lasting.find_first_of("\r\n") != std::string::npos)
          throw InputError(quoted_text(lasting) +
                           " has a line break, which a parameter file cannot "
                           "hold; a text of one line is expected");
      }
    catch (const InputError &error)
      {
        throw InputError((entry.origin.empty() ? "" : entry.origin + ", ") +
                         "entry " + quoted_name(entry.path()) + ": " +
                         error.what() + ".");
      }
    entry.given                         = true;
    const std::vector<std::string> path = split(entry.subsection, '/');
    for (const std::string &name : path)
      handler.enter_subsection(name);
    handler.set(entry.key, lasting);
    for (std::size_t i = 0; i < path.size(); ++i)
      handler.leave_subsection();
  }

  void
  ParameterDeclarator::check_mandatory_entries(const std::string &name) const
  {
    std::vector<std::string> missing;
    for (const ParameterEntry &entry : declared)
      if (entry.need == Need::mandatory && !entry.given)
        missing.push_back(quoted_name(entry.path()) + " (" + entry.kind + ")");
    if (!missing.empty())
      throw InputError(
        name + ": " +
        (missing.size() == 1 ? "The mandatory entry " :
                               "The mandatory entries ") +
        join(missing, ", ") +
        (missing.size() == 1 ? " is missing." : " are missing."));
  }

  const ParameterEntry &
  ParameterDeclarator::entry_at(const std::string &path) const
  {
    const auto found = index_of_path.find(path);
    if (found == index_of_path.end())
      throw InputError("There is no parameter " + quoted_name(path) + ".");
    return declared[found->second];
  }

  void
  ParameterDeclarator::set(const std::string &path, const std::string &text)
  {
    std::vector<std::string> names = split(path, '/');
    if (names.empty())
      throw InputError("An entry without a name cannot be set.");
    const std::string key = names.back();
    names.pop_back();
    ParameterEntry &entry = find(names, key, "");
    entry.origin.clear();
    assign(entry, text);
  }

  std::string
  ParameterDeclarator::get(const std::string &path) const
  {
    const ParameterEntry &entry = entry_at(path);
    return handler.get(split(entry.subsection, '/'), entry.key);
  }

  std::string
  ParameterDeclarator::where(const std::string &path) const
  {
    const ParameterEntry &entry = entry_at(path);
    return (entry.origin.empty() ? "" : entry.origin + ", ") + "entry " +
           quoted_name(path);
  }

  const std::vector<ParameterEntry> &
  ParameterDeclarator::entries() const
  {
    return declared;
  }
} // namespace asperity
