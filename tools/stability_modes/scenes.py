"""Dry scenes of the program: C7, C14, C19, C23, C29."""

from .mode import Axis, Mode, grid

QUICK = {"Output/Picture interval": 0, "Output/Checkpoint interval": 0,
         "Mesh/Spans": 40, "Mesh/Refinement levels": 1,
         "Protocol/Ramp steps": 8, "Protocol/Slide steps": 16}


def friction(scene):
    found = scene.summary()["friction"]
    return {"mu": found["mu"], "load": abs(found["carried_load"] - 1.)}


def row_with(rows, **settings):
    """The value of mu in the row with these settings, or None."""
    for row in rows:
        if all(row[name] == value for name, value in settings.items()):
            return float(row["mu"]) if row["mu"] else None
    return None


CONTACT = {"mortar": ("mortar", 0), "mortar, augmented": ("mortar", 20),
           "gauss-point": ("gauss-point", 0),
           "gauss-point, augmented": ("gauss-point", 20)}


def penalty(cell, means):
    formulation, augmentations = CONTACT[cell["contact"]]
    return means.run(
        {**QUICK, "Mesh/Spans": 80, "Mesh/Refinement levels": 2,
         "Protocol/Ramp steps": 12, "Protocol/Slide steps": 24,
         "Load/Pressure": cell["pressure"],
         "Contact/Formulation": formulation,
         "Contact/Augmentations": augmentations,
         "Contact/Penalty factor": cell["penalty"]},
        friction, about="penalty is soft|Gauss-point")


C7 = Mode(
    "C7", "penalty too soft or too hard: the reference scene R0",
    "A soft penalty lets the bodies overlap, which falsifies mu; a hard one "
    "makes the system ill-conditioned and lets contacts chatter.",
    "penalty factor, formulation and augmentation, pressure",
    "mu within 3 % of that of the augmented mortar form with a factor of 30",
    "From a factor of 1 on mu is right in both forms, and with augmentation "
    "from 0.01 on; softer without it takes 10 to 82 % off mu, which is told.",
    Axis("penalty", "penalty factor c in c E/h"),
    Axis("contact", "contact", {
        "gauss-point": "Gauss point",
        "gauss-point, augmented": "Gauss point, augmented"}),
    Axis("pressure", "pressure"), ["mu", "load"],
    lambda full: grid(pressure=["300 MPa"] + (["1300 MPa"] if full else []),
                      contact=CONTACT,
                      penalty=[0.01, 0.1, 1, 8, 30, 100, 1000, 10000] +
                      ([0.03, 0.3, 3, 1e5, 1e6] if full else [])),
    penalty, {"mu": 0.03},
    lambda row, rows: {"mu": row_with(rows, contact="mortar, augmented",
                                      penalty="30", pressure=row["pressure"])})

BLOCK = {**QUICK, "Tool/Kind": "flat", "Material/Law": "neo-Hooke",
         "Mesh/Spans": 16, "Mesh/Refinement levels": 0,
         "Protocol/Ramp steps": 4, "Interface/Shear law": "Coulomb"}


def stick(cell, means):
    exact = float(cell["coefficient"])

    def read(scene):
        mu = friction(scene)["mu"]
        return {"mu": mu, "error": abs(mu - exact) / max(exact, 0.01)}
    return means.run({**BLOCK, "Protocol/Slide steps": cell["steps"],
                      "Interface/Friction coefficient": exact,
                      "Interface/Stick penalty": cell["stick"]}, read,
                     about="Stick")


C14 = Mode(
    "C14", "stick and slip: a block that slides by Coulomb's law",
    "The kink between stick and slip makes Newton's method jump; a soft "
    "tangential penalty never slips.",
    "tangential over normal penalty, friction coefficient of the spots, time "
    "steps",
    "mu of flat on flat within 1 % of that of the spots",
    "A tangential penalty too soft to slip within a tenth of the way gives "
    "too little friction, up to 100 %, which is told.",
    Axis("stick", "stick penalty over normal penalty"),
    Axis("coefficient", "friction coefficient of the spots"),
    Axis("steps", "steps", {"2": "2 time steps", "8": "8 time steps",
                            "64": "64 time steps"}),
    ["mu", "error"],
    lambda full: grid(steps=[2, 8] + ([64] if full else []),
                      coefficient=[0, 0.1, 0.5, 2, 5],
                      stick=["1e-6", "1e-4", "1e-3", "0.03", "1", "1000"] +
                      (["1e-5", "0.01", "30"] if full else [])),
    stick, {"error": 0.01})


def softening(cell, means):
    return means.run(
        {**QUICK, "Mesh/Spans": cell["spans"],
         "Mesh/Refinement levels": 0 if cell["spans"] == "10" else 1,
         "Heat/Model": cell["heat"],
         "Load/Temperature": f"{cell['celsius']} degC"},
        friction, about="elements across|shortest wave|melt|locali")


C19 = Mode(
    "C19", "thermal softening: bands as thin as the mesh",
    "Where heat softens faster than strain hardens, strain gathers in bands of "
    "one element, so that results follow the mesh.",
    "spans of the mesh, temperature of the chip, heat model; R0 at 300 MPa",
    "mu within 5 % of that of 80 spans (which is the reference)",
    "From 40 spans on mu is that of 80 within 5 % or the mesh is told not to "
    "resolve the tool: asperities, not bands, set the length.",
    Axis("spans", "spans over the period"),
    Axis("celsius", "temperature [degC]"), Axis("heat", "heat"),
    ["mu", "load"],
    lambda full: grid(heat=["adiabatic", "conducting"],
                      celsius=[25, 900, 1400, 1490] if not full else
                      [25, 300, 675, 900, 1100, 1300, 1400, 1450, 1490, 1500],
                      spans=[10, 20, 40, 80] + ([160] if full else [])),
    softening, {"mu": 0.05},
    lambda row, rows: {"mu": row_with(rows, heat=row["heat"], spans="80",
                                      celsius=row["celsius"])})


def ramp(cell, means):
    return means.run(
        {**QUICK, "Protocol/Inertia": cell["inertia"],
         "Protocol/Ramp fraction": cell["fraction"],
         "Protocol/Ramp steps": cell["steps"]},
        friction, about="carry|load (still )?grows|settled")


C23 = Mode(
    "C23", "impulsive start: the load ramp",
    "A load that comes at once shakes a chip with inertia, and steps too few "
    "for the ramp jump over the first plastic strain.",
    "part of the time that the load takes to grow, steps in it, inertia",
    "mu within 3 % of that of a quasi-static chip with a ramp of 0.2 in 24 "
    "steps, load carried within 5 %",
    "A quasi-static chip may be loaded in one step; a ramp that lasts into "
    "the window of mu takes 3 to 99 % off, and a chip with mass that is "
    "loaded within 10 transits of a wave swings, up to 31 %: both are told.",
    Axis("fraction", "ramp over end time"), Axis("steps", "steps in the ramp"),
    Axis("inertia", "inertia"), ["mu", "load"],
    lambda full: grid(inertia=["quasi-static", "dynamic"],
                      steps=[1, 3, 8, 24] + ([96] if full else []),
                      fraction=[0.001, 0.01, 0.05, 0.2, 0.5, 1] +
                      ([0.1, 0.8] if full else [])),
    ramp, {"mu": 0.03, "load": 0.05},
    lambda row, rows: {"mu": row_with(rows, inertia="quasi-static",
                                      fraction="0.2", steps="24")})


def distance(cell, means):
    way = float(cell["distance"])
    steps = max(16, round(way / 0.05))
    return means.run(
        {**QUICK, "Load/Velocity": f"{cell['velocity']} m/min",
         "Load/Temperature": f"{cell['celsius']} degC",
         "Protocol/Sliding distance": f"{way} um",
         "Protocol/Inertia": "quasi-static",
         "Protocol/Slide steps": steps}, friction,
        about="running in|slides only|not steady|fiftieth")


C29 = Mode(
    "C29", "mu of the running in: too short a way",
    "After a fixed time slow runs have slid less than fast ones, so that an "
    "effect of the velocity is one of the distance.",
    "sliding distance, velocity, temperature; R0 at 300 MPa",
    "mu over the second half of the way within 15 % of that of 4 um (which is "
    "the reference) at the same velocity",
    "Running in takes a third to half a micrometre whatever the velocity, and "
    "runs that end before are told.",
    Axis("distance", "sliding distance [um]"),
    Axis("velocity", "velocity [m/min]"),
    Axis("celsius", "temperature", {"25": "25 degC", "675": "675 degC"}),
    ["mu", "load"],
    lambda full: grid(celsius=[25, 675], velocity=[22.5, 200, 1000],
                      distance=[0.01, 0.03, 0.1, 0.3, 1, 2, 4] if not full else
                      [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3,
                       4]),
    distance, {"mu": 0.15},
    lambda row, rows: {"mu": row_with(rows, distance="4",
                                      celsius=row["celsius"],
                                      velocity=row["velocity"])})

MODES = [C7, C14, C19, C23, C29]
