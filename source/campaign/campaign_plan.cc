#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/campaign/campaign_plan.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace asperity
{
  namespace
  {
    const char *const profile_entry = "Tool/Topography/Profile position";

    /** The unit behind a number, "1" if there is none. */
    std::string
    unit_of(const std::string &text)
    {
      char *end = nullptr;
      std::strtod(text.c_str(), &end);
      const std::string unit = trim(end);
      return unit.empty() ? "1" : unit;
    }

    std::string
    symbol_of(const std::string &entry)
    {
      if (entry == "Load/Pressure")
        return "p";
      if (entry == "Load/Velocity")
        return "v";
      if (entry == "Load/Temperature")
        return "T";
      std::string symbol = entry.substr(entry.rfind('/') + 1);
      symbol.erase(std::remove(symbol.begin(), symbol.end(), ' '),
                   symbol.end());
      return symbol;
    }

    double
    end_of_range(const std::string &text,
                 const Dimension    dimension,
                 const std::string &where)
    {
      try
        {
          return parse_quantity(text, dimension);
        }
      catch (const InputError &error)
        {
          throw InputError(where + ": " + error.what() + ".");
        }
    }

    /** That of a number with a unit. */
    Dimension
    dimension_of_quantity(const std::string &text, const std::string &where)
    {
      try
        {
          return dimension_of(unit_of(text));
        }
      catch (const InputError &error)
        {
          throw InputError(where + ": " + error.what() + ".");
        }
    }

    LawInput
    resolve(const InputParameters     &parameters,
            const ParameterDeclarator &declarator,
            const std::string         &section)
    {
      LawInput input;
      input.name                = parameters.entry;
      input.symbol              = symbol_of(parameters.entry);
      input.unit                = unit_of(parameters.from);
      input.scale               = parameters.scale;
      const std::string from    = declarator.where(section + "/From");
      const Dimension dimension = dimension_of_quantity(parameters.from, from);
      input.lower = end_of_range(parameters.from, dimension, from);
      input.upper = end_of_range(parameters.to,
                                 dimension,
                                 declarator.where(section + "/To"));
      if (!(input.lower < input.upper))
        throw InputError(declarator.where(section + "/To") + ": found " +
                         parameters.to + "; expected more than " +
                         parameters.from + ".");
      if (input.scale == Scale::logarithmic && input.lower <= 0.)
        throw InputError(declarator.where(section + "/Scale") +
                         ": found logarithmic with a range from " +
                         parameters.from + "; expected a range above 0.");
      return input;
    }
  } // namespace



  CampaignPlan::CampaignPlan(const CampaignParameters  &parameters,
                             const ParameterDeclarator &declarator)
    : profiles(split(parameters.profile_positions, ','))
  {
    EntryValues lower, upper;
    for (unsigned int i = 0; i < parameters.inputs.size(); ++i)
      {
        const InputParameters &input = parameters.inputs[i];
        if (input.entry.empty())
          continue;
        inputs_.push_back(resolve(input,
                                  declarator,
                                  "Campaign/Input " + std::to_string(i + 1)));
        lower.emplace_back(input.entry, input.from);
        upper.emplace_back(input.entry, input.to);
      }
    // The scene itself judges both ends of the ranges and the profiles.
    try
      {
        SceneInput(parameters.base_scene, upper);
        SceneInput         input(parameters.base_scene, lower);
        std::ostringstream text;
        input.declarator.write_prm(text);
        base_scene_text_ = text.str();
        base_scene       = input.record;
        for (const std::string &position : profiles)
          input.declarator.set(profile_entry, position);
      }
    catch (const InputError &error)
      {
        throw InputError(declarator.where("Campaign/Base scene") + ": " +
                         error.what());
      }
  }



  void
  CampaignPlan::start(const CampaignParameters &parameters,
                      const std::string        &path)
  {
    const DesignParameters &design = parameters.design;
    if (std::filesystem::exists(path))
      read(path);
    follow(
      design.kind == DesignKind::grid ?
        grid_points(std::vector<unsigned int>(design.grid_points.begin(),
                                              design.grid_points.end()),
                    inputs_) :
        design_points(design.kind, design.initial_runs, inputs_, design.seed),
      false);
    follow(design_points(
             DesignKind::random, design.test_runs, inputs_, design.seed + 1),
           true);
  }



  const std::string &
  CampaignPlan::base_scene_text() const
  {
    return base_scene_text_;
  }



  std::string
  CampaignPlan::description(const CampaignParameters &parameters) const
  {
    std::string text = "Campaign: " + parameters.base_scene + ", " +
                       std::to_string(n_points(false)) + " training points";
    if (parameters.design.batch > 0)
      text += " (up to " + std::to_string(parameters.design.maximum_runs) +
              " by active learning)";
    text += ", " + std::to_string(n_points(true)) + " test points";
    if (n_profiles() > 1)
      text += ", each on " + std::to_string(n_profiles()) + " profiles";
    text += "\n";
    for (const LawInput &input : inputs_)
      text += "  " + input.symbol + ": " + input.name + ", " +
              format_quantity(input.lower, input.unit) + " to " +
              format_quantity(input.upper, input.unit) + "\n";
    return text;
  }



  void
  CampaignPlan::follow(const std::vector<double> &design, const bool test)
  {
    const std::size_t         d = inputs_.size();
    std::vector<PlannedPoint> known;
    std::copy_if(points_.begin(),
                 points_.end(),
                 std::back_inserter(known),
                 [test](const PlannedPoint &point) {
                   return point.test == test;
                 });
    for (std::size_t i = 0; i < design.size() / d; ++i)
      {
        const std::vector<double> x =
          as_written(std::vector<double>(design.begin() + i * d,
                                         design.begin() + (i + 1) * d));
        if (i >= known.size())
          add(test, x);
        else if (known[i].x != x)
          throw InputError(
            "The output directory holds a campaign with another design or "
            "seed (point " +
            std::to_string(known[i].id) +
            " differs); take another output directory.");
      }
  }



  std::vector<double>
  CampaignPlan::as_written(std::vector<double> x) const
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = parse_quantity(format_quantity(x[i], inputs_[i].unit),
                            dimension_of(inputs_[i].unit));
    return x;
  }



  void
  CampaignPlan::add(const bool test, const std::vector<double> &x)
  {
    PlannedPoint point;
    point.id   = points_.size() + 1;
    point.test = test;
    point.x    = as_written(x);
    points_.push_back(point);
  }



  const std::string &
  CampaignPlan::warning() const
  {
    return warning_;
  }



  std::string
  CampaignPlan::changed_file() const
  {
    return base_scene.changed_file();
  }



  const std::vector<LawInput> &
  CampaignPlan::inputs() const
  {
    return inputs_;
  }



  const std::vector<PlannedPoint> &
  CampaignPlan::points() const
  {
    return points_;
  }



  unsigned int
  CampaignPlan::n_points(const bool test) const
  {
    return std::count_if(points_.begin(),
                         points_.end(),
                         [test](const PlannedPoint &point) {
                           return point.test == test;
                         });
  }



  unsigned int
  CampaignPlan::n_profiles() const
  {
    return std::max<std::size_t>(1, profiles.size());
  }



  RunOrder
  CampaignPlan::order(const PlannedPoint &point,
                      const unsigned int  profile) const
  {
    RunOrder order;
    order.id      = point.id;
    order.profile = profile;
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      order.changes.emplace_back(inputs_[i].name,
                                 format_quantity(point.x[i], inputs_[i].unit));
    if (!profiles.empty())
      order.changes.emplace_back(profile_entry, profiles[profile]);
    return order;
  }
} // namespace asperity
