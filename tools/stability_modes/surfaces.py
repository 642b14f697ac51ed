"""Surfaces and laws: C11, C24."""

import csv
import os

import numpy as np

from .mode import Axis, Mode, exceeds, grid

PLACES = {"valley": "above a valley", "asperity": "in front of a sharp asperity",
          "corner": "beside a corner", "open_end": "above a crest"}
PROJECTION = {"wrong": 0.5, "uncertified": 0.5}
C11 = Mode(
    "C11", "closest point: several minima, kinks, centres of curvature",
    "Newton's method from a near guess ends in another minimum, and at the "
    "centre of curvature it has no second derivative.",
    "height above the curve over the radius of curvature (1 is its centre), "
    "place, degree; 100 points a cell, half of them with a bad guess",
    "each distance that of a brute-force search to 1e-11, each certified",
    "Not one wrong point: the certificate finds the global minimum whatever "
    "the guess.",
    Axis("offset", "height over radius of curvature"),
    Axis("case", "place", PLACES),
    Axis("degree", "degree", {str(p): f"degree {p}" for p in range(1, 8)}),
    ["wrong", "uncertified", "error"],
    lambda full: grid(degree=[2, 3, 5] if not full else [1, 2, 3, 4, 5, 7],
                      case=PLACES,
                      offset=[-10, -1, -0.1, 0, 0.1, 0.5, 0.9, 0.99, 1, 1.01,
                              1.5, 2, 10, 100]),
    lambda cell, means: means.sweep("C11", cell), PROJECTION)

FACES = {"-1": "everywhere", "0": "no p low", "1": "no p high", "2": "no v low",
         "3": "no v high", "4": "no T low", "5": "no T high"}
INTERVAL = {"miss": 0.05}


def interval(cell, means):
    found = means.sweep("C24", cell)
    if "coverage" in found.values:
        # Of the share outside of the interval: too many is what misleads.
        found.values["miss"] = max(0., 0.95 - found.values["coverage"])
    return found


C24 = Mode(
    "C24", "Gaussian process: too sure of itself",
    "The interval holds less than it says between points of a kink, with noise "
    "that was not learnt, and beyond the data.",
    "noise of the runs, where the box has no training points (a slab of 15 %), "
    "points, smooth or with a kink; 1000 other runs",
    "the 95 % interval holds at least 90 % of them",
    "Within its points the interval holds what it says, but for 5 % of noise "
    "on 80 points (83 % instead of 95), and that and a slab without points "
    "are told.",
    Axis("noise", "relative noise of a run"),
    Axis("face", "training points", FACES),
    Axis("law", "law"), ["coverage", "miss", "error"],
    lambda full: grid(law=["dry, 80 points", "lubricated, 80 points"] +
                      (["dry, 150 points", "lubricated, 150 points"] if full
                       else []),
                      face=FACES, noise=[0, 0.0002, 0.002, 0.01, 0.05]),
    lambda cell, means: interval({
        "truth": cell["law"].split(", ")[0],
        "points": cell["law"].split(", ")[1].split()[0],
        "noise": cell["noise"], "face": cell["face"]}, means), INTERVAL)

KINDS = {"waves": "waves", "step": "a step", "rough": "self-affine, H = 0.8"}


def heights(kind):
    """A profile of 200 points over 20 um, in um, with an rms of 0.2."""
    x = np.arange(200) / 200.
    if kind == "waves":
        z = np.sin(8. * np.pi * x) + 0.5 * np.sin(14. * np.pi * x + 1.)
    elif kind == "step":
        z = np.tanh(8. * np.sin(2. * np.pi * (x - 0.22)))
    else:
        k = np.arange(1, 40)
        phase = np.random.default_rng(1).uniform(0., 2. * np.pi, k.size)
        z = (k ** -1.3 * np.cos(2. * np.pi * np.outer(x, k) + phase)).sum(1)
    z -= z.mean()
    return 0.2 * z / z.std()


TREATMENT = {"no search": 0, "spikes beyond 8 removed": 8}
FIT = {"height": 0.1}


def fitted(cell, means):
    """A map of equal rows whose middle one has a spike, and the profile that
    is made of it, against the profile without."""
    z = heights(cell["kind"])
    noise = np.random.default_rng(2).normal(0., 0.01, (40, z.size))
    rows = z + noise
    rows[20, 60] += 0.2 * float(cell["spike"])
    text = "\n".join(" ".join(f"{v:.6f}" for v in row) for row in rows) + "\n"
    entries = {"Topography/File": "map.txt", "Topography/Spacing x": "0.1 um",
               "Topography/Height unit": "um",
               "Topography/F-operator": "none",
               "Topography/Profile position": "row 20",
               "Topography/Spike threshold": TREATMENT[cell["treatment"]]}

    def read(scene):
        with open(os.path.join(scene.folder, "profile.csv"),
                  encoding="utf-8") as file:
            found = np.array([row[1] for row in list(csv.reader(file))[2:]],
                             dtype=float) * 1e6
        found = np.interp(np.arange(200) / 200.,
                          np.arange(found.size) / found.size, found)
        # At the seam of the period measured heights fade out of the fit.
        off = (found - z)[20:-20]
        off -= np.median(off)
        return {"height": float(np.abs(off).max() / np.ptp(z))}
    also = {"map.txt": text}
    result = means.run(entries, read, command="topography", also=also,
                       output="Output directory", about="neighbours|tilts")
    if result.ended == "values" and exceeds(result.values, FIT):
        scene = {f"Tool/{path}": value for path, value in entries.items()}
        told = means.run({"Tool/Kind": "measured", **scene}, lambda _: {},
                         command="check", also=also,
                         about="steeper than|neighbours|tilts")
        result.ended = "warned" if told.sentence else "values"
        result.sentence = told.sentence
    return result


C27 = Mode(
    "C27", "fit of a measured profile: spikes and steep flanks",
    "A spline that is fitted through a spike or a step overshoots beside it, "
    "and the tool of the scene has a peak that no surface had.",
    "height of a spike of the microscope over the rms roughness, kind of the "
    "surface, search for spikes",
    "largest error of the profile below 10 % of its peak-to-valley height",
    "Searched for, spikes of the height of the roughness and more are found; "
    "left in, the profile is told to have one. The line that is taken off a "
    "profile before it is closed to a period tilts one with a step, or with "
    "few waves, by up to 10 % of its height, which is told where the ends meet "
    "without.",
    Axis("spike", "height of a spike over the rms roughness"),
    Axis("kind", "surface", KINDS), Axis("treatment", "treatment"),
    ["height"],
    lambda full: grid(treatment=TREATMENT, kind=KINDS,
                      spike=[0, 0.3, 1, 3, 10, 100, 1000]),
    fitted, FIT)

MODES = [C11, C24]
