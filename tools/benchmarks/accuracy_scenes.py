"""Forty dry scenes on which the numerical error of mu is judged: the sixteen
reference scenes, and 24 profiles of five surfaces at loads, distances and
places that are drawn from the ranges of the reference scenes with a fixed
seed. Three of the surfaces are measured ones that are no part of this
repository (parameter_files/surfaces/README.md); scenes of files that are not
there are left out.

Beside them, for single tasks, R0 with two more harmonics."""

import os
import random

import dry_scene

REFERENCE = os.path.join(dry_scene.ROOT, "parameter_files", "reference_scenes")
MEASURED = os.path.join(dry_scene.ROOT, "parameter_files", "measured_surfaces")
SHARED = os.path.join(os.path.dirname(dry_scene.ROOT), "shared", "surfaces")
TOPOGRAPHY = "Tool/Topography/"
TWO_MORE_HARMONICS = {
    "Tool/Wave numbers": "1, 2, 3, 4, 5, 6, 12, 25",
    "Tool/Amplitudes":
        "0.16, 0.12, 0.09, 0.06, 0.04, 0.02, 0.03, 0.015 um",
    "Tool/Phases": "0.3, 1.9, 4.1, 5.2, 0.9, 2.6, 1.1, 2.2 rad"}
LAND = os.path.join(SHARED, "sample-land.x3p")
# As `asperity new` reads it, and scaled as the wire is.
LAND_ENTRIES = {
    "Tool/Kind": "measured", TOPOGRAPHY + "File": LAND,
    TOPOGRAPHY + "Crop": "window",
    TOPOGRAPHY + "Crop columns": "112 .. 415",
    TOPOGRAPHY + "Crop rows": "0 .. 212",
    TOPOGRAPHY + "F-operator": "polynomial",
    TOPOGRAPHY + "Polynomial degree": 2,
    TOPOGRAPHY + "L-filter nesting index": "100 um"}

# By surface: how many profiles, scene file, map, rows to choose from, where a
# profile may begin [um], its length [um], and what else is set: S-filters of
# 3 um after scaling. The wire's profile is all of a row.
SURFACES = {
    "blasted": (5, "blasted_tool.prm", None, (20, 300), (20, 120), (12, 20),
                {"S-filter nesting index": "3 um"}),
    "polished": (5, "polished_tool.prm", None, (20, 300), (20, 120), (12, 20),
                 {"S-filter nesting index": "3 um"}),
    "alicona": (5, "alicona_scan.prm",
                os.path.join(SHARED, "alicona_al3d-1.al3d"), (20, 280),
                (10, 60), (12, 20), {"S-filter nesting index": "3 um"}),
    "wire": (5, "cut_wire.prm",
             os.path.join(SHARED, "wire_cut_aluminium.x3p"), (3, 63), None,
             None, {"Scale x": 0.02, "Scale z": 0.04}),
    "land": (4, "common.prm", LAND, (10, 200), (20, 600), (90, 130),
             {"S-filter nesting index": "20 um", "Scale x": 0.15,
              "Scale z": 0.15})}


def reference_scenes():
    found = {}
    for file in ("R0", "R1"):
        for pressure in (300, 1300):
            for velocity in (200, 22.5):
                for temperature in (25, 675):
                    found[f"{file}_p{pressure}_v{velocity}_T{temperature}"] = (
                        os.path.join(REFERENCE, file + ".prm"),
                        dry_scene.load_case(pressure, velocity, temperature))
    return found


def profile_scenes(seed=15, number_of_each=None, prefix=""):
    """Loads from 300 to 1300 MPa and 22.5 to 200 m/min (by their logarithms),
    25 to 675 degC, 0.2 to 1 um of sliding."""
    found, draw = {}, random.Random(seed).uniform
    for surface, (number, file, _, rows, starts, lengths,
                  more) in SURFACES.items():
        for i in range(number_of_each or number):
            pressure = round(300 * (1300 / 300)**draw(0, 1))
            velocity = round(22.5 * (200 / 22.5)**draw(0, 1), 1)
            entries = {**dry_scene.load_case(pressure, velocity,
                                             round(draw(25, 675))),
                       **(LAND_ENTRIES if surface == "land" else {}),
                       TOPOGRAPHY + "Profile position":
                           f"row {round(draw(*rows))}",
                       "Geometry/Chip height": "6 um",
                       "Protocol/Friction window": "time",
                       "Protocol/Sliding distance":
                           f"{draw(0.2, 1):.2f} um"}
            if starts is not None:
                entries[TOPOGRAPHY + "Profile start"] = \
                    f"{round(draw(*starts))} um"
                entries[TOPOGRAPHY + "Profile length"] = \
                    f"{round(draw(*lengths))} um"
            entries.update({TOPOGRAPHY + name: value
                            for name, value in more.items()})
            found[f"{prefix}{surface}_{i + 1}"] = (
                os.path.join(MEASURED, file), entries)
    return found


def fresh_scenes():
    """Two more profiles of each surface, on which nothing was fitted."""
    return profile_scenes(seed=29, number_of_each=2, prefix="fresh_")


def fine_scenes():
    """R0 with two more harmonics, which no constant was fitted to."""
    return {f"fine_p{p}_v{v}_T{T}": (
        os.path.join(REFERENCE, "R0.prm"),
        {**dry_scene.load_case(p, v, T), **TWO_MORE_HARMONICS})
        for p, v, T in ((300, 200, 25), (1300, 22.5, 25))}


def missing(scene):
    """The map of a scene if it is not there."""
    surface = SURFACES.get(scene.removeprefix("fresh_").split("_")[0])
    if surface and surface[2] and not os.path.exists(surface[2]):
        return surface[2]
    return None


def scenes():
    """Files and the entries that are set beside them, by name."""
    return {**reference_scenes(), **profile_scenes(), **fine_scenes(),
            **fresh_scenes()}
