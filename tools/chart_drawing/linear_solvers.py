"""Direct solvers of the tangent over its size: time and memory, beside what
bandwidth and arithmetic of the machine allow."""

import time

import numpy as np

from .style import (BLUE, GREEN, GREY, INK, PURPLE, RED, finish_logs, label_ends,
                    mark_default, mark_failed, panels)

TITLE = "Linear solvers over size: time and memory against the machine"
SOLVERS = {"cholmod": (BLUE, "o-"), "umfpack": (RED, "s-"), "klu": (GREEN, "D-"),
           "mumps": (PURPLE, "^-")}
DEFAULT_SIZE = "160 spans, strip 0.3 um"
ENTRIES_A_ROW = 50  # (2 p + 1)^2 neighbours of two components, p = 2


def sizes(full):
    """{name: (entries, solvers that are left out as they take too long)}"""
    meshes = [(40, 1, 0.3), (80, 2, 0.3), (160, 3, 0.3), (320, 3, 0.3),
              (640, 3, 0.3), (896, 2, 2.6)]
    if full:
        meshes += [(1536, 2, 3.), (2048, 1, 4.6)]
    return {f"{spans} spans, strip {strip} um": (
        {"Mesh/Spans": spans, "Mesh/Refinement levels": levels,
         "Mesh/Strip depth": f"{strip} um"},
        () if spans <= 320 or full and spans <= 640 else
        ("umfpack", "klu", "mumps") if not full and spans > 640 else ("klu",))
        for spans, levels, strip in meshes}


def dissection(n_x, n_y, p=2, border=0):
    """(entries of the factor, operations) of a Cholesky factorisation by nested
    dissection of n_x x n_y control points with two unknowns each, which couple
    over p neighbours. `border` unknowns around the part are eliminated later."""
    if n_x < n_y:
        n_x, n_y = n_y, n_x
    if n_x <= 3 * p:
        s = 2. * n_x * n_y
        halves = (0., 0.)
    else:
        s = 2. * p * n_y
        half = dissection((n_x - p) / 2., n_y, p, border / 2. + s)
        halves = (2. * half[0], 2. * half[1])
    return (halves[0] + s * s / 2. + s * border,
            halves[1] + s ** 3 / 3. + s * s * border + s * border ** 2)


def machine():
    """(bytes a second of a sum of two long arrays, operations a second of a
    product of matrices), one thread, the best of some tries."""
    a, b = np.ones(4_000_000), np.ones(4_000_000)
    square = np.ones((600, 600))
    transfer = arithmetic = 0.
    for _ in range(6):
        start = time.process_time()
        np.add(a, b, out=a)
        transfer = max(transfer, 3. * a.nbytes / (time.process_time() - start))
        start = time.process_time()
        square @ square
        arithmetic = max(arithmetic, 2. * 600. ** 3 /
                         (time.process_time() - start))
    return transfer, arithmetic


def measure(chart):
    scenes, meshes = {}, sizes(chart.full)
    for mesh, (entries, left_out) in meshes.items():
        for solver in SOLVERS:
            if solver not in left_out:
                scenes[f"{solver}, {mesh}"] = {
                    **entries, "Solver/Linear solver": solver}
    runs = chart.scenes(scenes)
    transfer, arithmetic = machine()
    unit = phase(runs[f"cholmod, {DEFAULT_SIZE}"], "factorisation")
    start_up = min(run.memory for run in runs.values())
    rows = []
    for mesh, (entries, left_out) in meshes.items():
        n = runs[f"cholmod, {mesh}"].value("mesh", "unknowns")
        depth = max(n / (2. * entries["Mesh/Spans"]), 1.)
        fill, operations = dissection(entries["Mesh/Spans"], depth)
        moved = 12. * ENTRIES_A_ROW * n + 8. * fill
        for solver in SOLVERS:
            if solver in left_out:
                continue
            run = runs[f"{solver}, {mesh}"]
            rows.append({
                "run": f"{solver}, {mesh}", "solver": solver, "unknowns": n,
                "factorisation": phase(run, "factorisation") / unit,
                "solution": phase(run, "solution") / unit,
                "assembly": phase(run, "assembly") / unit,
                "Newton iterations": run.newton,
                "memory beyond that of the smallest run [MB]":
                    1e-6 * (run.memory - start_up) if not run.failed
                    else float("nan"),
                "bound by bandwidth": moved / transfer / unit,
                "bound by arithmetic": operations / arithmetic / unit,
                "factor by nested dissection [MB]": 8e-6 * fill,
                "failed": run.failure or ""})
    chart.table(rows, "a factorisation by CHOLMOD on the default mesh; memory "
                f"is a maximum, bandwidth {transfer:.3g} B/s and arithmetic "
                f"{arithmetic:.3g} 1/s of one core")


def show(chart):
    rows = chart.rows()
    sentence = picture(chart, rows)
    chart.page(TITLE, *conclusion(chart, rows, sentence))


def phase(run, name):
    """Processor seconds of a phase of one Newton iteration: the share that it
    has of the run's wall time, in processor time."""
    share = run.value("cost", name) / run.value("cost", "wall_time")
    return share * run.seconds / run.newton


def conclusion(chart, rows, sentence):
    of = {row["run"]: row for row in rows}
    default = of[f"cholmod, {DEFAULT_SIZE}"]
    points = {row["solver"]: (row["factorisation"] + row["solution"],
                              max(row["memory beyond that of the smallest run "
                                      "[MB]"], 1.))
              for row in rows if DEFAULT_SIZE in row["run"]}
    verdict = chart.judge(points["cholmod"], points, "memory [MB]")
    largest = max((r for r in rows if r["solver"] == "cholmod"),
                  key=lambda row: row["unknowns"])
    bound = max(largest["bound by bandwidth"], largest["bound by arithmetic"])
    return (
        "Factorisation of the tangent a Newton iteration, in units of that by "
        "CHOLMOD on the default mesh. On the default mesh "
        f"({default['unknowns']:.0f} unknowns, here) the others take "
        + ", ".join(f"{solver} {points[solver][0] / points['cholmod'][0]:.1f}"
                    for solver in points if solver != "cholmod")
        + f" times as long. {verdict} {sentence}",
        "The bounds are of the machine: reading the matrix and writing the factor "
        "once at the bandwidth of a long sum, and the operations of a nested "
        "dissection of as many control points on a rectangle at the speed of a "
        "product of matrices. At the largest size, "
        f"{largest['unknowns']:.0f} unknowns, CHOLMOD takes "
        f"{largest['factorisation'] / bound:.0f} times the larger bound, of which "
        "its ordering, made anew with each pattern, and its transpositions are "
        "a part.")


def picture(chart, rows):
    figure, (axes,) = panels(2, width=5.4, height=4.3)
    memory = "memory beyond that of the smallest run [MB]"
    ends = ([], [])
    for solver, (colour, line) in SOLVERS.items():
        of_solver = [row for row in rows if row["solver"] == solver]
        good = [row for row in of_solver if not row["failed"]]
        for panel, what, end in zip(axes, ("factorisation", memory), ends):
            shown = [row for row in good if row[what] > (2. if what == memory
                                                         else 0.)]
            panel.loglog([row["unknowns"] for row in shown],
                         [row[what] for row in shown], line, color=colour)
            mark_failed(panel, [row["unknowns"] for row in of_solver
                                if row["failed"]], colour)
            if shown:
                end.append((shown[-1][what], solver, colour))
    own = sorted((row for row in rows if row["solver"] == "cholmod"),
                 key=lambda row: row["unknowns"])
    n = [row["unknowns"] for row in own]
    for what, style, text in (
            ("bound by bandwidth", ":", "bound:\nbandwidth"),
            ("bound by arithmetic", "--", "bound:\narithmetic"),
            ("assembly", "-.", "assembly")):
        axes[0].loglog(n, [row[what] for row in own], style, color=INK
                       if what == "assembly" else GREY, lw=1.2)
        ends[0].append((own[-1][what], text, INK if what == "assembly" else GREY))
    factor = "factor by nested dissection [MB]"
    axes[1].loglog(n, [row[factor] for row in own], "--", color=GREY, lw=1.2)
    ends[1].append((own[-1][factor], "bound: factor\nby dissection", GREY))
    default = next(row for row in own if DEFAULT_SIZE in row["run"])
    mark_default(axes[0], default["unknowns"], default["factorisation"],
                 "default mesh\nand solver", (-8, 14), "right")
    mark_default(axes[1], default["unknowns"], default[memory],
                 "default", (-8, 10), "right")
    axes[0].set(title="time of a Newton iteration by solver",
                xlabel="unknowns", ylabel="time over the default factorisation")
    axes[1].set(title="memory", xlabel="unknowns",
                ylabel="memory beyond that of the smallest run [MB]")
    finish_logs(*axes)
    for panel, end in zip(axes, ends):
        label_ends(panel, end)
    chart.picture(figure)
    fraction = own[-1]["assembly"] / own[-1]["factorisation"]
    return (f"Assembly, in proportion to the unknowns, takes {fraction:.2f} times "
            "the factorisation at the largest size, and "
            f"{default['assembly'] / default['factorisation']:.1f} times on the "
            "default mesh.")
