#!/usr/bin/python3
"""A rigid cone and a rigid ball that plough a soft block, against formulas.

Usage: tools/benchmarks/ploughing.py [--asperity PROGRAM] [--to FOLDER]
                                     [--spans N]

The block does not harden. mu of a cone whose flank rises by theta is
2 tan(theta)/pi, that of a ball of radius R with a contact of radius a
  2 (R^2/a^2 asin(a/R) - sqrt(R^2/a^2 - 1))/pi,
both where the front half of the contact alone bears the load, which pushes with
the same pressure everywhere, and nothing piles up (J. Goddard, H. Wilman, Wear 5
(1962) 114). a of the ball comes from the contact fraction of the run.

The table goes to the screen in Markdown, runs into FOLDER (default
output/benchmarks). Some ten minutes a run.
"""

import math
import os

from dry_scene import ROOT, arguments_of, print_head, run

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


def goddard_wilman(a):
    """mu of a ball with a contact of radius a [um]."""
    q = RADIUS / a
    return 2. / math.pi * (q * q * math.asin(1. / q) - math.sqrt(q * q - 1.))


def main():
    parser = arguments_of(__doc__)
    parser.add_argument("--spans", type=int, default=24)
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    os.makedirs(arguments.to, exist_ok=True)
    common = os.path.join(ROOT, "parameter_files", "surface_patches",
                          "common.prm")
    print_head("tool | contact radius [um] | mu by the formula | mu | off [%] | "
               "largest plastic strain | steps | Newton iterations | time [s]")
    for name, height in (("cone", cone), ("ball", ball)):
        path = os.path.join(arguments.to, f"{name}.txt")
        write_map(path, height)
        summary = run(arguments, f"plough_{name}",
                      scene(path, arguments.spans), common, may_fail=True)
        if summary is None:
            continue
        mu, cost = summary["friction"]["mu"], summary["cost"]
        # The front half bears the load.
        radius = PERIOD * math.sqrt(2. * summary["contact_fraction"] / math.pi)
        exact = (2. * math.tan(ANGLE) / math.pi if name == "cone"
                 else goddard_wilman(radius))
        print(f"| {name} | {radius:.2f} | {exact:.4f} | {mu:.4f} | "
              f"{100. * (mu / exact - 1.):+.1f} | "
              f"{summary['end']['max_plastic_strain']:.2f} | {cost['steps']} | "
              f"{cost['newton_iterations']} | {cost['wall_time']:.0f} |",
              flush=True)


if __name__ == "__main__":
    main()
