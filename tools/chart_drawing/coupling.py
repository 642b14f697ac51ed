"""Iterations of the coupling over the Robin coefficient, by acceleration, on the
piston, whose impedances are known, and on a scene."""

import math

import numpy as np
from matplotlib.colors import LogNorm

from .style import (BLUE, GREEN, GREY, INK, RED, finish_logs, label_ends,
                    mark_default, mark_failed, panels)

TITLE = "Coupling: iterations over the Robin coefficient"
METHODS = {"plain": ("relaxation", RED, "s-"), "Aitken": ("Aitken", GREEN, "D-"),
           "IQN-ILS": ("IQN-ILS", BLUE, "o-")}
CONDITIONS = {"automatic": "tangent\nand secant", "secant": "secant\nalone",
              "dirichlet": "Dirichlet-\nNeumann"}
MONOLITHIC = {"monolithic, Reynolds": "Reynolds", "monolithic, dry": "none"}


def coefficients(full):
    """alpha [Pa s/m]"""
    return ([10. ** (k / 2.) for k in range(12, 25)] if full else
            [1e7, 1e8, 1e9, 1e10, 1e12])


def measure(chart):
    piston = chart.benchmark("coupling_benchmarks").rows("coupling_map.csv")
    chart.table(piston, name="piston.csv")
    scenes = {f"{method}, {alpha if alpha == 'automatic' else f'{alpha:.3g}'}": {
        "Coupling/Acceleration": kind,
        "Coupling/Robin coefficient": alpha if alpha == "automatic"
        else f"{alpha:.6g} Pa s/m"}
        for method, (kind, _, _) in METHODS.items()
        for alpha in ["automatic", *coefficients(chart.full)]}
    scenes["Dirichlet-Neumann, IQN-ILS"] = {
        "Coupling/Scheme": "Dirichlet-Neumann"}
    scenes |= {name: {"Lubrication/Model": model}
               for name, model in MONOLITHIC.items()}
    runs = chart.scenes(scenes)
    default = runs["IQN-ILS, automatic"]
    rows = []
    for name, run in runs.items():
        steps = run.rows("friction.csv") if not run.failed else []
        column = ("newton" if name.startswith("mono") else "coupling"
                  ) + " iterations [-]"
        counts = [float(row[column]) for row in steps] or [math.nan]
        rows.append({"run": name, "iterations a step": np.mean(counts),
                     "largest": max(counts), "mu": run.mu,
                     "time": run.seconds / default.seconds,
                     "failed": run.failure or ""})
    chart.table(rows, "the run with the default coupling")


def show(chart):
    piston = chart.rows("piston.csv")
    of = {row["run"]: row for row in chart.rows()}
    points = {name: (row["time"], row["iterations a step"])
              for name, row in of.items() if not name.startswith("mono")}
    verdict = chart.judge(points["IQN-ILS, automatic"], points, "iterations")
    picture(chart, piston, of)
    chart.page(TITLE, *conclusion(piston, of, verdict))


def conclusion(piston, of, verdict):
    counts = {}
    for row in piston:
        key = row["method"], row["condition"]
        counts.setdefault(key, []).append(
            row["iterations"] if row["converged"] == 1. else math.nan)
    def told(method, condition):
        values = counts.get((method, condition), [math.nan])
        lost = sum(map(math.isnan, values))
        best = [value for value in values if not math.isnan(value)]
        return (f"{min(best):.1f} to {max(best):.1f}" if best else "no") + (
            f" ({lost} of {len(values)} without result)" if lost else "")
    def steps(run):
        return ("does not couple" if of[run]["failed"] else
                f"{of[run]['iterations a step']:.1f}")
    failed = [name for name, row in of.items() if row["failed"]]
    return (
        "Piston and chamber, over nine impedances of the fluid from a tenth of "
        "the solid's to a sealed one: iterations a step with IQN-ILS are "
        f"{told('IQN-ILS', 'automatic')} with the coefficient of the tangent "
        "corrected by secants (the program's `automatic`), "
        f"{told('IQN-ILS', 'secant')} with secants from the second step on, "
        f"{told('IQN-ILS', 'dirichlet')} with Dirichlet-Neumann; without "
        f"acceleration {told('plain', 'automatic')}, "
        f"{told('plain', 'secant')} and {told('plain', 'dirichlet')}; there a "
        "fixed coefficient is as good only where it is nearly Z_s.",
        "The scene is R1 full of incompressible oil, 300 MPa, 200 m/min. The "
        f"default (automatic, IQN-ILS) takes "
        f"{of['IQN-ILS, automatic']['iterations a step']:.1f} iterations a step, "
        f"the same without acceleration {steps('plain, automatic')}, with Aitken "
        f"{steps('Aitken, automatic')}. {verdict} A fixed coefficient has to be "
        "found by trial, and a tenfold of the best one fails. "
        "Where oil and chip are solved together (a Reynolds film), Newton's "
        "method takes "
        f"{of['monolithic, Reynolds']['iterations a step']:.1f} iterations a step "
        "at "
        f"{of['monolithic, Reynolds']['time']:.2f} of the time; there is no "
        f"monolithic Navier-Stokes flow. {len(failed)} of {len(of)} runs did not "
        "couple.")


def picture(chart, piston, of):
    figure, axes = panels(2, 2, width=5.6, height=3.7)
    for panel, method in zip(axes.flat, METHODS):
        image = draw_map(panel, [row for row in piston
                                 if row["method"] == method])
        panel.set_title(f"piston, {method if method != 'plain' else 'without'}"
                        f"{' acceleration' if method == 'plain' else ''}")
    if piston:
        figure.colorbar(image, ax=axes[0, 1], label="iterations a step",
                        ticks=[1, 3, 10, 30, 100], format="%g")
    draw_scene(axes[1, 1], of, coefficients(chart.full))
    chart.picture(figure)


def draw_map(panel, rows):
    """Iterations over alpha/Z_s and Z_f/Z_s; x where there is no result."""
    alphas = sorted({r["alpha"] for r in rows if r["condition"] == "robin"})
    fluids = sorted({r["Z_f"] for r in rows})
    n = len(alphas) + len(CONDITIONS)
    image = np.full((len(fluids), n), np.nan)
    for row in rows:
        column = (alphas.index(row["alpha"])
                  if row["condition"] == "robin" else
                  len(alphas) + list(CONDITIONS).index(row["condition"]))
        line = fluids.index(row["Z_f"])
        if row["converged"] == 1.:
            image[line, column] = row["iterations"]
        else:
            panel.text(column, line, "×", ha="center", va="center", color=RED,
                       size=8)
    shown = panel.imshow(image, origin="lower", aspect="auto", cmap="GnBu",
                         norm=LogNorm(1, 100))
    decades = [k for k, a in enumerate(alphas)
               if abs(math.log10(a) - round(math.log10(a))) < 1e-6]
    panel.set_xticks(decades, [f"{alphas[k]:g}" for k in decades], size=7.5)
    for k, text in enumerate(("auto", "secant", "D-N")):
        panel.text(len(alphas) + k, len(fluids) - 0.4, text, rotation=90, size=7,
                   ha="center", va="bottom",
                   weight="bold" if text == "auto" else "normal")
    panel.set_yticks(range(len(fluids)), ["sealed" if math.isinf(z) else f"{z:g}"
                                          for z in fluids], size=7.5)
    panel.axvline(len(alphas) - 0.5, color=INK, lw=0.8)
    panel.set_xlabel("alpha/Z$_s$", labelpad=1)
    panel.set_ylabel("Z$_f$/Z$_s$")
    panel.grid(False)
    return shown


def draw_scene(panel, of, alphas):
    ends = []
    shift = {"plain": 0.94, "Aitken": 0.88, "IQN-ILS": 0.82}
    for method, (_, colour, line) in METHODS.items():
        good = [a for a in alphas if not of[f"{method}, {a:.3g}"]["failed"]]
        ys = [of[f"{method}, {a:.3g}"]["iterations a step"] for a in good]
        panel.loglog(good, ys, line, color=colour)
        mark_failed(panel, [a for a in alphas if a not in good], colour,
                    shift[method])
        automatic = of[f"{method}, automatic"]
        if automatic["failed"]:
            mark_failed(panel, [alphas[-1] * 30.], colour, shift[method])
        else:
            y = automatic["iterations a step"]
            panel.plot([alphas[-1] * 30.], [y], line[0], color=colour)
            ends.append((y, method if method != "plain" else "no acceleration",
                         colour))
            if method == "IQN-ILS":
                mark_default(panel, alphas[-1] * 30., y, "default", (-8, -15),
                             "right")
    reynolds = of["monolithic, Reynolds"]["iterations a step"]
    panel.axhline(reynolds, color=GREY, ls="--", lw=1.2)
    ends.append((reynolds, "monolithic\nReynolds film", GREY))
    panel.set_xlim(alphas[0] / 3., alphas[-1] * 100.)
    panel.set_ylim(top=60)
    panel.set(title="R1 full of oil", xlabel="alpha [Pa s/m]",
              ylabel="iterations a step")
    finish_logs(panel)
    panel.set_xticks([*alphas, alphas[-1] * 30.],
                     [*(f"10$^{{{round(math.log10(a))}}}$" if a == 10. ** round(
                         math.log10(a)) else "" for a in alphas), "auto"])
    label_ends(panel, ends)
