#!/usr/bin/python3
"""A rigid cone and a rigid ball that plough a soft block, against formulas.

Usage: tools/benchmarks/ploughing.py [--asperity PROGRAM] [--to FOLDER]
                                     [--spans N]

The block does not harden. Where what touches bears the same pressure everywhere
mu is the area of the contact as one sees it along the motion over that from
above. If the front half of a disc of radius a touches, and nothing piles up, it
is 2 tan(theta)/pi of a cone whose flank rises by theta, and
  2 (R^2/a^2 asin(a/R) - sqrt(R^2/a^2 - 1))/pi
of a ball of radius R (J. Goddard, H. Wilman, Wear 5 (1962) 114). If the block
springs back behind the tip, so that it touches there, too, up to a line across
the motion at a sin(omega) (S. Lafaye, C. Gauthier, R. Schirrer, Tribol. Lett. 21
(2006) 95), the line's own area is taken off: with c, s the cosine and sine
  A_n = a^2 (pi/2 + omega + s c),
  A_t = a^2 tan(theta) (c - s^2 log((1 + c)/s))                      of a cone,
  A_t = r^2 asin(a c/r) - a c sqrt(R^2 - a^2), r^2 = R^2 - a^2 s^2   of a ball.
a and omega are those of the run's last picture: the largest half width of what
touches and how far it reaches behind the tip. Its own areas (`shape`), with
whatever piles up, tell how much of mu is the shape of the contact; the rest are
pressures that differ over it.

The table goes to the screen in Markdown, runs into FOLDER (default
output/benchmarks). Some ten minutes a run.
"""

import math
import os
import sys

import numpy as np

from dry_scene import ROOT, arguments_of, print_head, run

sys.path.insert(0, os.path.join(ROOT, "tools"))
from patch_pictures import Face  # noqa: E402

PERIOD = 4.  # um
SPACING = 0.05  # um, of the map
ANGLE = math.radians(10.)
RADIUS = 3.  # um


def cone(r):
    return -math.tan(ANGLE) * r


def ball(r):
    return -(RADIUS - math.sqrt(RADIUS**2 - r * r))


def write_map(path, height):
    """A map of 6 um x 6 um with the tip in its middle, periodic in PERIOD."""
    n = round(6. / SPACING)

    def wrapped(i):
        return (i * SPACING - 3. + 0.5 * PERIOD) % PERIOD - 0.5 * PERIOD

    with open(path, "w", encoding="utf-8") as file:
        for j in range(n):
            file.write(" ".join(
                f"{height(math.hypot(wrapped(i), wrapped(j))):.6f}"
                for i in range(n)) + "\n")


def scene(path, spans):
    topography = {"File": path, "Lateral unit": "um", "Height unit": "um",
                  "Spacing x": f"{SPACING} um", "F-operator": "none",
                  "Profile length": f"{PERIOD} um"}
    return {"Geometry/Width": f"{PERIOD} um",
            "Geometry/Chip height": f"{PERIOD} um",
            "Tool/Kind": "measured",
            **{f"Tool/Topography/{key}": value
               for key, value in topography.items()},
            "Mesh/Spans": spans,
            "Material/Law": "Voce", "Material/Adiabatic heating": "false",
            "Load/Pressure": "70 MPa",
            "Protocol/Ramp steps": 12, "Protocol/Slide steps": 24,
            "Protocol/Sliding distance": "2.5 um",
            "Protocol/Ramp fraction": 0.15, "Protocol/Window fraction": 0.3}


def projected_areas(name, a, omega):
    """(A_t, A_n) of a contact of radius a [um] that reaches back to omega."""
    c, s = math.cos(omega), math.sin(omega)
    normal = a * a * (0.5 * math.pi + omega + s * c)
    if name == "cone":
        behind = s * s * math.log((1. + c) / s) if s > 0. else 0.
        return a * a * math.tan(ANGLE) * (c - behind), normal
    r = math.sqrt(RADIUS**2 - (a * s)**2)
    return (r * r * math.asin(a * c / r) -
            a * c * math.sqrt(RADIUS**2 - a * a), normal)


def shape(name, folder):
    """Half width, way back and way ahead of what touches at the end [um], and
    mu of its shape under an even pressure."""
    face = Face(folder, None)
    touches = face.pressure > 0.02 * face.pressure.max()
    corners = face.corners[touches]
    # The tip is in the middle; the chip comes from negative x.
    corners[..., :2] = (corners[..., :2] - corners[:, :1, :2] +
                        corners[:, :1, :2] % PERIOD - 0.5 * PERIOD)
    x, y = corners[..., 0].mean(axis=1), corners[..., 1].mean(axis=1)
    diagonals = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    area = 0.5 * np.abs(diagonals[0][:, 0] * diagonals[1][:, 1] -
                        diagonals[0][:, 1] * diagonals[1][:, 0])
    r = np.hypot(x, y)
    slope = (math.tan(ANGLE) if name == "cone"
             else r / np.sqrt(RADIUS**2 - r * r))
    mu = np.sum(area * slope * -x / r) / np.sum(area)
    return (np.abs(corners[..., 1]).max(), max(0., corners[..., 0].max()),
            -corners[..., 0].min(), mu)


def main():
    parser = arguments_of(__doc__)
    parser.add_argument("--spans", type=int, default=24)
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    os.makedirs(arguments.to, exist_ok=True)
    common = os.path.join(ROOT, "parameter_files", "surface_patches",
                          "common.prm")
    print_head("tool | half width, behind, ahead [um] | mu, Goddard and Wilman | "
               "Lafaye | shape | run | largest plastic strain | steps | "
               "Newton iterations | time [s]")
    for name, height in (("cone", cone), ("ball", ball)):
        path = os.path.join(arguments.to, f"{name}.txt")
        write_map(path, height)
        summary = run(arguments, f"plough_{name}",
                      scene(path, arguments.spans), common, may_fail=True)
        if summary is None:
            continue
        a, behind, ahead, of_shape = shape(
            name, os.path.join(arguments.to, f"plough_{name}"))
        without, back = (
            np.divide(*projected_areas(name, a, omega))
            for omega in (0., math.asin(min(1., behind / a))))
        cost = summary["cost"]
        print(f"| {name} | {a:.2f}, {behind:.2f}, {ahead:.2f} | {without:.4f} | "
              f"{back:.4f} | {of_shape:.4f} | {summary['friction']['mu']:.4f} | "
              f"{summary['end']['max_plastic_strain']:.2f} | {cost['steps']} | "
              f"{cost['newton_iterations']} | {cost['wall_time']:.0f} |",
              flush=True)


if __name__ == "__main__":
    main()
