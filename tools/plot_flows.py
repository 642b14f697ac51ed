#!/usr/bin/python3
"""Draw the vortex street, decoded from two numbers, beside that of the run.

Usage: tools/plot_flows.py FOLDER [--to FOLDER]

FOLDER is that of the benchmark learned_flows, which writes street_fields.csv into
it. Writes into FOLDER (or the other one)

  learned_flows.png  the speed of a flow that was held out, of the run and of
                     each decoder, and the size of the difference
"""

import argparse
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.tri import Triangulation
except ImportError as error:
    sys.exit(f"{error}: plot_flows.py needs matplotlib and numpy; "
             "tools/install_dependencies installs them.")

CYLINDER = (0.2, 0.2, 0.05)  # DFG 2D-2: centre and radius [m]


def read(path):
    """Columns by their names."""
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")
    values = np.loadtxt(path, delimiter=",", skiprows=1)
    return dict(zip(names, values.T))


def decoders_of(columns):
    return [name[len("u of "):-len(" [m/s]")] for name in columns
            if name.startswith("u of ")]


def mesh_of(columns):
    """Triangles between the nodes, but for the cylinder."""
    x, y = columns["x [m]"], columns["y [m]"]
    mesh = Triangulation(x, y)
    x_0, y_0, radius = CYLINDER
    middle_x = x[mesh.triangles].mean(axis=1)
    middle_y = y[mesh.triangles].mean(axis=1)
    mesh.set_mask(np.hypot(middle_x - x_0, middle_y - y_0) < radius)
    return mesh


def velocity(columns, who):
    return columns[f"u of {who} [m/s]"], columns[f"v of {who} [m/s]"]


def draw(axes, columns):
    """A row of pictures for each decoder; the first row is the run."""
    mesh = mesh_of(columns)
    u, v = velocity(columns, "the run")
    largest = np.hypot(u, v).max()
    for row, who in zip(axes, decoders_of(columns)):
        u_0, v_0 = velocity(columns, who)
        difference = np.hypot(u_0 - u, v_0 - v)
        for axis, values, most, colours, title in (
                (row[0], np.hypot(u_0, v_0), largest, "viridis",
                 who + ": speed [m/s]"),
                (row[1], difference, 0.1 * largest, "magma",
                 f"difference, at most {difference.max() / largest:.2%} of the "
                 "largest speed")):
            if who == "the run" and axis is row[1]:
                axis.axis("off")
                continue
            picture = axis.tripcolor(mesh, np.minimum(values, most),
                                     shading="gouraud", cmap=colours,
                                     vmin=0., vmax=most)
            plt.colorbar(picture, ax=axis, fraction=0.01, pad=0.02)
            axis.set_title(title, loc="left", fontsize=8)
            axis.set_aspect("equal")
            axis.set_xticks([])
            axis.set_yticks([])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--to", help="folder of the picture")
    options = parser.parse_args()
    source = os.path.join(options.folder, "street_fields.csv")
    if not os.path.exists(source):
        sys.exit(f"{source} does not exist; the folder of 'learned_flows street' "
                 "is expected.")
    columns = read(source)
    n_rows = len(decoders_of(columns))
    figure, axes = plt.subplots(n_rows, 2, squeeze=False,
                                figsize=(13, 1.45 * n_rows))
    draw(axes, columns)
    figure.tight_layout()
    path = os.path.join(options.to or options.folder, "learned_flows.png")
    figure.savefig(path, dpi=65)
    print(path)


if __name__ == "__main__":
    main()
