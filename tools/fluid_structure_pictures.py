"""Draw a fluid-structure run: fluid and body, and the history of both."""

import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from run_output import RunError, part_at, read_summary, steps_of

TABLE = "fluid_structure.csv"
BODY_COLOUR = "#12355b"


def triangles_of(part):
    return np.concatenate([part.cells[:, [0, 1, 2]], part.cells[:, [0, 2, 3]]])


def unit_of_length(size):
    """Name of a unit in which a size [m] is a handy number, and its factor."""
    for name, factor in (("m", 1.), ("mm", 1e3)):
        if size * factor >= 1.:
            return name, factor
    return "µm", 1e6


def unit_of_pressure(size):
    for name, factor in (("GPa", 1e-9), ("MPa", 1e-6), ("kPa", 1e-3)):
        if size * factor >= 1.:
            return name, factor
    return "Pa", 1.


def box_of(fluid, body):
    """What is drawn: a long channel only about its body."""
    low = np.minimum(fluid.min(axis=0), body.min(axis=0))
    high = np.maximum(fluid.max(axis=0), body.max(axis=0))
    width, height = high - low
    if width > 4. * height:
        middle = 0.5 * (body[:, 0].min() + body[:, 0].max())
        left = np.clip(middle - 1.5 * height, low[0], high[0] - 4. * height)
        low[0], high[0] = left, left + 4. * height
    return low, high


def draw_panel(axes, fluid, values, body, stress, factor, colours, box):
    """One field of the fluid, the body coloured by its stress."""
    limits = np.quantile(values, (0.002, 0.998))
    image = axes.tripcolor(fluid.points[:, 0] * factor,
                           fluid.points[:, 1] * factor, triangles_of(fluid),
                           values, shading="gouraud", cmap=colours,
                           vmin=limits[0], vmax=max(limits[1], limits[0] + 1e-30),
                           rasterized=True)
    solid = axes.tripcolor(body.points[:, 0] * factor,
                           body.points[:, 1] * factor, triangles_of(body),
                           stress, shading="gouraud", cmap="YlOrRd",
                           rasterized=True)
    low, high = box
    margin = 0.01 * (high - low)
    axes.set(xlim=(factor * (low - margin)[0], factor * (high + margin)[0]),
             ylim=(factor * (low - margin)[1], factor * (high + margin)[1]))
    axes.set_aspect("equal")
    return image, solid


def plot_fields(directory, step, target):
    """Speed and pressure of the fluid, stress of the body, deformed."""
    steps = steps_of(directory, "fluid")
    if not steps:
        raise RunError(f"{directory} holds no picture of the fluid yet.")
    step = max(steps) if step is None else step
    if step not in steps:
        raise RunError(f"There is no picture of step {step}; there are those of "
                       f"{', '.join(map(str, sorted(steps)))}.")
    fluid, body = part_at(directory, "fluid", step), part_at(directory, "body", step)
    box = box_of(fluid.points, body.points)
    size = box[1] - box[0]
    length, factor = unit_of_length(size.max())
    pressure = fluid.field("pressure less its mean")
    mean = np.mean(fluid.field("pressure").astype(float) - pressure)
    pressure_unit, pressure_factor = unit_of_pressure(np.abs(pressure).max())
    stress = body.field("von Mises stress [Pa]")
    stress_unit, stress_factor = unit_of_pressure(np.abs(stress).max())
    speed = np.linalg.norm(fluid.field("velocity"), axis=1)

    is_wide = size[0] > 2. * size[1]
    shape = (2, 1) if is_wide else (1, 2)
    width = 9. if is_wide else 12.
    height = 2.2 + (2. * (width - 2.5) * size[1] / size[0] if is_wide else
                    (width / 2. - 1.8) * size[1] / size[0])
    figure, panels = plt.subplots(*shape, figsize=(width, height),
                                  constrained_layout=True)
    for axes, values, colours, label in (
            (panels[0], speed, "viridis", "speed of the fluid [m/s]"),
            (panels[1], pressure * pressure_factor, "coolwarm",
             f"pressure less its mean\nof {mean:.5g} Pa [{pressure_unit}]")):
        image, solid = draw_panel(axes, fluid, values, body,
                                  stress * stress_factor, factor, colours, box)
        figure.colorbar(image, ax=axes, label=label, shrink=0.8)
        axes.set(xlabel=f"x [{length}]", ylabel=f"y [{length}]")
    figure.colorbar(solid, ax=panels.ravel().tolist(), shrink=0.5,
                    orientation="horizontal", aspect=40,
                    label=f"von Mises stress of the body [{stress_unit}]")
    figure.suptitle(f"{read_summary(directory).get('problem', 'Run')}, "
                    f"t = {steps[step][0]:.4g} s")
    figure.savefig(target, dpi=120)
    plt.close(figure)


def read_history(directory):
    """Columns of the table by their headings, as arrays."""
    path = os.path.join(directory, TABLE)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        values = np.array(rows[1:], dtype=float)
    except (OSError, ValueError) as error:
        raise RunError(f"{path} cannot be read: {error}")
    if len(rows) < 2:
        raise RunError(f"{path} holds no step yet.")
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def frequency(time, values, mean):
    """From upward crossings of the mean, as in the published tables."""
    before, after = values[:-1], values[1:]
    up = (before <= mean) & (mean < after)
    if up.sum() < 2:
        return float("nan")
    crossings = (time[:-1][up] + np.diff(time)[up] * (mean - before[up]) /
                 (after[up] - before[up]))
    return (len(crossings) - 1) / (crossings[-1] - crossings[0])


def plot_history(directory, target, seconds=None):
    """All columns over time; if a window is given, mean, amplitude and frequency
    of each in the last seconds, printed."""
    table = read_history(directory)
    time = table.pop("time [s]")
    figure, panels = plt.subplots(len(table), 1, sharex=True,
                                  figsize=(9., 1.5 * len(table) + 0.8),
                                  constrained_layout=True)
    style = "o-" if len(time) < 60 else "-"
    for axes, (name, values) in zip(panels, table.items()):
        axes.plot(time, values, style, color=BODY_COLOUR, lw=0.9, ms=2.5)
        axes.set_ylabel(name.replace(" [", "\n["), fontsize=8)
        axes.grid(alpha=0.3)
        if seconds is not None:
            window = time >= time[-1] - seconds
            low, high = values[window].min(), values[window].max()
            mean = 0.5 * (low + high)
            print(f"{name}: {mean:.5g} +- {0.5 * (high - low):.5g} "
                  f"[{frequency(time[window], values[window], mean):.4g} Hz]")
    panels[-1].set_xlabel("time [s]")
    figure.savefig(target, dpi=110)
    plt.close(figure)


def plot_fluid_structure(directory, step, folder, seconds=None):
    """Both pictures. @return their paths."""
    fields = os.path.join(folder, "fluid_structure.png")
    history = os.path.join(folder, "history.png")
    plot_fields(directory, step, fields)
    plot_history(directory, history, seconds)
    return fields, history
