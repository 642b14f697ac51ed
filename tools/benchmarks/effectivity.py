#!/usr/bin/python3
"""What the program says of its numerical error against what it is.

Usage: tools/benchmarks/effectivity.py [--asperity PROGRAM] [--to FOLDER]
           [--scenes WORDS] [--error PART] [--finest SPANS] TASK

  estimate  `Accuracy/Control = estimate` at the default settings against a
            finer run on the forty scenes of accuracy_scenes.py: the sixteen dry
            reference scenes, and profiles of five surfaces at loads of their
            own, of which those are skipped whose height map is not there
  adaptive  `Accuracy/Control = adaptive` for the wanted error: the error that
            is left in the corrected mu and in that of the last run, and the
            cost over that of the best fixed settings: the cheapest of 40, 80
            and 160 spans, 12 + 48 and 24 + 96 steps, default penalty [Pa/m] and
            half of it, whose mu keeps the error
  fixed     one and the same settings for all scenes: in how many of them mu keeps
            the wanted error, and the sum of their costs, of the runs in
            histories/accuracy_members.csv; computes nothing
  remeshing Mesh/Adaptive levels against meshes that are fine along the whole
            edge: mu, unknowns, cost, and what changes of the mesh do to the run
            (--finest 640 is the reference, at 320 spans a fifth of its time)
  check     error and time that `asperity check` predicts for these settings
            against the run and its estimate, with its signed sources and with
            the root of their squares, before they cancel, on ten profiles that
            no constant was fitted to (--scenes fresh)

Tables go to the screen in Markdown. Runs that are done stay in FOLDER (default
output/effectivity) and are not repeated, so that the tool can be stopped and
started at will. --scenes R0,blasted takes the scenes whose names begin so;
fine takes R0 with two more harmonics.

mu of the finer runs is in histories/accuracy_references.csv: half the element
length, a quarter of the time step and eight times the penalty [Pa/m], the mean
of runs on meshes that are moved against the surfaces, by 0 and half an element
or by a quarter, half and three quarters of one, and its uncertainty from their
scatter. It is itself off by a quarter of the errors by mesh and steps and an
eighth of that by the penalty, and the estimate is compared with as much of
itself as it can see. Scenes that are not in it are compared with one run of
half the length, half the step and four times the penalty.

Errors below a seventh of Accuracy/Error (0.1 %) are nobody's concern, and errors
below the uncertainty of the reference nobody knows: ratios are told as they
are, and with estimate and error raised to the larger of the two.
"""

import argparse
import csv
import json
import math
import os
import re
import statistics
import subprocess
import sys

import accuracy_scenes
import dry_scene
from accuracy_scenes import scenes

ROOT = dry_scene.ROOT
REFERENCES = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                          "histories", "accuracy_references.csv")
MEMBERS = os.path.join(os.path.dirname(REFERENCES), "accuracy_members.csv")
DEFAULT = {"Mesh/Spans": 160, "Mesh/Refinement levels": 3,
           "Mesh/Strip depth": "0.1 um",
           "Protocol/Ramp steps": 24, "Protocol/Slide steps": 96,
           "Contact/Penalty factor": 8, "Solver/Tolerance": 1e-4}
# Four times the penalty [Pa/m], since elements are half as long.
FINER = {**DEFAULT, "Mesh/Spans": 320, "Mesh/Refinement levels": 4,
         "Mesh/Strip depth": "0.05 um", "Protocol/Ramp steps": 48,
         "Protocol/Slide steps": 192, "Contact/Penalty factor": 16}
SEEN = {"mesh": 0.75, "step": 0.75, "penalty": 0.875}
SEEN_BY_ONE = {"mesh": 0.75, "step": 0.5, "penalty": 0.75}
FIXED = [{"Mesh/Spans": spans, "Mesh/Refinement levels": levels,
          "Protocol/Ramp steps": steps, "Protocol/Slide steps": 4 * steps,
          "Contact/Penalty factor": 8 * 160 / spans * penalty}
         for spans, levels in ((40, 1), (80, 2), (160, 3))
         for steps in (12, 24) for penalty in (0.5, 1.)]
FLOOR = 1e-3


def cached_run(arguments, scene, name, entries):
    """The summary of a run, computed unless it is there."""
    folder = os.path.join(arguments.to, scene, name)
    if os.path.exists(folder):
        with open(os.path.join(folder, "summary.json"),
                  encoding="utf-8") as text:
            return json.load(text)
    file, of_scene = scenes()[scene]
    # Elsewhere, since a run that is stopped may leave a summary.
    summary = dry_scene.run(arguments, os.path.join(scene, "unfinished"),
                            {**of_scene, **entries}, include=file,
                            may_fail=True)
    if summary is not None:
        os.rename(os.path.join(arguments.to, scene, "unfinished"), folder)
    return summary


def truth(arguments, scene):
    """mu of finer runs, its relative uncertainty, and the part of each error
    that they can see."""
    with open(REFERENCES, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["scene"] == scene:
                return (float(row["mu"]), float(row["uncertainty"] or 0.), SEEN)
    summary = cached_run(arguments, scene, "finer", FINER)
    return (None if summary is None else summary["friction"]["mu"], 0.,
            SEEN_BY_ONE)


def total(parts, chance):
    """As ErrorEstimate::total(), of parts with their signs."""
    squares = sum(part**2 for part in parts)
    return (sum(parts)**2 + 0.1**2 * squares + chance**2)**0.5


def work(summary):
    """To which the time of a run is nearly proportional."""
    return summary["mesh"]["unknowns"] * summary["cost"]["newton_iterations"]


def within(ratios, low=0.5, high=2.):
    return sum(low <= ratio <= high for ratio in ratios)


def estimate(arguments):
    dry_scene.print_head("scene | mu | off [%] | corrected [%] | estimate [%] | "
                         "mesh | steps | penalty | chance | uncertainty of the "
                         "reference [%] | "
                         "cost of companions | estimate over error | "
                         "with floor")
    ratios, floored = [], []
    for scene in chosen(arguments):
        summary = cached_run(arguments, scene, "estimate",
                             {**DEFAULT, "Accuracy/Control": "estimate"})
        mu, uncertainty, seen = truth(arguments, scene)
        if summary is None or mu is None or "accuracy" not in summary:
            print(f"| {scene} | no result |", flush=True)
            continue
        off = summary["friction"]["mu"] / mu - 1.
        told = summary["accuracy"]["by_source"]
        expected = total([told[source] * seen[source] for source in seen],
                         told["chance"])
        floor = max(FLOOR, uncertainty)
        ratios.append(expected / abs(off))
        floored.append(max(expected, floor) / max(abs(off), floor))
        cost = work(summary)
        left = off - sum(told[source] * seen[source] for source in seen)
        print(f"| {scene} | {summary['friction']['mu']:.5f} | {100 * off:+.2f} "
              f"| {100 * left:+.2f} "
              f"| {100 * summary['accuracy']['error']:.2f} | "
              + " | ".join(f"{100 * told[source]:+.2f}" for source in seen)
              + f" | {100 * told['chance']:.2f} | {100 * uncertainty:.2f}"
              f" | {summary['accuracy']['cost'] / cost - 1.:.2f} | "
              f"{ratios[-1]:.2f} | {floored[-1]:.2f} |", flush=True)
    for name, values in (("", ratios), ("with floor, ", floored)):
        if values:
            print(f"\n{name}within a factor of 2: {within(values)} of "
                  f"{len(values)}; smallest {min(values):.2f}, largest "
                  f"{max(values):.2f}")


def best_fixed(arguments, scene, mu):
    """The cheapest fixed settings that keep the error, and their cost; None if
    none do."""
    for entries in FIXED:  # the dearer ones come later
        steps, spans = entries["Protocol/Ramp steps"], entries["Mesh/Spans"]
        factor = entries["Contact/Penalty factor"]
        summary = cached_run(arguments, scene,
                             f"fixed_{spans}_{steps}_{factor:g}",
                             {**DEFAULT, **entries})
        if (summary is not None
                and abs(summary["friction"]["mu"] / mu - 1.)
                <= arguments.error):
            return f"{spans}, {steps} + {4 * steps}", work(summary)
    return "none", None


def adaptive(arguments):
    dry_scene.print_head("scene | corrected mu | off [%] | uncertainty [%] | "
                         "mu off [%] | rounds | runs | spans | steps | penalty "
                         "factor | best fixed settings | cost of the run over "
                         "theirs | cost of all over theirs")
    met, last_costs, costs = [], [], []
    for scene in chosen(arguments):
        summary = cached_run(
            arguments, scene, f"adaptive_{arguments.error}",
            {**DEFAULT, "Accuracy/Control": "adaptive",
             "Accuracy/Error": arguments.error})
        mu, _, _ = truth(arguments, scene)
        if summary is None or mu is None or "accuracy" not in summary:
            print(f"| {scene} | no result |", flush=True)
            continue
        accuracy = summary["accuracy"]
        last = accuracy["rounds"][-1]
        off = accuracy["corrected_mu"] / mu - 1.
        met.append(abs(off) <= arguments.error)
        best, cost = best_fixed(arguments, scene, mu)
        shown = ["", ""]
        if cost is not None:
            last_costs.append(last["unknowns"] * last["newton_iterations"]
                              / cost)
            costs.append(accuracy["cost"] / cost)
            shown = [f"{last_costs[-1]:.2f}", f"{costs[-1]:.1f}"]
        print(f"| {scene} | {accuracy['corrected_mu']:.5f} | {100 * off:+.2f} "
              f"| {100 * accuracy['uncertainty']:.2f} | "
              f"{100 * (summary['friction']['mu'] / mu - 1.):+.2f} | "
              f"{len(accuracy['rounds'])} | {accuracy['runs']} | "
              f"{last['spans']} | {last['ramp_steps']} + {last['slide_steps']} "
              f"| {last['penalty_factor']:g} | {best} | "
              + " | ".join(shown) + " |", flush=True)
    if met:
        print(f"\nmet: {sum(met)} of {len(met)}")
    if costs:
        print(f"cost over that of the best fixed settings, median: last run "
              f"{statistics.median(last_costs):.2f}, all "
              f"{statistics.median(costs):.1f}")


def fixed(arguments):
    with open(REFERENCES, encoding="utf-8") as file:
        references = {row["scene"]: float(row["mu"])
                      for row in csv.DictReader(file)}
    settings = {}
    with open(MEMBERS, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if line[0] != "#"):
            if row["moved"] == "0":
                of = tuple(int(row[name])
                           for name in ("mesh", "step", "penalty"))
                settings.setdefault(of, {})[row["scene"]] = row
    dry_scene.print_head("spans | steps | penalty factor | kept | of | sum of "
                         "unknowns x Newton iterations")
    for (mesh, step, penalty), rows in sorted(settings.items()):
        if len(rows) < len(references):
            continue
        kept = sum(abs(float(row["mu"]) / references[scene] - 1.)
                   <= arguments.error for scene, row in rows.items())
        cost = sum(int(row["unknowns"]) * int(row["newton_iterations"])
                   for row in rows.values())
        print(f"| {round(160 * 2**mesh)} | {math.ceil(24 * 2**step)} + "
              f"{math.ceil(96 * 2**step)} | {8 * 2.**(penalty - mesh):g} | "
              f"{kept} | {len(rows)} | {cost:.2e} |")


def remeshing(arguments):
    dry_scene.print_head("scene | spans | levels at contacts | mu | off [%] | "
                         "mean unknowns | Newton iterations | unknowns x "
                         "iterations over those without | remeshes | largest "
                         "change of mu [%] | drift of plastic work")
    for scene in chosen(arguments):
        results = {}
        spans, level = arguments.finest, int(math.log2(arguments.finest // 20))
        while level >= 2:
            for adaptive in (0, level):
                results[spans, adaptive] = cached_run(
                    arguments, scene, f"mesh_{spans}_{adaptive}",
                    {**DEFAULT, "Mesh/Spans": spans, "Solver/Tolerance": 1e-6,
                     "Mesh/Refinement levels": level,
                     "Mesh/Adaptive levels": adaptive})
            spans, level = spans // 2, level - 1
        print_remeshing(scene, results,
                        results[arguments.finest, 0]["friction"]["mu"])


def print_remeshing(scene, results, reference):
    def mean_work(summary):
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
              f"{100 * (mu / reference - 1.):+.2f} | {mean_work(summary)[0]} | "
              f"{summary['cost']['newton_iterations']} | "
              f"{mean_work(summary)[1] / mean_work(even)[1]:.2f} | "
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
    dry_scene.print_head("scene | estimate [%] | sources, uncancelled [%] | "
                         "predicted [%] | predicted over estimate | over "
                         "sources | cost over R0's | predicted | predicted "
                         "over cost")
    errors, of_sources, costs = [], [], []
    reference = cached_run(arguments, "R0_p300_v200_T25", "default", DEFAULT)
    of_reference = work(reference)
    for scene in chosen(arguments):
        summary = cached_run(arguments, scene, "estimate",
                             {**DEFAULT, "Accuracy/Control": "estimate"})
        if summary is None or "accuracy" not in summary:
            print(f"| {scene} | no result |", flush=True)
            continue
        error, time = prediction(
            arguments, os.path.join(arguments.to, scene, "estimate",
                                    "scene.prm"))
        estimated = summary["accuracy"]["error"]
        sources = sum(part**2 for part in
                      summary["accuracy"]["by_source"].values())**0.5
        cost = work(summary) / of_reference
        errors.append(error / estimated)
        of_sources.append(error / sources)
        costs.append(time / cost)
        print(f"| {scene} | {100 * estimated:.2f} | {100 * sources:.2f} | "
              f"{100 * error:.2f} | {errors[-1]:.2f} | {of_sources[-1]:.2f} | "
              f"{cost:.2f} | {time:.2f} | {costs[-1]:.2f} |", flush=True)
    if errors:
        print(f"\nwithin a factor of 2: error {within(errors)}, sources "
              f"{within(of_sources)}, cost {within(costs)} of {len(errors)}")


def chosen(arguments):
    """Of the scenes wanted, those whose height map is there."""
    names = (list(scenes()) if arguments.scenes
             else [*accuracy_scenes.reference_scenes(),
                   *accuracy_scenes.profile_scenes()])
    words = tuple(arguments.scenes.split(","))
    found = []
    for scene in names:
        if not scene.startswith(words):
            continue
        if accuracy_scenes.missing(scene):
            print(f"{scene} skipped: {accuracy_scenes.missing(scene)} is not "
                  "there", file=sys.stderr, flush=True)
        else:
            found.append(scene)
    return found


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    tasks = {"estimate": estimate, "adaptive": adaptive, "fixed": fixed,
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
