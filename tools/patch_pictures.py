"""Pictures of a run in three dimensions: the face of the chip under the tool."""

import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from run_output import RunError, Vtu, heading, part_at, read_summary, steps_of

UM = 1e6  # micrometres a metre
MPA = 1e-6
PRESSURE = "contact pressure [Pa]"
OIL = "oil pressure [Pa]"
TEMPERATURE = "temperature of the chip [degC]"
RELIEF = 0.08  # height over length in space, so that the asperities are seen


def is_patch(directory):
    """Whether the contact is drawn as squares, not as a line."""
    if not os.path.exists(os.path.join(directory, "contact.pvd")):
        return False
    steps = steps_of(directory, "contact")
    return bool(steps) and Vtu(steps[max(steps)][1]).cells.shape[1] == 4


class Face:
    """The contact face at a step: corners of its squares [um], mean pressure
    of contact and oil [MPa], mean temperature [degC] and height [um] of
    each."""

    def __init__(self, directory, step):
        steps = steps_of(directory, "contact")
        step = max(steps) if step is None else step
        if step not in steps:
            raise RunError(f"There is no picture of step {step}; there are those "
                           f"of {', '.join(map(str, sorted(steps)))}.")
        self.time = steps[step][0]
        picture = part_at(directory, "contact", step)
        # VTK's order of corners, around the square.
        self.corners = picture.in_space[picture.cells] * UM
        def mean(name, factor):
            if name not in picture.fields:
                return None
            return (picture.field(name) * factor)[picture.cells].mean(axis=1)

        self.pressure = mean(PRESSURE, MPA)
        self.oil = mean(OIL, MPA)
        self.temperature = mean(TEMPERATURE, 1.)
        self.corners[..., 2] -= self.corners[..., 2].mean()
        self.height = self.corners[..., 2].mean(axis=1)


def draw_map(figure, axes, face, values, label, colours, limit=None):
    low = values.min() if limit is None else 0.
    squares = PolyCollection(face.corners[..., :2], array=values, cmap=colours,
                             edgecolors="face", linewidths=0.2)
    squares.set_clim(low, values.max() if limit is None else limit)
    axes.add_collection(squares)
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_xlabel("x [µm]")
    axes.set_ylabel("y [µm]")
    figure.colorbar(squares, ax=axes, shrink=0.8).set_label(label)


def draw_in_space(axes, face, limit):
    """@return the factor on heights"""
    corners = face.corners.copy()
    stretch = max(1., np.round(RELIEF * np.ptp(corners[..., 0]) /
                               max(np.ptp(corners[..., 2]), 1e-12)))
    corners[..., 2] *= stretch
    colours = plt.get_cmap("magma_r")(np.clip(face.pressure / limit, 0., 1.))
    # Free squares keep a light grey, so that the relief is seen.
    light = 0.75 + 0.2 * (face.height - face.height.min()) / max(
        np.ptp(face.height), 1e-12)
    free = face.pressure <= 0.02 * limit
    colours[free, :3] = light[free, None]
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colours,
                                           edgecolors="none"))
    spans = []
    for i, set_limits in enumerate((axes.set_xlim, axes.set_ylim, axes.set_zlim)):
        low, high = corners[..., i].min(), corners[..., i].max()
        spans.append(max(high - low, 1e-3))
        set_limits(low, low + spans[-1])
    axes.set_box_aspect(spans, zoom=0.88)
    axes.view_init(elev=35., azim=-60.)
    axes.set_xlabel("x [µm]")
    axes.set_ylabel("y [µm]")
    axes.set_zticks([])
    return stretch


def draw_motion(axes, angle):
    """An arrow in a corner, the way the chip slides. angle: to x [rad]"""
    along, up = 0.06 * np.cos(angle), 0.06 * np.sin(angle)
    axes.annotate("", xy=(0.1 + along, 0.9 + up), xytext=(0.1 - along, 0.9 - up),
                  xycoords="axes fraction",
                  arrowprops={"arrowstyle": "-|>", "color": "black", "lw": 2.})


def plot_patch(directory, step, target):
    """The chip's face in space, and maps of its height, the contact pressure
    and, where there is oil, its pressure, and, where heat is conducted, the
    temperature."""
    face = Face(directory, step)
    touching = face.pressure[face.pressure > 0.]
    # A few hard points would else lighten all the rest.
    limit = np.quantile(touching, 0.99) if touching.size else 1.
    further = [(values, label, colours) for values, label, colours in (
        (face.oil, "oil pressure [MPa]", "Blues"),
        (face.temperature, "temperature of the chip [°C]", "inferno"))
               if values is not None]
    n_maps = 2 + len(further)
    figure = plt.figure(figsize=(5.5 * n_maps, 9.))
    grid = figure.add_gridspec(2, n_maps, height_ratios=(1.3, 1.), left=0.07,
                               right=0.95, bottom=0.07, top=0.93, wspace=0.3)
    # Axes in space are square and cut off what is beyond: larger than the row.
    space = figure.add_axes((0., 0.23, 1., 0.88), projection="3d", zorder=-1)
    stretch = draw_in_space(space, face, limit)
    draw_map(figure, figure.add_subplot(grid[1, 0]), face, face.pressure,
             "contact pressure [MPa]", "magma_r", limit)
    for i, (values, label, colours) in enumerate(further):
        draw_map(figure, figure.add_subplot(grid[1, 1 + i]), face, values, label,
                 colours, max(values.max(), 1e-6) if colours == "Blues" else None)
    heights = figure.add_subplot(grid[1, n_maps - 1])
    draw_map(figure, heights, face, face.height, "height of the chip [µm]",
             "viridis")
    summary = read_summary(directory)
    draw_motion(heights, summary["load"].get("sliding_direction", 0.))
    figure.suptitle(heading(directory, summary) +
                    f", t = {face.time * 1e6:.4g} µs\nFace of the chip, heights "
                    f"{stretch:.0f} times, coloured where the tool presses; it "
                    "slides along the arrow", fontsize=11)
    figure.savefig(target, dpi=110)
    plt.close(figure)
