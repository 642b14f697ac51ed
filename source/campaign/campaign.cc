#include <asperity/base/atomic_file.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/campaign/campaign.h>
#include <asperity/campaign/task_counter.h>
#include <asperity/surrogate/active_learning.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace asperity
{
  Campaign::Campaign(const CampaignParameters  &parameters,
                     const ParameterDeclarator &declarator,
                     const MPI_Comm             communicator,
                     const Runner              &runner)
    : parameters(parameters)
    , communicator(communicator)
    , runner(runner)
    , is_first(is_first_rank())
    , plan_(parameters, declarator)
    , results_(parameters, plan_)
  {
    MpiSession::start();
    lock_folder(declarator.where("Campaign/Output directory"));
    const std::string path = parameters.directory + "/plan.json";
    plan_.start(parameters, path);
    // All ranks have read the plan before it is written again.
    MPI_Barrier(communicator);
    if (is_first)
      {
        plan_.save(path);
        write_atomically(base_scene(), [&](std::ostream &out) {
          out << plan_.base_scene_text();
        });
        write_atomically(parameters.directory + "/campaign.prm",
                         [&](std::ostream &out) { declarator.write_prm(out); });
        if (!plan_.warning().empty())
          std::cout << "Warning: " << plan_.warning() << "\n";
        progress = std::make_unique<ProgressLine>(std::cout);
      }
    MPI_Barrier(communicator);
  }



  std::string
  Campaign::base_scene() const
  {
    return parameters.directory + "/base_scene.prm";
  }



  void
  Campaign::lock_folder(const std::string &where)
  {
    std::string refusal;
    if (is_first)
      try
        {
          folder = std::make_unique<OutputFolder>(parameters.directory,
                                                  where,
                                                  FolderUse::campaign);
          if (!folder->warning().empty())
            std::cout << "Warning: " << folder->warning() << "\n";
        }
      catch (const InputError &error)
        {
          refusal = error.what();
        }
    refusal = dealii::Utilities::MPI::broadcast(communicator, refusal, 0);
    if (!refusal.empty())
      throw InputError(refusal);
  }



  void
  Campaign::run()
  {
    perform();
    for (std::vector<double> batch = next_batch(); !batch.empty();
         batch                     = next_batch())
      {
                            const std::size_t d = plan_.inputs().size();
                            for (std::size_t i = 0; i < batch.size() / d; ++i)
          plan_.add(false,
                    std::vector<double>(batch.begin() + i * d,
                                        batch.begin() + (i + 1) * d));
        if (is_first)
          plan_.save(parameters.directory + "/plan.json");
        perform();
      }
    results_.collect();
    if (is_first)
      results_.table().write(parameters.directory + "/runs.csv");
  }



  std::string
  Campaign::description() const
  {
    std::string       text   = plan_.description(parameters);
    const std::size_t n_open = open_orders().size();
    const std::size_t n_all  = plan_.points().size() * plan_.n_profiles();
    if (n_open < n_all)
      text += "  " + std::to_string(n_all - n_open) + " of " +
              std::to_string(n_all) + " runs are in " + parameters.directory +
              " already\n";
    const int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    return text + "  on " + std::to_string(n_ranks) +
           (n_ranks > 1 ? " ranks\n" : " rank (mpirun -np N shares them)\n");
  }



  std::vector<RunOrder>
  Campaign::open_orders() const
  {
    std::vector<RunOrder> orders;
    for (const PlannedPoint &point : plan_.points())
      for (unsigned int k = 0; k < plan_.n_profiles(); ++k)
        {
          RunOrder   order  = plan_.order(point, k);
          const auto record = read_record(results_.path_of(order), order);
          if (plan_.wants_fields())
            order.field_file = results_.field_file_of(order);
          // Fields are written before the record.
          const bool misses_fields = record && record->done &&
                                     !order.field_file.empty() &&
                                     !std::filesystem::exists(order.field_file);
          if (!record || misses_fields ||
              (!record->done && parameters.repeat_failed_runs && first_try))
            orders.push_back(order);
        }
    return orders;
  }



  void
  Campaign::perform()
  {
    // All ranks read the same files, and none is written before all have.
    const std::vector<RunOrder> orders = open_orders();
    first_try                          = false;
    MPI_Barrier(communicator);
    std::string change;
    for_each_task(orders.size(), communicator, [&](const std::size_t i) {
      if (!change.empty())
        return;
      const RunRecord record = runner(base_scene(), orders[i]);
      change                 = plan_.changed_file();
      if (!change.empty())
        return;
      write_record(results_.path_of(orders[i]), orders[i], record);
      if (is_first)
        show_progress(orders);
    });
    for (const std::string &found :
         dealii::Utilities::MPI::all_gather(communicator, change))
      if (!found.empty())
        throw InputError("While the campaign ran, a file of the base scene has "
                         "changed: " +
                         found +
                         "; the runs since then are not recorded. Expected the "
                         "file as it was, or another output directory.");
    n_performed += orders.size();
  }



  void
  Campaign::show_progress(const std::vector<RunOrder> &orders)
  {
    results_.collect();
    results_.table().write(parameters.directory + "/runs.csv");
    const SampleTable &table = results_.table();
    const std::size_t  n_done =
      table.count(SampleRole::training, SampleStatus::done) +
      table.count(SampleRole::test, SampleStatus::done);
    const std::size_t n_failed = table.samples().size() - n_done;
    const std::size_t n_open =
      std::count_if(orders.begin(), orders.end(), [&](const RunOrder &order) {
        return !std::filesystem::exists(results_.path_of(order));
      });
    const std::size_t n_later =
      parameters.design.batch == 0 ||
          parameters.design.maximum_runs <= plan_.n_points(false) ?
        0 :
        (parameters.design.maximum_runs - plan_.n_points(false)) *
          plan_.n_profiles();
    const double n_session = n_performed + orders.size() - n_open;
    progress->update(
      n_session / (n_session + n_open + n_later),
      std::to_string(n_done) + " runs done" +
        (n_failed > 0 ? ", " + std::to_string(n_failed) + " failed" : "") +
        ", " + std::to_string(n_open + n_later) + " to come at most");
  }



  bool
  Campaign::target_is_met()
  {
    const unsigned int  n_planned = plan_.n_points(false);
    std::vector<double> after_batch;
    for (const unsigned int n : results_.steps_of_learning())
      {
        if (n <= n_planned && errors.count(n) == 0)
          errors[n] = cross_validate(results_.train(results_.training_data(n)))
                        .mean_relative_error;
        if (n <= n_planned)
          after_batch.push_back(errors.at(n));
      }
    StoppingRule rule;
    rule.target = parameters.design.target_error;
    return rule.is_met(after_batch);
  }



  std::vector<double>
  Campaign::next_batch()
  {
    const DesignParameters &design    = parameters.design;
    const unsigned int      n_planned = plan_.n_points(false);
    std::vector<double>     batch;
    if (is_first && design.batch > 0 && n_planned < design.maximum_runs)
      {
        results_.collect();
        if (!target_is_met())
          batch = next_points(results_.train(results_.training_data(n_planned)),
                              results_.failed_points(),
                              std::min(design.batch,
                                       design.maximum_runs - n_planned));
        progress->note(std::to_string(n_planned) +
                       " training points: mean error of cross-validation " +
                       format_quantity(100. * errors.at(n_planned), "1", 3) +
                       " %");
      }
    return dealii::Utilities::MPI::broadcast(communicator, batch, 0);
  }



  const CampaignResults &
  Campaign::results() const
  {
    return results_;
  }



  const CampaignPlan &
  Campaign::plan() const
  {
    return plan_;
  }
} // namespace asperity
