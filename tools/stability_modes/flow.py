"""Flow, film and moving meshes: C15, C20, C21, C22."""

from .mode import Axis, Mode, grid

ELEMENT = Axis("element", "element", {"equal-order": "equal order, stabilised"})

SLIDING = {"drift": 1e-9}
C15 = Mode(
    "C15", "moving meshes: inverted cells, drift",
    "A mesh that follows its walls as an elastic body shears until a cell is "
    "inverted, and one that moves by increments does not come back.",
    "sliding distance in the gap of the reference scene, kind and stiffening of "
    "the mesh, opening of the gap",
    "no inverted cell, and back to the start to 1e-9 of the distance",
    "Columns slide as far as one likes; the elastic mesh ends after some tens "
    "of nanometres in this gap, and the watch on its cells says where.",
    Axis("distance", "sliding distance [um]"),
    Axis("mesh", "mesh in the gap", {
        "columns": "columns", **{e: f"elastic, exponent {e}"
                                 for e in ("0", "1", "1.5", "2")}}),
    Axis("opening", "opening", {"0": "gap of 20 nm", "0.1": "gap of 120 nm",
                                "0.5": "gap of 520 nm"}),
    ["drift", "quality"],
    lambda full: grid(opening=[0, 0.1, 0.5],
                      mesh=["columns", "0", "1"] + (["1.5"] if full else []) +
                      ["2"],
                      distance=[0.001, 0.01, 0.03, 0.1, 0.3, 1] +
                      ([3, 10, 100] if full else [10])),
    lambda cell, means: means.sweep("C15", cell), SLIDING)

SMALL_STEPS = {"pressure": 2., "velocity": 2.}
C20 = Mode(
    "C20", "stabilised elements with tiny time steps",
    "The term that stabilises the pressure is weighed by the time step and "
    "fades with it; a start that is not discretely free of divergence gives "
    "spikes of pressure.",
    "time step, cells, element; vortices of Taylor from their interpolated "
    "velocity, three steps",
    "errors of pressure and velocity at most twice those of a steady flow on "
    "the same mesh",
    "The pressure stays flat over eight decades of the step, stabilised or not.",
    Axis("step", "time step [s]"), Axis("cells", "cells in each direction"),
    ELEMENT, ["pressure", "velocity"],
    lambda full: grid(element=["Taylor-Hood", "equal-order"],
                      cells=[4, 8, 16] + ([32] if full else []),
                      step=[f"1e-{i}" for i in range(8, 0, -1)]),
    lambda cell, means: means.sweep("C20", cell), SMALL_STEPS)

UNIFORM = {"velocity": 1e-10, "pressure": 1e-10}
C21 = Mode(
    "C21", "geometric conservation: a uniform flow on a moving mesh",
    "Fluxes of the mesh that do not sum to the change of volume make flow out "
    "of nothing.",
    "amplitude of the mesh's motion over the side, time step, element and time "
    "scheme",
    "velocity and pressure of a uniform flow kept to 1e-10",
    "A uniform flow stays uniform until cells are inverted or, stabilised with a "
    "step of 10 s, Newton's method finds no better point; both are said.",
    Axis("amplitude", "amplitude of the mesh over its side"),
    Axis("step", "time step [s]"),
    Axis("method", "element and scheme"), ["velocity", "pressure"],
    lambda full: grid(method=["Taylor-Hood, BDF2", "Taylor-Hood, Euler",
                              "equal-order, BDF2", "equal-order, Euler"],
                      step=["1e-6", "1e-3", "0.1", "10"],
                      amplitude=[0.001, 0.01, 0.03, 0.06, 0.1, 0.2]),
    lambda cell, means: means.sweep("C21", {
        "amplitude": cell["amplitude"], "step": cell["step"],
        **dict(zip(("element", "scheme"), cell["method"].split(", ")))}),
    UNIFORM)

BARUS = {"load": 0.02}
C22 = Mode(
    "C22", "piezoviscous film: pressure that runs away",
    "With the viscosity of Barus the pressure of a slider is infinite from a "
    "finite load on (alpha q_max = 1, here alpha = 4).",
    "pressure coefficient over that of the slider, cells",
    "load within 2 % of the exact one",
    "Up to 99 % of the limit the load is right on 50 cells and more; 20 cells "
    "are 2 to 7 % off from alpha = 3.5 on, which the change of the viscosity "
    "from cell to cell tells, and beyond the limit the film says that its "
    "pressure runs away.",
    Axis("alpha", "pressure coefficient alpha U eta L/h^2"),
    Axis("cells", "cells"), Axis("film", "film"), ["load"],
    lambda full: grid(film=["slider 2 : 1"],
                      cells=[20, 50, 200, 1000] + ([5000] if full else []),
                      alpha=[0, 1, 2, 3, 3.5, 3.8, 3.9, 3.96, 3.99, 4, 4.1, 5,
                             8, 100]),
    lambda cell, means: means.sweep("C22", {"alpha": cell["alpha"],
                                            "cells": cell["cells"]}), BARUS)

MODES = [C15, C20, C21, C22]
