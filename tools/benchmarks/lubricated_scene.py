#!/usr/bin/python3
"""What each rung of the lubricant ladder says, and what it costs.

Usage: tools/benchmarks/lubricated_scene.py [--asperity PROGRAM] [--to FOLDER]
                                            [--flow] TASK

  ladder   the eight load cases of R0 with all rungs, at the wettings 0.6 (dry,
           pocket, Reynolds) and 1; with --flow also Stokes and Navier-Stokes,
           which are the rungs that take a minute each
  wetting  mu, contact fraction and oil pressure over the wetting, pocket and
           Reynolds, at 300 MPa, 200 m/min, 25 degC
  film     the Reynolds rung over the thickness of its residual film
  thin     the Reynolds rung at wetting 0.6 with oil that is ever thinner, and
           the pocket that it must become
  flooded  the sixteen reference scenes full of oil, with the model of
           Lee (2025: dynamic, incompressible Navier-Stokes), with an incompressible
           film, and with what the audit chooses
  pockets  the same scenes where the gap is cut below a sealing gap, beside the
           other rungs: contact, pressure in the pockets, thrust

Tables go to the screen in Markdown, charts as PNG into FOLDER (default
output/benchmarks). Run it on a quiet machine; compare within one run only.
"""

import argparse
import csv
import os
import sys

from dry_scene import ROOT, load_case, print_head, run

sys.path.insert(0, os.path.join(ROOT, "tools"))
from run_output import part_at  # noqa: E402

CASES = [(p, v, T) for p in (300, 1300) for v in (22.5, 200) for T in (25, 675)]
HEAD = ("mu | contact fraction | oil pressure [MPa] | share of the load | "
        "mu by shear | steps | Newton iterations | wall time [s]")
FLOODED = {"flow": {},
           "film": {"Lubrication/Model": "Reynolds",
                    "Lubricant/Density law": "incompressible",
                    "Protocol/Inertia": "automatic"},
           "audit": {"Lubrication/Model": "automatic",
                     "Protocol/Inertia": "automatic"}}
CUT = {"Lubrication/Sealing gap": "60 nm"}
FLOODED_POCKETS = {
    "one gap": {},
    "pockets below 20 nm": {"Lubrication/Sealing gap": "20 nm"},
    "pockets below 60 nm": CUT,
    "pockets below 60 nm, compressible": {**CUT, "Flow/Compressible": "true"},
    "pocket without flow, compressible": {**CUT, "Lubrication/Model": "pocket",
                                          "Protocol/Inertia": "automatic"},
    "film, compressible": {"Lubrication/Model": "Reynolds",
                           "Protocol/Inertia": "automatic"}}
FLOODED_LABELS = {"flow": "Navier-Stokes, incompressible, dynamic",
                  "film": "Reynolds, incompressible",
                  "audit": "the audit's choice, compressible"}
COLOURS = {"none": "#9aa0a6", "pocket": "#12355b", "Reynolds": "#c1553b",
           "Stokes": "#6a8d73", "Navier-Stokes": "#8e6bbf"}


def rung(model, wetting):
    return {"Lubrication/Model": model, "Lubrication/Wetting": wetting}


def row(summary):
    oil, friction, cost = (summary.get("oil", {}), summary["friction"],
                           summary["cost"])
    shear = abs(oil.get("T_x_shear", 0.) / friction["T_y"])
    return (f"{friction['mu']:.5f} | {summary['contact_fraction']:.4f} | "
            f"{oil.get('pressure', 0.) * 1e-6:.1f} | "
            f"{oil.get('load_share', 0.):.3f} | {shear:.5f} | "
            f"{cost['steps']} | {cost['newton_iterations']} | "
            f"{cost['wall_time']:.1f}")


def ladder(arguments):
    print_head("p [MPa] | v [m/min] | T [degC] | wetting | model | " + HEAD)
    results = {}
    for case in CASES:
        rungs = [("none", 0.), ("pocket", 0.6), ("Reynolds", 0.6),
                 ("pocket", 1.), ("Reynolds", 1.)]
        if arguments.flow:
            rungs += [("Stokes", 1.), ("Navier-Stokes", 1.)]
        for model, wetting in rungs:
            name = "ladder_p{}_v{}_T{}_".format(*case) + f"{model}_{wetting}"
            summary = run(arguments, name,
                          {**load_case(*case), **rung(model, wetting)})
            results[case, wetting, model] = summary["friction"]["mu"]
            print("| {} | {} | {} | ".format(*case) +
                  f"{wetting} | {model} | {row(summary)} |", flush=True)
    chart_ladder(arguments, results)


def chart_ladder(arguments, results):
    plt = pyplot()
    figure, panels = plt.subplots(1, 2, figsize=(11, 4), sharey=True)
    for axes, wetting in zip(panels, (0.6, 1.)):
        models = [m for m in COLOURS
                  if (CASES[0], 0. if m == "none" else wetting, m) in results]
        width = 0.8 / len(models)
        for i, model in enumerate(models):
            of_model = 0. if model == "none" else wetting
            axes.bar([j + (i - 0.5 * (len(models) - 1)) * width
                      for j in range(len(CASES))],
                     [results[case, of_model, model] for case in CASES],
                     width, label="dry" if model == "none" else model,
                     color=COLOURS[model])
        label_cases(axes)
        axes.set_title(f"wetting {wetting:g}", fontsize=10)
    panels[0].set_ylabel("mu")
    save(figure, arguments, "lubricant_ladder.png")


def wetting(arguments):
    print_head("model | wetting | " + HEAD)
    values = (0.3, 0.4, 0.5, 0.55, 0.6, 0.7, 0.8, 0.9, 1.)
    plt = pyplot()
    figure, panels = plt.subplots(1, 3, figsize=(12, 3.6))
    for model in ("pocket", "Reynolds"):
        summaries = []
        for value in values:
            summaries.append(run(arguments, f"wetting_{model}_{value}",
                                 {**load_case(300, 200, 25),
                                  **rung(model, value)}))
            print(f"| {model} | {value} | {row(summaries[-1])} |", flush=True)
        curves = ([s["friction"]["mu"] for s in summaries],
                  [s["contact_fraction"] for s in summaries],
                  [s["oil"]["pressure"] * 1e-6 for s in summaries])
        for axes, curve in zip(panels, curves):
            axes.plot(values, curve, "o-", ms=3, color=COLOURS[model],
                      label=model)
    for axes, name in zip(panels, ("mu", "contact fraction",
                                   "oil pressure [MPa]")):
        axes.set(xlabel="wetting", ylabel=name)
        axes.grid(alpha=0.3)
    panels[0].legend()
    save(figure, arguments, "wetting.png")


def film(arguments):
    print_head("residual film [nm] | " + HEAD)
    for thickness in (2, 5, 10, 20):
        summary = run(arguments, f"film_{thickness}",
                      {**load_case(300, 200, 25), **rung("Reynolds", 0.6),
                       "Lubrication/Residual film": f"{thickness} nm"})
        print(f"| {thickness} | {row(summary)} |", flush=True)


def thin(arguments):
    print_head("v [m/min] | oil | " + HEAD)
    plt = pyplot()
    figure, axes = plt.subplots(figsize=(5.5, 3.8))
    factors = (1, 0.1, 0.01, 1e-3, 1e-4)
    for velocity, colour in ((22.5, COLOURS["pocket"]),
                             (200, COLOURS["Reynolds"])):
        case = load_case(300, velocity, 25)
        pocket = run(arguments, f"thin_v{velocity}_pocket",
                     {**case, **rung("pocket", 0.6)})
        print(f"| {velocity} | pocket | {row(pocket)} |", flush=True)
        curve = []
        for factor in factors:
            summary = run(arguments, f"thin_v{velocity}_{factor:g}",
                          {**case, **rung("Reynolds", 0.6),
                           "Lubricant/Viscosity": f"{0.032 * factor} Pa s"})
            curve.append(summary["friction"]["mu"])
            print(f"| {velocity} | viscosity x {factor:g} | {row(summary)} |",
                  flush=True)
        axes.semilogx(factors, curve, "o-", ms=4, color=colour,
                      label=f"film, {velocity} m/min")
        axes.axhline(pocket["friction"]["mu"], color=colour, ls=":",
                     label=f"pocket, {velocity} m/min")
    axes.set(xlabel="viscosity over that of the oil", ylabel="mu")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save(figure, arguments, "thin_oil.png")


def flooded(arguments):
    print_head("scene | p [MPa] | v [m/min] | T [degC] | model | mu | mu end | "
               "contact fraction | oil pressure [MPa] | share of the load | "
               "mu by shear | mean film [nm] | steps | iterations a step | "
               "core time [s]")
    results = {}
    for scene in ("R0", "R1"):
        for case in CASES:
            for model in FLOODED:
                summary, rows, seconds = run_flooded(arguments, scene, case,
                                                     model)
                results[scene, case, model] = summary["friction"]["mu"]
                print("| {} | {} | {} | {} | ".format(scene, *case) +
                      f"{flooded_row(summary, rows)} | {seconds:.1f} |",
                      flush=True)
    chart_rungs(arguments, results, FLOODED, "flooded.png", FLOODED_LABELS)


def pockets(arguments):
    print_head("scene | p [MPa] | v [m/min] | T [degC] | oil | mu | "
               "contact fraction | largest contact pressure [GPa] | "
               "share of the load | T_x of the oil over T_y [%] | "
               "difference of pressure in a pocket [%] | pockets at most | "
               "iterations a step | at most | core time [s]")
    results = {}
    for scene in ("R0", "R1"):
        for case in CASES:
            for model, entries in FLOODED_POCKETS.items():
                summary, rows, seconds = run_flooded(
                    arguments, scene, case, model,
                    {**entries, "Output/Picture interval": 120})
                folder = os.path.join(
                    arguments.to,
                    "lubricated_{}_p{}_v{}_T{}_{}".format(scene, *case, model))
                results[scene, case, model] = summary["friction"]["mu"]
                print("| {} | {} | {} | {} | ".format(scene, *case) +
                      f"{model} | {pocket_row(summary, rows, folder)} | "
                      f"{seconds:.1f} |", flush=True)
    chart_rungs(arguments, results, FLOODED_POCKETS, "flowing_pockets.png")


def pocket_row(summary, rows, folder):
    begin = summary["friction"]["window"][0]
    window = [r for r in rows if float(r["time [s]"]) >= begin]
    thrust = (sum(float(r["oil T_x [N/m]"]) for r in window) /
              sum(float(r["T_y [N/m]"]) for r in window))
    is_flow = summary["models"]["lubricant"] == "Navier-Stokes"
    iterations = [float(r["coupling iterations [-]" if is_flow else
                          "newton iterations [-]"]) for r in rows]
    contact = max(float(r["max contact pressure [Pa]"]) for r in rows)
    difference = f"{100. * pressure_difference(folder):.1f}" if is_flow else "-"
    return (f"{summary['friction']['mu']:.5f} | "
            f"{summary['contact_fraction']:.4f} | {contact * 1e-9:.2f} | "
            f"{summary['oil']['load_share']:.3f} | {100. * thrust:+.2f} | "
            f"{difference} | {max(int(r['pockets [-]']) for r in rows)} | "
            f"{sum(iterations) / len(iterations):.1f} | "
            f"{max(iterations):.0f}")


def pressure_difference(folder):
    """The largest over all pockets of (max p - min p)/max p at the end."""
    oil = part_at(folder, "oil", 10**9)
    pressure = oil.field("pressure")
    pocket = oil.fields.get("pocket")
    if pocket is None:
        return (pressure.max() - pressure.min()) / pressure.max()
    in_pockets = [pressure[pocket.ravel() == k] for k in set(pocket.ravel())]
    return max((p.max() - p.min()) / p.max() for p in in_pockets)


def run_flooded(arguments, scene, case, model, entries=None):
    """The reference scene by a model: its summary, the rows of its
    friction.csv, and the processor seconds that it took."""
    before = os.times()
    name = "lubricated_{}_p{}_v{}_T{}".format(scene, *case)
    summary = run(arguments, f"{name}_{model}", entries or FLOODED[model],
                  include=os.path.join(ROOT, "parameter_files",
                                       "reference_scenes", name + ".prm"))
    with open(os.path.join(arguments.to, f"{name}_{model}", "friction.csv"),
              encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    after = os.times()
    return summary, rows, (after.children_user - before.children_user +
                           after.children_system - before.children_system)


def flooded_row(summary, rows):
    friction, oil, cost = (summary["friction"], summary["oil"],
                           summary["cost"])
    begin = friction["window"][0]
    films = [float(r["mean gap [m]"]) for r in rows
             if float(r["time [s]"]) >= begin]
    coupled = sum(float(r["coupling iterations [-]"]) for r in rows)
    iterations = coupled if coupled > 0 else cost["newton_iterations"]
    return (f"{summary['models']['lubricant']} | {friction['mu']:.5f} | "
            f"{friction['mu_end']:.5f} | {summary['contact_fraction']:.4f} | "
            f"{oil['pressure'] * 1e-6:.1f} | {oil['load_share']:.3f} | "
            f"{abs(oil['T_x_shear'] / friction['T_y']):.5f} | "
            f"{1e9 * sum(films) / len(films):.0f} | {cost['steps']} | "
            f"{iterations / cost['steps']:.1f}")


def chart_rungs(arguments, results, models, name, labels=None):
    plt = pyplot()
    figure, panels = plt.subplots(1, 2, figsize=(11, 4), sharey=True)
    width = 0.8 / len(models)
    colours = list(COLOURS.values())[::-1] + ["#d9a441"]
    for axes, scene in zip(panels, ("R0", "R1")):
        for i, model in enumerate(models):
            axes.bar([j + (i - 0.5 * (len(models) - 1)) * width
                      for j in range(len(CASES))],
                     [results[scene, case, model] for case in CASES], width,
                     label=labels[model] if labels else model,
                     color=colours[i])
        label_cases(axes)
        axes.set_title(f"{scene}, gap full of oil", fontsize=10)
    panels[0].set_ylabel("mu")
    save(figure, arguments, name)


def label_cases(axes):
    axes.set_xticks(range(len(CASES)),
                    ["{} MPa\n{} m/min\n{} °C".format(*case)
                     for case in CASES], fontsize=7)
    axes.grid(axis="y", alpha=0.3)
    axes.legend(fontsize=8)


def pyplot():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot
    return matplotlib.pyplot


def save(figure, arguments, name):
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.to, name), dpi=120)


TASKS = {"ladder": ladder, "wetting": wetting, "film": film, "thin": thin,
         "flooded": flooded, "pockets": pockets}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("task", choices=sorted(TASKS))
    parser.add_argument("--asperity",
                        default=os.path.join(ROOT, "build", "asperity"))
    parser.add_argument("--to", default=os.path.join(ROOT, "output",
                                                     "benchmarks"))
    parser.add_argument("--flow", action="store_true",
                        help="also the rungs with a flow of their own")
    arguments = parser.parse_args()
    TASKS[arguments.task](arguments)


if __name__ == "__main__":
    main()
