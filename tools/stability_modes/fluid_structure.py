"""Fluid-structure problems and oil: C1, C2, C4, C6, C16."""

import math

from .mode import Axis, Mode, grid
from .scenes import QUICK

SILENT = {"Output/Picture interval": 0, "Output/Checkpoint interval": 0}
CHANNEL = {**SILENT, "Fluid/Cells along": 20, "Body/Spans along": 20}
BOX = {**SILENT, "Fluid/Refinements": 0, "Body/Spans along": 2}
DOMAIN = {**SILENT, "Fluid/Cells along": 20, "Fluid/Cells across": 3,
          "Body/Spans across": 6, "Time/Ends": "0.2 us"}
TABLE = "fluid_structure.csv"


def box_filling(scene, ramp=1.):
    """Volume that the box has gained over what has flowed in by implicit
    Euler: an inlet 1 m wide, a parabola of 1 m/s, a quarter of a sine."""
    rows, inflow, before = scene.rows(TABLE), 0., 0.
    for row in rows:
        t = row["time"]
        inflow += (t - before) * 2. / 3. * math.sin(
            0.5 * math.pi * min(1., t / ramp))
        before = t
    gained = rows[-1]["volume of the fluid"] - scene.summary()["initial_volume"]
    return abs(gained / inflow - 1.)


def iterations(scene):
    rows = scene.rows(TABLE)
    return sum(r["coupling iterations"] for r in rows) / len(rows)


PROBLEMS = {
    "enclosed domain": ("fluid_structure/enclosed_domain.prm", DOMAIN),
    "inflatable box": ("fluid_structure/inflatable_box.prm",
                       {**BOX, "Time/Steps": "0.1 s", "Time/Ends": "0.5 s"}),
    "lined channel": ("fluid_structure/lined_channel.prm",
                      {**CHANNEL, "Time/Steps": "1e-3 s",
                       "Time/Ends": "3e-3 s"}),
    "flooded gap": (None, {
        **QUICK, "Mesh/Spans": 40, "Mesh/Refinement levels": 1,
        "Lubrication/Model": "Stokes", "Protocol/Inertia": "dynamic",
        "Protocol/Ramp steps": 6, "Protocol/Slide steps": 6}),
}


def enclosed(cell, means):
    include, entries = PROBLEMS[cell["problem"]]

    def read(scene):
        if cell["problem"] == "flooded gap":
            rows = scene.rows("friction.csv")
            first, last = (r["oil reference volume"] for r in (rows[0],
                                                                rows[-1]))
            return {"volume": abs(last / first - 1.)}
        if cell["problem"] == "inflatable box":
            return {"volume": box_filling(scene),
                    "iterations": iterations(scene)}
        rows = scene.rows(TABLE)
        now = rows[-1]["volume of the fluid"]
        start = scene.summary()["initial_volume"]
        return {"volume": abs(now / start - 1.)
                if cell["problem"] == "enclosed domain" else 0.,
                "iterations": iterations(scene)}
    return means.run({**entries, "Coupling/Scheme": cell["scheme"],
                      "Coupling/Acceleration": cell["acceleration"]}, read,
                     include and means.file(include), about="olume|oupling")


SCHEME = Axis("scheme", "scheme")
C1 = Mode(
    "C1", "enclosed incompressible fluid",
    "With the motion of its walls prescribed (Dirichlet-Neumann) enclosed fluid "
    "has neither a level of pressure nor a solution.",
    "problem, acceleration, coupling scheme",
    "volume of the fluid kept to 1e-4, or grown by what has flowed in (in the "
    "open channel, whose volume is free: all steps converged)",
    "Dirichlet-Neumann is refused for what it is where the fluid is enclosed; "
    "Robin-Neumann keeps the volume.",
    Axis("acceleration", "acceleration"), Axis("problem", "problem"), SCHEME,
    ["volume", "iterations"],
    lambda full: grid(scheme=["Dirichlet-Neumann", "Robin-Neumann"],
                      problem=PROBLEMS,
                      acceleration=["relaxation", "Aitken", "IQN-ILS"]),
    enclosed, {"volume": 1e-4})


def channel(scene):
    last = scene.rows(TABLE)[-1]
    return {"displacement": last["displacement y"],
            "iterations": iterations(scene)}


def from_row(value, rows, **settings):
    for row in rows:
        if all(row[name] == wanted for name, wanted in settings.items()):
            return float(row[value]) if row[value] else None
    return None


METHODS = {f"{short}, {a}": (scheme, a)
           for short, scheme in (("D-N", "Dirichlet-Neumann"),
                                 ("R-N", "Robin-Neumann"))
           for a in ("relaxation", "Aitken", "IQN-ILS")}


def added_mass(cell, means):
    scheme, acceleration = METHODS[cell["method"]]
    step = float(cell["step"])
    return means.run(
        {**CHANNEL, "Time/Steps": f"{step} s", "Time/Ends": f"{3 * step} s",
         "Time/Maximum cuts": 1, "Problem/Pulse/Duration": f"{50 * step} s",
         "Material/Density": f"{1000. * float(cell['ratio'])} kg/m3",
         "Coupling/Scheme": scheme, "Coupling/Acceleration": acceleration},
        channel, means.file("fluid_structure/lined_channel.prm"),
        about="were halved")


C2 = Mode(
    "C2", "added mass: light bodies around heavy fluid",
    "Dirichlet-Neumann diverges where the body is as light as the fluid, and a "
    "smaller step does not help.",
    "time step, density of the body over that of the fluid, scheme and "
    "acceleration; three steps of a pulse in a lined channel",
    "displacement of the wall within 1 % of that by Robin-Neumann with IQN-ILS "
    "(which is the reference)",
    "Robin-Neumann converges everywhere but by plain relaxation beside the "
    "lightest body and the shortest step, which says so; Dirichlet-Neumann "
    "ends with a sentence where it fails, or goes on in steps that are halved, "
    "whose other grid in time is 5 to 25 % off and told.",
    Axis("step", "time step [s]"),
    Axis("ratio", "density of body over fluid"),
    Axis("method", "method"), ["displacement", "iterations"],
    lambda full: grid(method=METHODS,
                      ratio=[0.1, 1, 10, 100] if full else [0.1, 1, 100],
                      step=["1e-3", "1e-4", "1e-5"] +
                      (["1e-6"] if full else [])),
    added_mass, {"displacement": 0.01},
    lambda row, rows: {"displacement": from_row(
        "displacement", rows, method="R-N, IQN-ILS", ratio=row["ratio"],
        step=row["step"])})


def leak(cell, means):
    step = float(cell["step"])
    return means.run(
        {**BOX, "Time/Steps": f"{step} s", "Time/Ends": f"{5 * step} s",
         "Coupling/Tolerance": cell["tolerance"],
         "Coupling/Acceleration": cell["acceleration"]},
        lambda scene: {"filling": box_filling(scene),
                       "iterations": iterations(scene)},
        means.file("fluid_structure/inflatable_box.prm"), about="oleran")


TOLERANCE = Axis("tolerance", "coupling tolerance")
C4 = Mode(
    "C4", "mass that leaks through a Robin interface",
    "A Robin interface lets fluid cross the wall until the iteration has "
    "converged, so that a loose tolerance loses mass.",
    "coupling tolerance, time step, acceleration; five steps of the inflatable "
    "box",
    "growth of the volume within 1e-4 of what has flowed in",
    "The jump of the velocity is among what has to converge, so that a "
    "tolerance of 1e-4 keeps the mass to 2e-6; with 1e-3 and more, and large "
    "steps, up to 1.5e-4 of what flows in leaks, which is told.",
    TOLERANCE, Axis("step", "time step [s]"),
    Axis("acceleration", "acceleration"), ["filling", "iterations"],
    lambda full: grid(acceleration=["Aitken", "IQN-ILS"],
                      step=(["0.002"] if full else []) + ["0.02", "0.1"],
                      tolerance=["1e-8", "1e-6", "1e-4", "1e-3", "1e-2"] +
                      (["1e-7", "1e-5"] if full else [])),
    leak, {"filling": 1e-4})


def loose(cell, means):
    step = float(cell["step"])
    return means.run(
        {**CHANNEL, "Time/Steps": f"{step} s", "Time/Ends": "2e-3 s",
         "Coupling/Tolerance": cell["tolerance"],
         "Coupling/Acceleration": cell["acceleration"]}, channel,
        means.file("fluid_structure/lined_channel.prm"), about="oleran")


C6 = Mode(
    "C6", "loose coupling tolerance: forces that are not converged",
    "Iterations that stop early leave forces and amplitudes wrong.",
    "coupling tolerance, time step, acceleration; a pulse in a lined channel",
    "displacement of the wall within 2 % of that of IQN-ILS with a tolerance of "
    "1e-5 (which is the reference, and 2e-5 off that of 1e-8 where there is "
    "one)",
    "Up to 1e-3 results are those of a tight tolerance within 0.4 %; 1e-2, the "
    "largest that is accepted, is 3 % off with the longer step, which is told.",
    TOLERANCE, Axis("step", "time step [s]"),
    Axis("acceleration", "acceleration"), ["displacement", "iterations"],
    lambda full: grid(acceleration=["Aitken", "IQN-ILS"],
                      step=(["2e-4"] if full else []) + ["5e-4", "1e-3"],
                      tolerance=["1e-8", "1e-5", "1e-4", "1e-3", "1e-2"] +
                      (["1e-6"] if full else [])),
    loose, {"displacement": 0.02},
    lambda row, rows: {"displacement": from_row(
        "displacement", rows, acceleration="IQN-ILS", tolerance="1e-5",
        step=row["step"])})

OIL = {"pocket": {"Lubrication/Model": "pocket"},
       "pockets, seals of 60 nm": {"Lubrication/Model": "pocket",
                                   "Lubrication/Sealing gap": "60 nm"},
       "Reynolds": {"Lubrication/Model": "Reynolds"},
       "Stokes, seals of 60 nm": {"Lubrication/Model": "Stokes",
                                  "Lubrication/Sealing gap": "60 nm",
                                  "Flow/Compressible": "true",
                                  "Protocol/Inertia": "dynamic"}}


def pinch(cell, means):
    def read(scene):
        rows = scene.rows("friction.csv")
        volumes = [r["oil reference volume"] for r in rows]
        found = scene.summary()["friction"]
        return {"load": abs(found["carried_load"] - 1.), "mu": found["mu"],
                "oil": max(volumes) / min(volumes) - 1.}
    return means.run(
        {**QUICK, "Protocol/Ramp steps": 12, "Protocol/Slide steps": 12,
         "Protocol/Window fraction": 0.8, **OIL[cell["model"]],
         "Lubrication/Wetting": cell["wetting"],
         "Load/Pressure": f"{cell['pressure']} MPa"}, read,
        about="carry|oil|Oil|settled")


C16 = Mode(
    "C16", "pockets that are pinched shut",
    "Where surfaces close, a mesh of the oil has no cells left, and a pocket "
    "that is split or merged can lose its oil.",
    "part of the void full of oil, pressure up to full closure, model of the "
    "oil; R0, 24 steps",
    "load carried within 2 %, mass of the oil kept to 1e-3",
    "Oil and load are kept up to closure; what cannot be balanced, flow with "
    "seals at 3 GPa above all, ends with the step and its reason.",
    Axis("wetting", "part of the void full of oil"),
    Axis("pressure", "pressure [MPa]"), Axis("model", "model"),
    ["load", "oil", "mu"],
    lambda full: grid(model=OIL, pressure=[30, 300, 3000] +
                      ([100, 1300, 6000] if full else []),
                      wetting=[0.01, 0.3, 0.9, 1] if not full else
                      [0.01, 0.1, 0.3, 0.6, 0.9, 0.99, 1]),
    pinch, {"load": 0.02, "oil": 1e-3})

MODES = [C1, C2, C4, C6, C16]
