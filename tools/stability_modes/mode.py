"""What a failure mode is: its cells, how a cell is measured and judged."""

import math
from dataclasses import dataclass, field

RIGHT, TOLD, WRONG, NOT_FINITE, HUNG = OUTCOMES = (
    "right", "ended with a sentence", "wrong", "not finite", "hung")


@dataclass
class Axis:
    """A setting of the cells; its values in the order in which they come."""
    setting: str
    label: str
    names: dict = field(default_factory=dict)

    def name(self, value):
        return self.names.get(value, value)


@dataclass
class Measurement:
    """What became of a cell. ended: "values", "warned" (values, with a warning
    about what the mode is about), "reported" (a sentence instead of values),
    "failed" (anything that is neither) or "hung"."""
    ended: str
    values: dict = field(default_factory=dict)
    sentence: str = ""


@dataclass
class Mode:
    name: str        # C1 to C29
    title: str
    question: str    # how the method is known to fail
    swept: str       # for the table
    band: str        # what counts as right
    conclusion: str
    x: Axis
    y: Axis
    panels: Axis
    values: list     # names of what is measured
    cells: object    # full -> list of settings, all of them text
    measure: object  # (cell, means) -> Measurement
    bands: dict      # value: largest that is right
    reference: object = None  # (row, rows) -> {value: expected}

    def settings(self):
        return [a.setting for a in (self.panels, self.y, self.x)]

    def judge(self, row, rows):
        """The outcome of a row, and the value that decided."""
        ended = row["ended"]
        if ended in ("reported", "hung", "failed"):
            return ({"reported": TOLD, "hung": HUNG, "failed": WRONG}[ended], "")
        errors = {value: number(row[value]) for value in self.bands}
        if self.reference:
            expected = self.reference(row, rows)
            for value, exact in expected.items():
                errors[value] = (abs(errors[value] / exact - 1.)
                                 if exact is not None else math.nan)
                if exact is None:
                    return WRONG, "there is no reference"
        if not all(math.isfinite(error) for error in errors.values()):
            return NOT_FINITE, ""
        worst = max(errors, key=lambda value: errors[value] / self.bands[value])
        note = f"{worst} {errors[worst]:.2g} off"
        if errors[worst] <= self.bands[worst]:
            return RIGHT, note
        return (TOLD if ended == "warned" else WRONG), note


def number(text):
    return math.nan if text in ("", None) else float(text)


def grid(**axes):
    """All combinations, as text."""
    cells = [{}]
    for name, values in axes.items():
        cells = [{**cell, name: str(value)}
                 for cell in cells for value in values]
    return cells


def exceeds(values, bands):
    """Whether a value is not below its band; one that is no number is not."""
    return any(not values.get(value, math.nan) <= band
               for value, band in bands.items())
