"""Contact: C8, C9, C10, C13. The problems are those of tests/contact."""

from .mode import Axis, Mode, grid

FORMULATION = Axis("formulation", "formulation",
                   {"gauss-point": "Gauss point"})
DEGREE_TOO = {f"{f} p={p}": (f, str(p)) for f in ("mortar", "gauss-point")
              for p in (1, 2, 3)}
PENALTY = "penalty factor c in c E/h"


def scene_entries(cell):
    """A scene of the program with the contact of a cell."""
    return {"Contact/Formulation": cell["formulation"],
            "Contact/Penalty factor": cell["penalty"],
            "Mesh/Degree": cell["degree"]}


def with_degree(cell):
    formulation, degree = DEGREE_TOO[cell["method"]]
    return {**{k: v for k, v in cell.items() if k != "method"},
            "formulation": formulation, "degree": degree}


def audited(name, bands):
    def measure(cell, means):
        settings = with_degree(cell)
        return means.sweep(name, settings, (scene_entries(settings),
                                            "penalty factor|soft|degree 1"),
                           bands)
    return measure


METHOD = Axis("method", "formulation and degree",
              {name: name.replace("gauss-point", "Gauss point")
               for name in DEGREE_TOO})

HERTZ = {"pressure": 0.1}
C8 = Mode(
    "C8", "contact that is over-constrained: line contact of Hertz",
    "A Gauss-point contact has more constraints than the edge has freedom, so "
    "that its pressure oscillates once the penalty is hard.",
    "penalty factor, elements on the half-width, formulation and degree",
    "L2 error of the pressure of Hertz below 10 %",
    "From a factor of 8 on the mortar form is right with four elements on the "
    "half-width; a factor of 1 there is 11 and 14 % off, which is told as "
    "softer ones are, and the Gauss-point form from 100 on.",
    Axis("penalty", PENALTY), Axis("elements", "elements on the half-width"),
    METHOD, ["pressure", "force", "iterations"],
    lambda full: grid(
        method=DEGREE_TOO if full else ["mortar p=2", "gauss-point p=2"],
        elements=[4, 8, 16] if full else [4, 8],
        penalty=[0.01, 0.1, 1, 10, 100, 1000] + ([1e4, 1e5] if full else [])),
    audited("C8", HERTZ), HERTZ)

FULL_CONTACT = {"pressure": 0.1}
C9 = Mode(
    "C9", "pressure space too rich: checkerboard in full contact",
    "With pressures of the same order as the displacement the constraints "
    "depend on each other, and the pressure becomes a checkerboard on fine "
    "meshes (a lack of inf-sup stability).",
    "elements a wave, penalty factor, formulation and degree; a sine wave "
    "pressed until all of it touches (Westergaard)",
    "L2 error of the smooth exact pressure below 10 %",
    "Both forms are smooth at degree 2 and more as long as the penalty is not "
    "hard for the points of the Gauss-point form, and degree 1 is not; both "
    "are told.",
    Axis("elements", "elements a wave"), Axis("penalty", PENALTY), METHOD,
    ["pressure", "iterations"],
    lambda full: grid(method=DEGREE_TOO, penalty=[10, 100, 1000, 10000] + ([1] if full else []),
                      elements=[8, 16, 32] + ([64, 128] if full else [])),
    audited("C9", FULL_CONTACT), FULL_CONTACT)

BALANCE = {"balance": 1e-9, "sum": 1e-12, "tangent": 1e-6}
C10 = Mode(
    "C10", "forces out of balance on curved surfaces",
    "A contact that does not derive from one potential loses force where its "
    "normals turn, and its tangent is not that of its residual.",
    "amplitude of the wavy tool over its period, penalty factor, formulation",
    "reaction of the support against the force of the contact to 1e-9, sum of "
    "nodal forces to 1e-12, tangent against differences to 1e-6",
    "Forces balance to round-off and the tangent is exact, up to amplitudes at "
    "which Newton's method ends without a solution and says so.",
    Axis("amplitude", "amplitude over period"), Axis("penalty", PENALTY),
    FORMULATION, ["balance", "sum", "tangent"],
    lambda full: [
        {**cell, "degree": "2"} for cell in grid(
            formulation=["mortar", "gauss-point"],
            penalty=[0.1, 1, 10, 100, 1000],
            amplitude=[0.005, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3] +
            ([0.002, 0.25] if full else []))],
    lambda cell, means: means.sweep("C10", {**cell, "degree": 2}), BALANCE)

FLAT = {"pressure": 0.01, "iterations": 20}
C13 = Mode(
    "C13", "active set that flips: flat on flat without a gap",
    "All gaps are zero at once, so that the set of contacts can flip for ever.",
    "way of the rigid ceiling down, up and down again over the height of the "
    "block, from zero over round-off to a permille, penalty, formulation",
    "pressure within 1 % of the formula (or of a strain of 1e-9), at most 20 "
    "iterations",
    "The set settles in a few iterations everywhere. With 1e4 and more times "
    "the usual penalty the round-off of positions is a pressure of 1e-11 of "
    "E, which is told.",
    Axis("shift", "way over height"),
    Axis("penalty", "penalty over E/height"), FORMULATION,
    ["pressure", "iterations"],
    lambda full: grid(
        formulation=["mortar", "gauss-point"],
        penalty=[1, 100, 1e4, 1e6] + ([1e8, 1e10] if full else []),
        shift=[0, 1e-16, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3]),
    lambda cell, means: means.sweep("C13", cell), FLAT)

MODES = [C8, C9, C10, C13]
