"""What a campaign leaves behind, as plot_law.py reads it: the table of runs, the
friction law as a function of arrays, and smaller tables."""

import csv
import json

import numpy as np

from asperity_friction import FrictionError, FrictionLaw

# people's units: (factor, offset) of an SI value
UNITS = {"MPa": (1e-6, 0.), "GPa": (1e-9, 0.), "kPa": (1e-3, 0.),
         "m/min": (60., 0.), "mm/s": (1e3, 0.), "degC": (1., -273.15),
         "um": (1e6, 0.), "nm": (1e9, 0.), "mm": (1e3, 0.), "us": (1e6, 0.),
         "%": (100., 0.), "mPa s": (1e3, 0.), "kg/m3": (1., 0.)}
NAMES = {"p": "pressure", "v": "velocity", "T": "temperature"}
CONFIDENCE = 1.96  # standard deviations of the 95 % interval


class LawError(Exception):
    """Something is missing from the campaign; the message is for the user."""


class Input:
    """An input of the law and how people read it."""

    def __init__(self, symbol, name, unit, lower, upper, scale):
        self.symbol, self.name, self.scale = symbol, name, scale
        self.lower, self.upper = float(lower), float(upper)
        self.factor, self.offset = UNITS.get(unit, (1., 0.))
        self.unit = unit.replace("degC", "°C").replace("um", "µm")
        if unit not in UNITS:
            self.unit = "–" if unit == "1" else "SI"

    def shown(self, value):
        return self.factor * np.asarray(value) + self.offset

    def si(self, shown):
        return (np.asarray(shown) - self.offset) / self.factor

    def label(self):
        name = NAMES.get(self.symbol, self.name.split("/")[-1].lower())
        return f"{name} [{self.unit}]"

    def text(self, value):
        """A value as in a heading."""
        unit = "" if self.unit in ("–", "SI") else " " + self.unit
        name = "" if self.symbol in NAMES else self.symbol + " = "
        return f"{name}{float(self.shown(value)):.4g}{unit}"

    def unit_coordinate(self, value):
        g = np.log if self.scale == "logarithmic" else np.asarray
        return (g(value) - g(self.lower)) / (g(self.upper) - g(self.lower))

    def middle(self):
        if self.scale == "logarithmic":
            return np.sqrt(self.lower * self.upper)
        return 0.5 * (self.lower + self.upper)

    def between(self, n, low=None, high=None):
        low = self.lower if low is None else low
        high = self.upper if high is None else high
        return np.linspace(low, high, n)


class Runs:
    """The sample table of a campaign; values in SI units."""

    def __init__(self, path):
        self.inputs = []
        try:
            with open(path, newline="", encoding="utf-8") as file:
                lines = file.read().splitlines()
            for line in lines:
                if line.startswith("# input: "):
                    self.inputs.append(
                        Input(*[part.strip() for part in line[9:].split(";")]))
            rows = list(csv.reader(line for line in lines
                                   if not line.startswith("#")))
            names = [name.split(" [")[0] for name in rows[0]]
            done = [row for row in rows[1:] if row[2] == "done"]
            self.is_test = np.array([row[1] == "test" for row in done], bool)
            numbers = np.array([row[3:-1] for row in done], float)
            self.columns = dict(zip(names[3:-1], numbers.T))
        except (OSError, ValueError, IndexError, TypeError) as error:
            raise LawError(f"{path} cannot be read as a table of runs: {error}.")
        if not len(numbers):
            raise LawError(f"{path} holds no run that is done.")
        self.x = numbers[:, :len(self.inputs)]

    def output(self, name):
        if name not in self.columns:
            raise LawError(f"The runs have no column '{name}', which the law is "
                           f"about; they have {', '.join(self.columns)}.")
        return self.columns[name]


class Law:
    """The friction law as a function of arrays of its inputs."""

    def __init__(self, path):
        try:
            with open(path, encoding="utf-8") as file:
                document = json.load(file)
            self.law = FrictionLaw(path)
        except (OSError, ValueError, FrictionError) as error:
            raise LawError(f"{path} cannot be read as a friction law: {error}")
        output = document["output"]
        self.output = output["name"]
        self.is_logarithmic = output["scale"] == "logarithmic"
        if document.get("model") == "piecewise power law":
            self.noise = (document["calibration"]
                          * document["constants"]["scatter"])
        else:
            self.noise = output["factor"] * np.sqrt(
                document["hyperparameters"]["noise_variance"])
        self.inputs = [Input(*[entry[key] for key in
                               ("symbol", "name", "unit", "lower", "upper",
                                "scale")]) for entry in document["inputs"]]

    def predict(self, values, of_surface=False):
        """mu, ends of the 95 % interval of another run on these profiles or of
        the mean over the whole surface, trusted; values: arrays by symbol."""
        values = dict(zip(values, np.broadcast_arrays(*values.values())))
        points = [values.pop(symbol, 0.) for symbol in "pvT"]
        answer = self.law.predict(*points, others=values)
        mu, deviation = np.asarray(answer.mu), np.asarray(answer.deviation)
        scale = mu if self.is_logarithmic else 1.
        half = CONFIDENCE * np.hypot(deviation / scale, self.noise)
        if of_surface:
            half = np.hypot(half, self.law.topography.error * mu / scale)
        trusted = np.asarray(answer.trusted)
        if self.is_logarithmic:
            return mu, mu * np.exp(-half), mu * np.exp(half), trusted
        return mu, mu - half, mu + half, trusted


def read_table(path, n_text_columns=0):
    """Columns by name without unit; numbers that are missing are NaN."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file
                                   if not line.startswith("#")))
        names = [name.split(" [")[0] for name in rows[0]]
        columns = list(zip(*rows[1:])) or [()] * len(names)
        table = {}
        for i, (name, column) in enumerate(zip(names, columns)):
            table[name] = list(column) if i < n_text_columns else np.array(
                [float(text) if text else np.nan for text in column])
        return table
    except (OSError, ValueError, IndexError) as error:
        raise LawError(f"{path} cannot be read as a table: {error}.")
