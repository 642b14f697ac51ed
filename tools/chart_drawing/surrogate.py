"""Error of the friction law over the runs and the time that it learns from."""

import os

from .style import (BLUE, GREEN, GREY, RED, finish_logs, label_ends, log_axis,
                    mark_default, mark_failed, panels)

TITLE = "Surrogate: error of the friction law over runs and time"
DESIGN = "Campaign/Design/"
ERRORS = {"test error [-]": "mean error of the test runs",
          "largest test error [-]": "largest error of the test runs",
          "leave one out error [-]": "cross-validation"}


def campaigns(full):
    """{name: entries}; the first one computes the test runs for all."""
    n = 120 if full else 24
    active = ({DESIGN + "Initial runs": 20, DESIGN + "Batch": 10,
               DESIGN + "Maximum runs": n, DESIGN + "Test runs": 100}
              if full else {})
    static = {DESIGN + "Batch": 0, DESIGN + "Test runs": 0}
    sizes = (20, 40, 80, 120) if full else (12, 24)
    designs = {"active learning": active}
    designs |= {f"Sobol, {m} runs": {**static, DESIGN + "Initial runs": m}
                for m in sizes}
    side = 5 if full else 3
    designs[f"grid, {side ** 3} runs"] = {
        **static, DESIGN + "Kind": "grid",
        DESIGN + "Grid points": f"{side}, {side}, {side}"}
    return designs


def measure(chart):
    file = os.path.join(chart.source, "active.prm")
    base = chart.scenes({"default scene": {"Mesh/Spans": 160,
                                           "Mesh/Refinement levels": 3,
                                           "Protocol/Ramp steps": 24,
                                           "Protocol/Slide steps": 96}})
    unit = base["default scene"].seconds
    rows, tests = [], {}
    for name, entries in campaigns(chart.full).items():
        run = chart.keeper.campaign(name, {**entries, **tests}, file)
        results = os.path.join(run.folder, "campaign")
        if not tests and not run.failed:
            tests[DESIGN + "Test table"] = os.path.join(results, "runs.csv")
        rows += rows_of(name, run, entries, unit, not rows)
    chart.table(rows, "one run of the same scene with default mesh and steps")


def show(chart):
    rows = chart.rows()
    picture(chart, rows)
    chart.page(TITLE, *conclusion(chart, rows))


def rows_of(name, run, entries, unit, has_tests):
    history = run.rows(os.path.join("campaign", "history.csv"))
    if run.failed or not history:
        return [{"campaign": name, "design": name.split(",")[0], "runs": int(
            name.split(",")[1].split()[0]) if "," in name else 1,
            "failed": run.failure or "no history"}]
    n_tests = entries.get(DESIGN + "Test runs", 10) if has_tests else 0
    last = int(history[-1]["runs"])
    return [{"campaign": name, "design": name.split(",")[0],
             "runs": int(row["runs"]),
             "time": run.seconds / (last + n_tests) * int(row["runs"]) / unit,
             **{key: float(row[key]) if row[key] else float("nan")
                for key in (*ERRORS, "coverage of the 95 % interval [-]")},
             "failed": ""} for row in history]


def conclusion(chart, rows):
    good = [row for row in rows if not row["failed"]]
    active = [row for row in good if row["design"] == "active learning"]
    last = active[-1]
    ends = {row["campaign"]: row for row in good}
    points = {f"{row['campaign']}, {row['runs']:.0f} runs":
              (row["runs"], row["test error [-]"]) for row in good}
    verdict = chart.judge((last["runs"], last["test error [-]"]), points,
                          "test error")
    others = "; ".join(f"{row['campaign']} {100 * row['test error [-]']:.2f} %"
                       for row in ends.values()
                       if row["design"] != "active learning")
    return (
        "A Gaussian process of mu(p, v, T) of a coarse R0 over the box of the "
        "friction law, judged by random runs that it has not seen. With active "
        f"learning (the default) the mean error falls from "
        f"{100 * active[0]['test error [-]']:.2f} % at {active[0]['runs']:.0f} runs to "
        f"{100 * last['test error [-]']:.2f} % at {last['runs']:.0f}, the largest is "
        f"{100 * last['largest test error [-]']:.1f} %, and "
        f"{100 * last['coverage of the 95 % interval [-]']:.0f} % of the test runs "
        f"are within the 95 % interval. Without it: {others}. {verdict}",
        f"In time the {last['runs']:.0f} runs are {last['time']:.1f} default runs "
        "of the same scene. Cross-validation does not fall with the error: the runs "
        "that active learning adds are those that are hardest to predict, at the "
        "edges of the box. Ten test runs tell a mean error, hardly a coverage. The "
        "blasted tool in `parameter_files/friction_law` "
        "is the large version of this chart: 90 dry runs in less than an hour of "
        "one core, 0.32 % in the mean.")


def picture(chart, rows):
    figure, (axes,) = panels(2, width=5.2, height=4.)
    good = [row for row in rows if not row["failed"]]
    looks = {"active learning": (BLUE, "o-"), "Sobol": (GREEN, "s--"),
             "grid": (RED, "D")}
    ends = []
    for design, (colour, line) in looks.items():
        of_design = [row for row in good if row["design"] == design]
        axes[0].loglog([row["runs"] for row in of_design],
                       [100 * row["test error [-]"] for row in of_design], line,
                       color=colour)
        mark_failed(axes[0], [row["runs"] for row in rows if row["failed"]
                              and row["design"] == design], colour)
        if of_design:
            ends.append((100 * of_design[-1]["test error [-]"],
                         design, colour))
    active = [row for row in good if row["design"] == "active learning"]
    for key, (colour, line) in zip(ERRORS, ((BLUE, "o-"), (RED, "^-"),
                                            (GREY, "s-"))):
        axes[1].loglog([row["time"] for row in active],
                       [100 * row[key] for row in active], line, color=colour)
    axes[1].set(title="active learning over time",
                xlabel="time over that of a run with default mesh and steps")
    axes[0].set(title="designs over the number of runs", xlabel="runs",
                ylabel="mean error of the test runs [%]")
    if active:
        mark_default(axes[0], active[-1]["runs"],
                     100 * active[-1]["test error [-]"], offset=(-10, -4),
                     align="right")
    finish_logs(*axes)
    log_axis(axes[0].xaxis, sorted({row["runs"] for row in good}))
    label_ends(axes[0], ends)
    label_ends(axes[1], [(100 * active[-1][key], text, colour)
                         for (key, text), colour in zip(
                             ERRORS.items(), (BLUE, RED, GREY))] if active else [])
    chart.picture(figure)
