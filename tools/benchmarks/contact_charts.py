#!/usr/bin/python3
"""Draw the tables of contact_benchmarks.

Usage: tools/benchmarks/contact_charts.py DIRECTORY

Reads DIRECTORY/contact_{penalty,ironing,ironing_curves,punch}.csv and writes
contact_penalty.png, contact_ironing.png and contact_punch.png beside them.
"""

import csv
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

FORMULATIONS = {"mortar": ("mortar", "tab:blue"),
                "gauss_point": ("Gauss point", "tab:red")}


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def select(rows, column, **conditions):
    return [float(row[column]) for row in rows
            if all(row[key] == value for key, value in conditions.items())]


def draw_penalty(folder):
    rows = read(f"{folder}/contact_penalty.csv")
    panels = [("pressure_error", "pressure error, relative L2", "log"),
              ("penetration", "largest penetration over gap scale", "log"),
              ("iterations", "Newton iterations, all load steps", "linear"),
              ("condition", "condition number of the tangent", "log")]
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), sharex=True)
    for axis, (column, label, scale) in zip(axes.flat, panels):
        for case, line in (("hertz", "-o"), ("westergaard", "--s")):
            for key, (name, color) in FORMULATIONS.items():
                axis.plot(select(rows, "penalty_h_over_E", case=case,
                                 formulation=key),
                          select(rows, column, case=case, formulation=key),
                          line, color=color, markersize=4,
                          label=f"{case.capitalize()}, {name}")
        axis.set_xscale("log")
        axis.set_yscale(scale)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("penalty times h/E")
    axes[0, 0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(f"{folder}/contact_penalty.png", dpi=110)


def draw_ironing(folder):
    curves = read(f"{folder}/contact_ironing_curves.csv")
    rows = read(f"{folder}/contact_ironing.csv")
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.6))
    for key, (name, color) in FORMULATIONS.items():
        for degree, line in (("1", ":"), ("2", "--"), ("3", "-")):
            which = {"formulation": key, "degree": degree}
            x = select(curves, "position_over_h", **which)
            for axis, column in zip(axes, ("vertical", "lateral")):
                axis.plot(x, [100 * y for y in select(curves, column, **which)],
                          line, color=color, label=f"{name}, p = {degree}")
        for elements, line in (("8", "-o"), ("16", "--s")):
            which = {"formulation": key, "penalty_h_over_E": "100",
                     "elements_on_thickness": elements}
            axes[2].semilogy(select(rows, "degree", **which),
                             [100 * y for y in
                              select(rows, "vertical_ripple", **which)],
                             line, color=color,
                             label=f"{name}, {elements} elements")
    axes[0].set_ylabel("vertical force, deviation [% of mean]")
    axes[1].set_ylabel("lateral force [% of vertical]")
    axes[2].set_ylabel("vertical ripple, rms [%]")
    axes[2].set_xlabel("degree")
    axes[2].set_xticks([1, 2, 3])
    for axis in axes[:2]:
        axis.set_xlabel("sliding distance over element length")
    for axis in (axes[0], axes[2]):
        axis.legend(fontsize=8, ncol=2, loc="upper center",
                    bbox_to_anchor=(0.5, 1.28))
    figure.tight_layout()
    figure.savefig(f"{folder}/contact_ironing.png", dpi=110)


def draw_punch(folder):
    rows = read(f"{folder}/contact_punch.csv")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), sharey=True)
    for axis, penalty in zip(axes, ("1", "100")):
        for key, (name, color) in FORMULATIONS.items():
            which = {"formulation": key, "penalty_h_over_E": penalty}
            axis.plot(select(rows, "x", **which),
                      select(rows, "pressure", **which), ".-", color=color,
                      linewidth=0.8, markersize=3, label=name)
        x = select(rows, "x", **which)
        axis.plot(x, select(rows, "exact", **which), "k", label="exact")
        axis.set_title(f"penalty {penalty} E/h")
        axis.set_xlabel("x over half-width")
        axis.set_ylim(0, 6)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("pressure over its mean")
    axes[0].legend()
    figure.tight_layout()
    figure.savefig(f"{folder}/contact_punch.png", dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for draw in (draw_penalty, draw_ironing, draw_punch):
        draw(sys.argv[1])
