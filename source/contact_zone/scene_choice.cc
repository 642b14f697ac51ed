#include <asperity/contact_zone/scene_choice.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace asperity
{
  namespace
  {
    /** As parameter files have them: three digits are enough for a choice. */
    std::string
    um(const double length)
    {
      return format_quantity(length, "um", 3);
    }

    std::string
    whole(const double value)
    {
      return std::to_string(std::lround(value));
    }

    /** Of pressure waves in a large body [m/s]. */
    double
    wave_speed(const MaterialParameters &material)
    {
      const auto   law = material.make_law();
      const double E = law->young_modulus(), nu = law->poisson_ratio();
      return std::sqrt(E * (1. - nu) / ((1. + nu) * (1. - 2. * nu)) /
                       law->density());
    }

    /** Writes down choices in a declarator and in the list of entries. */
    class SceneChooser
    {
    public:
      SceneChooser(const TopographyParameters &given,
                   const EntryValues          &settings);

      SceneChoice
      choose(const std::string &name);

    private:
      void
      set(const std::string &path,
          const std::string &text,
          const std::string &reason);
      /** The entry as it is, since it matters. */
      void
      keep(const std::string &path, const std::string &reason);
      void
      set_surface();
      void
      set_load();
      void
      set_sizes();
      void
      set_protocol(const SceneSizes &sizes);
      void
      set_output(const std::string &name);
      void
      audit();
      void
      write();

      SceneChoice                choice;
      const TopographyParameters given;
      dealii::ParameterHandler   handler;
      ParameterDeclarator        declarator;
      EntryValues                settings;
      SurfaceChoice              surface;
    };

    SceneChooser::SceneChooser(const TopographyParameters &given,
                               const EntryValues          &settings)
      : given(given)
      , declarator(handler)
      , settings(settings)
    {
      choice.parameters.declare(declarator);
      for (const auto &[path, text] : settings)
        declarator.set(path, text);
      choice.parameters.check(declarator);
      surface = choose_surface(given);
    }

    SceneChoice
    SceneChooser::choose(const std::string &name)
    {
      set_surface();
      set_load();
      set_sizes();
      set_output(name);
      choice.parameters.check(declarator);
      write();
      audit();
      return choice;
    }

    void
    SceneChooser::set(const std::string &path,
                      const std::string &text,
                      const std::string &reason)
    {
      declarator.set(path, text);
      choice.entries.push_back({path, text, reason});
    }

    void
    SceneChooser::keep(const std::string &path, const std::string &reason)
    {
      choice.entries.push_back({path, declarator.get(path), reason});
    }

    void
    SceneChooser::set_surface()
    {
      const std::string section = "Tool/Topography/";
      set("Tool/Kind", "measured", "the map below.");
      set(section + "File", given.file, "relative to this parameter file.");
      const std::string said = "as given to 'asperity new'.";
      if (!given.lateral_unit.empty())
        set(section + "Lateral unit", given.lateral_unit, said);
      if (!given.height_unit.empty())
        set(section + "Height unit", given.height_unit, said);
      if (given.spacing_x)
        set(section + "Spacing x",
            format_quantity(*given.spacing_x, "um"),
            said);
      for (const CommentedEntry &entry : surface.entries)
        set(section + entry.path, entry.text, entry.reason);
      keep("Chip surface/Kind",
           "the chip comes to the tool smooth; the tool roughens it.");
      choice.findings = surface.findings;
      choice.warnings = surface.warnings;
    }

    void
    SceneChooser::set_load()
    {
      const auto reason = [this](const std::string &path) {
        for (const auto &setting : settings)
          if (setting.first == path)
            return "as given to 'asperity new'.";
        return "the default; set that of your process.";
      };
      for (const char *path :
           {"Load/Pressure", "Load/Velocity", "Load/Temperature"})
        keep(path, reason(path));
      keep("Material/Law",
           "steel 42CrMo4; the subsection Material describes others.");
      const bool oil =
        choice.parameters.lubrication.model != LubricantModel::none;
      keep("Lubrication/Model",
           oil ? "the audit of the scene chooses; 'asperity check' says what." :
                 "dry; --oil 0.6 of 'asperity new' fills 60 % of the void.");
      if (oil)
        keep("Lubrication/Wetting", reason("Lubrication/Wetting"));
      const LoadParameters &load = choice.parameters.load;
      choice.findings.push_back(
        "Load: " + format_quantity(load.pressure, "MPa") + ", " +
        format_quantity(load.velocity, "m/min") + ", " +
        format_quantity(load.temperature, "degC") + ", " +
        (oil ? "oil in " +
                 format_quantity(100. * choice.parameters.lubrication.wetting,
                                 "1",
                                 3) +
                 " % of the void." :
               std::string("dry.")));
    }

    void
    SceneChooser::set_sizes()
    {
      const MaterialParameters &material = choice.parameters.material;
      const SceneSizes          sizes({surface.shortest_wave,
                                       surface.period,
                                       surface.peak_to_valley,
                                       surface.largest_slope,
                                       choice.parameters.load.velocity,
                                       wave_speed(material)});
      const double              element = surface.period / sizes.spans;
      set("Geometry/Chip height",
          um(sizes.chip_height),
          "half the period, so that the bottom feels the load and no single "
          "asperity, and at least five times the peak-to-valley height of " +
            um(surface.peak_to_valley) + ".");
      set("Geometry/Initial gap",
          um(sizes.initial_gap),
          "3 % of the peak-to-valley height.");
      set("Mesh/Spans",
          std::to_string(sizes.spans),
          "elements of " + format_quantity(element, "nm", 3) + ", " +
            whole(surface.shortest_wave / element) +
            " for the shortest wave of " + um(surface.shortest_wave) +
            "; twice as many change mu by about 1 %.");
      set("Mesh/Refinement levels",
          std::to_string(sizes.levels),
          "the coarsest elements are " + um(element * (1u << sizes.levels)) +
            " wide.");
      set("Mesh/Strip depth", um(sizes.strip), "five elements.");
      keep(
        "Mesh/Degree",
        "finer elements pay more than a higher degree where contacts begin and end.");
      choice.findings.push_back(
        "Mesh: " + std::to_string(sizes.spans) + " spans, " +
        whole(surface.shortest_wave / element) +
        " for the shortest wave, refined " + std::to_string(sizes.levels) +
        " times from a chip " + um(sizes.chip_height) + " high.");
      set_protocol(sizes);
    }

    void
    SceneChooser::set_protocol(const SceneSizes &sizes)
    {
      const ProtocolParameters &protocol = choice.parameters.protocol;
      set("Protocol/End time",
          format_quantity(sizes.ramp_time / protocol.ramp_fraction, "us", 4),
          "the load comes within a fifth of it, " +
            format_quantity(sizes.ramp_time, "us", 3) +
            ": slow enough for a chip in balance.");
      set("Protocol/Friction window",
          "steady",
          "mu of sliding, not of running in.");
      set("Protocol/Steady distance",
          um(sizes.steady_distance),
          "0.4 shortest waves, about the length of a contact.");
      set("Protocol/Steady step",
          format_quantity(sizes.steady_step, "nm", 3),
          "a sixtieth of the shortest wave.");
      set("Protocol/Steady tolerance",
          "0.02",
          "less than one profile differs from another.");
      set("Protocol/Maximum distance",
          um(sizes.maximum_distance),
          "4 shortest waves; a dry tool is steady by half of it, oil may take "
          "longer.");
    }

    void
    SceneChooser::set_output(const std::string &name)
    {
      set("Output/Output directory",
          "output/" + name,
          "relative to where the program is started.");
      set("Output/Picture interval", "20", "about ten pictures.");
    }

    void
    SceneChooser::audit()
    {
      SceneParameters parameters = choice.parameters;
      parameters.resolve();
      const AuditedScene<2> audited(parameters);
      choice.lubricant = audited.audit.lubricant;
      for (const std::string &warning : audited.audit.warnings)
        if (warning.find("surface: ") == std::string::npos)
          choice.warnings.push_back(warning);
      if (choice.lubricant != LubricantModel::none)
        choice.findings.push_back("Oil by " + name(choice.lubricant) +
                                  ", as the audit chooses.");
      const double flattening = surface.rms_slope *
                                audited.scene->law->young_modulus() /
                                choice.parameters.load.pressure;
      if (flattening < 2.)
        choice.warnings.push_back(
          "The surface is so smooth that the pressure flattens it elastically "
          "(slope times Young's modulus is " +
          format_quantity(flattening, "1", 2) +
          " times the pressure): most of it will be in contact, and mu near "
          "zero without adhesion.");
    }

    void
    SceneChooser::write()
    {
      std::ostringstream out;
      write_wrapped(out,
                    "Made by 'asperity new' from the map " + given.file +
                      ". Entries that are not here have their defaults; "
                      "'asperity parameters' lists all of them.",
                    "# ");
      write_commented_prm(out, declarator, choice.entries);
      choice.text = out.str();
    }
  } // namespace



  SceneSizes::SceneSizes(const SceneScale &scale)
  {
    chip_height = std::max(0.5 * scale.period, 5. * scale.peak_to_valley);
    const double per_wave = 16. * scale.period / scale.shortest_wave;
    const double steepest =
      8. * scale.period * scale.largest_slope / scale.peak_to_valley;
    const double wanted = std::clamp(std::max(per_wave, steepest), 68., 2048.);
    levels = std::clamp(static_cast<int>(std::log2(wanted / 17.)), 0, 6);
    const unsigned int multiple = 1u << levels;
    spans = multiple * static_cast<unsigned int>(std::ceil(wanted / multiple));
    strip = 5. * scale.period / spans;
    initial_gap          = 0.03 * scale.peak_to_valley;
    const double transit = 2. * chip_height / scale.wave_speed;
    ramp_time =
      std::max(0.1 * scale.shortest_wave / scale.velocity, 12. * transit);
    steady_distance  = 0.4 * scale.shortest_wave;
    steady_step      = scale.shortest_wave / 60.;
    maximum_distance = 4. * scale.shortest_wave;
  }



  SceneChoice
  choose_scene(const TopographyParameters &given,
               const EntryValues          &settings,
               const std::string          &name)
  {
    return SceneChooser(given, settings).choose(name);
  }
} // namespace asperity
