#!/usr/bin/python3
"""What plane strain errs over the texture aspect ratio Str of a surface.

Usage: tools/benchmarks/plane_strain.py [--asperity PROGRAM] [--to FOLDER]
                                        [--spans N] [--shear M ...]

One surface of six waves with random phases is stretched across the motion, so
that Str goes from 1 to 0.05, while its profiles along the motion stay the same.
mu of each as a patch in three dimensions, of profiles at equal distances in
plane strain, and of the mean over them; without shear of the interface and with
a share M of the shear strength of the chip.

The table goes to the screen in Markdown, the chart and the runs into FOLDER
(default output/benchmarks). A minute or two a patch.
"""

import math
import os
import sys

from dry_scene import ROOT, arguments_of, print_head, run

PERIOD = 5.  # um
SAMPLES = 50  # a period
# Waves along the motion and across it, amplitude [um], phase.
WAVES = ((1, 1, 0.05, 0.3), (1, -1, 0.04, 2.1), (2, 1, 0.02, 4.0),
         (2, -1, 0.02, 1.2), (1, 0, 0.02, 5.1), (0, 1, 0.03, 0.7))
STRETCHES = (1, 2, 4, 8, 20)
PROFILES = 6


def height(x, y):
    """At a place in periods [um]."""
    return sum(a * math.cos(2. * math.pi * (k * x + l * y) + phase)
               for k, l, a, phase in WAVES)


def write_map(path):
    n = 3 * SAMPLES // 2
    with open(path, "w", encoding="utf-8") as file:
        for j in range(n):
            file.write(" ".join(f"{height(i / SAMPLES, j / SAMPLES):.6f}"
                                for i in range(n)) + "\n")


def surface(path, stretch):
    topography = {"File": path, "Lateral unit": "um", "Height unit": "um",
                  "Spacing x": f"{PERIOD / SAMPLES:.8g} um",
                  "Spacing y": f"{stretch * PERIOD / SAMPLES:.8g} um",
                  "F-operator": "none", "Profile length": f"{PERIOD} um"}
    return {"Tool/Kind": "measured",
            **{f"Tool/Topography/{key}": value
               for key, value in topography.items()}}


def shear(factor):
    if factor == 0.:
        return {}
    return {"Interface/Shear law": "shear factor",
            "Interface/Shear factor": factor, "Heat/Model": "adiabatic"}


def patch(arguments, path, stretch, factor):
    entries = {**surface(path, stretch), **shear(factor),
               "Geometry/Width": f"{stretch * PERIOD} um",
               "Mesh/Spans": arguments.spans,
               "Mesh/Spans across": arguments.spans,
               "Mesh/Strip depth": f"{PERIOD / arguments.spans} um"}
    return run(arguments, f"patch_{stretch}_m{factor}", entries,
               arguments.common, may_fail=True)


def profiles(arguments, path, factor):
    """mu of profiles at equal distances."""
    values = []
    for i in range(PROFILES):
        position = (i + 0.5) / PROFILES * PERIOD
        entries = {**surface(path, 1), **shear(factor),
                   "Geometry/Dimension": 2, "Mesh/Spans": arguments.spans,
                   "Mesh/Strip depth": f"{PERIOD / arguments.spans} um",
                   "Tool/Topography/Profile direction": "0 deg",
                   "Tool/Topography/Profile start": "0 um",
                   "Tool/Topography/Periodic continuation": "none",
                   "Tool/Topography/Profile position": f"{position:.6g} um"}
        summary = run(arguments, f"profile_{i}_m{factor}", entries,
                      arguments.common, may_fail=True)
        if summary is not None:
            values.append(summary["friction"]["mu"])
    return values


def draw(arguments, rows, means):
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError as error:
        sys.exit(f"{error}: the chart needs matplotlib; "
                 "tools/install_dependencies installs it.")
    figure, axes = plt.subplots(1, len(means), figsize=(6 * len(means), 4),
                                squeeze=False)
    for axis, (factor, values) in zip(axes[0], means.items()):
        points = [(ratio, mu) for m, ratio, mu in rows if m == factor]
        axis.semilogx([ratio for ratio, _ in points],
                      [mu for _, mu in points], "o-", label="patch")
        axis.axhspan(min(values), max(values), alpha=0.15, color="C1")
        axis.axhline(sum(values) / len(values), color="C1",
                     label="profiles: mean and range")
        axis.set_title("no shear of the interface" if factor == 0.
                       else f"shear factor {factor}")
        axis.set_xlabel("texture aspect ratio Str [-]")
        axis.set_ylabel("mu [-]")
        axis.set_ylim(bottom=0.)
        axis.grid(alpha=0.3)
        axis.legend()
    figure.tight_layout()
    file = os.path.join(arguments.to, "plane_strain.png")
    figure.savefig(file, dpi=100)
    print(file)


def main():
    parser = arguments_of(__doc__)
    parser.add_argument("--spans", type=int, default=24)
    parser.add_argument("--shear", type=float, nargs="*", default=[0., 0.5])
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    arguments.common = os.path.join(ROOT, "parameter_files",
                                    "surface_patches", "common.prm")
    os.makedirs(arguments.to, exist_ok=True)
    path = os.path.join(arguments.to, "waves.txt")
    write_map(path)
    rows, means = [], {}
    for factor in arguments.shear:
        values = profiles(arguments, path, factor)
        if not values:
            continue
        means[factor] = values
        mean = sum(values) / len(values)
        print(f"m = {factor}: profiles " +
              ", ".join(f"{mu:.4f}" for mu in values) +
              f"; mean {mean:.4f}\n")
        print_head("m | Str | mu | contact fraction | one profile misses "
                   "[%] | their mean [%] | Newton iterations | time [s]")
        for stretch in STRETCHES:
            summary = patch(arguments, path, stretch, factor)
            if summary is None:
                continue
            ratio = summary["surfaces"]["Str"]
            mu, cost = summary["friction"]["mu"], summary["cost"]
            rows.append((factor, ratio, mu))
            print(f"| {factor} | {ratio:.2f} | {mu:.4f} | "
                  f"{summary['contact_fraction']:.3f} | "
                  f"{100. * (min(values) / mu - 1.):+.0f} to "
                  f"{100. * (max(values) / mu - 1.):+.0f} | "
                  f"{100. * (mean / mu - 1.):+.0f} | "
                  f"{cost['newton_iterations']} | "
                  f"{cost['wall_time']:.0f} |", flush=True)
    draw(arguments, rows, means)


if __name__ == "__main__":
    main()
