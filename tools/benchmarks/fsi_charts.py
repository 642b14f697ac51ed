#!/usr/bin/python3
"""Draw and measure a history of fsi_benchmarks fsi2 or fsi3.

Usage: tools/benchmarks/fsi_charts.py FILE.csv PICTURE.png [SECONDS]

Mean and amplitude are those of the largest and the smallest value in the last
SECONDS (default 1) of the history, frequencies from upward crossings of the
mean in that window, as in the published tables.
"""

import csv
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLUMNS = (("ux", "u_x of the tip", 1e3, "mm"), ("uy", "u_y of the tip", 1e3,
           "mm"), ("drag", "drag", 1, "N/m"), ("lift", "lift", 1, "N/m"))


def frequency(time, values, mean):
    crossings = [t0 + (t1 - t0) * (mean - a) / (b - a)
                 for t0, t1, a, b in zip(time, time[1:], values, values[1:])
                 if a <= mean < b]
    if len(crossings) < 2:
        return float("nan")
    return (len(crossings) - 1) / (crossings[-1] - crossings[0])


def main(file_name, picture, seconds):
    with open(file_name, newline="", encoding="utf-8") as file:
        rows = [{k: float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]
    time = [row["time"] for row in rows]
    window = [i for i, t in enumerate(time) if t >= time[-1] - seconds]
    figure, axes = plt.subplots(5, 1, figsize=(10, 9), sharex=True)
    for axis, (key, name, scale, unit) in zip(axes, COLUMNS):
        values = [scale * row[key] for row in rows]
        axis.plot(time, values, linewidth=0.8)
        axis.set_ylabel(f"{name} [{unit}]")
        last = [values[i] for i in window]
        mean = (max(last) + min(last)) / 2
        print(f"{key}: {mean:.5g} +- {(max(last) - min(last)) / 2:.5g} {unit} "
              f"[{frequency([time[i] for i in window], last, mean):.4g} Hz]")
    axes[4].plot(time, [row["iterations"] for row in rows], ".", markersize=2)
    axes[4].set_ylabel("iterations")
    axes[4].set_xlabel("t [s]")
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)
    iterations = [row["iterations"] for row in rows]
    print(f"iterations a step: {sum(iterations) / len(iterations):.2f}, in the "
          f"window {sum(iterations[i] for i in window) / len(window):.2f}, at "
          f"most {max(iterations):.0f}")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2],
         float(sys.argv[3]) if len(sys.argv) > 3 else 1.)
