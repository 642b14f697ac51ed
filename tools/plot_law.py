#!/usr/bin/python3
"""Draw a campaign and the friction law that it was made for.

Usage: tools/plot_law.py DIRECTORY [DIRECTORY ...] [--to FOLDER]
           [--temperatures 25,675] [--velocity 111] [--set WETTING=0.5 ...]
       tools/plot_law.py DIRECTORY|LAW.json --measured FILE [--over v]
           [--set T=300 ...] [--to FOLDER]

Writes into the (first) campaign's directory, or FOLDER

  friction_law.png     mu over pressure and velocity at several temperatures: the
                       law in colours with dashed lines of equal mu, and the runs
                       near each temperature as dots in the same colours; where
                       the law is not trusted, the picture is hatched
  beyond_the_data.png  mu over pressure at one velocity and these temperatures,
                       with its 95 % interval, also outside of the runs' range
  test_runs.png        if there are test runs: what the law says of them over
                       what was computed
  error_over_runs.png  error of the laws of growing numbers of runs, for each of
                       the directories, such as those of a grid, of Sobol points
                       and of active learning
  sensitivity.png      which input matters how much
  measured.png         with --measured alone: measured friction coefficients and
                       what the law says at the same points, over the input that
                       spreads most or that of --over; see
                       tools/measured_friction.py for the file

Reads runs.csv, friction_law.json, history.csv and sensitivity.csv; of further
directories history.csv alone. Numbers of the options are in the units of the
campaign (degC, m/min). Inputs besides pressure, velocity and temperature stand
at the middle of their ranges, or as --set says. Needs libasperity_friction.so,
which is built with Asperity; see asperity_friction.py.
"""

import argparse
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
except ImportError as error:
    sys.exit(f"{error}: plot_law.py needs matplotlib and numpy; "
             "tools/install_dependencies installs them.")

from asperity_friction import FrictionError
from campaign_data import NAMES, Law, LawError, Runs, read_table
from measured_friction import plot_measured

USUAL_SLICES = {"T": [25., 675.], "v": [111.]}  # in degC, m/min

LAW_COLOUR, RUN_COLOUR, TEST_COLOUR = "#12355b", "#c8553d", "#f2c14e"
NEARNESS = 0.12  # part of a range within which a run is drawn in a slice


class Campaign:
    """A directory's runs and law, and the slices through the law that are
    drawn."""

    def __init__(self, directory, arguments):
        self.name = os.path.basename(os.path.abspath(directory))
        self.runs = Runs(os.path.join(directory, "runs.csv"))
        self.inputs = self.runs.inputs
        self.law = Law(os.path.join(directory, "friction_law.json"))
        self.mu = self.runs.output(self.law.output)
        by_symbol = {entry.symbol: entry for entry in self.inputs}
        ordered = [by_symbol[s] for s in "pvT" if s in by_symbol]
        ordered += [entry for entry in self.inputs if entry not in ordered]
        self.across = ordered[0]
        self.up = ordered[1] if len(ordered) > 1 else None
        self.slice = ordered[2] if len(ordered) > 2 else None
        self.fixed = {entry.symbol: entry.middle() for entry in ordered[3:]}
        self._set(arguments.set or [])
        self.slices = self._values(self.slice, arguments.temperatures)
        self.level = self._values(self.up, arguments.velocity)[:1]

    def _set(self, settings):
        for text in settings:
            symbol, _, value = text.partition("=")
            entry = next((i for i in self.inputs
                          if symbol.lower() == i.symbol.lower()), None)
            if entry is None or entry.symbol not in self.fixed:
                raise LawError(f"'{symbol}' of --set is none of the inputs that "
                               f"are fixed: {', '.join(self.fixed) or 'none'}.")
            try:
                self.fixed[entry.symbol] = float(entry.si(float(value)))
            except ValueError:
                raise LawError(f"'{text}' of --set is not NAME=NUMBER.")

    @staticmethod
    def _values(entry, given):
        """SI values at which an input is held: those asked for, the usual ones
        within its range, or its middle."""
        if entry is None:
            return [None]
        if given:
            try:
                return [float(entry.si(float(text)))
                        for text in given.split(",")]
            except ValueError:
                raise LawError(f"'{given}' is not a list of numbers of "
                               f"{entry.label()}.")
        usual = entry.si(USUAL_SLICES.get(entry.symbol, []))
        inside = [float(value) for value in usual
                  if entry.lower - 1e-6 <= value <= entry.upper + 1e-6]
        if len(inside) == len(usual) and inside:
            return inside
        if entry.symbol == "T":
            return [entry.lower, entry.upper]
        return [entry.middle()]

    def point(self, across, up, level):
        """Values of all inputs by symbol."""
        values = dict(self.fixed)
        for entry, value in ((self.across, across), (self.up, up),
                             (self.slice, level)):
            if entry is not None:
                values[entry.symbol] = value
        return values

    def near(self, held, is_test=False):
        """Runs near the values held (by symbol): their inputs by symbol, and
        their mu as it would be at the values held, by the law's difference."""
        chosen = self.runs.is_test == is_test
        for entry, x in zip(self.inputs, self.runs.x.T):
            if held.get(entry.symbol) is not None:
                gap = entry.unit_coordinate(x) - entry.unit_coordinate(
                    held[entry.symbol])
                chosen &= np.abs(gap) <= NEARNESS
        own = {entry.symbol: x[chosen]
               for entry, x in zip(self.inputs, self.runs.x.T)}
        moved = dict(own, **{s: v for s, v in held.items() if v is not None})
        if not chosen.any():
            return own, np.zeros(0)
        ratio = self.law.predict(moved)[0] / self.law.predict(own)[0]
        return own, self.mu[chosen] * ratio

    def heading(self):
        fixed = ", ".join(entry.text(self.fixed[entry.symbol])
                          for entry in self.inputs
                          if entry.symbol in self.fixed)
        n = int((~self.runs.is_test).sum())
        return f"{self.name}: {n} runs" + (f"; {fixed}" if fixed else "")

    def slice_title(self, level):
        return "" if level is None else self.slice.text(level)


def save(figure, folder, name):
    path = os.path.join(folder, name)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    print(path)


def plot_law(campaign, folder):
    """Colours over two inputs, a panel a slice."""
    across, up = campaign.across, campaign.up
    a, u = np.meshgrid(across.between(121), up.between(121))
    fields = [campaign.law.predict(campaign.point(a, u, level))
              for level in campaign.slices]
    low = min(field[0].min() for field in fields)
    high = max(field[0].max() for field in fields)
    norm = matplotlib.colors.Normalize(low, high)
    levels = matplotlib.ticker.MaxNLocator(10).tick_values(low, high)
    n = len(fields)
    figure, panels = plt.subplots(1, n, figsize=(4.9 * n + 1.2, 4.6),
                                  squeeze=False, constrained_layout=True)
    for axes, level, (mu, _, _, trusted) in zip(panels[0], campaign.slices,
                                                fields):
        x, y = across.shown(a), up.shown(u)
        image = axes.pcolormesh(x, y, mu, cmap="viridis", norm=norm,
                                shading="gouraud", rasterized=True)
        lines = axes.contour(x, y, mu, levels=levels, colors="white", linestyles="dashed",
                             linewidths=0.9)
        axes.clabel(lines, fmt="%.3g", fontsize=7)
        if not trusted.all():
            axes.contourf(x, y, ~trusted, levels=[0.5, 1.5], colors="none",
                          hatches=["///"])
        draw_runs(axes, campaign, level, norm)
        axes.set(xlabel=across.label(), ylabel=up.label(),
                 title=campaign.slice_title(level))
    bar = figure.colorbar(image, ax=panels[0].tolist(), pad=0.01)
    bar.set_label(f"friction coefficient {label_of(campaign)}")
    explain(figure, campaign, all(field[3].all() for field in fields))
    save(figure, folder, "friction_law.png")


def draw_runs(axes, campaign, level, norm):
    """The runs near a slice, in the colours of the law: a dot that stands out
    is an error of the law."""
    held = {} if level is None else {campaign.slice.symbol: level}
    own, mu = campaign.near({**campaign.fixed, **held})
    axes.scatter(campaign.across.shown(own[campaign.across.symbol]),
                 campaign.up.shown(own[campaign.up.symbol]), c=mu, norm=norm,
                 cmap="viridis", s=46, edgecolors="black", linewidths=0.9,
                 zorder=3, clip_on=False)


def label_of(campaign):
    return "µ [–]" if campaign.law.output == "mu" else (
        f"{campaign.law.output} [–]")


def explain(figure, campaign, is_trusted):
    """The name of the campaign, what the dots are, and the hatching."""
    text = campaign.heading()
    if campaign.slice is not None:
        entry = campaign.slice
        half = NEARNESS * (entry.upper - entry.lower) * entry.factor
        unit = entry.unit.replace("°C", "K")  # a difference
        within = (f"±{half:.3g} {unit}" if entry.scale == "linear" else
                  f"{100 * NEARNESS:.0f} % of the range")
        text += (f"\ndots: runs within {within}, moved to the panel's "
                 f"{NAMES.get(entry.symbol, 'value')} by the law")
    if not is_trusted:
        text += "; hatched: not trusted"
    figure.suptitle(text, fontsize=10)


def plot_beyond(campaign, folder):
    """mu over the first input with its interval, in and outside of the box."""
    across, v = campaign.across, campaign.level[0]
    width = across.upper - across.lower
    low = max(across.lower - 0.4 * width, 0.05 * across.lower)
    a = across.between(400, low, across.upper + 0.4 * width)
    n = len(campaign.slices)
    figure, panels = plt.subplots(1, n, figsize=(4.9 * n + 0.6, 4.4),
                                  sharey=True, squeeze=False,
                                  constrained_layout=True)
    inside = (a >= across.lower) & (a <= across.upper)
    tops, bottoms = [], []
    for axes, level in zip(panels[0], campaign.slices):
        points = campaign.point(a, v, level)
        mu, lower, upper, trusted = campaign.law.predict(points)
        _, *whole, _ = campaign.law.predict(points, of_surface=True)
        x = across.shown(a)
        if campaign.law.law.topography.profiles > 1:
            axes.fill_between(x, *whole, color=LAW_COLOUR, alpha=0.1, lw=0.,
                              label="95 % interval of the whole surface")
        axes.fill_between(x, lower, upper, color=LAW_COLOUR, alpha=0.2, lw=0.,
                          label="95 % interval")
        axes.plot(x, mu, "--", color=LAW_COLOUR, lw=1.2, label="law")
        axes.plot(x, np.where(trusted, mu, np.nan), color=LAW_COLOUR, lw=2.2,
                  label="law, trusted")
        for end in (across.lower, across.upper):
            axes.axvline(across.shown(end), color="#4a4f57", lw=0.8, ls=":")
        held = {e.symbol: value for e, value in ((campaign.up, v),
                                                 (campaign.slice, level))
                if e is not None}
        for is_test, colour in ((False, RUN_COLOUR), (True, TEST_COLOUR)):
            own, near = campaign.near({**campaign.fixed, **held}, is_test)
            if len(near):
                axes.plot(across.shown(own[across.symbol]), near, "o", ms=5,
                          color=colour, mec="black", mew=0.6, zorder=3,
                          label="test runs near" if is_test else "runs near")
        title = [entry.text(value) for entry, value in
                 ((campaign.up, v), (campaign.slice, level))
                 if entry is not None]
        axes.set(xlabel=across.label(), title=", ".join(title))
        axes.grid(alpha=0.3)
        tops.append(max(whole[1][inside].max(), mu.max()))
        bottoms.append(min(whole[0][inside].min(), mu.min()))
    room = 0.35 * (max(tops) - min(bottoms))
    panels[0][0].set_ylim(max(0., min(bottoms) - room), max(tops) + room)
    panels[0][0].set_ylabel(f"friction coefficient {label_of(campaign)}")
    panels[0][-1].legend(loc="best", fontsize=8)
    figure.suptitle(campaign.heading() + "; the runs' range is dotted",
                    fontsize=10)
    save(figure, folder, "beyond_the_data.png")


def plot_tests(campaign, folder):
    """Law over computation for the test runs."""
    is_test = campaign.runs.is_test
    x = {entry.symbol: column[is_test]
         for entry, column in zip(campaign.inputs, campaign.runs.x.T)}
    computed = campaign.mu[is_test]
    mu, lower, upper, _ = campaign.law.predict(x)
    error = np.abs(mu - computed) / np.abs(computed)
    covered = np.mean((lower <= computed) & (computed <= upper))
    figure, axes = plt.subplots(figsize=(5.4, 5.2), constrained_layout=True)
    axes.errorbar(computed, mu, yerr=[mu - lower, upper - mu], fmt="o", ms=4,
                  color=LAW_COLOUR, ecolor="#9fb3c8", elinewidth=0.9)
    ends = [min(computed.min(), mu.min()), max(computed.max(), mu.max())]
    axes.plot(ends, ends, color=RUN_COLOUR, lw=1.2, zorder=0)
    axes.set(xlabel=f"computed {label_of(campaign)}",
             ylabel=f"law, with its 95 % interval {label_of(campaign)}")
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(alpha=0.3)
    axes.set_title(f"{campaign.name}: {is_test.sum()} test runs, mean error "
                   f"{100 * error.mean():.3g} %, largest {100 * error.max():.3g}"
                   f" %,\n{100 * covered:.0f} % of them in the interval",
                   fontsize=10)
    save(figure, folder, "test_runs.png")


def plot_errors(directories, folder):
    """Errors of laws over the number of runs, a colour a campaign."""
    figure, axes = plt.subplots(figsize=(7., 4.8), constrained_layout=True)
    colours = plt.rcParams["axes.prop_cycle"].by_key()["color"]
    for number, directory in enumerate(directories):
        path = os.path.join(directory, "history.csv")
        history = read_table(path)
        colour = colours[number % len(colours)]
        name = os.path.basename(os.path.abspath(directory))
        try:
            runs, tested = history["runs"], 100. * history["test error"]
            left_out = 100. * history["leave one out error"]
        except KeyError as error:
            raise LawError(f"{path} has no column {error}.")
        if np.isfinite(tested).any():
            axes.plot(runs, tested, "-o", color=colour, ms=4, lw=1.6,
                      label=f"{name}: test runs")
        axes.plot(runs, left_out, "--s", color=colour, ms=3.5, lw=1.,
                  mfc="white", label=f"{name}: leave one out")
    axes.set(yscale="log", xlabel="number of training runs",
             ylabel="mean relative error [%]")
    axes.yaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(
        lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(matplotlib.ticker.FuncFormatter(
        lambda value, _: f"{value:g}" if f"{value:e}"[0] in "25" else ""))
    axes.set_xlim(left=0.)
    axes.grid(alpha=0.3, which="both")
    axes.legend(fontsize=9)
    save(figure, folder, "error_over_runs.png")


def plot_sensitivity(directory, folder):
    """First-order and total indices as bars with their intervals."""
    path = os.path.join(directory, "sensitivity.csv")
    table = read_table(path, 2)
    try:
        labels = [NAMES.get(symbol, name.split("/")[-1].lower())
                  for name, symbol in zip(table["input"], table["symbol"])]
        bars = [("S1", "by itself (first order)", LAW_COLOUR),
                ("ST", "with its interactions (total)", TEST_COLOUR)]
        figure, axes = plt.subplots(figsize=(1.6 * len(labels) + 2., 4.2),
                                    constrained_layout=True)
        x = np.arange(len(labels))
        for side, (key, text, colour) in zip((-0.2, 0.2), bars):
            axes.bar(x + side, table[key], 0.38, yerr=table[key + "_conf"],
                     color=colour, capsize=4, label=text)
    except KeyError as error:
        raise LawError(f"{path} has no column {error}.")
    axes.set_xticks(x, labels)
    axes.set_ylabel("share of the variance of µ [–]")
    axes.axhline(0., color="black", lw=0.8)
    axes.grid(alpha=0.3, axis="y")
    axes.legend(fontsize=9)
    axes.set_title(os.path.basename(os.path.abspath(directory)) +
                   ": Sobol sensitivity indices", fontsize=10)
    save(figure, folder, "sensitivity.png")


def plot(arguments):
    if arguments.measured:
        return plot_measured(arguments, save)
    for directory in arguments.directories:
        if not os.path.isdir(directory):
            raise LawError(f"{directory} is not a directory.")
    first = arguments.directories[0]
    folder = arguments.to or first
    os.makedirs(folder, exist_ok=True)
    campaign = Campaign(first, arguments)
    if campaign.up is not None:
        plot_law(campaign, folder)
    plot_beyond(campaign, folder)
    if campaign.runs.is_test.any():
        plot_tests(campaign, folder)
    plot_errors(arguments.directories, folder)
    plot_sensitivity(first, folder)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("directories", nargs="+", metavar="DIRECTORY",
                        help="output directories of campaigns")
    parser.add_argument("--to", help="folder for the pictures")
    parser.add_argument("--temperatures", help="such as 25,300,675")
    parser.add_argument("--velocity", help="of beyond_the_data.png")
    parser.add_argument("--set", action="append", metavar="NAME=VALUE",
                        help="value of an input of the law")
    parser.add_argument("--measured", metavar="FILE",
                        help="draw measured.png alone, beside this file")
    parser.add_argument("--over", metavar="INPUT", help="of measured.png")
    try:
        plot(parser.parse_args())
    except (LawError, FrictionError) as error:
        print(f"plot_law.py: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
