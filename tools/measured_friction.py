"""Measured friction beside a law: the file of measurements, read as strictly as
`asperity fit` reads it, and its picture.

A file of measurements is comma-separated. Lines that begin with # are comments;
the first other line has the headings: `mu`; `deviation of mu`, `series` and
`source` if they are known; and inputs by their symbols, with units, `v [m/min]`,
`p [MPa]`, `T [degC]`. A cell of an input or a deviation is empty where it is not
known. parameter_files/experiments has such files.
"""

import csv
import os

import matplotlib.pyplot as plt
import numpy as np

from campaign_data import CONFIDENCE, Law, LawError, NAMES, UNITS

OWN = ("mu", "deviation of mu", "series", "source")
SI_UNITS = {"Pa": (1., 0.), "m/s": (1., 0.), "K": (1., 0.), "1": (1., 0.)}
UNITS_OF = {"p": ("Pa", "kPa", "MPa", "GPa"), "v": ("m/s", "m/min", "mm/s"),
            "T": ("K", "degC")}
COLOURS = ("#12355b", "#c8553d", "#3a7d44", "#8a4f9e", "#b8860b", "#4a4f57")


class Measurements:
    """Columns of a file in SI: mu, deviation (NaN: not known), series, and the
    inputs by symbol (NaN: not known)."""

    def __init__(self, path):
        self.path = path
        try:
            with open(path, newline="", encoding="utf-8-sig") as file:
                lines = file.read().splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise LawError(f"The measurements {path} cannot be read: {error}.")
        rows = [(number, next(csv.reader([line.strip()])))
                for number, line in enumerate(lines, 1)
                if line.strip() and not line.strip().startswith("#")]
        if not rows:
            raise LawError(f"{path} has no headings; a line such as "
                           "'v [m/min],mu' is expected.")
        self.line = rows[0][0]
        names = [self._column(text.strip()) for text in rows[0][1]]
        symbols = [name for name, _ in names]
        if len(set(symbols)) < len(symbols):
            self._fail("two columns have one name, but different names are "
                       "expected")
        if "mu" not in symbols:
            self._fail("the headings have no column 'mu', but the friction "
                       "coefficient is expected")
        table = {symbol: [] for symbol in symbols}
        for self.line, cells in rows[1:]:
            if len(cells) != len(names):
                self._fail(f"{len(cells)} columns were found, but {len(names)} "
                           "are expected")
            for (symbol, unit), cell in zip(names, cells):
                table[symbol].append(self._cell(symbol, unit, cell.strip()))
        if len(rows) < 2:
            self._fail("the file ends behind its headings, but a measurement is "
                       "expected")
        n = len(table["mu"])
        self.mu = np.array(table["mu"])
        self.deviation = np.array(table.get("deviation of mu", [np.nan] * n))
        self.series = table.get("series", [""] * n)
        self.x = {symbol: np.array(values) for symbol, values in table.items()
                  if symbol not in OWN}

    def _fail(self, sentence):
        raise LawError(f"Line {self.line} of the measurements {self.path}: "
                       f"{sentence}.")

    def _column(self, heading):
        """Symbol and unit of a column."""
        if heading in OWN:
            return heading, None
        symbol, bracket, unit = heading.rpartition(" [")
        if not bracket or not unit.endswith("]"):
            self._fail(f"the heading '{heading}' was found, but "
                       f"{', '.join(OWN)}, or an input with its unit, such as "
                       "'v [m/min]', is expected")
        unit = unit[:-1]
        known = UNITS_OF.get(symbol, list(UNITS) + list(SI_UNITS))
        if unit not in known:
            self._fail(f"the heading '{heading}' was found, but one of the units "
                       f"{', '.join(known)} is expected")
        return symbol, unit

    def _cell(self, symbol, unit, text):
        if symbol in ("series", "source"):
            return text
        if not text and symbol != "mu":
            return np.nan
        try:
            value = float(text)
        except ValueError:
            value = np.nan
        if not np.isfinite(value) or (unit is None and value <= 0.):
            kind = "positive number" if unit is None else "number"
            self._fail(f"in the column '{symbol}' '{text}' was found, but a "
                       f"{kind} is expected")
        factor, offset = {**SI_UNITS, **UNITS}.get(unit, (1., 0.))
        return (value - offset) / factor


def point_values(measured, inputs, given):
    """SI values of the law's inputs at all points, by symbol.
    given: values by symbol of inputs that the file does not have"""
    known = {entry.symbol for entry in inputs}
    for symbol in measured.x:
        if symbol not in known:
            raise LawError(f"The law does not depend on '{symbol}', a column of "
                           f"{measured.path}; its inputs are "
                           f"{', '.join(sorted(known))}.")
    values = {}
    for entry in inputs:
        column = measured.x.get(entry.symbol)
        if column is None and entry.symbol not in given:
            raise LawError(f"The law depends on '{entry.symbol}', which "
                           f"{measured.path} does not have; give it by "
                           f"--set {entry.symbol}=NUMBER.")
        if column is None:
            column = np.full(len(measured.mu), given[entry.symbol])
        elif np.isnan(column).any() and entry.symbol in given:
            column = np.where(np.isnan(column), given[entry.symbol], column)
        if np.isnan(column).any():
            raise LawError(f"{measured.path} has points without "
                           f"{entry.symbol}, on which the law depends; give it "
                           f"by --set {entry.symbol}=NUMBER.")
        values[entry.symbol] = column
    return values


def abscissa(measured, inputs, wanted):
    """The input over which mu is drawn: the one asked for, or the one that
    spreads most."""
    by_symbol = {entry.symbol: entry for entry in inputs}
    if wanted:
        if wanted not in by_symbol or wanted not in measured.x:
            raise LawError(f"'{wanted}' of --over is no column that the law "
                           "depends on.")
        return by_symbol[wanted]
    spread = {symbol: np.nanmax(x) / max(np.nanmin(x), 1e-300)
              for symbol, x in measured.x.items() if symbol in by_symbol}
    if not spread:
        raise LawError(f"{measured.path} has no input of the law.")
    return by_symbol[max(spread, key=spread.get)]


def draw_series(axes, measured, chosen, law, values, over, colour, name):
    """Dots that were measured, and what the law says at the same points; a line
    where the points differ in one input only."""
    x = over.shown(values[over.symbol][chosen])
    error = CONFIDENCE * measured.deviation[chosen]
    axes.errorbar(x, measured.mu[chosen],
                  yerr=None if np.isnan(error).all() else error, fmt="o", ms=6,
                  color=colour, capsize=3, label=f"{name}measured", zorder=3)
    own = {symbol: column[chosen] for symbol, column in values.items()}
    mu, lower, upper, trusted = law.predict(own)
    axes.errorbar(x, mu, yerr=[mu - lower, upper - mu], fmt="D", ms=6,
                  mfc="white", color=colour, elinewidth=0.8, alpha=0.9,
                  label=f"{name}law, with its 95 % interval")
    if not trusted.all():
        axes.plot(x[~trusted], mu[~trusted], "x", ms=10, color=colour,
                  label=f"{name}law, not trusted")
    others = [column for symbol, column in own.items() if symbol != over.symbol]
    if len(set(x)) > 1 and all(np.ptp(column) < 1e-9 * abs(column[0]) + 1e-12
                               for column in others):
        along = {symbol: column[0] for symbol, column in own.items()}
        line = np.linspace(own[over.symbol].min(), own[over.symbol].max(), 200)
        along[over.symbol] = line
        axes.plot(over.shown(line), law.predict(along)[0], color=colour, lw=1.4)
    return np.mean(np.abs(mu / measured.mu[chosen] - 1.))


def plot_measured(arguments, save):
    """Draws measured.png beside a law's file or into its campaign's folder.
    save: takes figure, folder and name"""
    first = arguments.directories[0]
    if len(arguments.directories) > 1:
        raise LawError("--measured takes one law or campaign.")
    path = first if os.path.isfile(first) else os.path.join(
        first, "friction_law.json")
    law = Law(path)
    inputs = law.inputs
    measured = Measurements(arguments.measured)
    given = {}
    for text in arguments.set or []:
        symbol, _, value = text.partition("=")
        entry = next((i for i in inputs if i.symbol.lower() == symbol.lower()),
                     None)
        try:
            given[entry.symbol] = float(entry.si(float(value)))
        except (AttributeError, ValueError):
            raise LawError(f"'{text}' of --set is not NAME=NUMBER of an input.")
    values = point_values(measured, inputs, given)
    over = abscissa(measured, inputs, arguments.over)
    names = list(dict.fromkeys(measured.series))
    figure, axes = plt.subplots(figsize=(7.4, 5.), constrained_layout=True)
    errors = []
    for number, name in enumerate(names):
        chosen = np.array([text == name for text in measured.series])
        errors.append(draw_series(axes, measured, chosen, law, values, over,
                                  COLOURS[number % len(COLOURS)],
                                  name + ": " if name else ""))
    fixed = [next(i for i in inputs if i.symbol == symbol).text(value)
             for symbol, value in given.items()]
    axes.set(xlabel=over.label(), ylabel="friction coefficient µ [–]",
             ylim=(0., None))
    axes.set_title(f"{os.path.basename(measured.path)}: mean error "
                   f"{100 * np.mean(errors):.3g} %"
                   + (f"; {', '.join(fixed)}" if fixed else ""), fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    folder = arguments.to or os.path.dirname(path) or "."
    os.makedirs(folder, exist_ok=True)
    save(figure, folder, "measured.png")
