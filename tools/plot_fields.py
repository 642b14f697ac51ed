#!/usr/bin/python3
"""Draw fields of `asperity field` beside those of a run at the same point.

Usage: tools/plot_fields.py FIELDS RUN [--to FOLDER]

FIELDS is the folder of the decoded fields, RUN the output directory of the run.
Writes into FIELDS (or FOLDER)

  learned_fields.png  at the last time of the fields: the contact pressure along
                      the edge of the chip, decoded and of the run, and the
                      equivalent plastic strain under it, decoded, of the run,
                      and the difference

and prints the differences in the pressure, over its norm, and in the strain,
over its largest value. Reads contact.pvd, chip.pvd and their .vtu files of
both; the run must have a picture at that time.
"""

import argparse
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np

    from run_output import (RunError, Vtu, heading, part_at, read_summary,
                            steps_of)
except ImportError as error:
    sys.exit(f"{error}: plot_fields.py needs matplotlib and numpy; "
             "tools/install_dependencies installs them.")

UM, GPA = 1e6, 1e-9
PRESSURE = "contact pressure [Pa]"
STRAIN = "equivalent plastic strain [-]"
SAME_TIME = 1e-3  # of it


def pictures_of(fields, run, part):
    """Of the decoded fields at their last time and of the run at this time."""
    decoded = steps_of(fields, part)
    if not decoded:
        raise RunError(f"{fields} holds no picture of the {part}.")
    time, path = decoded[max(decoded)]
    steps = steps_of(run, part)
    if not steps:
        raise RunError(f"{run} holds no picture of the {part}.")
    step = min(steps, key=lambda s: abs(steps[s][0] - time))
    if abs(steps[step][0] - time) > SAME_TIME * time:
        raise RunError(f"{run} has no picture of the {part} at {time:.4g} s; "
                       f"the nearest one is at {steps[step][0]:.4g} s.")
    return Vtu(path), part_at(run, part, step)


def draw_pressure(axes, decoded, run):
    """@return the difference over the pressure of the run, in the L2 norm"""
    lines = []
    for picture, style, label in ((run, {"color": "#b9bfc9", "lw": 4.}, "run"),
                                  (decoded, {"color": "#12355b", "lw": 1.2},
                                   "decoded")):
        x = picture.points[:, 0] * UM
        order = np.argsort(x)
        lines.append((x[order], picture.field(PRESSURE)[order] * GPA))
        axes.plot(*lines[-1], label=label, **style)
    axes.set_ylabel("contact pressure [GPa]")
    axes.set_ylim(bottom=0.)
    axes.legend(frameon=False)
    (x, true), (x_decoded, found) = lines
    difference = np.interp(x, x_decoded, found) - true
    width = np.gradient(x)
    return np.sqrt((width * difference**2).sum() / (width * true**2).sum())


def draw_strain(figure, panels, decoded, run):
    """@return largest difference over the largest strain"""
    values = [decoded.field(STRAIN), run.field(STRAIN)]
    if len(values[0]) != len(values[1]):
        raise RunError("The run is on another mesh than the decoded fields.")
    largest = values[1].max()
    rows = ((values[0], "decoded", "viridis", 0., largest),
            (values[1], "run", "viridis", 0., largest),
            (values[0] - values[1], "decoded - run", "coolwarm",
             -0.1 * largest, 0.1 * largest))
    for axes, (field, name, colours, low, high) in zip(panels, rows):
        # Both on the places of the run, which hardly differ.
        points = run.points * UM
        cells = run.cells
        triangles = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
        drawn = axes.tripcolor(points[:, 0], points[:, 1], triangles, field,
                               shading="gouraud", cmap=colours, vmin=low,
                               vmax=high)
        figure.colorbar(drawn, ax=axes, pad=0.01, label="plastic strain [-]")
        axes.set_title(name, loc="left", fontsize=10)
        axes.set_ylabel("y [µm]")
        axes.set_ylim(bottom=0.5 * points[:, 1].max())
    return np.abs(values[0] - values[1]).max() / largest


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("fields", help="folder of decoded fields")
    parser.add_argument("run", help="output directory of a run")
    parser.add_argument("--to", help="folder for the picture")
    arguments = parser.parse_args()
    folder = arguments.to or arguments.fields
    try:
        edges = pictures_of(arguments.fields, arguments.run, "contact")
        chips = pictures_of(arguments.fields, arguments.run, "chip")
        os.makedirs(folder, exist_ok=True)
        figure, panels = plt.subplots(4, 1, figsize=(9., 9.), sharex=True,
                                      layout="constrained")
        pressure = draw_pressure(panels[0], *edges)
        strain = draw_strain(figure, panels[1:], *chips)
        panels[0].set_title(heading(arguments.run,
                                    read_summary(arguments.run)), fontsize=11)
        panels[-1].set_xlabel("x [µm]")
        target = os.path.join(folder, "learned_fields.png")
        figure.savefig(target, dpi=110)
        plt.close(figure)
        print(target)
        print(f"contact pressure: difference {100. * pressure:.2g} %, plastic "
              f"strain: {100. * strain:.2g} % of the largest at most")
    except RunError as error:
        print(f"plot_fields.py: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
