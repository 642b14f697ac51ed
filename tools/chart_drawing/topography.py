"""What the preparation of a measured surface does to mu."""

from .style import BLUE, RED, log_axis, mark_default, mark_failed, panels

TITLE = "Topography: how much of the answer is the preparation of the surface"
MAP = "Tool/Topography/"
DEFAULT = "as it is"


def sweeps(full):
    """{panel: {run: (x or None, entries)}}; x of the default among them."""
    cutoffs = ((2.5, 3, 4, 6, 8, 10, 14, 20) if full else (3, 4, 7, 10, 16))
    spans = (8, 10, 12, 16, 20, 30, 60, 80) if full else (8, 12, 20, 70)
    rows = range(5, 60, 4) if full else (5, 18, 31, 44, 57)
    return {
        "cut-off of the S-filter [um]": {
            f"S-filter {c:g} um": (c, {MAP + "S-filter nesting index": f"{c} um"})
            for c in cutoffs},
        "control points of the spline": {
            f"{n} control points": (n, {"Tool/Spline spans": n})
            for n in spans},
        "place of the profile [row of the map]": {
            f"row {r}": (r, {MAP + "Profile position": f"row {r}"})
            for r in rows},
        "continuation and spline": {
            "mirrored": (None, {MAP + "Periodic continuation": "mirror",
                                MAP + "Profile length": "20.25 um"}),
            "repeated, with its jump": (None, {
                MAP + "Periodic continuation": "none"}),
            "interpolated": (None, {"Tool/Spline fit": "interpolation"}),
            "L-filter 20 um": (None, {MAP + "L-filter nesting index": "20 um"}),
            "other direction": (None, {MAP + "Profile direction": "180 deg"}),
            "across (90 deg)": (None, {MAP + "Profile direction": "90 deg",
                                       MAP + "Profile start": "0 um",
                                       MAP + "Profile length": "0 um"})}}


def measure(chart):
    mesh = ({"Mesh/Spans": 320, "Mesh/Refinement levels": 4,
             "Protocol/Ramp steps": 20, "Protocol/Slide steps": 60}
            if chart.full else {})
    groups = sweeps(chart.full)
    runs = chart.scenes({DEFAULT: mesh, **{
        name: {**mesh, **entries} for group in groups.values()
        for name, (_, entries) in group.items()}})
    default = runs[DEFAULT]
    rows = [{"run": name, "mu": run.mu,
             "mu over that of the default": run.mu / default.mu,
             "contact fraction": run.value("contact_fraction"),
             "time": run.seconds / default.seconds,
             "failed": run.failure or ""} for name, run in runs.items()]
    chart.table(rows, "the run of the default preparation")


def show(chart):
    of = {row["run"]: row for row in chart.rows()}
    groups = sweeps(chart.full)
    picture(chart, groups, of)
    chart.page(TITLE, *conclusion(groups, of))


def span(rows):
    mus = [row["mu"] for row in rows if not row["failed"]]
    return (min(mus), max(mus)) if mus else (float("nan"), float("nan"))


def conclusion(groups, of):
    mu = of[DEFAULT]["mu"]
    sentences = []
    for name, group in groups.items():
        low, high = span([of[run] for run in group])
        sentences.append(f"{name.split(' [')[0]} {low:.3f} to {high:.3f}")
    control = list(groups["control points of the spline"])
    return (
        "mu of the blasted tool (300 MPa, 200 m/min, 25 degC, 1 um of sliding) is "
        f"{mu:.4f} as `parameter_files/friction_law` prepares it; its range when "
        f"one choice is varied: {'; '.join(sentences)}. Numerics are 1 % of mu "
        "here: nearly all of the answer is how the surface is prepared, the S-filter "
        "above all, and which profile stands for it. A longer cut-off flattens the "
        "asperities: mu falls and the contact fraction rises. With too few control "
        "points the spline does the same.",
        "There is no front of cost and error, since all preparations cost the same "
        "and nobody knows the right one. The default of one span of the spline for "
        "two points of the profile (40 control points) is "
        f"{100 * abs(mu / of[control[-1]]['mu'] - 1):.1f} % off {control[-1]} and "
        "so near the end of that choice; the cut-off of 5 um is ten pixels, and no "
        "value of it is where mu stops to change: it has to come from the "
        "instrument and the question.")


def picture(chart, groups, of):
    figure, axes = panels(2, 2, width=5.2, height=3.6)
    for panel, (name, group) in zip(axes.flat, groups.items()):
        twin = panel.twinx()
        twin.grid(False)
        twin.spines["right"].set_visible(True)
        xs = [x for x, _ in group.values()]
        if None in xs:
            draw_choices(panel, twin, group, of)
        else:
            draw_sweep(panel, twin, name, group, of)
        panel.set_ylabel("mu", color=BLUE)
        twin.set_ylabel("contact fraction", color=RED)
        panel.set_title(name.split(" [")[0])
        panel.set_xlabel("" if None in xs else name)
        for axis in (panel, twin):
            axis.set_ylim(0, 1.2 * axis.get_ylim()[1])
    chart.picture(figure)


def draw_sweep(panel, twin, name, group, of):
    points = [(x, of[run]) for run, (x, _) in group.items()]
    default = {"cut": 5., "con": 40.}.get(name[:3])
    if default is not None:
        points.append((default, of[DEFAULT]))
    points.sort(key=lambda point: point[0])
    good = [(x, row) for x, row in points if not row["failed"]]
    xs = [x for x, _ in good]
    line = "-" if default is not None else ""
    panel.plot(xs, [row["mu"] for _, row in good], "o" + line, color=BLUE)
    twin.plot(xs, [row["contact fraction"] for _, row in good], "s" + line,
              color=RED, ms=4, alpha=0.8)
    mark_failed(panel, [x for x, row in points if row["failed"]], BLUE)
    if default is None:
        panel.axhline(of[DEFAULT]["mu"], color=BLUE, lw=0.9, ls="--")
        panel.annotate("default: middle of the map", (0.99, of[DEFAULT]["mu"]),
                       xycoords=panel.get_yaxis_transform(), xytext=(0, 3),
                       textcoords="offset points", size=8, weight="bold",
                       ha="right")
    else:
        panel.set_xscale("log")
        log_axis(panel.xaxis, sorted(xs))
        mark_default(panel, default, of[DEFAULT]["mu"],
                     **({"offset": (-7, -14), "align": "right"}
                        if default == 5. else {"offset": (0, 11),
                                               "align": "center"}))


def draw_choices(panel, twin, group, of):
    names = [DEFAULT, *group]
    for k, name in enumerate(names):
        row = of[name]
        if row["failed"]:
            mark_failed(panel, [k], BLUE)
            continue
        panel.plot([k], [row["mu"]], "o", color=BLUE, ms=6)
        twin.plot([k], [row["contact fraction"]], "s", color=RED, ms=5,
                  alpha=0.8)
    mark_default(panel, 0, of[DEFAULT]["mu"], offset=(0, -18), align="center")
    panel.set_xticks(range(len(names)), names, rotation=35, ha="right", size=8)
    panel.set_xlim(-0.6, len(names) - 0.4)
