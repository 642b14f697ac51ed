#!/usr/bin/python3
"""Speed and accuracy of the dry scene, measured and charted.

Usage: tools/benchmarks/dry_scene.py [--asperity PROGRAM] [--to FOLDER] TASK

  convergence  mu of the reference scene R0 (300 MPa, 200 m/min, 25 degC) over
               mesh, time steps, penalty, quadrature and tolerance, each varied
               alone from the default settings, against the finest settings
  speed        time by phase, Newton iterations and factorisations of the eight
               load cases at the default settings, with the error of mu against
               the summaries in output/reference_scenes if they are there
  solvers      the linear solvers at the default settings
  cost         cost of a Newton iteration over the number of unknowns, to 10^5

Tables go to the screen in Markdown, charts as PNG into FOLDER (default
output/benchmarks). Run it on a quiet machine; compare within one run only.
"""

import argparse
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
QUIET = {"Output/Picture interval": 0, "Output/Checkpoint interval": 0}
FINEST = {"Mesh/Spans": 320, "Mesh/Refinement levels": 4,
          "Protocol/Ramp steps": 96, "Protocol/Slide steps": 384,
          "Contact/Penalty factor": 32}


def arguments_of(text):
    """Parser of a benchmark's command line: its program and its folder."""
    parser = argparse.ArgumentParser(
        description=text, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--asperity",
                        default=os.path.join(ROOT, "build", "asperity"))
    parser.add_argument("--to",
                        default=os.path.join(ROOT, "output", "benchmarks"))
    return parser


def load_case(pressure, velocity, temperature):
    return {"Load/Pressure": f"{pressure} MPa",
            "Load/Velocity": f"{velocity} m/min",
            "Load/Temperature": f"{temperature} degC"}


def run(arguments, name, entries, include=None, may_fail=False):
    """Runs the default scene, or that of a file, with some entries changed;
    returns its summary; of a run that may fail and does, None."""
    folder = os.path.join(arguments.to, name)
    os.makedirs(folder, exist_ok=True)
    file = os.path.join(folder, "scene.prm")
    entries = {**QUIET, **entries, "Output/Output directory": folder}
    with open(file, "w", encoding="utf-8") as out:
        if include is not None:
            out.write(f"include {include}\n")
        for path, value in entries.items():
            *sections, key = path.split("/")
            out.write("".join(f"subsection {name}\n" for name in sections))
            out.write(f"  set {key} = {value}\n" + "end\n" * len(sections))
    done = subprocess.run([arguments.asperity, file], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0 and not may_fail:
        sys.exit(f"{name}: {done.stderr.strip()}")
    if done.returncode != 0:
        print(f"{name}: {done.stderr.strip()}", file=sys.stderr, flush=True)
        return None
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as text:
        return json.load(text)


def cost_row(summary):
    cost = summary["cost"]
    return (f"{summary['mesh']['unknowns']} | {cost['steps']} | "
            f"{cost['newton_iterations']} | {cost['factorisations']} | "
            f"{cost['assembly']:.2f} | {cost['factorisation']:.2f} | "
            f"{cost['wall_time']:.2f}")


COST_HEAD = ("unknowns | steps | Newton iterations | factorisations | "
             "assembly [s] | factorisation [s] | wall time [s]")


def print_head(head):
    print(f"| {head} |")
    print("|" + " --- |" * (head.count("|") + 1), flush=True)


def convergence(arguments):
    case = load_case(300, 200, 25)
    reference = run(arguments, "finest", {**case, **FINEST})
    mu = reference["friction"]["mu"]
    print_head("settings | mu | mu at the end | error of mu | " + COST_HEAD)
    print(f"| finest | {mu:.5f} | {reference['friction']['mu_end']:.5f} | - | "
          f"{cost_row(reference)} |")
    variants = {
        "default": {},
        "80 spans": {"Mesh/Spans": 80, "Mesh/Refinement levels": 2},
        "320 spans": {"Mesh/Spans": 320, "Mesh/Refinement levels": 4},
        "strip 0.3 um": {"Mesh/Strip depth": "0.3 um"},
        "degree 3": {"Mesh/Degree": 3},
        "12 + 48 steps": {"Protocol/Ramp steps": 12,
                          "Protocol/Slide steps": 48},
        "48 + 192 steps": {"Protocol/Ramp steps": 48,
                           "Protocol/Slide steps": 192},
        "penalty factor 2": {"Contact/Penalty factor": 2},
        "penalty factor 32": {"Contact/Penalty factor": 32},
        "Gauss-point contact": {"Contact/Formulation": "gauss-point"},
        "3 x 3 Gauss points": {"Mesh/Quadrature points": 3},
        "tolerance 1e-6": {"Solver/Tolerance": 1e-6},
        "tolerance 1e-3": {"Solver/Tolerance": 1e-3},
    }
    points = []
    for name, entries in variants.items():
        summary = run(arguments, name.replace(" ", "_"), {**case, **entries})
        error = summary["friction"]["mu"] / mu - 1.
        points.append((name, summary["cost"]["wall_time"], abs(error)))
        print(f"| {name} | {summary['friction']['mu']:.5f} | "
              f"{summary['friction']['mu_end']:.5f} | {100 * error:+.2f} % | "
              f"{cost_row(summary)} |", flush=True)
    chart_accuracy(arguments, points)


def chart_accuracy(arguments, points):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for name, time, error in points:
        axes.loglog(time, 100 * error, "o", color="#12355b")
        axes.annotate(name, (time, 100 * error), fontsize=7,
                      textcoords="offset points", xytext=(4, 3))
    axes.axhline(0.7, color="#f2c14e", label="0.7 %, mesh tolerance of Lee (2025)")
    axes.set_xlabel("wall time of the run [s]")
    axes.set_ylabel("error of mu against the finest run [%]")
    axes.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.to, "accuracy_over_time.png"),
                   dpi=120)


def speed(arguments):
    print_head("p [MPa] | v [m/min] | T [degC] | mu | error of mu | "
               + COST_HEAD)
    for pressure in (300, 1300):
        for velocity in (22.5, 200):
            for temperature in (25, 675):
                name = f"dry_R0_p{pressure}_v{velocity}_T{temperature}"
                summary = run(arguments, name,
                              load_case(pressure, velocity, temperature))
                mu = summary["friction"]["mu"]
                error = "-"
                fine = os.path.join(ROOT, "output", "reference_scenes", name,
                                    "summary.json")
                if os.path.exists(fine):
                    with open(fine, encoding="utf-8") as text:
                        reference = json.load(text)["friction"]["mu"]
                    error = f"{100 * (mu / reference - 1.):+.2f} %"
                print(f"| {pressure} | {velocity} | {temperature} | {mu:.5f} | "
                      f"{error} | {cost_row(summary)} |", flush=True)


def solvers(arguments):
    print_head("linear solver | mu | " + COST_HEAD)
    for solver in ("cholmod", "umfpack", "klu", "mumps"):
        summary = run(arguments, solver, {**load_case(300, 200, 25),
                                          "Solver/Linear solver": solver})
        print(f"| {solver} | {summary['friction']['mu']:.5f} | "
              f"{cost_row(summary)} |", flush=True)


def cost(arguments):
    phases = ("assembly", "factorisation", "solution")
    print_head("spans | strip of finest cells | unknowns | Newton iterations | "
               + " | ".join(f"{phase} [ms]" for phase in phases))
    sizes = []
    for spans, levels, strip in ((40, 1, "0.3 um"), (80, 2, "0.3 um"),
                                 (160, 3, "0.3 um"), (320, 3, "0.3 um"),
                                 (640, 3, "0.3 um"), (640, 2, "1.4 um"),
                                 (896, 2, "2.6 um")):
        # A light load needs fewer iterations, which large meshes are spared.
        pressure = 300 if spans <= 320 else 10
        summary = run(arguments, f"cost_{spans}_{strip[:3]}",
                      {**load_case(pressure, 200, 25), "Mesh/Spans": spans,
                       "Mesh/Refinement levels": levels,
                       "Mesh/Strip depth": strip,
                       "Mesh/Row grading": 1.2,
                       "Protocol/End time": "0.02 us",
                       "Protocol/Ramp fraction": 1,
                       "Protocol/Ramp steps": 3})
        times, unknowns = summary["cost"], summary["mesh"]["unknowns"]
        per_iteration = [1e3 * times[phase] / times["newton_iterations"]
                         for phase in phases]
        sizes.append((unknowns, per_iteration))
        print(f"| {spans} | {strip} | {unknowns} | "
              f"{times['newton_iterations']} | "
              + " | ".join(f"{time:.3g}" for time in per_iteration) + " |",
              flush=True)
    chart_cost(arguments, phases, sorted(sizes))


def chart_cost(arguments, phases, sizes):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(6, 4))
    unknowns = [size[0] for size in sizes]
    for phase, marker, colour in zip(phases, "os^",
                                     ("#12355b", "#c1553b", "#6a8d73")):
        axes.loglog(unknowns,
                    [size[1][phases.index(phase)] for size in sizes],
                    marker + "-", color=colour, label=phase)
    axes.loglog(unknowns, [sizes[0][1][0] * n / unknowns[0] for n in unknowns],
                ":", color="grey", label="in proportion to the unknowns")
    axes.set_xlabel("unknowns")
    axes.set_ylabel("time per Newton iteration [ms]")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.to, "newton_cost.png"), dpi=120)


def main():
    parser = arguments_of(__doc__)
    tasks = {"convergence": convergence, "speed": speed, "solvers": solvers,
             "cost": cost}
    parser.add_argument("task", choices=tasks)
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    os.makedirs(arguments.to, exist_ok=True)
    tasks[arguments.task](arguments)


if __name__ == "__main__":
    main()
