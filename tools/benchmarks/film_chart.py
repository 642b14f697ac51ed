#!/usr/bin/python3
"""Draw the error of the Reynolds film against Stokes flow over the wall slope.

Usage: tools/benchmarks/film_chart.py DIRECTORY

Reads DIRECTORY/film_stokes.csv, which film_benchmarks writes, and writes
reynolds_against_stokes.png beside it.
"""

import csv
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

QUANTITIES = {"flow": ("flow rate", "-o"),
              "pressure": ("pressure, largest less smallest", "-s"),
              "drag": ("drag of the moving wall", "-^")}


def main(folder):
    path = f"{folder}/film_stokes.csv"
    with open(path, newline="", encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]
    slope = [row["slope"] for row in rows]
    figure, axis = plt.subplots(figsize=(6.5, 4.6))
    for key, (label, line) in QUANTITIES.items():
        error = [abs(row[f"{key}_reynolds"] / row[f"{key}_stokes"] - 1.)
                 for row in rows]
        axis.loglog(slope, error, line, markersize=4, label=label)
    axis.loglog(slope, [0.1 * s * s for s in slope], "k:",
                label="0.1 times slope squared")
    axis.loglog(slope, [row["mesh_error"] for row in rows], color="0.6",
                label="Stokes, two meshes apart")
    axis.set_xlabel("largest slope dh/dx of the wavy wall")
    axis.set_ylabel("error of Reynolds relative to Stokes")
    axis.grid(alpha=0.3, which="both")
    axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(f"{folder}/reynolds_against_stokes.png", dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
