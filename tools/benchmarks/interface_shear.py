#!/usr/bin/python3
"""The shear of the interface against a formula, and what it does to mu.

Usage: tools/benchmarks/interface_shear.py [--asperity PROGRAM] [--to FOLDER] TASK

  wave   a rigid wedge that slides on a perfectly plastic body and pushes a wave
         ahead of it, against the formula of Challen and Oxley (1979), for
         slopes of 5 and 10 degrees and shear factors of 0, 0.3, 0.6, 0.8
  standing  the same, but the wave is there from the start, so that mu is that of
         the theory's slip lines at once; over tip radius and mesh, and
         extrapolated
  junction  a cylinder pushed aside on a perfectly plastic chip: the pressure of what
         touches beside its shear, against the slip lines of Green (1954)
  cases  mu, its shares, contact and cost of the sixteen reference scenes for
         shear factors of 0, 0.5, 0.8 and 1, and a chart of them
  mesh   mu over mesh and time steps for shear factors of 0.5, 0.8 and 0.99
  steps  what the time steps err in the sixteen scenes, against 144 + 384 of them
  fine   mu of the sixteen scenes over the mesh, with steps that are short enough
  robust R0 from slow to fast and nearly molten: mu and iterations

Tables go to the screen in Markdown, runs into FOLDER (default output/benchmarks).
Run it on a quiet machine; compare times within one run only.
"""

import cmath
import csv
import math
import os
import sys

from dry_scene import ROOT, arguments_of, load_case, print_head, run

CASES = [(p, v, T) for p in (300, 1300) for v in (22.5, 200) for T in (25, 675)]
PERIOD = 10.  # um
WAVES = 60  # that a wedge is made of, the odd ones
YIELD_STRESS = 210.  # MPa


# The default settings, a tenth of the cost of the reference scenes' files.
SETTINGS = {"Mesh/Spans": 160, "Mesh/Refinement levels": 3,
            "Mesh/Strip depth": "0.1 um", "Protocol/Ramp steps": "automatic",
            "Protocol/Slide steps": 96, "Solver/Tolerance": 1e-4}


def shear(factor):
    if factor == 0.:
        return {"Interface/Shear law": "none"}
    return {"Interface/Shear law": "shear factor",
            "Interface/Shear factor": factor}


def challen_oxley(slope, f):
    """mu of a wedge of a slope [rad] and the load on the length of its contact
    over the shear strength k."""
    eta = math.acos(f)
    a = (1. + 0.5 * math.pi + eta - 2. * slope -
         2. * math.asin(math.sin(slope) / math.sqrt(1. - f)))
    tangential = a * math.sin(slope) + math.cos(eta - slope)
    normal = a * math.cos(slope) + math.sin(eta - slope)
    return tangential / normal, normal / math.cos(slope)


def wedge(degrees, f, contact_length=2.5, waves=WAVES):
    """A triangular wave whose load takes a contact of a length [um], on a body
    that is nearly rigid before it yields."""
    height = math.tan(math.radians(degrees)) * PERIOD / 2.
    _, hardness = challen_oxley(math.radians(degrees), f)
    pressure = (hardness * YIELD_STRESS / math.sqrt(3.) * contact_length /
                PERIOD)
    numbers = range(1, waves, 2)
    amplitudes = ", ".join(f"{4. * height / (math.pi * k)**2:.8g} um"
                           for k in numbers)
    return {"Tool/Kind": "harmonics",
            "Tool/Wave numbers": ", ".join(str(k) for k in numbers),
            "Tool/Amplitudes": amplitudes,
            "Tool/Phases": ", ".join("0 rad" for _ in numbers),
            "Geometry/Period": f"{PERIOD} um",
            "Geometry/Initial gap": "0 um",
            "Mesh/Strip depth": f"{0.3 * contact_length} um",
            "Material/Adiabatic heating": "false",
            "Material/Johnson-Cook/A": f"{YIELD_STRESS} MPa",
            "Material/Johnson-Cook/B": "0 MPa",
            "Material/Johnson-Cook/C": 0,
            "Load/Pressure": f"{pressure:.6g} MPa",
            "Load/Temperature": "20 degC",
            "Protocol/Inertia": "quasi-static",
            "Protocol/Friction window": "steady",
            "Protocol/Steady distance": f"{contact_length} um",
            "Protocol/Steady step": f"{20. * contact_length} nm",
            "Protocol/Steady tolerance": 0.003,
            "Protocol/Maximum distance": f"{6. * contact_length} um",
            **shear(f)}


def wave(arguments):
    print_head("slope [deg] | f | mu after Challen and Oxley | mu | off [%] | "
               "ploughing | interface shear | contact fraction | way [um] | "
               "steps | Newton iterations | time [s]")
    for degrees in (5, 10):
        for f in (0., 0.3, 0.6, 0.8):
            exact, _ = challen_oxley(math.radians(degrees), f)
            summary = run(arguments, f"wave_{degrees}_{f}", wedge(degrees, f),
                          may_fail=True)
            if summary is None:
                print(f"| {degrees} | {f} | {exact:.4f} |" + " - |" * 9,
                      flush=True)
                continue
            friction, cost = summary["friction"], summary["cost"]
            print(f"| {degrees} | {f} | {exact:.4f} | {friction['mu']:.4f} | "
                  f"{100. * (friction['mu'] / exact - 1.):+.1f} | "
                  f"{friction['ploughing']:.4f} | "
                  f"{friction['interface_shear']:.4f} | "
                  f"{summary['contact_fraction']:.4f} | "
                  f"{summary['end']['sliding_distance'] * 1e6:.2f} | "
                  f"{cost['steps']} | {cost['newton_iterations']} | "
                  f"{cost['wall_time']:.0f} |", flush=True)


def harmonics(corners, n):
    """Wave numbers, amplitudes and phases of the first n waves of a periodic
    polygon of corners (x, height)."""
    ends = corners[1:] + [(corners[0][0] + PERIOD, corners[0][1])]
    slopes = [(end[1] - start[1]) / (end[0] - start[0])
              for start, end in zip(corners, ends)]
    waves = []
    for k in range(1, n + 1):
        w = 2. * math.pi * k / PERIOD
        c = sum((before - after) * cmath.exp(-1j * w * x)
                for (x, _), before, after in zip(corners,
                                                 slopes[-1:] + slopes[:-1],
                                                 slopes)) / (PERIOD * w * w)
        waves.append((k, 2. * abs(c), cmath.phase(c)))
    return waves


def standing_wave(degrees, f, waves, spans, contact_length=2.5):
    """The wedge whose tip is at the level of the chip, and the wave of the
    theory ahead of it as the shape that the chip has at the start."""
    slope = math.radians(degrees)
    length = contact_length / math.cos(slope)
    front = math.asin(math.sin(slope) / math.sqrt(1. - f))
    tip = PERIOD / 2.
    crest = tip - contact_length
    foot = crest - length * math.sqrt(1. - f) * math.cos(front)
    chip = harmonics([(foot, 0.), (crest, length * math.sin(slope)),
                      (tip, 0.)], 2 * waves // 3)
    entries = {key: value for key, value
               in wedge(degrees, f, contact_length, waves).items()
               if not key.startswith("Protocol/")}
    return {**entries,
            "Chip surface/Kind": "harmonics",
            "Chip surface/Wave numbers": ", ".join(str(k) for k, _, _ in chip),
            "Chip surface/Amplitudes":
                ", ".join(f"{a:.8g} um" for _, a, _ in chip),
            "Chip surface/Phases":
                ", ".join(f"{phi:.8g} rad" for _, _, phi in chip),
            "Mesh/Spans": spans,
            "Mesh/Refinement levels": int(math.log2(spans // 20)),
            "Mesh/Strip depth": f"{0.6 * contact_length} um",
            "Protocol/Inertia": "quasi-static",
            "Protocol/Sliding distance": f"{0.1 * contact_length} um",
            "Protocol/Ramp fraction": 0.04,
            "Protocol/Ramp steps": 30,
            "Protocol/Slide steps": 40,
            "Protocol/Window fraction": 0.8}


def standing(arguments):
    print_head("slope [deg] | f | mu after Challen and Oxley | 40 waves, 160 "
               "spans | off [%] | 80 waves, 320 spans | off [%] | extrapolated "
               "| off [%]")
    for degrees, f in ((5, 0.6), (10, 0.6), (5, 0.8), (10, 0.8)):
        exact, _ = challen_oxley(math.radians(degrees), f)
        mu = [run(arguments, f"standing_{degrees}_{f}_{spans}",
                  standing_wave(degrees, f, waves, spans))["friction"]["mu"]
              for waves, spans in ((60, 160), (120, 320))]
        mu.append(2. * mu[1] - mu[0])
        print(f"| {degrees} | {f} | {exact:.4f} |" +
              "".join(f" {value:.4f} | {100. * (value / exact - 1.):+.1f} |"
                      for value in mu), flush=True)


def junction(arguments):
    strength = YIELD_STRESS / math.sqrt(3.)
    pressure = 90.
    run(arguments, "junction", {
        "Tool/Kind": "harmonics", "Tool/Wave numbers": "1",
        "Tool/Amplitudes": "0.25 um", "Tool/Phases": "0 rad",
        "Geometry/Period": f"{PERIOD} um", "Geometry/Initial gap": "0 um",
        "Mesh/Spans": 320, "Mesh/Refinement levels": 4,
        "Material/Adiabatic heating": "false",
        "Material/Johnson-Cook/A": f"{YIELD_STRESS} MPa",
        "Material/Johnson-Cook/B": "0 MPa", "Material/Johnson-Cook/C": 0,
        "Load/Pressure": f"{pressure} MPa", "Load/Temperature": "20 degC",
        "Protocol/Inertia": "quasi-static",
        "Protocol/Sliding distance": "60 nm",
        "Protocol/Ramp fraction": 0.005, "Protocol/Ramp steps": 12,
        "Protocol/Slide steps": 12, **shear(1.)})
    print_head("way [nm] | shear f over k | pressure over k | after Green | "
               "off [%] | alpha of Tabor")
    head = 2. + math.pi
    with open(os.path.join(arguments.to, "junction", "friction.csv"),
              encoding="utf-8") as file:
        for row in csv.DictReader(file):
            way = float(row["sliding distance [m]"]) * 1e9
            if way < 2.:
                continue
            p = pressure / float(row["contact fraction [-]"]) / strength
            f = min(1., p * float(row["interface shear [-]"]))
            exact = 1. + math.pi / 2. + math.acos(f) + math.sqrt(1. - f * f)
            print(f"| {way:.0f} | {f:.3f} | {p:.3f} | {exact:.3f} | "
                  f"{100. * (p / exact - 1.):+.1f} | "
                  f"{(head**2 - p**2) / f**2:.1f} |", flush=True)


def draw_cases(arguments, summaries):
    """mu, its part by shear, and what touches over the shear factor."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError as error:
        sys.exit(f"{error}: the chart needs matplotlib; "
                 "tools/install_dependencies installs it.")
    quantities = {
        "mu [-]": lambda s: s["friction"]["mu"],
        "part of mu by interface shear [-]":
            lambda s: s["friction"]["interface_shear"],
        "contact fraction [-]": lambda s: s["contact_fraction"]}
    figure, axes = plt.subplots(2, 3, figsize=(13, 7), sharex=True)
    for row, scene in zip(axes, ("R0", "R1")):
        for axis, (label, value) in zip(row, quantities.items()):
            for number, (p, v, T) in enumerate(CASES):
                points = [(m, value(s)) for (name, case, m), s
                          in summaries.items()
                          if name == scene and case == (p, v, T)]
                axis.plot(*zip(*sorted(points)), color=f"C{number // 2}",
                          linestyle="-" if T == 25 else "--", marker="o",
                          markersize=3,
                          label=f"{p} MPa, {v} m/min, {T} °C")
            axis.set_ylabel(f"{scene}: {label}")
            axis.grid(alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("shear factor m [-]")
    axes[0][0].legend(fontsize=7)
    figure.tight_layout()
    file = os.path.join(arguments.to, "shear_cases.png")
    figure.savefig(file, dpi=100)
    print(file)


def reference_scene(scene, case):
    return os.path.join(ROOT, "parameter_files", "reference_scenes",
                        "dry_{}_p{}_v{}_T{}.prm".format(scene, *case))


def cases(arguments):
    summaries = {}
    print_head("scene | p [MPa] | v [m/min] | T [degC] | m | mu | ploughing | "
               "interface shear | contact fraction | real contact pressure "
               "[MPa] | hottest point [degC] | steps | Newton iterations | "
               "time over that of m = 0")
    for scene in ("R0", "R1"):
        for case in CASES:
            reference = None
            for m in (0., 0.5, 0.8, 1.):
                summary = run(arguments,
                              "shear_{}_p{}_v{}_T{}".format(scene, *case) +
                              f"_m{m}", {**SETTINGS, **shear(m)},
                              reference_scene(scene, case), may_fail=True)
                if summary is None:
                    print("| {} | {} | {} | {} | ".format(scene, *case) +
                          f"{m} |" + " - |" * 9, flush=True)
                    continue
                summaries[scene, case, m] = summary
                friction, cost = summary["friction"], summary["cost"]
                reference = reference or cost["wall_time"]
                print("| {} | {} | {} | {} | ".format(scene, *case) +
                      f"{m} | {friction['mu']:.4f} | "
                      f"{friction['ploughing']:.4f} | "
                      f"{friction['interface_shear']:.4f} | "
                      f"{summary['contact_fraction']:.4f} | "
                      f"{summary['end']['real_contact_pressure'] * 1e-6:.0f} | "
                      f"{summary['end']['max_temperature'] - 273.15:.0f} | "
                      f"{cost['steps']} | {cost['newton_iterations']} | "
                      f"{cost['wall_time'] / reference:.2f} |", flush=True)
    draw_cases(arguments, summaries)


def mesh(arguments):
    print_head("m | settings | mu | interface shear | contact fraction | steps "
               "| Newton iterations | time [s]")
    variants = {"default": {},
                "80 spans": {"Mesh/Spans": 80, "Mesh/Refinement levels": 2},
                "320 spans": {"Mesh/Spans": 320, "Mesh/Refinement levels": 4},
                "640 spans": {"Mesh/Spans": 640, "Mesh/Refinement levels": 5},
                "72 + 192 steps": {"Protocol/Ramp steps": 72,
                                   "Protocol/Slide steps": 192},
                "144 + 384 steps": {"Protocol/Ramp steps": 144,
                                    "Protocol/Slide steps": 384}}
    for m in (0.5, 0.8, 0.99):
        for name, entries in variants.items():
            if m > 0.5 and name in ("640 spans", "144 + 384 steps"):
                continue  # most of all the time
            summary = run(arguments, f"mesh_{m}_{name.replace(' ', '_')}",
                          {**load_case(300, 200, 25), **shear(m), **entries})
            friction, cost = summary["friction"], summary["cost"]
            print(f"| {m} | {name} | {friction['mu']:.4f} | "
                  f"{friction['interface_shear']:.4f} | "
                  f"{summary['contact_fraction']:.4f} | {cost['steps']} | "
                  f"{cost['newton_iterations']} | {cost['wall_time']:.0f} |",
                  flush=True)


def steps(arguments):
    print_head("m | steps | off in the mean [%] | lowest | highest | Newton "
               "iterations")
    numbers = ((144, 384), (36, 96), (48, 96), (72, 96), (72, 60))
    for m in (0.5, 0.8):
        finest = {}
        for ramp, slide in numbers:
            off, iterations = [], 0
            for scene, case in ((s, c) for s in ("R0", "R1") for c in CASES):
                summary = run(
                    arguments,
                    "steps_{}_p{}_v{}_T{}".format(scene, *case) +
                    f"_m{m}_{ramp}_{slide}",
                    {**SETTINGS, **shear(m), "Protocol/Ramp steps": ramp,
                     "Protocol/Slide steps": slide},
                    reference_scene(scene, case))
                mu = summary["friction"]["mu"]
                mu_finest = finest.setdefault((scene, case), mu)
                off.append(100. * (mu / mu_finest - 1.))
                iterations += summary["cost"]["newton_iterations"]
            print(f"| {m} | {ramp} + {slide} | {sum(off) / len(off):+.2f} | "
                  f"{min(off):+.2f} | {max(off):+.2f} | {iterations} |",
                  flush=True)


def fine(arguments):
    print_head("scene | p [MPa] | v [m/min] | T [degC] | m | mu, 640 spans | with "
               "160 [%] | with 320 [%] | with 1280 [%]")

    def mu(scene, case, m, spans):
        return run(arguments,
                   "fine_{}_p{}_v{}_T{}".format(scene, *case) + f"_m{m}_{spans}",
                   {**SETTINGS, **shear(m), "Mesh/Spans": spans,
                    "Mesh/Refinement levels": int(math.log2(spans // 20)),
                    "Protocol/Ramp steps": 144, "Protocol/Slide steps": 192},
                   reference_scene(scene, case))["friction"]["mu"]

    for scene, case in ((s, c) for s in ("R0", "R1") for c in CASES):
        for m in (0.5, 0.8):
            coarse, medium, finer = (mu(scene, case, m, spans)
                                     for spans in (160, 320, 640))
            # Where the last change is large, another one tells.
            finest = (f"{100. * (mu(scene, case, m, 1280) / finer - 1.):+.2f}"
                      if abs(medium / finer - 1.) > 0.007 else "")
            print("| {} | {} | {} | {} | ".format(scene, *case) +
                  f"{m} | {finer:.4f} | {100. * (coarse / finer - 1.):+.2f} | "
                  f"{100. * (medium / finer - 1.):+.2f} | {finest} |",
                  flush=True)


def robust(arguments):
    print_head("p [MPa] | v [m/min] | T [degC] | mu, iterations at m = 0 | "
               "0.5 | 0.8 | 0.99")
    for row in ([300, 0.1, 25], [300, 2000, 25], [1300, 200, 675],
                [1300, 2000, 1200], [300, 200, 1450]):
        p, v, T = row
        for m in (0., 0.5, 0.8, 0.99):
            summary = run(arguments, f"robust_p{p}_v{v}_T{T}_m{m}",
                          {**SETTINGS, **shear(m), "Mesh/Spans": 80,
                           "Mesh/Refinement levels": 2,
                           "Load/Pressure": f"{p} MPa",
                           "Load/Velocity": f"{v} m/min",
                           "Load/Temperature": f"{T} degC",
                           "Protocol/Sliding distance": "0.8 um"},
                          reference_scene("R0", (300, 200, 25)), may_fail=True)
            row.append("-" if summary is None else
                       f"{summary['friction']['mu']:.3f}, "
                       f"{summary['cost']['newton_iterations']}")
        print("| " + " | ".join(map(str, row)) + " |", flush=True)


def main():
    parser = arguments_of(__doc__)
    tasks = {"wave": wave, "standing": standing, "junction": junction,
             "cases": cases, "mesh": mesh, "steps": steps,
             "fine": fine, "robust": robust}
    parser.add_argument("task", choices=tasks)
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    os.makedirs(arguments.to, exist_ok=True)
    tasks[arguments.task](arguments)


if __name__ == "__main__":
    main()
