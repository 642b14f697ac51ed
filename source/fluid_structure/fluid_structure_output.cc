#include <asperity/base/version.h>
#include <asperity/fluid_structure/fluid_structure_output.h>
#include <asperity/postprocess/summary.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using json = nlohmann::ordered_json;

  namespace
  {
    /** Up to which step pictures stay. */
    int
    kept(const FluidStructureRun &run)
    {
      return run.rows().empty() ? VtuSeries::keep_nothing :
                                  static_cast<int>(run.rows().size());
    }

    /** VTU has seven digits: in an enclosed fluid the differences may be less
     *  than a millionth of the pressure. */
    class PressureDifference : public dealii::DataPostprocessorScalar<2>
    {
    public:
      explicit PressureDifference(const double mean)
        : dealii::DataPostprocessorScalar<2>("pressure less its mean",
                                             dealii::update_values)
        , mean(mean)
      {}

      void
      evaluate_vector_field(
        const dealii::DataPostprocessorInputs::Vector<2> &inputs,
        std::vector<dealii::Vector<double>>              &values) const override
      {
        for (unsigned int q = 0; q < values.size(); ++q)
          values[q](0) = inputs.solution_values[q](2) - mean;
      }

    private:
      double mean;
    };

    ChipOutput<2>
    make_body_output(const FluidStructureRun &run, const unsigned int n)
    {
      const FluidStructure &system = *run.problem().system;
      return ChipOutput<2>(
        *system.body().space,
        system.body().geometry,
        n,
        static_cast<unsigned int>(std::lround(
          std::sqrt(system.body_assembler().table().points_per_element))));
    }
  } // namespace



  FluidStructureOutput::FluidStructureOutput(
    const FluidStructureParameters &parameters,
    const InputRecord              &inputs,
    const FluidStructureRun        &run)
    : parameters(parameters)
    , inputs(inputs)
    , table(parameters.output.directory + "/fluid_structure.csv",
            FluidStructureRow::columns())
    , body_output(make_body_output(run, parameters.output.subdivisions))
    , fluid(parameters.output.directory, "fluid", kept(run))
    , body(parameters.output.directory, "body", kept(run))
    , checkpoints(parameters.output.directory + "/checkpoint")
    , last_picture(run.rows().size())
  {
    for (const FluidStructureRow &row : run.rows())
      table.append(row.values());
  }



  void
  FluidStructureOutput::step(const FluidStructureRun &run)
  {
    table.append(run.rows().back().values());
    const unsigned int      step   = run.rows().size();
    const OutputParameters &output = parameters.output;
    if (output.picture_interval > 0 && step % output.picture_interval == 0)
      write_pictures(run);
    if (output.checkpoint_interval > 0 &&
        step % output.checkpoint_interval == 0)
      write_checkpoint(run);
  }



  void
  FluidStructureOutput::write_checkpoint(const FluidStructureRun &run) const
  {
    checkpoints.write({version_line(), inputs, run.save()}, run.rows().size());
  }



  void
  FluidStructureOutput::write_pictures(const FluidStructureRun &run)
  {
    const FluidStructure &system = *run.problem().system;
    const unsigned int    step   = run.rows().size();
    last_picture                 = step;
    fluid.write(step, run.time(), [&](std::ostream &out) {
      const NavierStokes      &flow = system.flow();
      const PressureDifference difference(run.problem().mean_pressure());
      dealii::DataOut<2>       data;
      flow.attach_to(data);
      data.add_data_vector(flow.space().dofs(), flow.solution(), difference);
      data.build_patches(flow.mapping(),
                         flow.space().degree(),
                         dealii::DataOut<2>::curved_inner_cells);
      data.set_flags(dealii::DataOutBase::VtkFlags(run.time(), step));
      data.write_vtu(out);
    });
    ChipFields fields;
    fields.displacement       = system.solid().displacement();
    fields.quadrature_scalars = {
      {"von Mises stress [Pa]", system.body_assembler().mises_stress()}};
    body.write(step, run.time(), [&](std::ostream &out) {
      body_output.write(out, fields, run.time(), step);
    });
  }



  void
  FluidStructureOutput::finish(const FluidStructureRun        &run,
                               const std::vector<std::string> &warnings,
                               const double                    wall_time)
  {
    if (last_picture != run.rows().size())
      write_pictures(run);
    const FluidStructure    &system       = *run.problem().system;
    const FluidStructureRow &last         = run.rows().back();
    double                   n_iterations = 0., most = 0.;
    for (const FluidStructureRow &row : run.rows())
      {
        n_iterations += row.iterations;
        most = std::max(most, row.iterations);
      }
    json summary;
    summary["program"]        = version_json();
    summary["problem"]        = name(parameters.problem.kind);
    summary["end"]            = {{"time", last.time},
                                 {"displacement",
                                  {last.displacement[0], last.displacement[1]}},
                                 {"drag", last.force[0]},
                                 {"lift", last.force[1]},
                                 {"mean_pressure", last.mean_pressure},
                                 {"volume", last.volume}};
    summary["initial_volume"] = run.initial_volume();
    summary["coupling"]       = {{"iterations_per_step",
                                  n_iterations / run.rows().size()},
                                 {"most_iterations", most}};
    summary["mesh"]           = {
                {"fluid_cells", run.problem().mesh.n_active_cells()},
                {"fluid_unknowns", system.flow().space().dofs().n_dofs()},
                {"body_cells", system.body().space->n_cells()},
                {"body_unknowns", 2 * system.body().space->n_functions()}};
    summary["cost"]     = {{"wall_time", wall_time},
                           {"steps", run.rows().size()},
                           {"cuts", run.n_cuts()}};
    summary["warnings"] = warnings;
    write_summary(parameters.output.directory + "/summary.json", summary);
  }
} // namespace asperity
