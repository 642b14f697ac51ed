#!/usr/bin/python3
"""Draw the curves of mesh_motion_benchmarks.

Usage: tools/benchmarks/mesh_motion_chart.py DIRECTORY

Reads DIRECTORY/mesh_motion.csv and writes mesh_motion.png beside it.
"""

import csv
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

PERIOD = 10.  # um


def read(path):
    curves = {}
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            x, y = curves.setdefault(row["mesh"], ([], []))
            x.append(float(row["distance_um"]))
            y.append(float(row["scaled_jacobian"]))
    return curves


def draw(folder):
    figure, axis = plt.subplots(figsize=(8, 4.5))
    for name, (x, y) in read(f"{folder}/mesh_motion.csv").items():
        axis.plot(x, y, "k" if name == "columns" else "-", label=name,
                  linewidth=1)
    axis.axhline(0., color="grey", linewidth=0.8)
    axis.axvline(PERIOD, color="grey", linestyle=":", linewidth=0.8)
    axis.text(PERIOD, -0.9, "one period ", ha="right", fontsize=8)
    axis.text(1e-4, 0.03, " inverted below", fontsize=8, color="grey")
    axis.set_xscale("log")
    axis.set_ylim(-1.02, 1.02)
    axis.set_xlabel("sliding distance [um]")
    axis.set_ylabel("smallest scaled Jacobian")
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8, loc="lower left")
    figure.tight_layout()
    figure.savefig(f"{folder}/mesh_motion.png", dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    draw(sys.argv[1])
