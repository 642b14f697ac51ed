#!/usr/bin/python3
"""Draw a run: the deformed topography and the friction coefficient.

Usage: tools/plot_run.py OUTPUT_DIRECTORY [--step N] [--to FOLDER]

Writes into the output directory (or FOLDER)

  deformed_topography.png  the deformed chip coloured by equivalent plastic
                           strain, the tool, the oil coloured by its pressure, and
                           the contact force on the chip as arrows: the hardest
                           contact and two periods; of a patch of the surface
                           (Geometry/Dimension = 3) the chip's face in space and
                           maps of its height, of the contact pressure, of
                           that of the oil and of its temperature
  oil_flow.png             if the oil fills the gap as a flow: its pressure, less
                           the mean, and its velocity; the height stretched
  friction.png             mu and contact fraction over time and sliding
                           distance; the averaging window is shaded, with the
                           mean and its spread

or, of a fluid-structure problem,

  fluid_structure.png      speed and pressure of the fluid, stress of the body
  history.png              displacement, drag, lift, pressure, volume and
                           iterations over time; --window SECONDS prints mean,
                           amplitude and frequency of each at the end

Reads chip.pvd, tool.pvd, contact.pvd and their .vtu files, friction.csv, and,
if there, oil.pvd and summary.json (load; friction.mu, friction.spread, and friction.window:
the times [s] at which the window starts and ends).
"""

import argparse
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np

    from fluid_structure_pictures import TABLE, plot_fluid_structure
    from patch_pictures import is_patch, plot_patch
    from run_output import (RunError, Vtu, heading, part_at, read_friction,
                            read_summary, steps_of)
except ImportError as error:
    sys.exit(f"{error}: plot_run.py needs matplotlib and numpy; "
             "tools/install_dependencies installs them.")

UM = 1e6  # micrometres a metre
STRAIN = "equivalent plastic strain [-]"
OIL = "oil pressure [Pa]"
TOOL_COLOUR, ARROW_COLOUR, WINDOW_COLOUR = "#b9bfc9", "#12355b", "#f2c14e"


def mean_at_points(points, values):
    """The mean over the elements that meet at a point; each brings its own
    value, and the picture shall be continuous."""
    size = np.ptp(points, axis=0).max()
    rounded = np.round(points / size * 1e5).astype(np.int64)
    _, index = np.unique(rounded, axis=0, return_inverse=True)
    index = index.ravel()
    return (np.bincount(index, values) / np.bincount(index))[index]


class Scene:
    """One step of a run in micrometres and gigapascals."""

    def __init__(self, directory, step):
        steps = steps_of(directory, "chip")
        if not steps:
            raise RunError(f"{directory} holds no picture of the chip yet.")
        self.step = max(steps) if step is None else step
        if self.step not in steps:
            raise RunError(f"There is no picture of step {step}; there are "
                           f"those of {', '.join(map(str, sorted(steps)))}.")
        self.time, path = steps[self.step]
        chip = Vtu(path)
        self.chip, self.cells = chip.points * UM, chip.cells
        self.strain = mean_at_points(self.chip, chip.field(STRAIN))
        self.tool = part_at(directory, "tool", self.step).points * UM
        line = part_at(directory, "contact", self.step)
        self.line = line.points * UM
        self.traction = line.field("traction [Pa]") * 1e-9
        self.oil_pressure = line.fields.get(OIL, np.zeros(1)).ravel() * 1e-6
        self.period = np.ptp(self.tool[:, 0])  # the tool is drawn once

    def copies(self, points, left, right):
        """Shifts by whole periods with which points cover [left, right]."""
        first = int(np.floor((left - points[:, 0].max()) / self.period))
        last = int(np.ceil((right - points[:, 0].min()) / self.period))
        return [k * self.period for k in range(first, last + 1)]

    def arrows(self, width, n_arrows=60):
        """Points and mean tractions on pieces of the contact line of equal
        length, so many in the width of a picture, so that the density of
        arrows is not that of the mesh."""
        x = self.line[:, 0]
        n_bins = max(1, round(n_arrows * np.ptp(x) / width))
        bins = ((x - x.min()) / np.ptp(x) * n_bins * (1 - 1e-9)).astype(int)
        points, tractions = [], []
        for b in np.unique(bins):
            inside = bins == b
            size = np.linalg.norm(self.traction[inside], axis=1)
            if size.max() > 0.:
                points.append(np.average(self.line[inside], axis=0,
                                         weights=size))
                tractions.append(self.traction[inside].mean(axis=0))
        return np.array(points).reshape(-1, 2), np.array(tractions).reshape(-1, 2)


def draw_scene(axes, scene, box, norms, arrow_length, with_key):
    """The part of the scene in box = (left, right, low, high); colours of
    strain and of oil pressure by norms."""
    left, right, low, high = box
    triangles = np.concatenate([scene.cells[:, [0, 1, 2]],
                                scene.cells[:, [0, 2, 3]]])
    strain = oil = None
    for shift in scene.copies(scene.chip, left, right):
        strain = axes.tripcolor(scene.chip[:, 0] + shift, scene.chip[:, 1],
                               triangles, scene.strain, shading="gouraud",
                               cmap="YlOrRd", norm=norms[0], rasterized=True)
    if scene.oil_pressure.max() > 0.:
        oil = draw_oil(axes, scene, left, right, norms[1])
    for shift in scene.copies(scene.line, left, right):
        axes.plot(scene.line[:, 0] + shift, scene.line[:, 1], color="#7a1f1f",
                  lw=0.8)
    for shift in scene.copies(scene.tool, left, right):
        x, y = scene.tool[:, 0] + shift, scene.tool[:, 1]
        axes.fill_between(x, y, 2. * high - low, color=TOOL_COLOUR, lw=0.)
        axes.plot(x, y, color="#4a4f57", lw=0.9)
    draw_arrows(axes, scene, box, arrow_length, with_key)
    axes.set(xlim=(left, right), ylim=(low, high), xlabel="x [µm]",
             ylabel="y [µm]")
    axes.set_aspect("equal")
    label_bodies(axes)
    return strain, oil


def draw_oil(axes, scene, left, right, norm):
    """The void between the bodies, coloured by the pressure of the oil."""
    tool = scene.tool[np.argsort(scene.tool[:, 0])]
    line = scene.line[:, 0], scene.line[:, 1]
    above = np.interp(line[0], tool[:, 0], tool[:, 1], period=scene.period)
    image = None
    for shift in scene.copies(scene.line, left, right):
        x = np.tile(line[0] + shift, (2, 1))
        y = np.array([line[1], np.maximum(above, line[1])])
        image = axes.pcolormesh(x, y, np.tile(scene.oil_pressure, (2, 1)),
                                shading="gouraud", cmap="Blues", norm=norm,
                                rasterized=True)
    return image


def draw_arrows(axes, scene, box, arrow_length, with_key):
    """The traction of the tool on the chip, and the key of its length."""
    left, right = box[:2]
    points, tractions = scene.arrows(right - left)
    size = np.linalg.norm(tractions, axis=1)
    largest = size.max(initial=0.)
    if largest == 0.:
        return
    visible = size > 0.02 * largest
    for shift in scene.copies(scene.line, left, right):
        arrows = axes.quiver(points[visible, 0] + shift, points[visible, 1],
                             *tractions[visible].T, pivot="tip", angles="xy",
                             scale_units="xy", scale=largest / arrow_length,
                             width=0.002, headwidth=3.5, headlength=4.5,
                             color=ARROW_COLOUR, zorder=4)
    if with_key:
        axes.quiverkey(arrows, 0.87, 0.92, largest, f"{largest:.2g} GPa",
                       labelpos="W", color=ARROW_COLOUR,
                       labelcolor=ARROW_COLOUR)


def label_bodies(axes):
    axes.text(0.012, 0.95, "tool", transform=axes.transAxes, va="top",
              color="#30343a")
    axes.annotate("", (0.145, 0.07), (0.075, 0.07), xycoords="axes fraction",
                  arrowprops={"arrowstyle": "-|>", "lw": 1.4})
    axes.text(0.012, 0.07, "chip", transform=axes.transAxes, va="center")


def magnified_box(scene):
    """A box about the hardest contact, in which the roughness fills a good
    part of the height."""
    L = scene.period
    width = np.clip(12. * np.ptp(scene.tool[:, 1]), 0.25 * L, L)
    hardest = scene.line[np.argmax(np.linalg.norm(scene.traction, axis=1))]
    start = scene.tool[:, 0].min()
    centre = start + (hardest[0] - start) % L
    if centre - 0.5 * width < start:
        centre += L
    return (centre - 0.5 * width, centre + 0.5 * width,
            hardest[1] - 0.2 * width, hardest[1] + 0.13 * width)


def plot_topography(directory, step, target):
    scene = Scene(directory, step)
    L, start = scene.period, scene.tool[:, 0].min()
    bottom, top = scene.chip[:, 1].min(), scene.tool[:, 1].max()
    whole = (start, start + 2. * L, bottom, top + 0.07 * L)
    zoom = magnified_box(scene)

    # A few points at the sharpest asperity would else darken all the rest.
    limit = max(np.quantile(scene.strain, 0.998), 1e-6)
    norms = (matplotlib.colors.Normalize(0., limit),
             matplotlib.colors.Normalize(0., max(scene.oil_pressure.max(), 1e-6)))
    shapes = [(box[3] - box[2]) / (box[1] - box[0]) for box in (zoom, whole)]
    figure, panels = plt.subplots(2, 1, figsize=(10., 9. * sum(shapes) + 2.3),
                                  height_ratios=shapes,
                                  constrained_layout=True)
    image, oil = draw_scene(panels[0], scene, zoom, norms,
                            0.11 * (zoom[1] - zoom[0]), True)
    draw_scene(panels[1], scene, whole, norms, 0.07 * L, False)
    panels[1].add_patch(plt.Rectangle((zoom[0], zoom[2]), zoom[1] - zoom[0],
                                      zoom[3] - zoom[2], fill=False, ls="--",
                                      lw=0.8, zorder=6))
    panels[0].set_title("The hardest contact (dashed frame); arrows: force of "
                        "the tool on the chip", fontsize=10)
    panels[1].set_title("Two periods", fontsize=10)
    bar = figure.colorbar(image, ax=panels, orientation="horizontal",
                          shrink=0.6, aspect=45, pad=0.03,
                          extend="max" if scene.strain.max() > limit else
                          "neither")
    bar.set_label("equivalent plastic strain [–]")
    if oil is not None:
        figure.colorbar(oil, ax=panels, orientation="vertical", shrink=0.5,
                        aspect=40, pad=0.01).set_label("oil pressure [MPa]")
    figure.suptitle(heading(directory, read_summary(directory)) +
                    f", t = {scene.time * 1e6:.4g} µs")
    figure.savefig(target, dpi=120)
    plt.close(figure)


def thinned(points, n_bins):
    """Of the points of a mesh, those next to the middles of the cells of a
    regular grid over it."""
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    place = (points - low) / size * n_bins
    cell = np.minimum(place.astype(int), np.array(n_bins) - 1)
    distance = np.linalg.norm(place - cell - 0.5, axis=1)
    order = np.argsort(distance)
    _, first = np.unique(cell[order] @ [1, n_bins[0]], return_index=True)
    return order[first]


def plot_flow(directory, step, target):
    """Pressure and velocity of an oil that fills the gap, one period."""
    scene = Scene(directory, step)
    oil = part_at(directory, "oil", scene.step)
    points = oil.points * UM
    pressure = mean_at_points(points, oil.field("pressure")) * 1e-6
    mean = np.average(pressure)  # of the open places only
    difference = pressure - mean
    velocity = oil.field("velocity")
    limit = max(np.quantile(abs(difference), 0.998), 1e-9)
    triangles = np.concatenate([oil.cells[:, [0, 1, 2]], oil.cells[:, [0, 2, 3]]])

    figure, axes = plt.subplots(figsize=(11., 4.5), constrained_layout=True)
    image = axes.tripcolor(points[:, 0], points[:, 1], triangles, difference,
                           shading="gouraud", cmap="RdBu_r", rasterized=True,
                           norm=matplotlib.colors.Normalize(-limit, limit))
    chosen = thinned(points, (48, 14))
    axes.quiver(points[chosen, 0], points[chosen, 1], *velocity[chosen].T,
                color=ARROW_COLOUR, width=0.0012, zorder=3)
    left, right = points[:, 0].min(), points[:, 0].max()
    for shift in scene.copies(scene.tool, left, right):
        axes.plot(scene.tool[:, 0] + shift, scene.tool[:, 1], color="#4a4f57")
    axes.set(xlim=(left, right), xlabel="x [µm]", ylabel="y [µm]")
    figure.colorbar(image, ax=axes, pad=0.01).set_label(
        f"oil pressure less its mean of {mean:.4g} MPa [MPa]")
    figure.suptitle(heading(directory, read_summary(directory)) +
                    f", t = {scene.time * 1e6:.4g} µs; arrows: velocity of the "
                    f"oil, the fastest {np.linalg.norm(velocity, axis=1).max():.3g} m/s",
                    fontsize=10)
    figure.savefig(target, dpi=120)
    plt.close(figure)


def window_of(summary):
    """(time window, mean, spread) of the average that the run reports, or None
    for each that it does not."""
    friction = summary.get("friction", {})
    return (friction.get("window"), friction.get("mu"), friction.get("spread"))


def draw_history(panels, x, window, table, mean, spread):
    """mu and contact fraction over x; the window and its mean."""
    for axes, values in zip(panels, (table["mu"],
                                     100. * table["contact fraction"])):
        if window is not None:
            axes.axvspan(*window, color=WINDOW_COLOUR, alpha=0.25, lw=0.,
                         label="averaging window")
        axes.plot(x, values, "-o", color=ARROW_COLOUR, ms=2.2, lw=1.2)
        axes.grid(alpha=0.3)
        axes.set_xlim(0., x.max() if x.max() > 0. else 1.)
    if window is not None and mean is not None:
        spread = spread or 0.
        panels[0].fill_between(window, mean - spread, mean + spread,
                               color="#c8553d", alpha=0.3, lw=0.)
        panels[0].plot(window, [mean, mean], color="#c8553d", lw=1.6,
                       label=f"mean {mean:.4f} ± {spread:.4f} (over time)")
        panels[0].legend(loc="best", fontsize=9)


SHARES = {"ploughing": "#6a8d73", "interface shear": "#d9a441", "oil shear": "#12355b"}


def draw_shares(axes, x, table):
    """What mu consists of, where it is more than ploughing."""
    shares = [name for name in SHARES if np.any(table.get(name, 0.) != 0.)]
    for name in shares if len(shares) > 1 else []:
        axes.plot(x, table[name], color=SHARES[name], lw=1., label=name)
        axes.legend(loc="best", fontsize=9)


def limits_of_mu(table, window, mean):
    """Ends of the axis of mu, which is negative where the tool pushes the chip
    along its way: while the load is small, mu is a quotient of two small numbers
    and may exceed every picture."""
    mu, time = table["mu"], table["time"]
    late = mu[time >= (window[0] if window else 0.2 * time[-1])]
    reference = 1.7 * max(abs(late).max(initial=0.), abs(mean or 0.))
    if reference == 0.:
        return 0., 1.
    return (max(-reference, 1.15 * min(mu.min(), 0.)),
            min(reference, 1.15 * max(mu.max(), 0.)))


def plot_friction(directory, _, target):
    table, summary = read_friction(directory), read_summary(directory)
    window, mean, spread = window_of(summary)
    figure, panels = plt.subplots(2, 1, figsize=(8., 6.), sharex=True,
                                  constrained_layout=True, height_ratios=(3, 2))
    time, distance = table["time"] * 1e6, table["sliding distance"] * UM
    draw_history(panels, time,
                 np.array(window) * 1e6 if window is not None else None,
                 table, mean, spread)
    draw_shares(panels[0], time, table)
    # The chip's bottom slides with one velocity: distance is a second scale.
    if distance[-1] > 0.:
        velocity = distance[-1] / time[-1]
        over = panels[0].secondary_xaxis(
            "top", functions=(lambda t: t * velocity, lambda d: d / velocity))
        over.set_xlabel("sliding distance [µm]")
    panels[0].set_ylabel("friction coefficient µ [–]")
    panels[1].set_ylabel("contact fraction [%]")
    panels[1].set_xlabel("time [µs]")
    panels[0].set_ylim(*limits_of_mu(table, window, mean))
    panels[1].set_ylim(bottom=0.)
    figure.suptitle(heading(directory, summary))
    figure.savefig(target, dpi=110)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--step", type=int, help="step to draw (the last)")
    parser.add_argument("--to", help="folder for the pictures")
    parser.add_argument("--window", type=float, metavar="SECONDS",
                        help="measure the end of a fluid-structure problem")
    arguments = parser.parse_args()
    folder = arguments.to or arguments.directory
    try:
        if not os.path.isdir(arguments.directory):
            raise RunError(f"{arguments.directory} is not a directory.")
        os.makedirs(folder, exist_ok=True)
        if os.path.exists(os.path.join(arguments.directory, TABLE)):
            print(*plot_fluid_structure(arguments.directory, arguments.step,
                                        folder, arguments.window), sep="\n")
            return 0
        topography = (plot_patch if is_patch(arguments.directory)
                      else plot_topography)
        pictures = {"deformed_topography.png": topography,
                    "friction.png": plot_friction}
        if os.path.exists(os.path.join(arguments.directory, "oil.pvd")):
            pictures["oil_flow.png"] = plot_flow
        for name, plot in pictures.items():
            plot(arguments.directory, arguments.step, os.path.join(folder, name))
            print(os.path.join(folder, name))
    except RunError as error:
        print(f"plot_run.py: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
