#!/usr/bin/python3
"""Draw the map of coupling_benchmarks and print its tables.

Usage: tools/benchmarks/coupling_charts.py DIRECTORY

Reads DIRECTORY/coupling_map.csv and writes robin_neumann_map.png beside it.
"""

import csv
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from chart_drawing.coupling import draw_map  # noqa: E402
from chart_drawing.style import plt  # noqa: E402

METHODS = ("plain", "Aitken", "IQN-ILS")


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def draw(rows, folder):
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), sharey=True,
                                layout="constrained")
    for axis, method in zip(axes, METHODS):
        picture = draw_map(axis, [r for r in rows if r["method"] == method])
        axis.set_title(method, pad=26)
    figure.colorbar(picture, ax=axes, label="iterations a step (x: none)")
    figure.savefig(f"{folder}/robin_neumann_map.png", dpi=110)


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
