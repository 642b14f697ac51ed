"""One look for all charts: colours that the colour-blind can tell apart, labels
beside the curves, marks for the default settings and for what failed."""

import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patheffects import withStroke  # noqa: E402
from matplotlib.ticker import (FixedLocator, FuncFormatter,  # noqa: E402
                               NullFormatter, NullLocator)

BLUE, RED, GREEN, PURPLE, CYAN, SAND, GREY = (
    "#3565a0", "#cc5a52", "#2f7d3b", "#8a3a75", "#2a96b8", "#a58a1e", "#7d8288")
COLOURS = (BLUE, RED, GREEN, PURPLE, SAND, CYAN, GREY)
MARKERS = "osD^vPX"
INK = "#333333"

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 10, "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False,
    "axes.edgecolor": "#888888", "axes.labelcolor": INK, "text.color": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.grid": True,
    "grid.color": "#e4e4e4", "grid.linewidth": 0.7, "axes.axisbelow": True,
    "lines.linewidth": 1.4, "lines.markersize": 4.5, "legend.frameon": False,
    "legend.fontsize": 8, "svg.hashsalt": "asperity", "svg.fonttype": "none", "figure.dpi": 110})


def panels(n_columns, n_rows=1, width=4.6, height=3.7, **options):
    """A figure with room for labels; always an array of axes."""
    return plt.subplots(n_rows, n_columns, squeeze=False,
                        figsize=(width * n_columns, height * n_rows),
                        layout="constrained", **options)


def number(value):
    """A tick as people write it: 0.01, 5, 2000, 1e6."""
    if value == 0:
        return "0"
    if 1e-3 <= abs(value) < 1e5:
        return f"{value:.10g}"
    exponent = math.floor(math.log10(abs(value)) + 1e-9)
    factor = value / 10. ** exponent
    power = f"10$^{{{exponent}}}$"
    return power if abs(factor - 1.) < 1e-6 else f"{factor:.3g}·{power}"


# decades that a logarithmic axis shows, and the ticks in a decade up to there
STEPS = ((0.4, (1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9)),
         (0.75, (1, 1.5, 2, 3, 5, 7)), (2.2, (1, 2, 5)), (3.3, (1, 3)), (math.inf, (1,)))


def log_axis(axis, ticks=None):
    """Readable ticks on a logarithmic axis: given ones, or those of the steps
    1, 2, 5 over a small range and of decades over a large one."""
    if ticks is None:
        low, high = sorted(axis.get_view_interval())
        decades = range(math.floor(math.log10(low)),
                        math.ceil(math.log10(high)) + 1)
        span = math.log10(high / low)
        steps = next(steps for limit, steps in STEPS if span < limit)
        stride = max(1, round(span / 5)) if span >= 6 else 1
        ticks = [s * 10. ** d for d in decades for s in steps
                 if low <= s * 10. ** d <= high and d % stride == 0]
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda v, _: number(v)))
    axis.set_minor_formatter(NullFormatter())


def finish_logs(*all_axes):
    """Gives all logarithmic axes their ticks, when their ranges are final."""
    for axes in all_axes:
        if axes.get_xscale() == "log":
            log_axis(axes.xaxis)
        if axes.get_yscale() == "log":
            log_axis(axes.yaxis)


def spread(values, least):
    """Values, each moved as little as needed for a distance between all."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    groups = []  # sum of what the first value is wanted to be, members
    for i in order:
        groups.append([values[i], [i]])
        while len(groups) > 1:
            (a, first), (b, second) = groups[-2:]
            start_a, start_b = a / len(first), b / len(second)
            if start_a + len(first) * least <= start_b:
                break
            total = a + b - len(second) * len(first) * least
            groups[-2:] = [[total, first + second]]
    placed = [0.] * len(values)
    for total, members in groups:
        for k, i in enumerate(members):
            placed[i] = total / len(members) + k * least
    return placed


def label_ends(axes, labels, size=8):
    """Labels at the right of a panel, each at the height of its curve's end:
    (y, text, colour), spread so that none covers another."""
    labels = [entry for entry in labels if math.isfinite(entry[0])]
    if not labels:
        return
    transform = axes.transData + axes.transAxes.inverted()
    x = axes.get_xlim()[1]
    wanted = [transform.transform((x, y))[1] for y, _, _ in labels]
    height = axes.get_window_extent().height * 72. / axes.figure.dpi
    # Two lines in a label take twice the room.
    lines = max(text.count("\n") + 1 for _, text, _ in labels)
    places = spread(wanted, 1.25 * size * lines / height)
    over = max(places) - 1.
    places = [place - max(over, 0.) for place in places]
    for place, (_, text, colour) in zip(places, labels):
        axes.annotate(text, (1.02, place), xycoords="axes fraction", size=size,
                      color=colour, va="center", ha="left",
                      annotation_clip=False)


def mark_default(axes, x, y, text="default", offset=(9, 9), align="left"):
    """A ring around the point of the default settings."""
    if not (math.isfinite(x) and math.isfinite(y)):
        return
    axes.plot([x], [y], "o", mfc="none", mec="black", ms=11, mew=1.2, zorder=6)
    axes.annotate(text, (x, y), xytext=offset, textcoords="offset points",
                  size=8, color="black", ha=align, weight="bold",
                  path_effects=[withStroke(linewidth=2.5, foreground="white")])


def mark_failed(axes, xs, colour, height=0.97):
    """A cross near the top of a panel for each run without result."""
    if xs:
        axes.plot(xs, [height] * len(xs), "x", color=colour, ms=7, mew=1.8,
                  transform=axes.get_xaxis_transform(), clip_on=False, zorder=6)
        axes.annotate("failed", (xs[-1], height), size=7, color=colour,
                      xycoords=axes.get_xaxis_transform(), xytext=(6, -3),
                      textcoords="offset points")


def front(points):
    """Those (cost, error) that no other point beats in both, by cost."""
    best, result = math.inf, []
    for cost, error in sorted(points):
        if error < best:
            best = error
            result.append((cost, error))
    return result


def distance_to_front(point, points):
    """The largest factor by which another point is better in cost and error at
    the same time; 1 on the Pareto front. Also that point's index."""
    gains = [min(point[0] / max(cost, 1e-300), point[1] / max(error, 1e-300))
             if math.isfinite(cost) and math.isfinite(error) else 0.
             for cost, error in points]
    k = max(range(len(gains)), key=lambda i: gains[i])
    return max(gains[k], 1.), k
