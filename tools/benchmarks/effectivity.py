#!/usr/bin/python3
"""What the program says of its numerical error against what it is.

Usage: tools/benchmarks/effectivity.py [--asperity PROGRAM] [--to FOLDER]
           [--scenes WORDS] [--error PART] [--finest SPANS] TASK

  estimate  `Accuracy/Control = estimate` at the default settings against a
            finer run: the sixteen dry reference scenes, profiles of the
            surfaces in parameter_files and those of the tests at loads of their
            own, and R0 with two more harmonics
  adaptive  `Accuracy/Control = adaptive` for the wanted error: the error that
            is left, and the cost over that of the default settings
  remeshing Mesh/Adaptive levels against meshes that are fine along the whole
            edge: mu, unknowns, cost, and what changes of the mesh do to the run
            (--finest 640 is the reference, at 320 spans a fifth of its time)
  check     error and time that `asperity check` predicts for these settings
            against the run, on the scenes that no constant was fitted to

Tables go to the screen in Markdown. Runs that are done stay in FOLDER (default
output/effectivity) and are not repeated, so that the tool can be stopped and
started at will. --scenes R0,blasted takes the scenes whose names begin so.

The finer run has half the element length, a quarter of the time step and eight
times the penalty; mu of the reference scenes is in
parameter_files/reference_scenes/finest.csv. That of the other scenes has half
of each, which costs a fifth: it is itself off by a quarter of the error by the
mesh, and by half of those by steps and penalty, and the estimate is compared
with as much of itself.
"""

import argparse
import csv
import json
import math
import os
import re
import subprocess

import dry_scene

ROOT = dry_scene.ROOT
REFERENCE = os.path.join(ROOT, "parameter_files", "reference_scenes")
DEFAULT = {"Mesh/Spans": 160, "Mesh/Refinement levels": 3,
           "Mesh/Strip depth": "0.1 um",
           "Protocol/Ramp steps": 24, "Protocol/Slide steps": 96,
           "Contact/Penalty factor": 8, "Solver/Tolerance": 1e-4}
# Twice the penalty [Pa/m] over elements half as long is the same factor.
FINER = {**DEFAULT, "Mesh/Spans": 320, "Mesh/Refinement levels": 4,
         "Protocol/Ramp steps": 48, "Protocol/Slide steps": 192}
SEEN = {"mesh": 0.75, "step": 0.5, "penalty": 0.5}
TOPOGRAPHY = "Tool/Topography/"
TWO_MORE_HARMONICS = {
    "Tool/Wave numbers": "1, 2, 3, 4, 5, 6, 12, 25",
    "Tool/Amplitudes":
        "0.16, 0.12, 0.09, 0.06, 0.04, 0.02, 0.03, 0.015 um",
    "Tool/Phases": "0.3, 1.9, 4.1, 5.2, 0.9, 2.6, 1.1, 2.2 rad"}


def measured(surface, position, start, length, load, slide, **more):
    """A profile of a scene in parameter_files/measured_surfaces; um."""
    entries = {**dry_scene.load_case(*load),
               TOPOGRAPHY + "Profile position": position,
               "Geometry/Chip height": "6 um", "Mesh/Strip depth": "0.3 um",
               "Protocol/Friction window": "time",
               "Protocol/Sliding distance": f"{slide} um"}
    if start is not None:
        entries[TOPOGRAPHY + "Profile start"] = f"{start} um"
        entries[TOPOGRAPHY + "Profile length"] = f"{length} um"
        entries[TOPOGRAPHY + "S-filter nesting index"] = "3 um"
    for name, value in more.items():
        entries[TOPOGRAPHY + name.replace("_", " ")] = value
    return os.path.join(ROOT, "parameter_files", "measured_surfaces",
                        surface + ".prm"), entries


def scenes():
    """Files and the entries that are set beside them, by name."""
    found = {}
    for file in ("R0", "R1"):
        for pressure in (300, 1300):
            for velocity in (200, 22.5):
                for temperature in (25, 675):
                    found[f"{file}_p{pressure}_v{velocity}_T{temperature}"] = (
                        os.path.join(REFERENCE, file + ".prm"),
                        dry_scene.load_case(pressure, velocity, temperature))
    wire = {"Scale_x": 0.02, "Scale_z": 0.04}
    found.update({
        "blasted_1": measured("blasted_tool", "middle", 30, 15,
                              (300, 200, 25), 0.8),
        "blasted_2": measured("blasted_tool", "row 40", 50, 15,
                              (600, 100, 300), 0.4),
        "blasted_3": measured("blasted_tool", "row 120", 20, 12,
                              (1000, 60, 500), 0.25),
        "polished_1": measured("polished_tool", "middle", 30, 15,
                               (300, 200, 25), 0.8),
        "polished_2": measured("polished_tool", "row 60", 40, 20,
                               (900, 50, 400), 0.4),
        "alicona": measured("alicona_scan", "row 100", 30, 20,
                            (800, 200, 600), 1.0),
        "wire_1": measured("cut_wire", "row 30", None, None,
                           (300, 200, 25), 0.8, **wire),
        "wire_2": measured("cut_wire", "row 20", None, None,
                           (1000, 30, 300), 0.2, **wire)})
    for load in ((300, 200, 25), (1300, 22.5, 25)):
        found["fine_p{}_v{}_T{}".format(*load)] = (
            os.path.join(REFERENCE, "R0.prm"),
            {**dry_scene.load_case(*load), **TWO_MORE_HARMONICS})
    return found


def cached_run(arguments, scene, name, entries):
    """The summary of a run, computed unless it is there."""
    summary = os.path.join(arguments.to, scene, name, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as text:
            return json.load(text)
    file, of_scene = scenes()[scene]
    return dry_scene.run(arguments, os.path.join(scene, name),
                         {**of_scene, **entries}, include=file, may_fail=True)


def finest_mu():
    """mu of the finest runs, by scene."""
    with open(os.path.join(REFERENCE, "finest.csv"), encoding="utf-8") as file:
        return {row["scene"]: float(row["mu"]) for row in csv.DictReader(file)}


def truth(arguments, scene):
    """mu of a finer run, and the part of each error that it lacks."""
    known = finest_mu()
    if scene in known:
        return known[scene], {"mesh": 1., "step": 1., "penalty": 1.}
    summary = cached_run(arguments, scene, "finer", FINER)
    return (None if summary is None else summary["friction"]["mu"]), SEEN


def total(parts):
    """As ErrorEstimate::total(), of parts with their signs."""
    squares = sum(part**2 for part in parts)
    return (0.5 * (squares + sum(parts)**2))**0.5


def within(ratios, low=0.5, high=2.):
    return sum(low <= ratio <= high for ratio in ratios)


def estimate(arguments):
    dry_scene.print_head("scene | mu | off [%] | estimate [%] | mesh | steps | "
                         "penalty | estimate over error")
    ratios = []
    for scene in chosen(arguments):
        summary = cached_run(arguments, scene, "estimate",
                             {**DEFAULT, "Accuracy/Control": "estimate"})
        mu, seen = truth(arguments, scene)
        if summary is None or mu is None or "accuracy" not in summary:
            print(f"| {scene} | no result |", flush=True)
            continue
        off = summary["friction"]["mu"] / mu - 1.
        told = summary["accuracy"]["by_source"]
        expected = total([told[source] * seen[source] for source in seen])
        ratios.append(expected / abs(off))
        print(f"| {scene} | {summary['friction']['mu']:.5f} | {100 * off:+.2f} "
              f"| {100 * summary['accuracy']['error']:.2f} | "
              + " | ".join(f"{100 * abs(told[source]):.2f}" for source in seen)
              + f" | {ratios[-1]:.2f} |", flush=True)
    if ratios:
        print(f"\nwithin a factor of 2: {within(ratios)} of {len(ratios)}; "
              f"smallest {min(ratios):.2f}, largest {max(ratios):.2f}")


def adaptive(arguments):
    dry_scene.print_head("scene | mu | off [%] | estimate [%] | wanted [%] | "
                         "rounds | runs | spans | steps | penalty factor | "
                         "unknowns | cost of the run over default | cost of "
                         "all over default")
    met = []
    for scene in chosen(arguments):
        summary = cached_run(
            arguments, scene, f"adaptive_{arguments.error}",
            {**DEFAULT, "Accuracy/Control": "adaptive",
             "Accuracy/Error": arguments.error})
        default = cached_run(arguments, scene, "default", DEFAULT)
        mu, _ = truth(arguments, scene)
        if summary is None or default is None or mu is None:
            print(f"| {scene} | no result |", flush=True)
            continue
        accuracy = summary["accuracy"]
        last = accuracy["rounds"][-1]
        off = summary["friction"]["mu"] / mu - 1.
        of_default = (default["mesh"]["unknowns"]
                      * default["cost"]["newton_iterations"])
        met.append(abs(off) <= arguments.error)
        print(f"| {scene} | {summary['friction']['mu']:.5f} | {100 * off:+.2f} "
              f"| {100 * accuracy['error']:.2f} | {100 * arguments.error:.2g} | "
              f"{len(accuracy['rounds'])} | {accuracy['runs']} | "
              f"{last['spans']} | {last['ramp_steps']} + {last['slide_steps']} "
              f"| {last['penalty_factor']:g} | {last['unknowns']} | "
              f"{last['unknowns'] * last['newton_iterations'] / of_default:.2f}"
              f" | {accuracy['cost'] / of_default:.2f} |", flush=True)
    if met:
        print(f"\nmet: {sum(met)} of {len(met)}")


def remeshing(arguments):
    dry_scene.print_head("scene | spans | levels at contacts | mu | off [%] | "
                         "mean unknowns | Newton iterations | unknowns x "
                         "iterations over those without | remeshes | largest "
                         "change of mu [%] | drift of plastic work")
    for scene in chosen(arguments):
        results = {}
        spans, level = arguments.finest, int(math.log2(arguments.finest // 20))
        while level >= 2:
            for adaptive in (0, level - 1):
                if adaptive and spans == arguments.finest:
                    continue
                results[spans, adaptive] = cached_run(
                    arguments, scene, f"mesh_{spans}_{adaptive}",
                    {**DEFAULT, "Mesh/Spans": spans, "Solver/Tolerance": 1e-6,
                     "Mesh/Refinement levels": level,
                     "Mesh/Adaptive levels": adaptive})
            spans, level = spans // 2, level - 1
        print_remeshing(scene, results,
                        results[arguments.finest, 0]["friction"]["mu"])


def print_remeshing(scene, results, reference):
    def work(summary):
        mesh = summary["mesh"]
        unknowns = mesh.get("remeshing", {}).get("mean_unknowns",
                                                 mesh["unknowns"])
        return unknowns, unknowns * summary["cost"]["newton_iterations"]

    for (spans, adaptive), summary in sorted(results.items()):
        if summary is None:
            print(f"| {scene} | {spans} | {adaptive} | no result |")
            continue
        even = results[spans, 0]
        told = summary["mesh"].get("remeshing")
        mu = summary["friction"]["mu"]
        print(f"| {scene} | {spans} | {adaptive} | {mu:.5f} | "
              f"{100 * (mu / reference - 1.):+.2f} | {work(summary)[0]} | "
              f"{summary['cost']['newton_iterations']} | "
              f"{work(summary)[1] / work(even)[1]:.2f} | "
              + (f"{told['remeshes']} | "
                 f"{100 * told['largest_change_of_mu']:.3f} | "
                 f"{told['drift_of_plastic_work']:.0e} |" if told else "| | |"),
              flush=True)


def prediction(arguments, file):
    """Error and time that `asperity check` predicts for a file."""
    done = subprocess.run([arguments.asperity, "check", file],
                          capture_output=True, text=True, check=True)
    found = re.search(r"numerical error of mu about ([\d.e+-]+) %, time about "
                      r"([\d.e+-]+) times", done.stdout)
    return float(found.group(1)) / 100., float(found.group(2))


def check(arguments):
    dry_scene.print_head("scene | off [%] | predicted [%] | predicted over off "
                         "| cost over R0's | predicted | predicted over cost")
    errors, costs = [], []
    reference = cached_run(arguments, "R0_p300_v200_T25", "default", DEFAULT)
    of_reference = (reference["mesh"]["unknowns"]
                    * reference["cost"]["newton_iterations"])
    for scene in chosen(arguments):
        summary = cached_run(arguments, scene, "default", DEFAULT)
        mu, _ = truth(arguments, scene)
        if summary is None or mu is None:
            print(f"| {scene} | no result |", flush=True)
            continue
        error, time = prediction(
            arguments, os.path.join(arguments.to, scene, "default",
                                    "scene.prm"))
        off = abs(summary["friction"]["mu"] / mu - 1.)
        cost = (summary["mesh"]["unknowns"]
                * summary["cost"]["newton_iterations"] / of_reference)
        errors.append(error / off)
        costs.append(time / cost)
        print(f"| {scene} | {100 * off:.2f} | {100 * error:.2f} | "
              f"{errors[-1]:.2f} | {cost:.2f} | {time:.2f} | {costs[-1]:.2f} |",
              flush=True)
    if errors:
        print(f"\nwithin a factor of 2: error {within(errors)}, cost "
              f"{within(costs)} of {len(errors)}")


def chosen(arguments):
    words = tuple(arguments.scenes.split(",")) if arguments.scenes else ("",)
    return [scene for scene in scenes() if scene.startswith(words)]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    tasks = {"estimate": estimate, "adaptive": adaptive,
             "remeshing": remeshing, "check": check}
    parser.add_argument("task", choices=tasks)
    parser.add_argument("--asperity",
                        default=os.path.join(ROOT, "build", "asperity"))
    parser.add_argument("--to", default=os.path.join(ROOT, "output",
                                                     "effectivity"))
    parser.add_argument("--scenes", default="")
    parser.add_argument("--error", type=float, default=0.007)
    parser.add_argument("--finest", type=int, default=640,
                        choices=(160, 320, 640))
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    os.makedirs(arguments.to, exist_ok=True)
    tasks[arguments.task](arguments)


if __name__ == "__main__":
    main()
