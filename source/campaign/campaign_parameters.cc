#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/campaign/campaign_parameters.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity
{
  namespace
  {
    std::string
    section(const unsigned int number)
    {
      return "Input " + std::to_string(number);
    }
  } // namespace



  void
  InputParameters::declare(ParameterDeclarator &parameters,
                           const unsigned int   number)
  {
    const auto in_section = parameters.subsection(section(number));
    parameters.text("Entry",
                    entry,
                    "The entry of the base scene that is varied, by its path, "
                    "such as Load/Pressure; empty: this input is not used.");
    parameters.text("From", from, "Lower end of its range, with a unit.");
    parameters.text("To", to, "Upper end of its range, with a unit.");
    parameters.choice("Scale",
                      scale,
                      {{"linear", Scale::linear},
                       {"logarithmic", Scale::logarithmic}},
                      "On which scale points are spread evenly and the law is "
                      "smooth; `logarithmic` for a range over decades.");
    parameters.text(
      "Export at",
      export_at,
      "Value of this input, with a unit, in exported tables, which "
      "are over pressure, velocity and temperature alone; C, "
      "Fortran and Python also take it as an argument. Empty: the "
      "base scene's value if it lies in the range, else the middle "
      "of the range.");
  }



  std::string
  InputParameters::path() const
  {
    return join(split(entry, '/'), "/");
  }



  void
  DesignParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Design");
    parameters.choice(
      "Kind",
      kind,
      {{"Sobol", DesignKind::sobol},
       {"Latin hypercube", DesignKind::latin_hypercube},
       {"grid", DesignKind::grid}},
      "How the points of the first runs fill the box: `Sobol`, a "
      "sequence of low discrepancy; `Latin hypercube`, each input "
      "in evenly filled strata; `grid`, every combination of evenly "
      "spread values.");
    parameters.integer("Initial runs",
                       initial_runs,
                       Range::between(3, FrictionLaw::largest_number_of_runs),
                       "Points of the first design, at least two more than "
                       "inputs; a grid has its own.");
    parameters.list("Grid points",
                    grid_points,
                    "1",
                    Range::between(2, 1000),
                    "Values of each input in a grid, in the order of the "
                    "inputs, both ends included.");
    parameters.integer("Batch",
                       batch,
                       Range::between(0, 1000),
                       "Points that active learning adds at a time, where the "
                       "law is least certain; 0 ends with the first design.");
    parameters.integer("Maximum runs",
                       maximum_runs,
                       Range::between(3, FrictionLaw::largest_number_of_runs),
                       "Active learning ends with this number of training "
                       "points.");
    parameters.number("Target error",
                      target_error,
                      Range::positive(),
                      "Active learning ends when the mean relative error of "
                      "cross-validation (leave one out) stays below this.");
    parameters.integer("Test runs",
                       test_runs,
                       Range::between(0, 100000),
                       "Random points that are computed to judge the law and "
                       "never used to train it.");
    parameters.file("Test table",
                    test_table,
                    "The runs.csv of another campaign with the same inputs, "
                    "whose test runs judge this law, too.");
    parameters.integer("Seed",
                       seed,
                       Range::between(0, 1000000000),
                       "Of random points; the same seed gives the same points "
                       "on every machine.");
  }



  namespace
  {
    void
    declare_plane_strain(ParameterDeclarator &parameters,
                         double              &below,
                         double              &above)
    {
      parameters.number(
        "Plane strain below",
        below,
        Range{0., 1., true, false},
        "How far mu of the surface may lie below that of its "
        "profiles in plane strain, as a share of it, found by "
        "patches in three dimensions. The law says so. Not stated "
        "if this and the next are 0.");
      parameters.number("Plane strain above",
                        above,
                        Range::non_negative(),
                        "The same above it.");
    }
  } // namespace



  void
  LawParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Friction law");
    parameters.choice("Output",
                      output,
                      {{"mu", LawOutput::mu},
                       {"mu at the end", LawOutput::mu_end}},
                      "The result that the law gives: `mu` over the friction "
                      "window of the base scene, or `mu at the end` of it.");
    parameters.choice("Kernel",
                      kernel,
                      {{"RBF", KernelKind::rbf},
                       {"Matern 3/2", KernelKind::matern_3_2},
                       {"Matern 5/2", KernelKind::matern_5_2}},
                      "Covariance of the Gaussian process: how smooth the law "
                      "is taken to be, infinitely, once or twice "
                      "differentiable. `Matern 3/2` has the most honest band "
                      "where asperities come into contact one by one.");
    parameters.choice("Output scale",
                      output_scale,
                      {{"logarithmic", Scale::logarithmic},
                       {"linear", Scale::linear}},
                      "Whether the process is fitted to ln(mu), for relative "
                      "errors and a law that stays positive, or to mu.");
    parameters.choice(
      "Pressure scale",
      pressure_scale,
      {{"pressure", PressureScale::as_it_is},
       {"pressure over shear strength", PressureScale::over_strength},
       {"logarithm of pressure over shear strength",
        PressureScale::logarithm_over_strength}},
      "What the process sees of an input Load/Pressure: the pressure, or "
      "`pressure over shear strength` k of the chip at the temperature and "
      "plastic strain of the point. The latter halves the error where what "
      "touches grows over much of the range; it needs a chip that yields. The "
      "logarithm, however the points are spread, is for what changes fastest at "
      "low pressure.");
    parameters.number("Largest trusted deviation",
                      largest_trusted_deviation,
                      Range::positive(),
                      "Standard deviation over mean up to which a prediction "
                      "inside the ranges is called trusted.");
    parameters.number("Shear limit strain",
                      shear_strain,
                      Range::non_negative(),
                      "Plastic strain of the chip at which its shear strength "
                      "k, the limit of the friction stress, is taken.");
    parameters.quantity("Shear limit rate",
                        shear_rate,
                        "1/s",
                        Range::positive(),
                        "Strain rate at which k is taken.");
    parameters.file("Sensitivity file",
                    sensitivity,
                    "The sensitivity.json that `asperity sensitivity` has made "
                    "of the base scene: the law says how far the choices that "
                    "were varied there may move it.");
    declare_plane_strain(parameters, plane_strain_below, plane_strain_above);
  }



  void
  ExportParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Export");
    parameters.flag("Write",
                    write,
                    "Write the law as C, Fortran and tables for other programs "
                    "into the folder `export`.");
    parameters.number("Table tolerance",
                      table_tolerance,
                      Range{1e-6, 1., true, false},
                      "Largest relative error of linear interpolation in the "
                      "tables; their grids are refined until they keep it.");
  }



  void
  CampaignParameters::declare(ParameterDeclarator &parameters)
  {
    {
      const auto in_section = parameters.subsection("Campaign");
      parameters.file("Base scene",
                      base_scene,
                      "Parameter file of the scene that is varied; its "
                      "Accuracy/Control does not count.",
                      Need::mandatory);
      parameters.text("Output directory",
                      directory,
                      "Folder of the campaign; one that holds results goes on "
                      "from them.");
      parameters.text(
        "Profile positions",
        profile_positions,
        "Values of the base scene's Tool/Topography/Profile "
        "position, separated by commas: every point is computed "
        "on each profile, mu is their mean, and their scatter "
        "tells how well it is known for the whole surface. Empty: one profile.");
      parameters.flag("Repeat failed runs",
                      repeat_failed_runs,
                      "Try runs again that failed in an earlier session.");
      for (unsigned int i = 0; i < inputs.size(); ++i)
        inputs[i].declare(parameters, i + 1);
      design.declare(parameters);
    }
    law.declare(parameters);
    exports.declare(parameters);
  }



  void
  CampaignParameters::check_input(const ParameterDeclarator &parameters,
                                  const std::size_t          number) const
  {
    const std::string      path  = "Campaign/" + section(number + 1) + "/";
    const InputParameters &input = inputs[number];
    for (const auto &[key, text] :
         {std::make_pair("From", input.from), {"To", input.to}})
      if (text.empty())
        throw InputError(parameters.where(path + key) +
                         ": found nothing for the input " +
                         quoted_name(input.path()) +
                         "; expected an end of its range with a unit, such "
                         "as 300 MPa.");
    for (std::size_t j = 0; j < number; ++j)
      if (inputs[j].path() == input.path())
        throw InputError(parameters.where(path + "Entry") + ": " +
                         quoted_name(input.path()) + " is already " +
                         section(j + 1) + "; expected each entry once.");
  }



  void
  CampaignParameters::check_profiles(
    const ParameterDeclarator &parameters) const
  {
    std::set<std::string> seen;
    for (const std::string &position : split(profile_positions, ','))
      if (position.empty() || !seen.insert(position).second)
        throw InputError(parameters.where("Campaign/Profile positions") +
                         ": found " +
                         (position.empty() ? "nothing between two commas" :
                                             quoted_text(position) + " twice") +
                         "; expected positions that differ.");
  }



  double
  DesignParameters::n_first_runs() const
  {
    if (kind != DesignKind::grid)
      return initial_runs;
    double n = 1.;
    for (const double n_values : grid_points)
      n *= n_values;
    return n;
  }



  void
  DesignParameters::check(const ParameterDeclarator &parameters,
                          const std::size_t          n_inputs) const
  {
    const std::string grid = parameters.where("Campaign/Design/Grid points");
    if (kind == DesignKind::grid && grid_points.size() != n_inputs)
      throw InputError(grid + ": found " + std::to_string(grid_points.size()) +
                       " numbers; expected one for each of the " +
                       std::to_string(n_inputs) + " inputs.");
    for (const double n : grid_points)
      if (n != std::round(n))
        throw InputError(grid + ": found " + format_number(n) +
                         "; expected whole numbers.");

    const double      n    = n_first_runs();
    const std::size_t need = n_inputs + 2;
    const std::string where =
      kind == DesignKind::grid ?
        grid :
        parameters.where("Campaign/Design/Initial runs");
    if (n < need || n > FrictionLaw::largest_number_of_runs)
      throw InputError(
        where + ": found " + format_number(n) + " runs; expected at least " +
        std::to_string(need) + " for a law of " + std::to_string(n_inputs) +
        (n_inputs == 1 ? " input" : " inputs") + " and at most " +
        std::to_string(FrictionLaw::largest_number_of_runs) + ".");
    if (batch > 0 && maximum_runs < n)
      throw InputError(parameters.where("Campaign/Design/Maximum runs") +
                       ": found " + std::to_string(maximum_runs) +
                       "; expected at least the " + format_number(n) +
                       " initial runs.");
  }



  void
  CampaignParameters::check(const ParameterDeclarator &parameters) const
  {
    if (trim(directory).empty())
      throw InputError(parameters.where("Campaign/Output directory") +
                       ": found nothing; expected a folder for the campaign.");
    std::size_t n_inputs = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (!inputs[i].entry.empty())
        {
          ++n_inputs;
          check_input(parameters, i);
        }
    if (n_inputs == 0)
      throw InputError(parameters.where("Campaign/Input 1/Entry") +
                       ": found no input; expected at least one entry of the "
                       "base scene, such as Load/Pressure.");
    check_profiles(parameters);
    design.check(parameters, n_inputs);
  }
} // namespace asperity
