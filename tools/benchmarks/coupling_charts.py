#!/usr/bin/python3
"""Draw the map of coupling_benchmarks and print its tables.

Usage: tools/benchmarks/coupling_charts.py DIRECTORY

Reads DIRECTORY/coupling_map.csv and writes robin_neumann_map.png beside it.
"""

import csv
import math
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm

METHODS = ("plain", "Aitken", "IQN-ILS")


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def columns(rows):
    alphas = sorted({float(r["alpha"]) for r in rows
                     if r["condition"] == "robin"})
    return ([("robin", a) for a in alphas]
            + [("automatic", None), ("dirichlet", None)])


def draw_panel(axis, rows, method):
    rows = [r for r in rows if r["method"] == method]
    impedances = sorted({float(r["Z_f"]) for r in rows})
    names = columns(rows)
    image = [[math.nan] * len(names) for _ in impedances]
    for r in rows:
        key = ((r["condition"], float(r["alpha"]))
               if r["condition"] == "robin" else (r["condition"], None))
        row, column = impedances.index(float(r["Z_f"])), names.index(key)
        if r["converged"] == "1":
            image[row][column] = float(r["iterations"])
        else:
            axis.text(column, row, "x", ha="center", va="center",
                      color="tab:red", fontsize=8)
    picture = axis.imshow(image, origin="lower", aspect="auto",
                          cmap="viridis_r", norm=LogNorm(1, 100))
    ticks = [i for i, (condition, a) in enumerate(names) if condition == "robin"
             and round(4 * math.log10(a)) in range(-12, 12, 4)]
    axis.set_xticks(ticks + [len(names) - 2, len(names) - 1])
    axis.set_xticklabels([f"{names[i][1]:g}" for i in ticks] + ["auto", "D-N"],
                         rotation=90)
    axis.set_yticks(range(len(impedances)))
    axis.set_yticklabels(["sealed" if math.isinf(z) else f"{z:g}"
                          for z in impedances])
    axis.axvline(len(names) - 2.5, color="black", linewidth=0.8)
    axis.set_xlabel("alpha / Z_s")
    axis.set_title(method)
    return picture


def draw(rows, folder):
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), sharey=True)
    for axis, method in zip(axes, METHODS):
        picture = draw_panel(axis, rows, method)
    axes[0].set_ylabel("Z_f / Z_s")
    figure.colorbar(picture, ax=axes, label="iterations a step (x: none)")
    figure.savefig(f"{folder}/robin_neumann_map.png", dpi=110,
                   bbox_inches="tight")


def print_tables(rows):
    errors = [abs(float(r["contraction"]) / float(r["formula"]) - 1)
              for r in rows if r["method"] == "plain"
              and r["condition"] == "robin" and float(r["formula"]) > 1e-3]
    print(f"largest error of the contraction: {max(errors):.1e}")
    print("| Z_f/Z_s | " + " | ".join(
        f"{m}: alpha = Z_s/100 | Z_s/10 | automatic | 10 Z_s | 100 Z_s | D-N"
        for m in METHODS) + " |")
    for z in sorted({float(r["Z_f"]) for r in rows}):
        cells = []
        for method in METHODS:
            for condition, alpha in (("robin", .01), ("robin", .1),
                                     ("automatic", 1.), ("robin", 10.),
                                     ("robin", 100.), ("dirichlet", math.inf)):
                r = next(r for r in rows if r["method"] == method
                         and float(r["Z_f"]) == z
                         and r["condition"] == condition
                         and (float(r["alpha"]) == alpha
                              or abs(float(r["alpha"]) / alpha - 1) < 1e-6))
                cells.append(f"{float(r['iterations']):.1f}"
                             if r["converged"] == "1" else "-")
        print(f"| {'sealed' if math.isinf(z) else f'{z:g}'} | "
              + " | ".join(cells) + " |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    table = read(f"{sys.argv[1]}/coupling_map.csv")
    draw(table, sys.argv[1])
    print_tables(table)
