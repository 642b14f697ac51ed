"""Coupling of flow and solid: C3, C5."""

from .mode import Axis, Mode, grid

ACCELERATION = Axis("acceleration", "acceleration",
                    {"relaxation": "plain", "IQN-ILS": "IQN-ILS"})

PISTON = {"error": 1e-3}
C3 = Mode(
    "C3", "Robin coefficient too small or too large: the piston",
    "The contraction is Z_f |Z_s - alpha| / (Z_s (Z_f + alpha)): a small alpha "
    "is slow, and above twice the impedance of the solid a sealed pocket "
    "diverges.",
    "alpha over the impedance Z_s of the solid, impedance of the fluid, "
    "acceleration; 20 steps of a driven piston, 100 iterations each",
    "way of the piston within 1e-3 of the same balance without iteration",
    "Plain iterations fail as the formula says; with IQN-ILS alpha hardly "
    "matters over six decades. What does not converge says so.",
    Axis("alpha", "alpha/Z_s"), Axis("Z_f", "Z_f/Z_s"), ACCELERATION,
    ["contraction", "error", "iterations"],
    lambda full: grid(acceleration=["relaxation", "Aitken", "IQN-ILS"],
                      Z_f=[0.1, 1, 10, 1000, "inf"] if not full else
                      [0.1, 0.3, 1, 3, 10, 100, 1000, 10000, "inf"],
                      alpha=[f"{10 ** (k / (4. if full else 2.)):.4g}"
                             for k in (range(-12, 13) if full
                                       else range(-6, 7))]),
    lambda cell, means: means.sweep("C3", cell), PISTON)

CASES = {"linear": "dense linear map", "rest": "at rest",
         "steady": "the same solution in each step",
         "constant": "output without input", "one_direction": "one direction "
         "reacts", "noise": "noise of 1e-9", "kink": "a kink as of contact"}
QUASI_NEWTON = {"error": 1e-6}
C5 = Mode(
    "C5", "quasi-Newton: empty, equal and noisy columns",
    "Least squares on columns that vanish or depend on each other give steps "
    "that are not finite, or stall.",
    "share of a column that must be new (filter), kind of the map on 8 "
    "unknowns, earlier steps whose columns are used; 5 steps of at most 100 "
    "iterations",
    "solution to 1e-6",
    "No step that is not finite; what stalls ends by the limit of iterations.",
    Axis("filter", "filter"), Axis("case", "fixed-point map", CASES),
    Axis("reused", "reused", {n: f"{n} earlier steps" for n in "0 2 10".split()}),
    ["error"],
    lambda full: grid(reused=[0, 2, 10], case=CASES,
                      filter=[0, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.3] +
                      ([0.6, 0.9] if full else [0.9])),
    lambda cell, means: means.sweep("C5", cell), QUASI_NEWTON)

MODES = [C3, C5]
