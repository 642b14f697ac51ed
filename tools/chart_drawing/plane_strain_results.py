"""What the runs of the chart of plane strain say: errors of profiles against the
patch of the same surface."""

import dataclasses
import math

STR = {"blasted": 0.6, "ground": 0.15}  # of the whole maps
FAIR = 10.  # per cent that a profile may err


def mean(values):
    values = [value for value in values if math.isfinite(value)]
    return sum(values) / len(values) if values else math.nan


def error(value, of):
    """In per cent."""
    return 100. * (value / of - 1.)


@dataclasses.dataclass
class Group:
    """Realisations of one kind of surface at one Str, and what is between it and
    the chip. Errors are in per cent of the patch."""
    surface: str
    interface: tuple  # shear factor and wetting
    stretch: float
    patches: dict  # {seed: value}
    profiles: dict  # {seed: values}

    @property
    def ratio(self):
        return STR.get(self.surface, 1. / self.stretch)

    @property
    def patch(self):
        return mean(self.patches.values())

    def all_profiles(self):
        return [value for seed in self.patches for value in self.profiles[seed]]

    def of_all_profiles(self):
        """Mean over the profiles of all surfaces."""
        return mean([mean(self.profiles[seed]) for seed in self.patches])

    def of_means(self):
        """Errors of the mean over the profiles of a surface, by seed."""
        return {seed: error(mean(self.profiles[seed]), patch)
                for seed, patch in self.patches.items()}

    def bias(self):
        """Error of the mean over the profiles of all surfaces."""
        return error(self.of_all_profiles(), self.patch)

    def of_profiles(self):
        return [error(value, patch) for seed, patch in self.patches.items()
                for value in self.profiles[seed]]

    def typical(self):
        """Root mean square of the errors of single profiles."""
        return math.sqrt(mean([e * e for e in self.of_profiles()]))


def interface_of(row):
    return row["m"], row["wetting"]


def groups(rows, settings=""):
    """For each quantity: groups by (surface, interface, stretch), in the order of
    the table."""
    return {quantity: groups_of(rows, quantity, settings)
            for quantity in ("mu", "contact fraction", "oil share")}


def groups_of(rows, quantity, settings=""):
    result = {}
    for row in rows:
        if row["kind"] != "patch" or row["settings"] != settings or \
                not math.isfinite(row[quantity]):
            continue
        key = row["surface"], interface_of(row), row["stretch or row"]
        group = result.setdefault(key, Group(*key, {}, {}))
        same = [other for other in rows if other["settings"] == settings and
                (other["surface"], interface_of(other)) == key[:2]]
        group.patches[row["seed"]] = row[quantity]
        group.profiles[row["seed"]] = [
            other[quantity] for other in same if other["kind"] == "profile"
            and other["seed"] == row["seed"]]
    return result


def fair_up_to(of_stretches, measure):
    """The largest Str up to which, from the lowest on, a measure of the groups
    stays below FAIR; None if the lowest is above already."""
    largest = None
    for group in sorted(of_stretches, key=lambda group: group.ratio):
        if not abs(measure(group)) <= FAIR:
            break
        largest = group.ratio
    return largest
