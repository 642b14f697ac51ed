#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/contact_zone/scene_choice.h>
#include <asperity/topography/make_profile.h>
#include <asperity/topography/read_height_map.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, std::string>> entry_of_option = {
      {"-p", "Load/Pressure"},
      {"-v", "Load/Velocity"},
      {"-T", "Load/Temperature"},
      {"--oil", "Lubrication/Wetting"}};

    /** Each value is tried alone, so that a message names its option. */
    EntryValues
    settings_of(const CommandOptions &options)
    {
      dealii::ParameterHandler handler;
      ParameterDeclarator      declarator(handler);
      SceneParameters          parameters;
      parameters.declare(declarator);
      EntryValues settings;
      for (const auto &[option, path] : entry_of_option)
        if (const auto found = options.values.find(option);
            found != options.values.end())
          try
            {
              declarator.set(path, found->second);
              settings.emplace_back(path, found->second);
            }
          catch (const InputError &error)
            {
              throw InputError("Option " + quoted_name(option) + ", " +
                               error.what());
            }
      if (options.values.count("--oil") != 0)
        settings.emplace_back("Lubrication/Model",
                              parameters.lubrication.wetting > 0. ?
                                "automatic" :
                                "none");
      return settings;
    }

    TopographyParameters
    map_of(const CommandOptions &options)
    {
      TopographyParameters map;
      map.file = options.words[0];
      if (const auto unit = options.values.find("--unit");
          unit != options.values.end())
        map.lateral_unit = map.height_unit = unit->second;
      if (const auto spacing = options.values.find("--spacing");
          spacing != options.values.end())
        try
          {
            map.spacing_x = parse_quantity(spacing->second, Dimension::length);
          }
        catch (const InputError &error)
          {
            throw InputError(std::string("Option '--spacing': ") +
                             error.what() + ".");
          }
      if (map.spacing_x && !(*map.spacing_x > 0.))
        throw InputError("Option '--spacing': found " +
                         options.values.at("--spacing") +
                         "; a length above zero is expected.");
      return map;
    }

    /** Reads the map as it is. */
    void
    check_map(TopographyParameters map)
    {
      map.form = FormChoice::none;
      TopographyReport report;
      treat_map(map, report);
    }

    /** Whether the file can be read as soon as the user says its units. */
    bool
    lacks_only_units(const TopographyParameters &map)
    {
      if (!map.height_unit.empty() && map.spacing_x)
        return false;
      try
        {
          read_height_map(map.file, {1e-6, 1e-6, 1e-6, 1e-6});
          return true;
        }
      catch (const InputError &)
        {
          return false;
        }
    }

    /** Fails at once where a file is; nothing that exists is overwritten. */
    void
    write_new_file(const std::string &name, const std::string &text)
    {
      const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(
        std::fopen(name.c_str(), "wx"), &std::fclose);
      if (!file)
        throw InputError("The file " + quoted_name(name) +
                         " cannot be created in this folder.");
      if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
          std::fflush(file.get()) != 0)
        {
          std::filesystem::remove(name);
          throw ComputationError("The file " + quoted_name(name) +
                                 " cannot be written in full.");
        }
    }

    void
    print(const SceneChoice &choice, const std::string &prm)
    {
      for (const std::string &finding : choice.findings)
        write_wrapped(std::cout, finding, "  ");
      for (const std::string &warning : choice.warnings)
        write_wrapped(std::cout, "Warning: " + warning, "");
      std::cout << "Written: " << prm
                << ", with the reason of every choice. Next: asperity " << prm
                << "\n";
    }
  } // namespace



  int
  new_scene(const std::vector<std::string> &arguments)
  {
    if (!is_first_rank())
      return 0;
    const CommandOptions options(
      arguments, {"-p", "-v", "-T", "--oil", "--spacing", "--unit"});
    if (options.words.size() != 1)
      throw InputError("'asperity new' takes one height map, as in 'asperity "
                       "new tool.x3p -p 300MPa -v 100m/min -T 300degC'.");
    const TopographyParameters map = map_of(options);
    const std::string name = std::filesystem::path(map.file).stem().string();
    const std::string prm  = name + ".prm";
    if (std::filesystem::exists(prm))
      throw InputError("The file " + quoted_name(prm) +
                       " is here already and is not overwritten; rename or "
                       "remove it, or start in another folder.");
    const EntryValues settings = settings_of(options);
    try
      {
        check_map(map);
      }
    catch (const InputError &error)
      {
        if (!lacks_only_units(map))
          throw;
        std::string what = error.what();
        what.pop_back(); // its full stop
        throw InputError(what + "; 'asperity new' takes them as --spacing "
                                "0.5um and --unit um.");
      }
    const SceneChoice choice = choose_scene(map, settings, name);
    write_new_file(prm, choice.text);
    print(choice, prm);
    return 0;
  }
} // namespace asperity
