#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_results.h>
#include <asperity/campaign/scene_sensitivity.h>

#include <algorithm>

#include "run_outputs.h"
#include "shear_limit.h"

namespace asperity
{
  namespace
  {
    SampleData
    read_tests(const std::string &path, const SampleTable &own)
    {
      const SampleTable tests = SampleTable::read(path);
      const auto        names = [](const SampleTable &table) {
        std::vector<std::string> result;
        for (const LawInput &input : table.inputs())
          result.push_back(input.name);
        return join(result, ", ");
      };
      if (names(tests) != names(own))
        throw InputError("entry 'Campaign/Design/Test table': the inputs of " +
                         quoted_name(path) + " are " + names(tests) +
                         "; expected those of this campaign, " + names(own) +
                         ".");
      return tests.data(SampleRole::test, own.outputs()[0].name);
    }
  } // namespace



  CampaignResults::CampaignResults(const CampaignParameters &parameters,
                                   const CampaignPlan       &plan)
    : parameters(parameters)
    , plan(plan)
    , table_(plan.inputs(), outputs(parameters.law.output))
    , shear_limit(
        shear_limit_of(SceneInput(parameters.base_scene).parameters.material,
                       parameters.law))
    , scatter_(plan.n_profiles())
  {
    const std::string &path = parameters.design.test_table;
    if (!path.empty())
      further_tests = read_tests(path, table_);
    if (!parameters.law.sensitivity.empty())
      choices = read_spreads(parameters.law.sensitivity);
    const double below = parameters.law.plane_strain_below,
                 above = parameters.law.plane_strain_above;
    if (below + above > 0.)
      choices.push_back({ChoiceSpread::plane_strain, below, above});
  }



  std::string
  CampaignResults::path_of(const RunOrder &order) const
  {
    return parameters.directory + "/runs/" + order.name(plan.n_profiles()) +
           ".json";
  }



  std::string
  CampaignResults::field_file_of(const RunOrder &order) const
  {
    return parameters.directory + "/runs/" + order.name(plan.n_profiles()) +
           ".h5";
  }



  Sample
  CampaignResults::combine(const PlannedPoint           &point,
                           const std::vector<RunRecord> &records) const
  {
    const auto columns = output_columns(parameters.law.output);
    Sample     sample;
    sample.id   = point.id;
    sample.x    = point.x;
    sample.role = point.test ? SampleRole::test : SampleRole::training;

    std::vector<RunRecord>             done;
    std::vector<std::optional<double>> values(records.size());
    for (std::size_t k = 0; k < records.size(); ++k)
      if (const std::string why = why_not_learnt(records[k], parameters.law);
          why.empty())
        {
          values[k] = records[k].*columns[0].value;
          done.push_back(records[k]);
        }
      else if (sample.reason.empty())
        sample.reason =
          (records.size() > 1 ? "Profile " + std::to_string(k + 1) + ": " :
                                "") +
          why;

    const auto mean = scatter_.mean(values);
    if (!mean)
      {
        sample.status = SampleStatus::failed;
        return sample;
      }
    for (const OutputColumn &column : columns)
      {
        double sum = 0.;
        for (const RunRecord &record : done)
          sum += record.*column.value;
        sample.outputs.push_back(sum / done.size());
      }
    sample.outputs[0] = mean->mean;
    sample.deviation  = mean->deviation;
    return sample;
  }



  void
  CampaignResults::collect()
  {
    table_   = SampleTable(plan.inputs(), outputs(parameters.law.output));
    scatter_ = ProfileScatter(plan.n_profiles());
    seconds_ = 0.;
    n_points_with_gaps_ = 0;
    n_without_result_   = 0;
    warnings_.clear();
    mechanisms_.clear();
    const auto value = output_columns(parameters.law.output)[0].value;

    std::vector<std::pair<PlannedPoint, std::vector<RunRecord>>> finished;
    for (const PlannedPoint &point : plan.points())
      {
        std::vector<RunRecord> records;
        std::vector<double>    values;
        for (unsigned int k = 0; k < plan.n_profiles(); ++k)
          {
            const RunOrder order = plan.order(point, k);
            if (const auto record = read_record(path_of(order), order))
              {
                note(*record);
                records.push_back(*record);
                if (why_not_learnt(*record, parameters.law).empty())
                  values.push_back((*record).*value);
              }
          }
        // Test runs must not say what the law learns, nor when they are done.
        if (values.size() == plan.n_profiles() && !point.test)
          scatter_.add(values);
        if (records.size() == plan.n_profiles())
          finished.emplace_back(point, records);
      }
    for (const auto &[point, records] : finished)
      {
        const Sample sample = combine(point, records);
        table_.add(sample);
        if (sample.status == SampleStatus::done && !sample.reason.empty())
          ++n_points_with_gaps_;
      }
  }



  void
  CampaignResults::note(const RunRecord &record)
  {
    seconds_ += record.seconds;
    if (record.done && !why_not_learnt(record, parameters.law).empty())
      {
        ++n_without_result_;
        return; // its warnings say why, each with other numbers
      }
    for (const std::string &mechanism : record.mechanisms)
      if (std::find(mechanisms_.begin(), mechanisms_.end(), mechanism) ==
          mechanisms_.end())
        mechanisms_.push_back(mechanism);
    for (const std::string &warning : record.warnings)
      {
        const auto known = std::find_if(warnings_.begin(),
                                        warnings_.end(),
                                        [&](const auto &entry) {
                                          return entry.first == warning;
                                        });
        if (known == warnings_.end())
          warnings_.emplace_back(warning, 1);
        else
          ++known->second;
      }
  }



  const SampleTable &
  CampaignResults::table() const
  {
    return table_;
  }



  SampleData
  CampaignResults::training_data(const unsigned int n_points) const
  {
    unsigned int n = 0, last_id = 0;
    for (const PlannedPoint &point : plan.points())
      if (!point.test && n++ < n_points)
        last_id = point.id;
    SampleData data =
      table_.data(SampleRole::training, table_.outputs()[0].name);
    // in the order of ids
    const std::size_t n_data =
      std::upper_bound(data.id.begin(), data.id.end(), last_id) -
      data.id.begin();
    data.id.resize(n_data);
    data.x.resize(n_data * plan.inputs().size());
    data.y.resize(n_data);
    if (!data.deviation.empty())
      data.deviation.resize(n_data);
    return data;
  }



  SampleData
  CampaignResults::test_data() const
  {
    SampleData data = table_.data(SampleRole::test, table_.outputs()[0].name);
    data.x.insert(data.x.end(), further_tests.x.begin(), further_tests.x.end());
    data.y.insert(data.y.end(), further_tests.y.begin(), further_tests.y.end());
    return data;
  }



  std::vector<unsigned int>
  CampaignResults::steps_of_learning() const
  {
    const DesignParameters &design = parameters.design;
    const unsigned int      n_all  = plan.n_points(false);
    const unsigned int      step   = design.batch > 0 ? design.batch : 10;
    // Only the beginning of a sequence fills the box by itself.
    unsigned int n =
      design.kind == DesignKind::grid ? n_all : design.initial_runs;
    if (design.batch == 0 && design.kind == DesignKind::sobol)
      n = std::min(n, 20u);

    std::vector<unsigned int> steps;
    for (; n < n_all; n += step)
      steps.push_back(n);
    steps.push_back(n_all);
    return steps;
  }



  std::vector<double>
  CampaignResults::failed_points() const
  {
    std::vector<double> points;
    for (const Sample &sample : table_.samples())
      if (sample.role == SampleRole::training &&
          sample.status == SampleStatus::failed)
        points.insert(points.end(), sample.x.begin(), sample.x.end());
    return points;
  }



  FrictionLaw
  CampaignResults::train(const SampleData &data) const
  {
    if (data.y.size() < plan.inputs().size() + 2)
      throw ComputationError(
        "Only " + std::to_string(data.y.size()) +
        " runs of the campaign gave a friction coefficient, too few for a law "
        "of " +
        std::to_string(plan.inputs().size()) +
        (plan.inputs().size() == 1 ? " input" : " inputs") + ", which needs " +
        std::to_string(plan.inputs().size() + 2) +
        "; what the others lack stands in " +
        quoted_name(parameters.directory + "/runs.csv") + ".");
    FrictionLawDescription description;
    description.inputs       = plan.inputs();
    description.output       = table_.outputs()[0].name;
    description.kernel       = parameters.law.kernel;
    description.output_scale = parameters.law.output_scale;
    description.largest_trusted_deviation =
      parameters.law.largest_trusted_deviation;
    description.n_profiles         = plan.n_profiles();
    description.topography_scatter = scatter_.total();
    description.shear_limit        = shear_limit;
    description.pressure_over_strength =
      parameters.law.pressure_scale != PressureScale::as_it_is;
    if (parameters.law.pressure_scale == PressureScale::logarithm_over_strength)
      for (LawInput &input : description.inputs)
        if (input.name == "Load/Pressure")
          input.scale = Scale::logarithmic;
    description.mechanisms = mechanisms_;
    description.choices    = choices;

    nlohmann::ordered_json &provenance = description.provenance;
    provenance["program"]              = version_json();
    provenance["base_scene"]           = parameters.base_scene;
    provenance["runs"]                 = data.y.size();
    return FrictionLaw::train(description, data.x, data.y, data.deviation);
  }



  std::vector<HistoryRow>
  CampaignResults::history() const
  {
    const SampleData        tests = test_data();
    std::vector<HistoryRow> rows;
    for (const unsigned int n : steps_of_learning())
      {
        const SampleData data = training_data(n);
        if (data.y.size() < plan.inputs().size() + 2)
          continue;
        const FrictionLaw law = train(data);
        rows.push_back({static_cast<unsigned int>(data.y.size()),
                        law.description().leave_one_out_error,
                        test_law(law, tests)});
      }
    return rows;
  }



  double
  CampaignResults::seconds() const
  {
    return seconds_;
  }



  unsigned int
  CampaignResults::n_without_result() const
  {
    return n_without_result_;
  }



  const ProfileScatter &
  CampaignResults::scatter() const
  {
    return scatter_;
  }



  std::vector<std::string>
  CampaignResults::warnings() const
  {
    std::vector<std::string> result;
    if (n_without_result_ > 0)
      result.push_back(
        "Runs that gave no friction coefficient and are not learnt from: " +
        std::to_string(n_without_result_) +
        "; runs.csv says why, and where they are close together the law has "
        "nothing to rest on.");
    for (const auto &[warning, n] : warnings_)
      result.push_back(std::to_string(n) + " runs: " + warning);
    if (n_points_with_gaps_ > 0)
      result.push_back("Points at which some profiles have failed: " +
                       std::to_string(n_points_with_gaps_) +
                       "; the mean over all profiles is estimated from the "
                       "others.");
    return result;
  }
} // namespace asperity
