"""Error of mu by time steps, inertia, load ramp and window."""

import numpy as np

from .style import (BLUE, GREEN, PURPLE, RED, finish_logs,
                    label_ends, mark_default, mark_failed, panels)

TITLE = "Time: steps, inertia, ramp and window"
FINEST = {False: (96, 384), True: (384, 1536)}
INERTIA = {"quasi-static": BLUE, "dynamic": RED}
DEFAULT = "quasi-static, 24 + 96 steps"


def steps(ramp, slide):
    return {"Protocol/Ramp steps": ramp, "Protocol/Slide steps": slide}


def scenes_of(full):
    """Groups of runs: over the number of steps, over the steps in the ramp,
    over its length, and one that slides six times as far."""
    sizes = (3, 6, 12, 24, 48, 96, 192) if full else (3, 6, 12, 24, 48)
    groups = {f"{inertia}, {n} + {4 * n} steps":
              {**steps(n, 4 * n), "Protocol/Inertia": inertia}
              for inertia in INERTIA for n in sizes}
    static = {"Protocol/Inertia": "quasi-static"}
    for n in (3, 6, 12, 48):
        groups[f"ramp of {n} steps"] = {**steps(n, 96), **static}
    for part in (0.1, 0.4):
        groups[f"ramp of {part:g} t_end"] = {
            **steps(round(120 * part), round(120 * (1. - part))), **static,
            "Protocol/Ramp fraction": part}
    for inertia in INERTIA if full else ("quasi-static",):
        groups[f"long, {inertia}"] = {
            "Protocol/End time": "1.5 us", "Protocol/Ramp fraction": 0.2 / 6.,
            **steps(12, 240), "Protocol/Inertia": inertia}
    groups["reference"] = {**steps(*FINEST[full]),
                           **static}
    return groups


COLUMNS = ("time [s]", "sliding distance [m]", "T_x [N/m]", "T_y [N/m]")


def measure(chart):
    mesh = ({"Mesh/Spans": 160, "Mesh/Refinement levels": 3} if chart.full
            else {})
    groups = scenes_of(chart.full)
    runs = chart.scenes({name: {**mesh, **entries}
                         for name, entries in groups.items()})
    exact, default = runs["reference"].mu, runs[DEFAULT]
    rows = [{"run": name, "mu": run.mu,
             "change of mu [%]": 100. * (run.mu / exact - 1.),
             "steps": run.value("cost", "steps"), "cuts": run.value("cost", "cuts"),
             "Newton iterations": run.newton,
             "time": run.seconds / default.seconds,
             "failed": run.failure or ""} for name, run in runs.items()]
    chart.table(rows, "the run of the default steps")
    chart.table([{"run": name, **{key: float(row[key]) for key in COLUMNS}}
                 for name, run in runs.items() if name.startswith("long")
                 and not run.failed for row in run.rows("friction.csv")],
                name="long_runs.csv")


def show(chart):
    of = {row["run"]: row for row in chart.rows()}
    points = {name: (row["Newton iterations"], abs(row["change of mu [%]"]))
              for name, row in of.items()
              if name.startswith("quasi-static") or name.startswith("ramp of")
              and "t_end" not in name}
    verdict = chart.judge(points[DEFAULT], points, "change of mu [%]")
    windows = picture(chart, scenes_of(chart.full), of)
    dynamic = of[DEFAULT.replace("quasi-static", "dynamic")]
    chart.page(
        TITLE, "mu of R0 (300 MPa, 200 m/min, 25 degC) against {} + {} "
        "quasi-static steps on the same mesh. ".format(*FINEST[chart.full]) +
        f"The default 24 + 96 steps are {points[DEFAULT][1]:.2f} % off, and the "
        "error is of first order in the step. "
        f"{verdict} Inertia changes mu by "
        f"{abs(dynamic['mu'] / of[DEFAULT]['mu'] - 1) * 100:.2f} % at these steps "
        f"and takes {dynamic['Newton iterations'] / of[DEFAULT]['Newton iterations']:.2f} "
        "times the Newton iterations, which are the cost here. "
        f"What dwarfs both is how far the tool has slid: {windows}")


def draw_steps(panel, groups, of, quantity):
    ends = []
    for inertia, colour in INERTIA.items():
        names = [name for name in groups if name.startswith(inertia)]
        good = [of[name] for name in names if not of[name]["failed"]]
        panel.loglog([row[quantity] for row in good],
                     [abs(row["change of mu [%]"]) for row in good], "o-",
                     color=colour)
        mark_failed(panel, [5 * int(name.split(",")[1].split("+")[0])
                            for name in names if of[name]["failed"]], colour)
        if good:
            ends.append((abs(good[-1]["change of mu [%]"]), inertia, colour))
    mark_default(panel, of[DEFAULT][quantity],
                 abs(of[DEFAULT]["change of mu [%]"]))
    return ends


def draw_ramps(panel, of):
    for kind, colour, marker in (("steps", GREEN, "D"), ("t_end", PURPLE, "^")):
        names = [name for name in of if name.startswith("ramp of")
                 and name.endswith(kind)]
        xs = [of[name]["Newton iterations"] for name in names]
        ys = [abs(of[name]["change of mu [%]"]) for name in names]
        panel.loglog(xs, ys, marker, color=colour)
        for name, x, y in zip(names, xs, ys):
            text = name[8:].replace("t_end", "t$_{end}$")
            panel.annotate(text, (x, y), xytext=(6, -3), size=7.5, color=colour,
                           textcoords="offset points")
    mark_default(panel, of[DEFAULT]["Newton iterations"],
                 abs(of[DEFAULT]["change of mu [%]"]))


def draw_window(panel, long_runs):
    """Returns a sentence about what the window does to mu."""
    means = {}
    sentence = "the long run is too short to tell."
    for inertia, colour in INERTIA.items():
        rows = [row for row in long_runs if row["run"] == f"long, {inertia}"]
        if not rows:
            continue
        t, s, x, y = (np.array([row[key] for row in rows]) for key in COLUMNS)
        ratio = np.divide(x, y, out=np.full_like(x, np.nan), where=y != 0.)
        panel.plot(1e6 * s, np.abs(ratio), color=colour, label=inertia,
                   lw=1.4 if inertia == "quasi-static" else 0.8)
        if inertia != "quasi-static":
            continue
        for text, begin, end, level in (
                ("default: last half of 0.25 us", 0.125e-6, 0.25e-6, BLUE),
                ("last half of 0.75 us", 0.375e-6, 0.75e-6, GREEN),
                ("last half of 1.5 us", 0.75e-6, 1.5e-6, PURPLE)):
            part = (t >= begin) & (t <= end * (1 + 1e-9))
            if part.sum() < 2:
                continue
            means[text] = mu = abs(np.trapz(x[part], t[part])
                                   / np.trapz(y[part], t[part]))
            panel.plot(1e6 * s[part][[0, -1]], [mu, mu], color=level, lw=4,
                       alpha=0.6, solid_capstyle="butt")
            panel.annotate(f"{mu:.4f}", (1e6 * s[part][-1], mu), size=8,
                           color=level, xytext=(0, -14), weight="bold"
                           if "default" in text else "normal",
                           textcoords="offset points")
        if len(means) < 3:
            continue
        mus = list(means.values())
        sentence = (f"the mean over the last half of six times the time is "
                    f"{100 * (mus[2] / mus[0] - 1):+.1f} % from that of the "
                    "default window (a window `steady` slides until this ends).")
    panel.set_ylim(bottom=0.85 * min(means.values(), default=0.))
    if panel.get_legend_handles_labels()[0]:
        panel.legend(loc="lower right")
    return sentence


def picture(chart, groups, of):
    figure, axes = panels(2, 2, width=5., height=3.5)
    draw_steps(axes[0, 0], groups, of, "steps")
    ends = draw_steps(axes[0, 1], groups, of, "Newton iterations")
    draw_ramps(axes[1, 0], of)
    sentence = draw_window(axes[1, 1], chart.rows("long_runs.csv"))
    axes[0, 0].set(title="over the number of steps", xlabel="steps",
                   ylabel="change of mu [%]")
    axes[0, 1].set(title="over Newton iterations", xlabel="Newton iterations")
    axes[1, 0].set(title="steps in the load ramp (green), its length (purple)",
                   xlabel="Newton iterations",
                   ylabel="change of mu [%]")
    axes[1, 1].set(title="mu over the sliding distance, and windows",
                   xlabel="sliding distance [um]", ylabel="mu")
    label_ends(axes[0, 1], ends)
    finish_logs(*axes.flat)
    chart.picture(figure)
    return sentence
