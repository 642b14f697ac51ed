#include <asperity/contact_zone/scene_output.h>

namespace asperity
{
  namespace
  {
    /** Rows and points as flat lists of numbers, and back. */
    std::vector<double>
    pack(const std::vector<FrictionRow> &rows)
    {
      std::vector<double> list;
      for (const FrictionRow &row : rows)
        for_each_entry(row, [&](const auto entry) { list.push_back(entry); });
      return list;
    }

    std::vector<FrictionRow>
    unpack(const std::vector<double> &list)
    {
      std::vector<FrictionRow> rows;
      auto                     value = list.begin();
      while (value != list.end())
        {
          rows.emplace_back();
          for_each_entry(rows.back(), [&](auto &entry) { entry = *value++; });
        }
      return rows;
    }

    std::vector<double>
    pack(const std::vector<MaterialState> &history)
    {
      std::vector<double> list;
      for (const MaterialState &point : history)
        {
          list.insert(list.end(),
                      point.Cp_inverse.begin(),
                      point.Cp_inverse.end());
          list.push_back(point.plastic_strain);
          list.push_back(point.temperature);
        }
      return list;
    }

    dealii::Vector<double>
    to_vector(const std::vector<double> &list)
    {
      return dealii::Vector<double>(list.begin(), list.end());
    }
  } // namespace



  Checkpoint
  save(const SlidingRun &run, const Scene &scene)
  {
    const RunState &state = run.state();
    Checkpoint      checkpoint;
    checkpoint.set("step", std::vector<std::int64_t>{state.step});
    checkpoint.set("time", std::vector<double>{state.time, state.dt_previous});
    checkpoint.set("u", state.u.begin(), state.u.end());
    checkpoint.set("u_previous",
                   state.u_previous.begin(),
                   state.u_previous.end());
    checkpoint.set("rows", pack(state.rows));
    checkpoint.set("history", pack(scene.chip->history()));
    checkpoint.set("multipliers", scene.contact->multipliers());
    checkpoint.set("hints", scene.contact->hints());
    if (scene.lubricant)
      checkpoint.set("lubricant", scene.lubricant->save());
    if (const LubricatedStep *step = run.lubricated_step())
      checkpoint.set("lubricated step", step->save());
    if (const GeneralizedAlpha *dynamics = run.dynamics())
      {
        checkpoint.set("velocity", dynamics->v.begin(), dynamics->v.end());
        checkpoint.set("acceleration", dynamics->a.begin(), dynamics->a.end());
        checkpoint.set("old forces",
                       run.old_forces.begin(),
                       run.old_forces.end());
      }
    return checkpoint;
  }



  void
  load(const Checkpoint &checkpoint, SlidingRun &run, Scene &scene)
  {
    const std::size_t n = scene.n_unknowns();
    RunState          state;
    state.step        = checkpoint.integers("step").at(0);
    state.time        = checkpoint.doubles("time", 2)[0];
    state.dt_previous = checkpoint.doubles("time", 2)[1];
    state.u           = to_vector(checkpoint.doubles("u", n));
    state.u_previous  = to_vector(checkpoint.doubles("u_previous", n));
    state.rows        = unpack(checkpoint.doubles("rows"));
    std::vector<MaterialState> history(scene.chip->history().size());
    const double              *value =
      checkpoint.doubles("history", 6 * history.size()).data();
    for (MaterialState &point : history)
      {
        for (double &component : point.Cp_inverse)
          component = *value++;
        point.plastic_strain = *value++;
        point.temperature    = *value++;
      }
    scene.chip->set_history(history);
    scene.contact->set_multipliers(
      checkpoint.doubles("multipliers", scene.contact->multipliers().size()));
    scene.contact->set_hints(
      checkpoint.doubles("hints", scene.contact->hints().size()));
    if (scene.lubricant)
      scene.lubricant->load(checkpoint.doubles("lubricant"));
    if (LubricatedStep *step = run.lubricated_step())
      step->load(checkpoint.doubles("lubricated step"));
    if (GeneralizedAlpha *dynamics = run.dynamics())
      {
        dynamics->u    = state.u;
        dynamics->v    = to_vector(checkpoint.doubles("velocity", n));
        dynamics->a    = to_vector(checkpoint.doubles("acceleration", n));
        run.old_forces = to_vector(checkpoint.doubles("old forces", n));
      }
    run.set_state(state);
  }
} // namespace asperity
