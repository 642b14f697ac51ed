#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/campaign/scene_sensitivity.h>
#include <asperity/topography/make_profile.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr double part_of_constants = 0.1;

    /** "20 um" of "10 um" and 2; a number of an entry has its unit behind it.
     */
    std::string
    scaled(const std::string &text, const double factor)
    {
      const std::size_t blank = text.find(' ');
      const double      value = parse_number(text.substr(0, blank));
      return format_quantity(factor * value, "1", 6) +
             (blank == std::string::npos ? "" : text.substr(blank));
    }

    /** Collects variations of a scene. */
    class Variations
    {
    public:
      explicit Variations(const SceneInput &input)
        : input(input)
      {}

      /** A value times each of the factors. */
      void
      scale(const std::string         &entry,
            const std::vector<double> &factors,
            const ChoiceKind           kind)
      {
        for (const double factor : factors)
          set(entry, scaled(input.declarator.get(entry), factor), kind);
      }

      void
      set(const std::string &entry,
          const std::string &value,
          const ChoiceKind   kind,
          const EntryValues &also = {})
      {
        list.push_back({entry, value, kind, also});
      }

      void
      vary_surface();

      void
      vary_scene();

      void
      vary_way();

      void
      vary_constants();

      std::vector<Variation> list;

    private:
      const SceneInput &input;
    };

    void
    Variations::vary_surface()
    {
      const SurfaceParameters &tool = input.parameters.tool;
      if (tool.kind != SurfaceKind::measured)
        return;
      const std::string           at = "Tool/Topography/";
      const TopographyParameters &t  = tool.topography;
      TopographyReport            report;
      const HeightMap             map = treat_map(t, report);
      // The samples resolve no shorter waves.
      const double shortest = 2. * std::max(map.dx, map.dy);
      for (const double factor : {0.3, 0.5, 2.})
        if (factor * t.s_filter > shortest)
          scale(at + "S-filter nesting index",
                {factor},
                ChoiceKind::preparation);
      const double length = t.length > 0. ? t.length : map.length_x();
      if (t.l_filter > 0.)
        scale(at + "L-filter nesting index",
              {0.5, 2.},
              ChoiceKind::preparation);
      else
        set(at + "L-filter nesting index",
            format_quantity(0.5 * length, "um", 4),
            ChoiceKind::preparation);
      set(at + "Profile length",
          format_quantity(0.5 * length, "um", 6),
          ChoiceKind::preparation);
      if (input.parameters.geometry.dimension == 3)
        return; // a window is in the middle of the map
      // A profile along y crosses the map along x.
      const bool   along_y = std::abs(std::cos(t.direction)) < 0.5;
      const double across  = along_y ? map.length_x() : map.length_y();
      for (const double part : {0.2, 0.4, 0.6, 0.8})
        set(at + "Profile position",
            format_quantity(part * across, "um", 4),
            ChoiceKind::profile);
    }

    void
    Variations::vary_way()
    {
      const ProtocolParameters &protocol = input.parameters.protocol;
      if (protocol.window == FrictionWindow::steady)
        {
          scale("Protocol/Steady distance", {2.}, ChoiceKind::scene);
          scale("Protocol/Steady tolerance", {0.5}, ChoiceKind::scene);
          return;
        }
      const std::string entry = protocol.sliding_distance ?
                                  "Protocol/Sliding distance" :
                                  "Protocol/End time";
      for (const double factor : {0.5, 2., 4.})
        {
          EntryValues also = {{"Protocol/Slide steps",
                               std::to_string(static_cast<unsigned int>(
                                 std::ceil(factor * protocol.slide_steps)))}};
          if (protocol.reversal_distance > 0.)
            also.emplace_back("Protocol/Reversal distance",
                              scaled(input.declarator.get(
                                       "Protocol/Reversal distance"),
                                     factor));
          set(entry,
              scaled(input.declarator.get(entry), factor),
              ChoiceKind::scene,
              also);
        }
    }

    void
    Variations::vary_scene()
    {
      const SceneParameters &scene = input.parameters;
      vary_way();
      scale("Geometry/Chip height", {0.5, 2.}, ChoiceKind::scene);
      if (scene.geometry.initial_gap > 0.)
        scale("Geometry/Initial gap", {0.5, 2.}, ChoiceKind::scene);
      if (std::isfinite(scene.material.make_law()->shear_limit(0., 0., 0.)))
        for (const double strain : {0., 0.5, 1., 2.})
          if (strain != scene.load.plastic_strain)
            set("Load/Plastic strain",
                format_number(strain),
                ChoiceKind::scene);
      if (scene.lubrication.model == LubricantModel::none)
        return;
      if (scene.lubrication.amount == OilAmount::film_thickness)
        scale("Lubrication/Oil film", {0.8, 1.2}, ChoiceKind::scene);
      else
        for (const double factor : {0.8, 1.2})
          if (const double w = factor * scene.lubrication.wetting; w <= 1.)
            set("Lubrication/Wetting", format_number(w), ChoiceKind::scene);
    }

    void
    Variations::vary_constants()
    {
      const std::vector<double>  factors   = {1. - part_of_constants,
                                              1. + part_of_constants};
      const InterfaceParameters &interface = input.parameters.interface;
      if (interface.uses_shear_strength())
        for (const double factor : factors)
          set("Interface/Shear factor",
              format_quantity(std::min(1., factor * interface.shear_factor),
                              "1",
                              6),
              ChoiceKind::constants);
      if (interface.law != InterfaceShear::none &&
          interface.law != InterfaceShear::shear_factor)
        scale("Interface/Friction coefficient", factors, ChoiceKind::constants);
      const std::string              law = input.declarator.get("Material/Law");
      const std::vector<std::string> entries =
        law == "Johnson-Cook" ?
          std::vector<std::string>{"A", "B", "n", "C", "m"} :
        law == "Voce" ?
          std::vector<std::string>{"Yield stress", "Saturation stress"} :
          std::vector<std::string>{};
      for (const std::string &entry : entries)
        {
          const std::string path = "Material/" + law + "/" + entry;
          if (parse_number(split(input.declarator.get(path), ' ').front()) !=
              0.)
            scale(path, factors, ChoiceKind::constants);
        }
      if (entries.empty())
        scale("Material/Young's modulus", factors, ChoiceKind::constants);
    }
  } // namespace



  std::string
  name(const ChoiceKind kind)
  {
    return kind == ChoiceKind::preparation ? "preparation" :
           kind == ChoiceKind::profile     ? "profile" :
           kind == ChoiceKind::scene       ? "scene" :
                                             "constants";
  }



  std::vector<Variation>
  variations_of(const SceneInput &input)
  {
    Variations variations(input);
    variations.vary_surface();
    variations.vary_scene();
    variations.vary_constants();
    return variations.list;
  }
} // namespace asperity
