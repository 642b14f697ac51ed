#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_results.h>
#include <asperity/constitutive/johnson_cook.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** What is tabulated of a run; the law's output must stand first. */
    struct OutputColumn
    {
      SampleOutput output;
      double RunRecord::*value;
    };

    std::vector<OutputColumn>
    output_columns(const LawOutput first)
    {
      std::vector<OutputColumn> columns = {
        {{"mu", "-"}, &RunRecord::mu},
        {{"mu_end", "-"}, &RunRecord::mu_end},
        {{"spread", "-"}, &RunRecord::spread},
        {{"contact_fraction", "-"}, &RunRecord::contact_fraction},
        {{"oil_pressure", "Pa"}, &RunRecord::oil_pressure},
        {{"oil_load_share", "-"}, &RunRecord::oil_load_share},
        {{"sliding_distance", "m"}, &RunRecord::sliding_distance},
        {{"max_plastic_strain", "-"}, &RunRecord::max_plastic_strain},
        {{"max_temperature", "K"}, &RunRecord::max_temperature}};
      if (first == LawOutput::mu_end)
        std::swap(columns[0], columns[1]);
      return columns;
    }

    std::vector<SampleOutput>
    outputs(const LawOutput first)
    {
      std::vector<SampleOutput> result;
      for (const OutputColumn &column : output_columns(first))
        result.push_back(column.output);
      return result;
    }

    /** Of the base scene's chip; unknown unless it is Johnson-Cook. */
    ShearLimit
    shear_limit_of(const CampaignParameters &parameters)
    {
      const SceneInput          scene(parameters.base_scene);
      const MaterialParameters &material = scene.parameters.material;
      ShearLimit                limit;
      if (material.law != MaterialLawName::johnson_cook)
        return limit;
      const JohnsonCook law(material.johnson_cook);
      limit.strain = parameters.law.shear_strain;
      limit.rate   = parameters.law.shear_rate;
      limit.k_0    = law.hardening(limit.strain).value *
                  law.rate_factor(limit.rate).value / std::sqrt(3.);
      limit.exponent = material.johnson_cook.m;
      limit.transition_temperature =
        material.johnson_cook.transition_temperature;
      limit.melting_temperature = material.johnson_cook.melting_temperature;
      return limit;
    }
  } // namespace



  TestReport
  test_law(const FrictionLaw &law, const SampleData &tests)
  {
    TestReport        report;
    const std::size_t d = law.description().inputs.size();
    report.n_runs       = tests.y.size();
    unsigned int inside = 0;
    for (std::size_t i = 0; i < tests.y.size(); ++i)
      {
        const LawPrediction prediction = law.predict(&tests.x[i * d]);
        const double        error =
          std::abs(prediction.mean - tests.y[i]) / std::abs(tests.y[i]);
        report.mean_relative_error += error / tests.y.size();
        report.largest_error = std::max(report.largest_error, error);
        if (prediction.lower <= tests.y[i] && tests.y[i] <= prediction.upper)
          ++inside;
      }
    if (report.n_runs > 0)
      report.coverage = static_cast<double>(inside) / report.n_runs;
    return report;
  }



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
                         path + " are " + names(tests) +
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
    , shear_limit(shear_limit_of(parameters))
  {
    const std::string &path = parameters.design.test_table;
    if (!path.empty())
      further_tests = read_tests(path, table_);
  }



  std::string
  CampaignResults::path_of(const RunOrder &order) const
  {
    return parameters.directory + "/runs/" + order.name(plan.n_profiles()) +
           ".json";
  }



  Sample
  CampaignResults::combine(const PlannedPoint           &point,
                           const std::vector<RunRecord> &records)
  {
    const auto columns = output_columns(parameters.law.output);
    Sample     sample;
    sample.id   = point.id;
    sample.x    = point.x;
    sample.role = point.test ? SampleRole::test : SampleRole::training;
    for (std::size_t i = 0; i < records.size(); ++i)
      if (!records[i].done)
        {
          sample.status = SampleStatus::failed;
          sample.reason =
            (records.size() > 1 ? "Profile " + std::to_string(i + 1) + ": " :
                                  "") +
            records[i].reason;
          return sample;
        }

    const double n = records.size();
    for (const OutputColumn &column : columns)
      {
        double mean = 0.;
        for (const RunRecord &record : records)
          mean += record.*column.value / n;
        sample.outputs.push_back(mean);
      }
    if (records.size() > 1)
      {
        const double mean     = sample.outputs[0];
        double       variance = 0.; // between profiles
        for (const RunRecord &record : records)
          variance += std::pow(record.*columns[0].value - mean, 2) / (n - 1.);
        sample.deviation = std::sqrt(variance / n);
        if (mean != 0.)
          {
            sum_of_variances += variance / (mean * mean);
            ++n_variances;
          }
      }
    return sample;
  }



  void
  CampaignResults::collect()
  {
    table_   = SampleTable(plan.inputs(), outputs(parameters.law.output));
    seconds_ = 0.;
    sum_of_variances = 0.;
    n_variances      = 0;
    warnings_.clear();
    for (const PlannedPoint &point : plan.points())
      {
        std::vector<RunRecord> records;
        for (unsigned int k = 0; k < plan.n_profiles(); ++k)
          {
            const RunOrder order = plan.order(point, k);
            if (const auto record = read_record(path_of(order), order))
              records.push_back(*record);
          }
        for (const RunRecord &record : records)
          {
            seconds_ += record.seconds;
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
        if (records.size() == plan.n_profiles())
          table_.add(combine(point, records));
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
        " runs of the campaign have succeeded, too few for a law; the reasons "
        "stand in " +
        parameters.directory + "/runs.csv.");
    FrictionLawDescription description;
    description.inputs       = plan.inputs();
    description.output       = table_.outputs()[0].name;
    description.kernel       = parameters.law.kernel;
    description.output_scale = parameters.law.output_scale;
    description.largest_trusted_deviation =
      parameters.law.largest_trusted_deviation;
    description.topography_scatter = topography_scatter();
    description.shear_limit        = shear_limit;

    nlohmann::ordered_json &provenance = description.provenance;
    provenance["program"]              = version_json();
    provenance["base_scene"]           = parameters.base_scene;
    provenance["profiles"]             = plan.n_profiles();
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



  double
  CampaignResults::topography_scatter() const
  {
    return n_variances > 0 ? std::sqrt(sum_of_variances / n_variances) : 0.;
  }



  std::vector<std::string>
  CampaignResults::warnings() const
  {
    std::vector<std::string> result;
    for (const auto &[warning, n] : warnings_)
      result.push_back(std::to_string(n) + " runs: " + warning);
    return result;
  }
} // namespace asperity
