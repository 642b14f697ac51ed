#!/usr/bin/python3
"""Draw the tools that `asperity optimize` has found.

Usage: tools/plot_tools.py FOLDER ... [--to FOLDER]

Each FOLDER is the output directory of a search. Writes into the first of them
(or FOLDER)

  tools.png  the profile of the base tool and below it the best one of each
             search, with its friction coefficient; and the best objective over
             the number of runs
"""

import argparse
import csv
import json
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    sys.exit(f"{error}: plot_tools.py needs matplotlib; "
             "tools/install_dependencies installs it.")

COLOURS = ("#17375e", "#c0504d", "#4f8f4f", "#e08a1e", "#7f5fa8")


def read_profile(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return ([float(row["x [um]"]) for row in rows],
            [float(row["height [um]"]) for row in rows])


def read_search(folder):
    """The summary of a search, or the end of the program."""
    path = os.path.join(folder, "summary.json")
    try:
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
        summary["found"]
    except (OSError, ValueError, KeyError):
        sys.exit(f"{path} is not the summary of 'asperity optimize'; the output "
                 "directory of a search that has ended is expected.")
    return summary


def mu_of(tool):
    """That of the check scene if there is one."""
    return tool.get("check", tool["results"]).get("mu")


def draw_profile(axis, path, title, colour):
    x, height = read_profile(path)
    axis.plot(x, height, color=colour)
    axis.fill_between(x, height, min(height), color=colour, alpha=0.15)
    axis.set_title(title, loc="left", fontsize=9)
    axis.set_ylabel("height [µm]", fontsize=8)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--to", help="folder of the picture")
    options = parser.parse_args()
    searches = [(folder, read_search(folder)) for folder in options.folders]

    figure = plt.figure(figsize=(11, 1.5 * (len(searches) + 1) + 0.5))
    grid = figure.add_gridspec(len(searches) + 1, 2, width_ratios=(1.4, 1))
    first, base = searches[0][0], searches[0][1]["base"]
    axes = [figure.add_subplot(grid[0, 0])]
    draw_profile(axes[0], os.path.join(first, "base_profile.csv"),
                 f"base: mu = {mu_of(base):.4f}", "0.3")
    history = figure.add_subplot(grid[:, 1])
    for k, (folder, summary) in enumerate(searches):
        colour = COLOURS[k % len(COLOURS)]
        name = os.path.basename(os.path.normpath(folder))
        method = min(summary["found"],
                     key=lambda m: summary["found"][m]["objective"])
        tool = summary["found"][method]
        axes.append(figure.add_subplot(grid[k + 1, 0], sharex=axes[0],
                                       sharey=axes[0]))
        draw_profile(axes[-1], os.path.join(folder, method, "best_profile.csv"),
                     f"{name}, {method}: mu = {mu_of(tool):.4f}", colour)
        for other, found in summary["found"].items():
            values = found["history"]
            history.semilogy(range(found["evaluations"] - len(values) + 1,
                                   found["evaluations"] + 1),
                             values, color=colour,
                             linestyle="-" if other == "DIRECT" else "--",
                             label=f"{name}, {other}")
    axes[-1].set_xlabel("x [µm]")
    history.set_xlabel("runs")
    history.set_ylabel("best objective over that of the base scene")
    history.grid(True, which="both", alpha=0.3)
    history.legend(fontsize=8)
    figure.tight_layout()
    path = os.path.join(options.to or first, "tools.png")
    figure.savefig(path, dpi=90)
    print(path)


if __name__ == "__main__":
    main()
