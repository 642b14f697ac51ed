#!/usr/bin/python3
"""Draw what `asperity shapes` has learned.

Usage: tools/plot_shapes.py [-o PICTURE] FOLDER [FOLDER ...]

Of each output folder, side by side: the codes of all shapes, drawn in the plane by
t-SNE (triangles: those that it was not trained with), and shapes in the plane
between pairs of codes, red where they are not water-tight.
"""

import argparse
import csv
import os
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

PARTS = (0., 0.25, 0.5, 0.75, 1.)  # of the way from code to code
DISTANCE = 2.2                     # of pictures of shapes of radius 1


def table(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def outlines(folder):
    """Segments of the shapes between codes, as [shape][segment, end, axis]."""
    path = os.path.join(folder, "interpolation.vtu")
    with open(path, encoding="utf-8") as file:
        text = file.read()

    def numbers(name, kind):
        found = re.search(f'<DataArray[^>]*Name="{name}"[^>]*>(.*?)</DataArray>',
                          text, re.DOTALL)
        if not found:
            raise ValueError(f"'{path}' has no array '{name}'.")
        return np.array(found.group(1).split(), dtype=kind)

    points = numbers("Points", float).reshape(-1, 3)[:, :2]
    cells = numbers("connectivity", int)
    if len(cells) != 2 * len(numbers("offsets", int)):
        raise ValueError(f"'{path}' has no shapes in the plane.")
    cells = cells.reshape(-1, 2)
    shapes = numbers("shape", float)[cells[:, 0]]
    return [points[cells[shapes == shape]] for shape in np.unique(shapes)]


def draw_codes(axes, folder):
    rows = table(folder, "shapes.csv")
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    for kind in kinds:
        for trained, marker in (("true", "o"), ("false", "^")):
            places = [(float(row["place_x"]), float(row["place_y"]))
                      for row in rows
                      if row["kind"] == kind and row["trained"] == trained]
            if places:
                axes.scatter(*zip(*places), s=14, marker=marker,
                             color=f"C{kinds.index(kind)}",
                             label=kind if trained == "true" else None)
    n = sum(name.startswith("z_") for name in rows[0])
    axes.set(title=f"codes of {n} numbers, t-SNE", xticks=[], yticks=[])
    axes.legend(fontsize=8)


def draw_shapes_between(axes, folder):
    rows = table(folder, "interpolation.csv")
    segments = outlines(folder)
    pairs = list(dict.fromkeys((row["first"], row["second"]) for row in rows))
    for line, pair in enumerate(pairs):
        members = [i for i, row in enumerate(rows)
                   if (row["first"], row["second"]) == pair]
        for column, part in enumerate(PARTS):
            i = members[round(part * (len(members) - 1))]
            colour = "k" if rows[i]["closed"] == "true" else "r"
            place = DISTANCE * np.array([column, -line])
            x, y = np.moveaxis(segments[i] + place, 2, 0)
            axes.plot(x.T, y.T, color=colour, linewidth=0.9)
    axes.set(title="between pairs of codes", aspect="equal")
    axes.axis("off")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("-o", "--output", default="shapes.png", metavar="PICTURE")
    arguments = parser.parse_args()
    n = len(arguments.folders)
    figure, axes = plt.subplots(2, n, figsize=(4. * n, 7.6), squeeze=False)
    try:
        for column, folder in enumerate(arguments.folders):
            draw_codes(axes[0, column], folder)
            draw_shapes_between(axes[1, column], folder)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"plot_shapes.py: {error}")
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=80)


if __name__ == "__main__":
    main()
