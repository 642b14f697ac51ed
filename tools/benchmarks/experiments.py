#!/usr/bin/python3
"""Measured friction beside the computed one, with one shear factor.

Usage: tools/benchmarks/experiments.py [--asperity PROGRAM] [--to FOLDER]
           [--shear-factor M] [--wetting W ...]

The shear factor m of the interface is calibrated on one dry point of the cutting
test of Lee (2025), section 2.1 (polished rake face; the blasted one wants more
than m = 1), by `asperity characterize` and `asperity calibrate`. Everything else
is predicted with it: the blasted rake face, the wet cuts at several fillings of
the void with oil, and the tribometer over its velocity. The table goes to the
screen in Markdown, measured_and_computed.png into FOLDER (default
output/experiments). --shear-factor leaves the calibration out. About a quarter of
an hour of one core.
"""

import argparse
import csv
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
SCENES = os.path.join(ROOT, "parameter_files", "experiments")
QUIET = {"Output/Picture interval": 0, "Output/Checkpoint interval": 0}


def rows_of(name):
    """Rows of a file of measurements, by heading."""
    with open(os.path.join(SCENES, name), encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    return list(csv.DictReader(lines))


def run(arguments, scene, name, entries):
    """Runs a scene with some entries changed; returns its summary. What has
    been computed before is taken from its folder."""
    folder = os.path.join(arguments.to, name)
    os.makedirs(folder, exist_ok=True)
    text = f"include {os.path.join(SCENES, scene)}\n"
    entries = {**QUIET, **entries, "Output/Output directory": folder}
    for path, value in entries.items():
        section, key = path.split("/")
        text += f"subsection {section}\n  set {key} = {value}\nend\n"
    file = os.path.join(folder, "scene.prm")
    summary = os.path.join(folder, "summary.json")
    old = open(file, encoding="utf-8").read() if os.path.exists(file) else ""
    if old != text or not os.path.exists(summary):
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)
        done = subprocess.run([arguments.asperity, file], capture_output=True,
                              text=True, check=False)
        if done.returncode != 0:
            print(f"{name}: {done.stderr.strip()}", file=sys.stderr)
            return None
    with open(summary, encoding="utf-8") as file:
        return json.load(file)


def interface(m):
    return {"Interface/Shear law": "shear factor", "Interface/Shear factor": m}


def calibrate(arguments):
    """m with which the dry cut with the polished rake face has its mu, by the
    campaign over m and `asperity calibrate`; 1 if even that is too little."""
    campaign = os.path.join(SCENES, "shear_factor.prm")
    for command in (["characterize", campaign],
                    ["calibrate", "output/experiments/shear_factor",
                     os.path.join(SCENES, "cutting_test.csv"), "--series",
                     "dry polished"]):
        done = subprocess.run([arguments.asperity] + command, cwd=ROOT,
                              capture_output=True, text=True, check=False)
        print(done.stdout if command[0] == "calibrate" else "",
              done.stderr, sep="", end="", flush=True)
    found = re.match(r"Interface/Shear factor = ([0-9.e-]+)", done.stdout)
    return float(found[1]) if found else 1.


def print_row(name, measured, summary, rows):
    if summary is None:
        print(f"| {name} | {measured:.3f} | - | - | - | - | - |", flush=True)
        return
    friction = summary["friction"]
    mu = friction["mu"]
    share = [friction.get(key) for key in
             ("ploughing", "interface_shear", "oil_shear")]
    text = " | ".join("-" if value is None else f"{value:.3f}"
                      for value in share)
    print(f"| {name} | {measured:.3f} | {mu:.3f} | {text} | "
          f"{100 * (mu / measured - 1.):+.0f} % |", flush=True)
    rows.append((name, measured, mu))


def cuts(arguments, m, rows):
    for row in rows_of("cutting_test.csv"):
        state, tool = row["series"].split()
        scene, measured = f"{state}_{tool}.prm", float(row["mu"])
        if state == "dry":
            print_row(f"cut, {row['series']}", measured,
                      run(arguments, scene, f"{state}_{tool}_m{m:.3f}",
                          interface(f"{m:.3f}")), rows)
            continue
        for wetting in arguments.wetting:
            name = f"{state}_{tool}_m{m:.3f}_w{wetting}"
            entries = {**interface(f"{m:.3f}"), "Lubrication/Wetting": wetting}
            print_row(f"cut, {row['series']}, oil in {100 * wetting:.0f} % of "
                      "the void", measured,
                      run(arguments, scene, name, entries), rows)


def tribometer(arguments, m, rows):
    for row in rows_of("aisi_1045_tin.csv"):
        v = row["v [m/min]"]
        entries = {**interface(f"{m:.3f}"), "Load/Velocity": f"{v} m/min",
                   "Load/Temperature": f"{row['T [degC]']} degC"}
        print_row(f"pin, {v} m/min, {float(row['T [degC]']):.0f} degC",
                  float(row["mu"]),
                  run(arguments, "dry_pin.prm", f"dry_pin_m{m:.3f}_v{v}",
                      entries), rows)


def chart(arguments, m, rows):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, panels = plt.subplots(1, 2, figsize=(11., 4.8),
                                  constrained_layout=True)
    of_cut = [row for row in rows if row[0].startswith("cut")]
    names = [name[5:].replace(", oil in ", "\noil ").replace(" of the void", "")
             for name, _, _ in of_cut]
    x = range(len(of_cut))
    panels[0].bar([i - 0.2 for i in x], [row[1] for row in of_cut], 0.38,
                  color="#c8553d", label="measured")
    panels[0].bar([i + 0.2 for i in x], [row[2] for row in of_cut], 0.38,
                  color="#12355b", label=f"computed, m = {m:.2f}")
    panels[0].set_xticks(list(x), names, fontsize=7, rotation=20)
    panels[0].set(ylabel="friction coefficient µ [–]",
                  title="cutting test, 5 m/min")
    panels[0].legend(fontsize=8)
    of_pin = [row for row in rows if row[0].startswith("pin")]
    v = [float(name.split()[1]) for name, _, _ in of_pin]
    panels[1].plot(v, [row[1] for row in of_pin], "o-", color="#c8553d",
                   label="published law (from memory)")
    panels[1].plot(v, [row[2] for row in of_pin], "D--", color="#12355b",
                   mfc="white", label=f"computed, m = {m:.2f}")
    panels[1].set(xscale="log", xlabel="velocity [m/min]",
                  title="pin on AISI 1045, 2 GPa", ylim=(0., None))
    panels[1].legend(fontsize=8)
    for axes in panels:
        axes.grid(alpha=0.3)
    path = os.path.join(arguments.to, "measured_and_computed.png")
    figure.savefig(path, dpi=120)
    print(path)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--asperity",
                        default=os.path.join(ROOT, "build", "asperity"))
    parser.add_argument("--to", default=os.path.join("output", "experiments"))
    parser.add_argument("--shear-factor", type=float)
    parser.add_argument("--wetting", type=float, nargs="+", default=[0.3, 0.6])
    arguments = parser.parse_args()
    arguments.to = os.path.abspath(arguments.to)
    m = arguments.shear_factor
    if m is None:
        m = calibrate(arguments)
    rows = []
    print(f"m = {m:.3f}\n\n| experiment | measured | computed | ploughing | "
          "interface | oil | error |\n| --- | --- | --- | --- | --- | --- | "
          "--- |", flush=True)
    cuts(arguments, m, rows)
    tribometer(arguments, m, rows)
    chart(arguments, m, rows)


if __name__ == "__main__":
    main()
