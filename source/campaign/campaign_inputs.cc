#include "campaign_inputs.h"

#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/surface.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace asperity
{
  const char *const profile_entry = "Tool/Topography/Profile position";

  namespace
  {
    /** Runs a check that does not know where in the campaign's file it is. */
    template <typename Call>
    auto
    at(const std::string &where, const Call &call)
    {
      try
        {
          return call();
        }
      catch (const InputError &error)
        {
          std::string message = error.what();
          if (message.back() != '.' && message.back() != '?')
            message += ".";
          throw InputError(where + ": " + message);
        }
    }

    /** The unit behind a number, "1" if there is none. */
    std::string
    unit_of(const std::string &text)
    {
      char *end = nullptr;
      std::strtod(text.c_str(), &end);
      const std::string unit = trim(end);
      return unit.empty() ? "1" : unit;
    }

    /** As messages and the columns of tables call an input. */
    std::string
    symbol_of(const std::string &entry, const bool by_full_path)
    {
      if (entry == "Load/Pressure")
        return "p";
      if (entry == "Load/Velocity")
        return "v";
      if (entry == "Load/Temperature")
        return "T";
      std::string symbol =
        by_full_path ? entry : entry.substr(entry.rfind('/') + 1);
      for (const char mark : {' ', '/'})
        symbol.erase(std::remove(symbol.begin(), symbol.end(), mark),
                     symbol.end());
      return symbol;
    }

    /** Entries of different sections may have one name. */
    void
    set_symbols(std::vector<LawInput> &inputs)
    {
      for (LawInput &input : inputs)
        {
          const std::string symbol = symbol_of(input.name, false);
          const auto        n =
            std::count_if(inputs.begin(),
                          inputs.end(),
                          [&](const LawInput &other) {
                            return symbol_of(other.name, false) == symbol;
                          });
          input.symbol = symbol_of(input.name, n > 1);
        }
    }

    /** Range and unit. @param section "Campaign/Input 1" */
    LawInput
    resolve(const InputParameters     &parameters,
            const ParameterDeclarator &declarator,
            const std::string         &section)
    {
      LawInput input;
      input.name             = parameters.path();
      input.unit             = unit_of(parameters.from);
      input.scale            = parameters.scale;
      const std::string from = declarator.where(section + "/From");
      const std::string to   = declarator.where(section + "/To");
      const Dimension   dimension =
        at(from, [&]() { return dimension_of(input.unit); });
      input.lower =
        at(from, [&]() { return parse_quantity(parameters.from, dimension); });
      input.upper =
        at(to, [&]() { return parse_quantity(parameters.to, dimension); });
      if (!(input.lower < input.upper))
        throw InputError(to + ": found " + parameters.to +
                         "; expected more than " + parameters.from + ".");
      if (input.scale == Scale::logarithmic && input.lower <= 0.)
        throw InputError(declarator.where(section + "/Scale") +
                         ": found logarithmic with a range from " +
                         parameters.from + "; expected a range above 0.");
      return input;
    }

    double
    middle(const LawInput &input)
    {
      return input.scale == Scale::logarithmic ?
               std::sqrt(input.lower) * std::sqrt(input.upper) :
               0.5 * (input.lower + input.upper);
    }

    /** @param text of the base scene, which may be a word such as automatic */
    double
    default_reference(const LawInput &input, const std::string &text)
    {
      try
        {
          const double value = parse_quantity(text, dimension_of(input.unit));
          if (value >= input.lower && value <= input.upper)
            return value;
        }
      catch (const InputError &)
        {} // no number, so none that could be taken
      return middle(input);
    }

    double
    reference(const LawInput    &input,
              const std::string &export_at,
              const std::string &of_base_scene,
              const std::string &where)
    {
      if (export_at.empty())
        return default_reference(input, of_base_scene);
      const double value = at(where, [&]() {
        return parse_quantity(export_at, dimension_of(input.unit));
      });
      if (!(value >= input.lower && value <= input.upper))
        throw InputError(where + ": found " + export_at +
                         "; expected a value of its range, " +
                         format_quantity(input.lower, input.unit) + " to " +
                         format_quantity(input.upper, input.unit) + ".");
      return value;
    }

    const ParameterEntry &
    find_entry(ParameterDeclarator &scene,
               const std::string   &path,
               const std::string   &where)
    {
      for (const ParameterEntry &entry : scene.entries())
        if (entry.path() == path)
          return entry;
      // which knows the nearest one
      at(where, [&]() { scene.set(path, ""); });
      throw std::logic_error("An unknown entry was set.");
    }

    void
    require_numeric(const ParameterEntry &entry, const std::string &where)
    {
      if (entry.subsection == "Output")
        throw InputError(where + ": found " + quoted_name(entry.path()) +
                         ", on which friction does not depend; expected an "
                         "entry that is not of the subsection Output.");
      for (const char *const kind : {"text", "flag", "file", "choice"})
        if (entry.kind.rfind(kind, 0) == 0)
          throw InputError(where + ": found " + quoted_name(entry.path()) +
                           ", whose value is no number; expected an entry that "
                           "takes a number.");
    }

    /** The scene's own judgement of all combinations of the ends. */
    void
    check_corners(const std::string           &base_scene,
                  const std::vector<LawInput> &inputs,
                  const std::string           &where)
    {
      for (unsigned int corner = 0; corner < (1u << inputs.size()); ++corner)
        {
          EntryValues values;
          for (std::size_t i = 0; i < inputs.size(); ++i)
            values.emplace_back(inputs[i].name,
                                format_quantity(((corner >> i) & 1) != 0 ?
                                                  inputs[i].upper :
                                                  inputs[i].lower,
                                                inputs[i].unit));
          at(where, [&]() { SceneInput(base_scene, values); });
        }
    }

    /** An input without influence would cost runs and teach nothing. */
    void
    check_influence(const SceneInput  &scene,
                    const std::string &entry,
                    const std::string &where)
    {
      for (const UnusedEntry &unused :
           unused_entries(scene.parameters, scene.declarator))
        if (unused.path == entry)
          throw InputError(where + ": found " + quoted_name(entry) +
                           ", on which the friction of the base scene does "
                           "not depend; it counts only with " +
                           unused.counts_with + ".");
    }

    /** Makes each profile once, so that none fails in the runs. */
    void
    check_profiles(const std::string &positions,
                   SceneInput        &scene,
                   const std::string &where)
    {
      for (const std::string &position : split(positions, ','))
        {
          if (scene.parameters.tool.kind != SurfaceKind::measured)
            throw InputError(where + ": found " + quoted_text(position) +
                             ", but the tool of the base scene is not measured "
                             "(Tool/Kind); expected nothing.");
          if (scene.parameters.geometry.dimension == 3)
            throw InputError(where + ": found " + quoted_text(position) +
                             ", but the base scene is a patch "
                             "(Geometry/Dimension = 3), whose window is in the "
                             "middle of the map; expected nothing.");
          at(where, [&]() {
            scene.declarator.set(profile_entry, position);
            make_surface(scene.parameters.tool,
                         scene.parameters.geometry.length);
          });
        }
    }
  } // namespace



  CampaignInputs::CampaignInputs(const CampaignParameters  &parameters,
                                 const ParameterDeclarator &declarator)
  {
    const std::string    where    = declarator.where("Campaign/Base scene");
    const auto           scene    = at(where, [&]() {
      return std::make_unique<SceneInput>(parameters.base_scene);
    });
    ParameterDeclarator &of_scene = scene->declarator;
    EntryValues          lower;
    for (std::size_t i = 0; i < parameters.inputs.size(); ++i)
      {
        const InputParameters &given = parameters.inputs[i];
        const std::string section = "Campaign/Input " + std::to_string(i + 1);
        if (given.entry.empty())
          continue;
        const std::string where_entry = declarator.where(section + "/Entry");
        const ParameterEntry &entry =
          find_entry(of_scene, given.path(), where_entry);
        require_numeric(entry, where_entry);
        is_whole_number.push_back(entry.kind.rfind("whole", 0) == 0);
        LawInput          input = resolve(given, declarator, section);
        const std::string was   = of_scene.get(input.name);
        at(declarator.where(section + "/From"),
           [&]() { of_scene.set(input.name, given.from); });
        at(declarator.where(section + "/To"),
           [&]() { of_scene.set(input.name, given.to); });
        input.reference = reference(input,
                                    given.export_at,
                                    was,
                                    declarator.where(section + "/Export at"));
        inputs.push_back(input);
        lower.emplace_back(input.name, given.from);
      }
    set_symbols(inputs);
    check_corners(parameters.base_scene, inputs, where);
    // The base scene's own values of the inputs do not count.
    const SceneInput lowest(parameters.base_scene, lower);
    for (std::size_t i = 0; i < parameters.inputs.size(); ++i)
      if (!parameters.inputs[i].entry.empty())
        check_influence(lowest,
                        parameters.inputs[i].path(),
                        declarator.where("Campaign/Input " +
                                         std::to_string(i + 1) + "/Entry"));
    std::ostringstream text;
    lowest.declarator.write_prm(text);
    base_scene_text = text.str();
    base_scene      = lowest.record;
    wants_accuracy  = lowest.parameters.accuracy.is_wanted();
    wants_fields    = !lowest.parameters.output.field_times.empty();
    check_profiles(parameters.profile_positions,
                   *scene,
                   declarator.where("Campaign/Profile positions"));
  }
} // namespace asperity
