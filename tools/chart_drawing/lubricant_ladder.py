"""The rungs of the oil over gap, slope, viscosity and speed, and which of them
suffices."""

import math

import numpy as np

from .style import (COLOURS, INK, MARKERS, finish_logs, label_ends, log_axis,
                    mark_default, mark_failed, plt)

TITLE = "Ladder of the oil: mu and cost, and the cheapest rung within 1 %"
RUNGS = {"dry": "none", "pocket": "pocket", "Reynolds": "Reynolds",
         "Stokes": "Stokes", "Navier-Stokes": "Navier-Stokes"}
COLOUR = dict(zip(RUNGS, (COLOURS[6], *COLOURS[:4])))
CENTRE = "gap 0.02"
AS_IT_IS = {CENTRE, "slope x 1", "viscosity x 1", "100 m/min"}
BEST = "Navier-Stokes"
LEAST = 1e-5  # mu below this is drawn as nil, a hollow mark at the bottom


def sweeps(full):
    """{quantity: {point: (value, entries)}}; the scene as it is lies in each."""
    gaps = (0.02, 0.1, 0.3, 1, 3) if full else (0.02, 0.2, 1)
    slopes = (0.1, 0.25, 0.5, 1, 1.5) if full else (0.2, 0.5, 1)
    viscosities = (1e-3, 1e-2, 0.1, 1, 10) if full else (0.01, 1, 4)
    speeds = (10, 30, 100, 200, 400) if full else (40, 100, 400)
    return {
        "smallest gap at the start [um]": {
            f"gap {g:g}": (g, {"Geometry/Initial gap": f"{g} um"}) for g in gaps},
        "largest slope of the tool": {
            f"slope x {s:g}": (0.75 * s, {
                "Tool/Amplitudes": ", ".join(
                    f"{s * a:.5g} um" for a in (0.16, 0.12, 0.09, 0.06, 0.04,
                                                0.02))}) for s in slopes},
        "viscosity over that of the oil": {
            f"viscosity x {f:g}": (f, {"Lubricant/Viscosity": f"{0.032 * f} Pa s"})
            for f in viscosities},
        "velocity [m/min]": {
            f"{v:g} m/min": (v, {"Load/Velocity": f"{v} m/min"})
            for v in speeds}}


def measure(chart):
    mesh = ({"Mesh/Spans": 160, "Mesh/Refinement levels": 3,
             "Protocol/Ramp steps": 24, "Protocol/Slide steps": 48,
             "Film mesh/Rows": 2}
            if chart.full else {})
    groups = sweeps(chart.full)
    centre = AS_IT_IS - {CENTRE}
    scenes = {f"{point}, {rung}": {**mesh, **entries, "Lubrication/Model": model}
              for group in groups.values()
              for point, (_, entries) in group.items() if point not in centre
              for rung, model in RUNGS.items()}
    runs = chart.scenes(scenes)
    for point in centre:
        for rung in RUNGS:
            runs[f"{point}, {rung}"] = runs[f"{CENTRE}, {rung}"]
    base = runs[f"{CENTRE}, dry"].seconds
    rows = []
    for quantity, group in groups.items():
        for point, (value, _) in group.items():
            exact = runs[f"{point}, {BEST}"].mu
            for rung in RUNGS:
                run = runs[f"{point}, {rung}"]
                rows.append({
                    "quantity": quantity, "point": point, "value": value,
                    "rung": rung, "mu": run.mu,
                    "off Navier-Stokes [%]": 100. * (run.mu / exact - 1.),
                    "off [% of the dry mu]": 100. * (run.mu - exact) /
                    runs[f"{point}, dry"].mu,
                    "contact fraction": run.value("contact_fraction"),
                    "time": run.seconds / base, "failed": run.failure or ""})
    chart.table(rows, "the dry run of the scene as it is")


def show(chart):
    groups = sweeps(chart.full)
    of = {(row["point"], row["rung"]): row for row in chart.rows()}
    cheapest = {measure: {point: cheapest_rung(of, point, measure)
                          for group in groups.values() for point in group}
                for measure in ("off Navier-Stokes [%]", "off [% of the dry mu]")}
    picture(chart, groups, of, cheapest)
    chart.page(TITLE, *conclusion(of, cheapest))


def cheapest_rung(of, point, measure):
    good = [(of[point, rung]["time"], rung) for rung in RUNGS
            if abs(of[point, rung][measure]) <= 1.]
    return min(good)[1] if good else None


def conclusion(of, cheapest):
    counts = [", ".join(f"{rung} at {n}" for rung in RUNGS
                        if (n := list(found.values()).count(rung)))
              for found in cheapest.values()]
    n = len(next(iter(cheapest.values())))
    times = {rung: of[CENTRE, rung]["time"] for rung in RUNGS}
    listed = ", ".join(f"{rung} {time:.1f}" for rung, time in times.items()
                       if math.isfinite(time))
    return (
        "R0 full of compressible oil (300 MPa, 100 m/min, 25 degC), each rung "
        "against Navier-Stokes on the same mesh and steps. Processor time over "
        f"that of the dry run: {listed}. The cheapest rung within 1 % of the "
        f"mu of Navier-Stokes is, of {n} points, {counts[0]}; within 1 % of the "
        f"dry mu, which is what oil takes away, {counts[1]}.",
        "The default is the dry rung, as how much oil there is is an input, and "
        "with `Lubrication/Model = automatic` the audit chooses the rung: in a void "
        "full of oil dry is never near, and no choice of accuracy. Errors of "
        "pocket and film against Navier-Stokes are in the maps.")


def picture(chart, groups, of, cheapest):
    figure = plt.figure(figsize=(13., 9.6))
    upper_grid = figure.add_gridspec(2, 4, left=0.06, right=0.89, top=0.97,
                                     bottom=0.47, wspace=0.24, hspace=0.13,
                                     height_ratios=(1.2, 1))
    maps = figure.add_gridspec(1, 2, left=0.06, right=0.95, top=0.36,
                               bottom=0.02, wspace=0.14)
    for column, (quantity, group) in enumerate(groups.items()):
        upper = figure.add_subplot(upper_grid[0, column])
        lower = figure.add_subplot(upper_grid[1, column], sharex=upper)
        points = sorted(group, key=lambda point: group[point][0])
        for k, rung in enumerate(RUNGS):
            good = [p for p in points if not of[p, rung]["failed"]]
            xs = [group[p][0] for p in good]
            nil = [group[p][0] for p in good if of[p, rung]["mu"] < LEAST]
            upper.plot(nil, [0.03] * len(nil), MARKERS[k], mfc="white",
                       color=COLOUR[rung], ms=5, clip_on=False,
                       transform=upper.get_xaxis_transform())
            for panel, what in ((upper, "mu"), (lower, "time")):
                panel.plot(xs, [of[p, rung][what] if of[p, rung][what] >= LEAST
                                else float("nan") for p in good],
                           MARKERS[k] + "-", color=COLOUR[rung], ms=4)
                mark_failed(panel, [group[p][0] for p in points
                                    if p not in good], COLOUR[rung],
                            0.98 - 0.05 * k)
        upper.set_xscale("log")
        upper.set_yscale("log")
        lower.set_yscale("log")
        finish_logs(upper, lower)
        log_axis(upper.xaxis, [float(f"{group[p][0]:.3g}") for p in points])
        lower.set_xlabel(quantity)
        here = next(p for p in points if p in AS_IT_IS)
        mark_default(upper, group[here][0], of[here, "dry"]["mu"],
                     "default: dry", (9, -14) if column == 0 else (-8, -16),
                     "left" if column == 0 else "right")
        if column == 0:
            upper.set_ylabel("mu (hollow: nil)")
            lower.set_ylabel("time over the dry run's")
        if column == 3:
            label_ends(upper, [(of[points[-1], rung]["mu"], rung, COLOUR[rung])
                               for rung in RUNGS])
    for k, (measure, found) in enumerate(cheapest.items()):
        draw_map(figure.add_subplot(maps[0, k]), groups, of, found,
                 "of mu" if k == 0 else "of the dry mu", measure)
    chart.picture(figure)


def draw_map(panel, groups, of, found, name, measure):
    """A cell a point: its colour is the cheapest rung that is near enough."""
    columns = max(len(group) for group in groups.values())
    for i, group in enumerate(groups.values()):
        for j, point in enumerate(sorted(group, key=lambda p: group[p][0])):
            rung = found[point]
            panel.add_patch(plt.Rectangle(
                (j + 0.03, i + 0.05), 0.94, 0.9, lw=0,
                color=COLOUR[rung] if rung else "#f1f1f1",
                alpha=0.28 if rung else 1.))
            second = [f"{of[point, r][measure]:+.3g}" for r in
                      ("pocket", "Reynolds")]
            panel.text(j + 0.5, i + 0.28, f"{group[point][0]:.3g}: "
                       f"{rung or 'none: failed'}", ha="center", va="center",
                       size=8.5, color=INK, weight="bold")
            panel.text(j + 0.5, i + 0.66, f"pocket {second[0]}\nfilm {second[1]}",
                       ha="center", va="center", size=7, color=INK)
    panel.set_xlim(0, columns)
    panel.set_ylim(len(groups), 0)
    panel.set_yticks(np.arange(len(groups)) + 0.5,
                     [q.split(" [")[0].replace("smallest ", "").replace(
                         "largest ", "").replace(" at the start", "").replace(
                         " of the tool", "").replace(" over that of the oil", "")
                      for q in groups])
    panel.set_xticks([])
    panel.grid(False)
    panel.tick_params(length=0)
    for side in panel.spines.values():
        side.set_visible(False)
    panel.set_title(f"Cheapest rung within 1 % {name}; errors in % below")
