"""Direct solvers of the tangent over its size: time and memory, beside what
bandwidth and arithmetic of the machine allow."""

import time

import numpy as np

from .style import (BLUE, GREEN, GREY, PURPLE, RED, finish_logs, label_ends,
                    mark_default, mark_failed, panels)

TITLE = "Linear solvers over size: time and memory against the machine"
SOLVERS = {"cholmod": (BLUE, "o-"), "umfpack": (RED, "s-"), "klu": (GREEN, "D-"),
           "mumps": (PURPLE, "^-")}
DEFAULT_SIZE = "160 spans, strip 0.3 um"
MEMORY = "memory beyond that of the smallest run [MB]"
FACTOR = "factor by nested dissection [MB]"
ENTRIES_A_ROW = 50  # (2 p + 1)^2 neighbours of two components, p = 2


def sizes(full):
    """{name: (entries, solvers that are left out as they take too long)}; small
    sizes take more steps."""
    meshes = [(40, 1, 0.3, 192), (80, 2, 0.3, 96), (160, 3, 0.3, 48),
              (320, 3, 0.3, 12), (640, 3, 0.3, 3)]
    if full:
        meshes += [(896, 2, 2.6, 3), (1536, 2, 3., 3), (2048, 1, 4.6, 3)]
    return {f"{spans} spans, strip {strip} um": (
        {"Mesh/Spans": spans, "Mesh/Refinement levels": levels,
         "Mesh/Strip depth": f"{strip} um", "Protocol/Ramp steps": steps},
        () if spans <= 320 else ("klu",) if full else ("umfpack", "klu", "mumps"))
        for spans, levels, strip, steps in meshes}


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
    # The memory of a run without its matrices: one of a hundred unknowns.
    least = {solver: {"Mesh/Spans": 8, "Mesh/Refinement levels": 0,
                      "Solver/Linear solver": solver} for solver in SOLVERS}
    runs = chart.scenes({**{f"{solver}, start-up": entries
                            for solver, entries in least.items()}, **scenes})
    transfer, arithmetic = machine()

    def iteration(run):
        return sum(run.value("cost", part) for part in
                   ("assembly", "factorisation", "solution")) / run.newton
    unit = iteration(runs[f"cholmod, {DEFAULT_SIZE}"])
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
            start_up = runs[f"{solver}, start-up"].memory
            rows.append({
                "run": f"{solver}, {mesh}", "solver": solver, "unknowns": n,
                "time": iteration(run) / unit,
                "Newton iterations": run.newton,
                MEMORY: 1e-6 * (run.memory - start_up) if not run.failed
                else float("nan"),
                "bound by bandwidth": moved / transfer / unit,
                "bound by arithmetic": operations / arithmetic / unit,
                FACTOR: 8e-6 * fill,
                "failed": run.failure or ""})
    chart.table(rows, "an iteration with CHOLMOD on 160 spans: "
                "assembly, factorisation, solution; memory is a maximum, bandwidth "
                f"{transfer:.3g} B/s and arithmetic {arithmetic:.3g} 1/s of one core",
                clock="wall time")


def show(chart):
    rows = chart.rows()
    picture(chart, rows)
    chart.page(TITLE, *conclusion(chart, rows))


def conclusion(chart, rows):
    of = {row["run"]: row for row in rows}
    points = {row["solver"]: (row["time"], max(row[MEMORY], 1.))
              for row in rows if DEFAULT_SIZE in row["run"] and not row["failed"]}
    verdict = chart.judge(points["cholmod"], points, "memory [MB]")
    largest = max((r for r in rows if r["solver"] == "cholmod" and not r["failed"]),
                  key=lambda row: row["unknowns"])
    bound = max(largest["bound by bandwidth"], largest["bound by arithmetic"])
    others = ", ".join(f"{solver} {time:.1f}" for solver, (time, _) in points.items()
                       if solver != "cholmod")
    common = max(row["unknowns"] for row in rows if row["solver"] == "mumps")
    own = next(row for row in rows if row["unknowns"] == common)
    at_largest = ", ".join(
        f"{row['solver']} {row['time'] / own['time']:.1f}" for row in rows
        if row["unknowns"] == common and row is not own and not row["failed"])
    return (
        "Time of a Newton iteration (assembly, factorisation, solution) in units of one with "
        f"CHOLMOD on {DEFAULT_SIZE} "
        f"({of[f'cholmod, {DEFAULT_SIZE}']['unknowns']:.0f} unknowns). There the "
        f"others take {others} times as long, and at {common:.0f} unknowns "
        f"{at_largest} times as long as CHOLMOD, the default. {verdict}",
        "The bounds are of the machine: reading the matrix and writing the factor "
        "once at the bandwidth of a long sum, and the operations of a nested "
        "dissection of as many control points on a rectangle at the speed of a "
        f"product of matrices. At {largest['unknowns']:.0f} unknowns an iteration "
        f"takes {largest['time'] / bound:.0f} times the larger bound: assembly, "
        "ordering, made anew with each pattern, and transpositions are the rest. "
        f"Memory grows by {largest[MEMORY]:.0f} MB, where the factor alone is "
        f"{largest[FACTOR]:.0f} MB." +
        ("" if chart.full else " Full mode goes up to a million unknowns."))


def picture(chart, rows):
    figure, (axes,) = panels(2, width=5.4, height=4.3)
    ends = ([], [])
    for solver, (colour, line) in SOLVERS.items():
        of_solver = [row for row in rows if row["solver"] == solver]
        good = [row for row in of_solver if not row["failed"]]
        for panel, what, end, least in zip(axes, ("time", MEMORY), ends, (0., 2.)):
            shown = [row for row in good if row[what] > least]
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
            ("bound by arithmetic", "--", "bound:\narithmetic")):
        axes[0].loglog(n, [row[what] for row in own], style, color=GREY, lw=1.2)
        ends[0].append((own[-1][what], text, GREY))
    axes[1].loglog(n, [row[FACTOR] for row in own], "--", color=GREY, lw=1.2)
    ends[1].append((own[-1][FACTOR], "bound: factor\nby dissection", GREY))
    default = next(row for row in own if DEFAULT_SIZE in row["run"])
    mark_default(axes[0], default["unknowns"], default["time"],
                 "default solver\non 160 spans", (4, -26), "left")
    mark_default(axes[1], default["unknowns"], default[MEMORY],
                 "default", (-8, 10), "right")
    axes[0].set(title="time of a Newton iteration by solver",
                xlabel="unknowns", ylabel="time over that of the default")
    axes[1].set(title="memory", xlabel="unknowns",
                ylabel=MEMORY)
    finish_logs(*axes)
    for panel, end in zip(axes, ends):
        label_ends(panel, end)
    chart.picture(figure)
