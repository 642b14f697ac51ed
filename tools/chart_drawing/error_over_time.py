"""Error of mu by the mesh over processor time: degrees, kinds of refinement."""

import math

from .style import (BLUE, COLOURS, GREY, MARKERS, finish_logs, front, label_ends,
                    mark_default, mark_failed, panels)

TITLE = "Error of mu by the mesh over time"


def graded(spans, levels, degree=2):
    return {"Mesh/Spans": spans, "Mesh/Refinement levels": levels,
            "Mesh/Degree": degree}


def uniform(spans, degree=2):
    return {"Mesh/Spans": spans, "Mesh/Refinement levels": 0,
            "Mesh/Row grading": 1, "Mesh/Degree": degree}


def elements(entries):
    """The same mesh with the functions of finite elements."""
    return {**entries, "Mesh/Continuity": "C0"}


def following(spans, levels):
    """All levels are only where the chip touches or soon will."""
    return {**graded(spans, levels), "Mesh/Adaptive levels": levels}


def tensor(spans):
    """Rows that grow from the contact edge on, of full width each."""
    return {"Mesh/Spans": spans, "Mesh/Refinement levels": 0}


def curves(full):
    """{curve: {spans: entries}}."""
    spans = {40: 1, 80: 2, 160: 3}
    high = {40: 1, 80: 2}
    if full:
        spans[320], high[160] = 4, 3
    result = {f"degree {degree}, graded": {
        n: graded(n, level, degree) for n, level in
        (spans if degree < 3 else high).items()} for degree in (1, 2, 3, 4)}
    result["degree 1, uniform\n(Q1 elements)"] = {
        n: uniform(n, 1) for n in ((20, 40, 80, 160) if full else (20, 40, 80))}
    result["degree 2, C0, uniform\n(Q2 elements)"] = {
        n: elements(uniform(n)) for n in ((10, 20, 40, 80) if full
                                          else (10, 20, 40))}
    result["degree 2, C0, graded\n(Q2 elements)"] = {
        n: elements(graded(n, level)) for n, level in spans.items()}
    result["degree 2, following the contacts"] = {
        n: following(n, level) for n, level in spans.items() if n > 40}
    result["degree 2, uniform"] = {
        n: uniform(n) for n in ((20, 40, 80, 120) if full else (20, 40, 60))}
    result["degree 2, rows graded"] = {
        n: tensor(n) for n in ((40, 80, 160, 320) if full else (40, 80, 160))}
    return result


# A mesh whose error changes its sign on one scene is not good: in full mode two
# scenes judge.
CASES = {
    "R0": {},
    "hot R0": {"Load/Pressure": "1300 MPa", "Load/Temperature": "675 degC"}}
DEFAULT = "degree 2, graded, 160 spans"


def cases(full):
    return CASES if full else {"R0": CASES["R0"]}


def reference_of(full):
    return f"reference, degree 2, {640 if full else 320} spans"


def measure(chart):
    sweep = curves(chart.full)
    reference = reference_of(chart.full)
    finest = graded(640, 5) if chart.full else graded(320, 4)
    meshes = {reference: finest, **{
        name_of(curve, n): entries for curve, points in sweep.items()
        for n, entries in points.items()}}
    runs = chart.scenes({f"{mesh}, {case}": {**entries, **of_case}
                         for mesh, entries in meshes.items()
                         for case, of_case in cases(chart.full).items()})
    rows = [row_of(mesh, runs, reference, list(cases(chart.full)))
            for mesh in meshes]
    chart.table(rows, "the runs of the default mesh")


def show(chart):
    rows, reference = chart.rows(), reference_of(chart.full)
    points = {row["mesh"]: (row["time"], row["error [%]"]) for row in rows
              if row["mesh"] != reference}
    verdict = chart.judge(points[DEFAULT], points, "error [%]")
    picture(chart, curves(chart.full), rows, points)
    wanted = {kind: min((time for mesh, (time, error) in points.items()
                         if mesh.startswith(kind) and error <= 0.7),
                        default=None)
              for kind in ("degree 1, uniform", "degree 2, C0, uniform",
                           "degree 2, C0, graded", "degree 2, uniform",
                           "degree 2, rows graded", "degree 2, graded",
                           "degree 2, following the contacts")}
    listed = ", ".join(f"{kind} " + ("not at all" if time is None else
                                     f"at {time:.2f} times its time")
                       for kind, time in wanted.items())
    chart.page(
        TITLE, "Error of mu by the mesh alone, on R0 at 300 MPa, 200 m/min, 25 degC"
        + (" and at 1300 MPa, 200 m/min, 675 degC (root mean square)"
           if chart.full else "") + ", against "
        f"{reference[11:].replace(', ', ' on ')} with the same steps and penalty. The "
        "default mesh (degree 2, 160 spans, three levels) is "
        f"{points[DEFAULT][1]:.2f} % off. {verdict} The wanted 0.7 % are reached "
        f"by: {listed}. Splines of degree 1 are bilinear finite elements (Q1) "
        "with 2 x 2 Gauss points, those of degree 2 whose knots are double "
        "(Mesh/Continuity = C0) biquadratic ones (Q2) with 3 x 3, through the "
        "same assembler. Meshes that follow the contacts have all their levels "
        "only there (Mesh/Adaptive levels)."
        + ("" if chart.full else " On one scene an error may pass through zero "
           "between two meshes, as those of degree 1 do: a point far below the "
           "trend of its curve is luck. Full mode judges by two scenes."))


def name_of(curve, spans):
    return f"{curve.split(chr(10))[0]}, {spans} spans"


def row_of(mesh, runs, reference, names):
    """A row of the table: the mean over the scenes."""
    of_mesh = {case: runs[f"{mesh}, {case}"] for case in names}
    errors = {case: 100. * (run.mu / runs[f"{reference}, {case}"].mu - 1.)
              for case, run in of_mesh.items()}
    failures = [run.failure for run in of_mesh.values() if run.failed]
    return {"mesh": mesh,
            "unknowns": max(run.value("mesh", "unknowns")
                            for run in of_mesh.values()),
            "error [%]": math.sqrt(sum(e ** 2 for e in errors.values())
                                   / len(errors)),
            **{f"error on {case} [%]": error for case, error in errors.items()},
            **{f"mu of {case}": run.mu for case, run in of_mesh.items()},
            "time": sum(run.seconds for run in of_mesh.values()) / sum(
                runs[f"{DEFAULT}, {case}"].seconds for case in names),
            "Newton iterations": sum(run.newton for run in of_mesh.values()),
            "failed": "; ".join(failures)}


def picture(chart, sweep, rows, points):
    figure, (axes,) = panels(2, width=4.9, height=4.2)
    of = {row["mesh"]: row for row in rows}
    for side, quantity in enumerate(("time", "unknowns")):
        panel, ends = axes[side], []
        for k, (curve, spans) in enumerate(sweep.items()):
            of_curve = [of[name_of(curve, n)] for n in spans]
            good = [row for row in of_curve if not row["failed"]]
            colour = COLOURS[k % len(COLOURS)]
            line = "-" if k < len(COLOURS) else ":"
            panel.loglog([row[quantity] for row in good],
                         [row["error [%]"] for row in good],
                         MARKERS[k % len(MARKERS)] + line, color=colour)
            mark_failed(panel, [row[quantity] for row in of_curve
                                if row["failed"] and row[quantity] > 0], colour)
            if good:
                ends.append((good[-1]["error [%]"], curve, colour))
        panel.axhline(0.7, color=GREY, lw=1, ls="--")
        mark_default(panel, of[DEFAULT][quantity], of[DEFAULT]["error [%]"])
    axes[0].step(*zip(*front(points.values())), where="post", color=BLUE,
                 alpha=0.25, lw=5, zorder=0)
    axes[0].set(xlabel="processor time over that of the default mesh",
                ylabel="error of mu by the mesh [%]",
                title="over time (band: Pareto front)")
    axes[1].set(xlabel="unknowns", title="over unknowns (dashed: wanted 0.7 %)")
    finish_logs(*axes)
    label_ends(axes[1], ends)
    chart.picture(figure)
