#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/campaign/campaign_plan.h>
#include <asperity/law_export/contact_point_law.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "campaign_inputs.h"

namespace asperity
{
  CampaignPlan::CampaignPlan(const CampaignParameters  &parameters,
                             const ParameterDeclarator &declarator)
    : profiles(split(parameters.profile_positions, ','))
  {
    const CampaignInputs found(parameters, declarator);
    inputs_          = found.inputs;
    is_whole_number  = found.is_whole_number;
    base_scene_text_ = found.base_scene_text;
    base_scene       = found.base_scene;
    wants_accuracy   = found.wants_accuracy;
    wants_fields_    = found.wants_fields;
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
      {
        text += "  " + input.symbol + ": " + input.name + ", " +
                format_quantity(input.lower, input.unit) + " to " +
                format_quantity(input.upper, input.unit);
        const auto &symbols = ContactPointLaw::symbols();
        if (parameters.exports.write &&
            std::find(symbols.begin(), symbols.end(), input.symbol) ==
              symbols.end())
          text += "; an argument of exported C and Fortran, " +
                  format_quantity(*input.reference, input.unit, 6) +
                  " in exported tables (Export at)";
        text += "\n";
      }
    if (wants_fields_)
      text += "  each run keeps its fields (Output/Field times), for 'asperity "
              "reduce'\n";
    if (wants_accuracy)
      text += "  Accuracy/Control of the base scene does not count: all points "
              "are computed with its mesh, steps and penalty, so that mu does "
              "not jump where others would be chosen, and are not corrected\n";
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
      {
        if (is_whole_number[i])
          x[i] = std::round(x[i]);
        x[i] = parse_quantity(format_quantity(x[i], inputs_[i].unit),
                              dimension_of(inputs_[i].unit));
      }
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



  bool
  CampaignPlan::wants_fields() const
  {
    return wants_fields_;
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
