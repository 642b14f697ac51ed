"""Solid and material: C12, C17, C18."""

from .mode import Axis, Mode, grid

IMPACT = {"velocity": 0.1, "energy": 0.01, "impulse": 0.1}


def impact(cell, means):
    return means.sweep("C12", cell, (
        {"Protocol/Inertia": "dynamic",
         "Protocol/Spectral radius": cell["rho"]}, "nothing damps"), IMPACT)


C12 = Mode(
    "C12", "impact: chatter and growth of energy",
    "Time integration that keeps the energy of a smooth motion gains it in "
    "impacts, and the contact force chatters.",
    "time step over the time of a wave through an element, spectral radius of "
    "generalised-alpha, penalty factor; a bar flies against a wall",
    "velocity after the impact within 10 % of minus that before, impulse within "
    "10 % of rho c v times 2 L/c, kinetic energy never 1 % above the start",
    "The undamped scheme gains energy (twelvefold with a hard penalty), which "
    "its spectral radius tells; where it damps, steps of two and more take 10 "
    "to 44 % of the rebound, which the run measures as energy that its steps "
    "have taken away (lost, from 3.5 % on) and says. Scenes are quasi-static "
    "unless asked otherwise.",
    Axis("courant", "time step c dt/h"),
    Axis("rho", "spectral radius at infinite frequency"),
    Axis("penalty", "penalty", {"1": "penalty factor 1", "8": "penalty factor "
                                "8", "100": "penalty factor 100"}),
    ["velocity", "energy", "lost", "overshoot", "impulse"],
    lambda full: grid(penalty=[1, 8, 100], rho=[0, 0.5, 0.8, 1],
                      courant=([0.1, 0.2] if full else []) +
                      [0.5, 1, 2, 4, 8, 16]),
    impact, IMPACT)

LOCKING = {"displacement": 0.02}
LOCKING_SCENE = "degree 1|Poisson's ratio"


def locking(cell, means):
    return means.sweep("C17", cell, (
        {"Mesh/Degree": cell["degree"],
         "Material/Poisson's ratio": cell["poisson"]}, LOCKING_SCENE), LOCKING)


C17 = Mode(
    "C17", "volumetric locking",
    "Where volume is kept, elements have no freedom left to deform.",
    "Poisson's ratio, cells in the wall, degree; a thick elastic cylinder under "
    "pressure",
    "way of the inner face within 2 % of Lame's formula",
    "Degree 1 locks from 0.3 on, and degrees above hold to 0.49, which is all "
    "that the program takes; both are told.",
    Axis("poisson", "Poisson's ratio"), Axis("cells", "cells in the wall"),
    Axis("degree", "degree", {str(p): f"degree {p}" for p in range(1, 5)}),
    ["displacement"],
    lambda full: grid(degree=[1, 2, 3, 4],
                      cells=[2, 4, 8] + ([16, 32] if full else []),
                      poisson=[0, 0.3, 0.4, 0.45, 0.47, 0.49, 0.499, 0.4999]),
    locking, LOCKING)

POINT = {"stress": 1e-6, "tangent": 1e-6}
C18 = Mode(
    "C18", "return map: slow and fast rates, melting, large increments",
    "The logarithm of a rate below the reference rate hardens negatively, near "
    "melting the residual is flat, and large increments overshoot.",
    "strain rate, temperature, strain increment of one step of Johnson and Cook",
    "flow stress at the end of the step to 1e-6 of the formula, tangent to 1e-6 "
    "of differences",
    "No point without a stress, from rest to 1e9 1/s and beyond melting.",
    Axis("rate", "strain rate [1/s]"), Axis("celsius", "temperature [degC]"),
    Axis("increment", "increment", {
        i: f"strain increment {i}" for i in
        ("1e-08", "1e-06", "0.0001", "0.01", "0.1", "1")}),
    ["stress", "tangent"],
    lambda full: grid(
        increment=[1e-8, 1e-6, 1e-4, 1e-2, 0.1, 1],
        celsius=[20, 400, 800, 1200, 1450, 1500, 1600] if not full else
        list(range(20, 1601, 79)),
        rate=["1e-6", "1e-4", "1e-2", "1", "1e3", "1e6", "1e9"] if not full
        else [f"1e{i}" for i in range(-6, 10)]),
    lambda cell, means: means.sweep("C18", cell), POINT)

MODES = [C12, C17, C18]
