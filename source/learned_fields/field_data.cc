#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/field_data.h>
#include <asperity/surrogate/sample_table.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace asperity
{
  namespace fs = std::filesystem;

  namespace
  {
    std::string
    fields_of(const std::string &campaign, const unsigned int id)
    {
      std::string number = std::to_string(id);
      if (number.size() < 4)
        number.insert(0, 4 - number.size(), '0');
      return campaign + "/runs/" + number + ".h5";
    }

    /** What the laws of the codes see of the inputs: as that of mu. */
    FrictionLawDescription
    description_of(const std::string &campaign, const SampleTable &table)
    {
      FrictionLawDescription result;
      result.inputs          = table.inputs();
      const std::string path = campaign + "/friction_law.json";
      if (fs::exists(path))
        {
          result = FrictionLaw::load(path).description();
          if (result.n_profiles > 1)
            throw InputError("The campaign in " + quoted_name(campaign) +
                             " has " + std::to_string(result.n_profiles) +
                             " profiles, whose fields have no mean; expected "
                             "one without Profile positions.");
        }
      result.choices.clear();
      result.warnings.clear();
      return result;
    }

    /** Takes every so manieth run out, if that is asked for or no run is a test
     *  run. */
    void
    hold_out(std::vector<FieldRun> &runs, const std::optional<double> &share)
    {
      const bool has_tests =
        std::any_of(runs.begin(), runs.end(), [](const FieldRun &run) {
          return run.held;
        });
      if (has_tests && !share)
        return;
      const double part = share.value_or(0.2);
      double       sum  = 0.5;
      for (FieldRun &run : runs)
        {
          sum += part;
          run.held = sum >= 1.;
          if (run.held)
            sum -= 1.;
        }
    }

    /** Adds a run; the first one says what all are to have. */
    void
    add(const Sample         &sample,
        const FieldSnapshots &fields,
        const std::string    &path,
        FieldData            &data)
    {
      if (data.runs.empty())
        data.layout = FieldLayout(fields);
      FieldRun run{sample.id,
                   sample.role == SampleRole::test,
                   sample.x,
                   data.layout.pack(fields, path),
                   {}};
      for (const FieldSnapshot &snapshot : fields.snapshots)
        run.mu.push_back(snapshot.mu);
      if (data.times.empty())
        for (const double share : fields.shares)
          {
            data.times.emplace_back();
            data.times.back().share = share;
          }
      const auto p = pressure_of(data.description);
      for (std::size_t i = 0; i < data.times.size(); ++i)
        {
          const FieldSnapshot &snapshot = fields.snapshots[i];
          data.times[i].time += snapshot.time;
          data.times[i].sliding_distance += snapshot.sliding_distance;
          data.times[i].pressure += snapshot.pressure / (p ? sample.x[*p] : 1.);
          data.times[i].direction = snapshot.direction;
        }
      data.runs.push_back(run);
    }
  } // namespace



  std::size_t
  FieldData::n_runs(const bool held) const
  {
    return std::count_if(runs.begin(), runs.end(), [&](const FieldRun &run) {
      return run.held == held;
    });
  }



  std::optional<std::size_t>
  pressure_of(const FrictionLawDescription &description)
  {
    for (std::size_t i = 0; i < description.inputs.size(); ++i)
      if (description.inputs[i].name == "Load/Pressure")
        return i;
    return {};
  }



  FieldData
  read_fields(const std::string &campaign, const std::optional<double> held_out)
  {
    if (!fs::exists(campaign + "/runs.csv"))
      throw InputError("The folder " + quoted_name(campaign) +
                       " has no runs.csv; the output directory of a campaign "
                       "is expected, as 'asperity characterize' makes it.");
    const SampleTable table = SampleTable::read(campaign + "/runs.csv");
    FieldData         data;
    data.description    = description_of(campaign, table);
    unsigned int n_done = 0;
    for (const Sample &sample : table.samples())
      {
        if (sample.status != SampleStatus::done)
          continue;
        ++n_done;
        if (const std::string path = fields_of(campaign, sample.id);
            fs::exists(path))
          add(sample, FieldSnapshots::read(path), path, data);
      }
    if (data.runs.empty())
      throw InputError("None of the " + std::to_string(n_done) + " runs in " +
                       quoted_name(campaign) +
                       " has kept its fields; expected a campaign whose base "
                       "scene has Output/Field times.");
    if (data.runs.size() < n_done)
      data.warnings.push_back(std::to_string(n_done - data.runs.size()) +
                              " runs have no fields and do not count.");
    for (FieldTime &time : data.times)
      for (double *sum : {&time.time, &time.sliding_distance, &time.pressure})
        *sum /= data.runs.size();
    hold_out(data.runs, held_out);
    const std::size_t n_needed = data.description.inputs.size() + 2;
    if (data.n_runs(false) < n_needed || data.n_runs(true) == 0)
      throw InputError("Of " + std::to_string(data.runs.size()) +
                       " runs with fields " +
                       std::to_string(data.n_runs(true)) +
                       " are held out; expected at least one, and " +
                       std::to_string(n_needed) + " others to learn from.");
    return data;
  }
} // namespace asperity
