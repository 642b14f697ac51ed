#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/contact_zone/lubrication_parameters.h>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, LubricantModel>> models = {
      {"automatic", LubricantModel::automatic},
      {"none", LubricantModel::none},
      {"pocket", LubricantModel::pocket},
      {"Reynolds", LubricantModel::reynolds},
      {"Stokes", LubricantModel::stokes},
      {"Navier-Stokes", LubricantModel::navier_stokes}};
  } // namespace



  std::string
  name(const LubricantModel model)
  {
    for (const auto &entry : models)
      if (entry.second == model)
        return entry.first;
    return "";
  }



  bool
  fills_gap(const LubricantModel model)
  {
    return model == LubricantModel::stokes ||
           model == LubricantModel::navier_stokes;
  }



  void
  FilmMeshParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Film mesh");
    parameters.integer("Columns per span",
                       columns_per_span,
                       Range::between(1, 100),
                       "Models `Stokes` and `Navier-Stokes`: columns of the "
                       "oil's quadratic cells on a span of the chip's edge.");
    parameters.integer("Rows",
                       rows,
                       Range::between(1, 100),
                       "Models `Stokes` and `Navier-Stokes`: cells between "
                       "chip and tool.");
  }



  void
  FlowParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Flow");
    parameters.choice("Mesh update",
                      mesh_update,
                      {{"columns", MeshUpdateKind::columns},
                       {"elastic", MeshUpdateKind::elastic}},
                      "How the nodes inside of the gap follow its walls: "
                      "`columns`, in fixed shares of the gap's height; "
                      "`elastic`, as those of a linear elastic body, as in Lee "
                      "(2025).");
    parameters.number("Stiffening",
                      stiffening,
                      Range::between(0., 4.),
                      "Mesh update `elastic`: exponent chi of (J_0/J)^chi, "
                      "with which small cells are stiffer than large ones.");
    parameters.choice("Time scheme",
                      time_scheme,
                      {{"BDF2", FluidTimeScheme::bdf2},
                       {"implicit Euler", FluidTimeScheme::implicit_euler}},
                      "`BDF2`, of second order; `implicit Euler`, of first "
                      "order, as in Lee (2025).");
    parameters.choice("Element",
                      element,
                      {{"Taylor-Hood", FluidElement::taylor_hood},
                       {"equal order", FluidElement::equal_order}},
                      "`Taylor-Hood`, the velocity quadratic and the pressure "
                      "linear; `equal order`, both quadratic, stabilised by "
                      "SUPG, PSPG and LSIC terms.");
    parameters.choice("Solver",
                      solver,
                      {{"direct", FlowSolverKind::direct},
                       {"Krylov", FlowSolverKind::krylov}},
                      "Of the linear systems of the flow: `direct`, a "
                      "factorisation; `Krylov`, an iteration with a "
                      "block preconditioner, in half the memory.");
    parameters.flag("Compressible",
                    compressible,
                    "Whether the density law of the oil counts in the flow, so "
                    "that enclosed oil has the pressure of its density; false: "
                    "the oil keeps its volume, as in Lee (2025).");
    declare_ends(parameters);
    parameters.quantity("Initial pressure",
                        initial_pressure,
                        "MPa",
                        Range::between(0., 1e10),
                        "Pressure that the oil has before the first step, in "
                        "which the chip feels it.");
  }



  void
  FlowParameters::declare_ends(ParameterDeclarator &parameters)
  {
    for (const bool is_left : {true, false})
      {
        GapEnd           &end  = is_left ? left : right;
        const std::string name = is_left ? "left" : "right";
        parameters.choice("Boundary " + name,
                          end.kind,
                          {{"periodic", GapEndKind::periodic},
                           {"pressure", GapEndKind::pressure},
                           {"resistance", GapEndKind::resistance}},
                          "What the oil meets at the " + name +
                            " end of the period: `periodic`, the other end; "
                            "`pressure`, a reservoir; `resistance`, a "
                            "reservoir behind a resistance. Chip and tool stay "
                            "periodic, and open ends go with the chip.");
        parameters.quantity("Pressure " + name,
                            end.pressure,
                            "MPa",
                            Range::between(0., 1e10),
                            "Of the reservoir at an open " + name + " end.");
        parameters.quantity("Resistance " + name,
                            end.resistance,
                            "MPa s/m",
                            Range::between(1., 1e18),
                            "R of the " + name +
                              " end: the pressure there is that of the "
                              "reservoir plus R times the mean velocity of "
                              "the oil that leaves. A channel of length l and "
                              "height h has R = 12 eta l/h^2.");
      }
  }



  void
  LubricationParameters::declare(ParameterDeclarator &parameters)
  {
    {
      const auto in_section = parameters.subsection("Lubrication");
      parameters.choice("Model",
                        model,
                        models,
                        "What the oil between tool and chip is: `none`, dry "
                        "contact; `pocket`, liquid enclosed in the voids, one "
                        "pressure a pocket, no flow; `Reynolds`, a thin film "
                        "that flows, cavitates and shears; `Stokes` and "
                        "`Navier-Stokes`, the flow in the whole gap, without "
                        "and with the inertia of the oil, which "
                        "fills the void; `automatic`, as the scene audit "
                        "says.");
      declare_amount(parameters);
      parameters.quantity("Sealing gap",
                          sealing_gap,
                          "nm",
                          Range::between(0., 1e-4),
                          "Models `pocket`, `Stokes` and `Navier-Stokes`: "
                          "where the gap is smaller, the surfaces seal, and "
                          "the void on each side is a pocket with a pressure "
                          "of its own; 0: all voids are connected, with flow "
                          "by the residual film.");
      parameters.list("Pockets",
                      pockets,
                      "um",
                      Range::between(0., 0.1),
                      "Models `Stokes` and `Navier-Stokes` with a Sealing gap: "
                      "which pockets hold oil at the start, by intervals of x, "
                      "from and to by turns, one in each pocket; the others "
                      "are dry. Empty: all hold oil.");
      parameters.quantity("Residual film",
                          residual_film,
                          "nm",
                          Range::between(1e-11, 1e-6),
                          "Models with flow: the thickness of the film where "
                          "the surfaces touch; of no effect in `Stokes` and "
                          "`Navier-Stokes` with a sealing gap.");
    }
    oil.declare(parameters);
    mesh.declare(parameters);
    flow.declare(parameters);
    coupling.declare(parameters);
  }



  void
  LubricationParameters::declare_amount(ParameterDeclarator &parameters)
  {
    parameters.choice("Oil amount",
                      amount,
                      {{"part of void at start", OilAmount::void_at_start},
                       {"part of void at touch", OilAmount::void_at_touch},
                       {"film thickness", OilAmount::film_thickness}},
                      "How much oil there is: `part of void at start`, "
                      "Wetting of the void between the surfaces at the "
                      "start, to which the initial gap belongs; `part of "
                      "void at touch`, Wetting of what is left of it when "
                      "they touch; `film thickness`, Oil film. The last two "
                      "do not depend on the initial gap, which grows if the "
                      "oil has no room in it.");
    parameters.number("Wetting",
                      wetting,
                      Range::between(0., 1.),
                      "w, the part of the void between the surfaces that "
                      "holds oil, as Oil amount says: 0 dry, 1 flooded.");
    parameters.quantity("Oil film",
                        film,
                        "nm",
                        Range::between(0., 1e-4),
                        "Volume of oil over area, as minimum quantity "
                        "lubrication doses it, where Oil amount is `film "
                        "thickness`.");
  }



  CouplingParameters
  LubricationParameters::default_coupling()
  {
    CouplingParameters coupling;
    coupling.acceleration.reused_steps = 2;
    coupling.acceleration.filter       = 0.03;
    return coupling;
  }



  GapFlowOptions
  LubricationParameters::gap_flow() const
  {
    GapFlowOptions options;
    options.oil              = oil;
    options.inertia          = model == LubricantModel::navier_stokes;
    options.residual_film    = residual_film;
    options.sealing_gap      = sealing_gap;
    options.columns_per_span = mesh.columns_per_span;
    options.rows             = mesh.rows;
    options.mesh_update      = flow.mesh_update;
    options.stiffening       = flow.stiffening;
    options.scheme           = flow.time_scheme;
    options.element          = flow.element;
    options.linear_solver    = flow.solver;
    options.compressible     = flow.compressible;
    options.wetting          = wetting;
    for (std::size_t i = 0; i + 1 < pockets.size(); i += 2)
      options.pockets.emplace_back(pockets[i], pockets[i + 1]);
    options.left             = flow.left;
    options.right            = flow.right;
    options.initial_pressure = flow.initial_pressure;
    return options;
  }



  void
  LubricationParameters::check(const ParameterDeclarator &parameters) const
  {
    if (model == LubricantModel::none || model == LubricantModel::automatic)
      return;
    check_amount(parameters);
    check_ends(parameters);
    oil.check(parameters);
    if (fills_gap(model))
      {
        check_flow(parameters);
        check_pockets(parameters);
      }
  }



  void
  LubricationParameters::check_pockets(
    const ParameterDeclarator &parameters) const
  {
    const auto refuse = [&](const std::string &what) {
      throw InputError(parameters.where("Lubrication/Pockets") + ": found " +
                       what);
    };
    if (pockets.empty())
      return;
    if (sealing_gap == 0.)
      refuse("intervals without a Sealing gap, so that all voids are one; "
             "expected a Sealing gap, or nothing.");
    if (pockets.size() % 2 == 1)
      refuse(std::to_string(pockets.size()) +
             " values; expected two for each interval, from and to.");
    for (std::size_t i = 1; i < pockets.size(); ++i)
      if (pockets[i] <= pockets[i - 1])
        refuse(format_quantity(pockets[i], "um") + " behind " +
               format_quantity(pockets[i - 1], "um") +
               "; expected increasing values, so that no interval is empty or "
               "overlaps another one.");
  }



  void
  LubricationParameters::check_flow(const ParameterDeclarator &parameters) const
  {
    const bool has_law = oil.compressibility.law != DensityLaw::incompressible;
    if (flow.compressible && !has_law)
      throw InputError(parameters.where("Flow/Compressible") +
                       ": found true with the Density law incompressible; "
                       "expected false, or a law that tells the density over "
                       "the pressure.");
    if (!flow.compressible && flow.left.kind == GapEndKind::periodic &&
        coupling.scheme == CouplingScheme::dirichlet_neumann)
      throw InputError(parameters.where("Coupling/Scheme") +
                       ": found Dirichlet-Neumann with incompressible oil, "
                       "which is enclosed, so that a prescribed motion of its "
                       "walls contradicts its volume; expected Robin-Neumann, "
                       "Flow/Compressible = true or open ends.");
  }



  void
  LubricationParameters::check_ends(const ParameterDeclarator &parameters) const
  {
    const auto is_open = [](const GapEnd &end) {
      return end.kind != GapEndKind::periodic;
    };
    if (!fills_gap(model) || (!is_open(flow.left) && !is_open(flow.right)))
      return;
    if (is_open(flow.left) != is_open(flow.right))
      {
        const std::string entry =
          is_open(flow.left) ? "Flow/Boundary right" : "Flow/Boundary left";
        throw InputError(parameters.where(entry) +
                         ": found periodic, but the other end is open; "
                         "expected pressure or resistance, or both ends "
                         "periodic.");
      }
    if (flow.compressible)
      throw InputError(parameters.where("Flow/Compressible") +
                       ": found true, but an end of the gap is open, where "
                       "oil is counted by its volume; expected false, or "
                       "Flow/Boundary left and Boundary right periodic.");
    if (sealing_gap > 0.)
      throw InputError(parameters.where("Lubrication/Sealing gap") +
                       ": found " + format_quantity(sealing_gap, "nm") +
                       ", but an end of the gap is open, and would be shut "
                       "and opened as the surfaces slide; expected 0, or "
                       "Flow/Boundary left and Boundary right periodic.");
  }



  void
  LubricationParameters::check_amount(
    const ParameterDeclarator &parameters) const
  {
    const bool        by_film = amount == OilAmount::film_thickness;
    const std::string entry =
      by_film ? "Lubrication/Oil film" : "Lubrication/Wetting";
    if ((by_film ? film : wetting) == 0.)
      throw InputError(parameters.where(entry) +
                       ": found 0, so that there is no oil; expected a "
                       "positive number, or the model `none`.");
    if (fills_gap(model) && amount != OilAmount::void_at_start)
      throw InputError(parameters.where("Lubrication/Oil amount") + ": found " +
                       parameters.get("Lubrication/Oil amount") +
                       ", but the model `" + name(model) +
                       "` fills the void with oil; expected part of void at "
                       "start, or the model `pocket` or `Reynolds`.");
    if (fills_gap(model) && wetting != 1. && sealing_gap == 0.)
      throw InputError(parameters.where("Lubrication/Wetting") + ": found " +
                       format_number(wetting) + ", but the model `" +
                       name(model) +
                       "` fills the void with oil; expected 1, a Sealing gap, "
                       "or the model `pocket` or `Reynolds`.");
  }
} // namespace asperity
