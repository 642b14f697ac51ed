"""Mortar, Gauss-point and augmented-Lagrange contact over the penalty."""

import math

from .style import (BLUE, GREEN, PURPLE, RED, finish_logs, label_ends,
                    mark_default, mark_failed, panels)

TITLE = "Contact: mortar, Gauss point and augmented Lagrange over the penalty"
METHODS = {
    "mortar": ({}, BLUE, "o-"),
    "Gauss point": ({"Contact/Formulation": "gauss-point"}, RED, "s-"),
    "mortar, augmented": ({"Contact/Augmentations": 20}, GREEN, "D-"),
    "Gauss point, augmented": ({"Contact/Formulation": "gauss-point",
                                "Contact/Augmentations": 20}, PURPLE, "^-")}
DEFAULT = "mortar, c = 8"


def penalties(full):
    return ((0.1, 0.3, 1, 3, 8, 30, 100, 300, 1e3, 3e3, 1e4) if full else
            (0.1, 0.5, 2, 8, 32, 200, 2e3))


def measure(chart):
    mesh = ({"Mesh/Spans": 160, "Mesh/Refinement levels": 3} if chart.full
            else {})
    scenes = {f"{method}, c = {c:g}": {**mesh, **entries,
                                       "Contact/Penalty factor": c}
              for method, (entries, _, _) in METHODS.items()
              for c in penalties(chart.full)}
    scenes["reference"] = {**mesh, "Contact/Augmentations": 50,
                           "Contact/Penalty factor": 32,
                           "Contact/Penetration tolerance": "0.01 nm"}
    hertz = chart.benchmark("contact_benchmarks", "hertz")
    runs = chart.scenes(scenes)
    exact, default = runs["reference"].mu, runs[DEFAULT]
    rows = []
    for method in METHODS:
        for c in penalties(chart.full):
            name = f"{method}, c = {c:g}"
            run = runs[name]
            depth = max((float(row["max penetration [m]"])
                         for row in run.rows("friction.csv")),
                        default=float("nan")) if not run.failed else float("nan")
            rows.append({
                "run": name, "method": method, "c": c, "mu": run.mu,
                "error of mu [%]": 100. * abs(run.mu / exact - 1.),
                "penetration [nm]": 1e9 * depth,
                "iterations": run.newton,
                "cuts": run.value("cost", "cuts"),
                "time": run.seconds / default.seconds,
                "failed": run.failure or ""})
    chart.table(rows, "the run of the default penalty and formulation")
    chart.table(hertz.rows("contact_penalty.csv"), name="hertz.csv")


def show(chart):
    rows, condition = chart.rows(), chart.rows("hertz.csv")
    points = {row["run"]: (row["iterations"], row["error of mu [%]"])
              for row in rows}
    verdict = chart.judge(points[DEFAULT], points, "error of mu [%]")
    picture(chart, rows, condition)
    of = {row["run"]: row for row in rows}
    hard = of[f"mortar, c = {penalties(chart.full)[-1]:g}"]
    chart.page(
        TITLE, "mu of R0 against the same mesh with an augmented mortar of 0.01 nm, "
        "the largest penetration of a point, the Newton iterations of all steps, "
        "and for Hertz's contact the condition number of the tangent. The default, "
        f"mortar with c = 8, is {points[DEFAULT][1]:.2f} % off in mu at "
        f"{points[DEFAULT][0]:.0f} iterations, which are the cost here. {verdict} "
        "A mortar contact closes its gaps in the mean over a function, so that "
        f"single points stay {hard['penetration [nm]']:.1f} nm deep however stiff "
        "the penalty; the Gauss-point form closes each of them, tends to another "
        f"mu ({of[hard['run'].replace('mortar', 'Gauss point')]['error of mu [%]']:.2f}"
        " % away on this mesh), and fails for Hertz from c = 1000 on. "
        "Augmentation takes most of the error of a soft penalty away and pays for "
        "it with iterations that a stiffer penalty does not need: from c = 32 on "
        "it changes nothing. Condition numbers grow in proportion to c from about "
        "30 on, the same for both forms.")


def picture(chart, rows, condition):
    figure, axes = panels(2, 2, width=5.2, height=3.4)
    quantities = ("error of mu [%]", "penetration [nm]", "iterations")
    titles = ("error of mu by contact [%]", "largest penetration [nm]",
              "Newton iterations of the run")
    for panel, quantity, title in zip(axes.flat, quantities, titles):
        ends = []
        for method, (_, colour, line) in METHODS.items():
            of_method = [row for row in rows if row["method"] == method]
            good = [row for row in of_method if not row["failed"]]
            panel.loglog([row["c"] for row in good],
                         [row[quantity] for row in good], line, color=colour,
                         label=method)
            mark_failed(panel, [row["c"] for row in of_method if row["failed"]],
                        colour)
            if good and panel is axes[0, 1]:
                ends.append((good[-1][quantity], method, colour))
        panel.set_title(title)
        label_ends(panel, ends)
        row = next(row for row in rows if row["run"] == DEFAULT)
        mark_default(panel, 8, row[quantity])
    panel = axes[1, 1]
    for method, key in (("mortar", "mortar"), ("Gauss point", "gauss_point")):
        good = [row for row in condition if row["formulation"] == key]
        _, colour, line = METHODS[method]
        panel.loglog([row["penalty_h_over_E"] for row in good],
                     [row["condition"] for row in good], line,
                     color=colour, **({"lw": 5, "alpha": 0.5}
                                      if method == "mortar" else {}))
        mark_failed(panel, [row["penalty_h_over_E"] for row in good
                            if math.isnan(row["pressure_error"])], colour)
        if method == "mortar":
            for row in good:
                if row["penalty_h_over_E"] == 8:
                    mark_default(panel, 8, row["condition"])
    panel.set_title("condition number of the tangent (Hertz)")
    for panel in axes[1]:
        panel.set_xlabel("c, the penalty over E/h")
    finish_logs(*axes.flat)
    chart.picture(figure)
