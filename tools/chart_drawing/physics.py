"""What each piece of physics changes of mu, at the corners of the (p, v, T) box."""

import numpy as np

from .style import INK, panels

TITLE = "Physics: change of mu over the (p, v, T) box"
CORNERS = [(p, v, T) for p in (300, 1300) for v in (22.5, 200) for T in (25, 675)]
# what is in or out: (scene, entries)
VARIANTS = {
    "rate term of the flow stress off": (
        "dry", {"Material/Johnson-Cook/C": 0}),
    "heating off (isothermal)": ("dry", {"Heat/Model": "isothermal"}),
    "conduction on": ("dry", {"Heat/Model": "conducting"}),
    # Without the damping of a radius of 0 the chip goes on ringing in such steps.
    "inertia on (dynamic)": ("dry", {"Protocol/Inertia": "dynamic",
                                     "Protocol/Spectral radius": 0}),
    "interface law: shear factor 0.3": (
        "dry", {"Interface/Shear law": "shear factor",
                "Interface/Shear factor": 0.3}),
    "oil film (wetting 0.6) on": ("oil", {}),
    "compressibility of the oil off": (
        "oil", {"Lubricant/Density law": "incompressible"}),
    "piezoviscosity on (Roelands)": (
        "oil", {"Lubricant/Pressure law": "Roelands"}),
    "the same with limited shear stress": (
        "oil", {"Lubricant/Pressure law": "Roelands",
                "Lubricant/Stress limit": "circular"}),
}


def load(corner):
    pressure, velocity, temperature = corner
    return {"Load/Pressure": f"{pressure} MPa",
            "Load/Velocity": f"{velocity} m/min",
            "Load/Temperature": f"{temperature} degC"}


def label(corner):
    return "{} MPa\n{} m/min\n{} °C".format(*corner)


def measure(chart):
    mesh = ({"Mesh/Spans": 160, "Mesh/Refinement levels": 3,
             "Protocol/Ramp steps": 24, "Protocol/Slide steps": 96}
            if chart.full else {})
    scenes = {"dry": {}, "oil": {}}
    for corner in CORNERS:
        where = " ".join(str(x) for x in corner)
        scenes["dry"][f"dry, {where}"] = {**mesh, **load(corner)}
        for name, (kind, entries) in VARIANTS.items():
            scenes[kind][f"{name}, {where}"] = {**mesh, **load(corner), **entries}
    runs = {name: run for kind, of_kind in scenes.items()
            for name, run in chart.scenes(of_kind, kind + ".prm").items()}
    rows = []
    for corner in CORNERS:
        where = " ".join(str(x) for x in corner)
        for name, (kind, entries) in VARIANTS.items():
            run = runs[f"{name}, {where}"]
            base = runs[f"dry, {where}" if kind == "dry" or not entries else
                        f"oil film (wetting 0.6) on, {where}"]
            rows.append({"change": name, "p [MPa]": corner[0],
                         "v [m/min]": corner[1], "T [degC]": corner[2],
                         "mu without": base.mu, "mu with": run.mu,
                         "change of mu [%]": 100. * (run.mu / base.mu - 1.),
                         "time": run.seconds / base.seconds,
                         "failed": run.failure or base.failure or ""})
    chart.table(rows, "the run without the change at the same corner")


def show(chart):
    change = np.full((len(VARIANTS), len(CORNERS)), np.nan)
    reasons = {}
    for row in chart.rows():
        place = (list(VARIANTS).index(row["change"]), CORNERS.index(
            (row["p [MPa]"], row["v [m/min]"], row["T [degC]"])))
        change[place], reasons[place] = row["change of mu [%]"], row["failed"]
    picture(chart, change, reasons)
    chart.page(TITLE, *conclusion(change))


def conclusion(change):
    ranges = {name: (np.nanmin(change[i]), np.nanmax(change[i]))
              for i, name in enumerate(VARIANTS)
              if np.isfinite(change[i]).any()}
    listed = "; ".join(f"{name} {low:+.1f} to {high:+.1f} %"
                       for name, (low, high) in ranges.items())
    out = [f"{name} {max(map(abs, ranges[name])):.0f} %"
           for name in ("heating off (isothermal)", "conduction on",
                        "inertia on (dynamic)")
           if name in ranges and max(map(abs, ranges[name])) > 5.]
    return (
        "Each row switches one piece of physics on or off and keeps the rest, at "
        "the eight corners of the box, after 0.6 um of sliding on a coarse R0; the "
        f"last three rows compare with the oil film. {listed}.",
        "The default physics is what each row starts from: rate term, adiabatic "
        "heating, compressible oil, a viscosity without pressure. Heating and "
        "conduction are within the numerical error of mu here: an adiabatic chip is "
        "enough for a contact without shear. " +
        (f"At some corners more than 5 %: {', '.join(out)}. "
         if out else "Nothing that is out by default matters by more than 5 %. ") +
        "What the mass changes is not the sliding but the load that grows within "
        "21 transits of a wave at 200 m/min: the hot chip sinks in deeper than in "
        "equilibrium (at 1300 MPa and 675 degC mu is +1.2 % here, +2.3 % and "
        "+2.7 % in steps of a quarter and a sixteenth, +2.5 % on half the mesh, "
        "and +0.6 % with a ramp of twice the length). The default spectral radius "
        "of 0.8 hides this behind a ringing that such steps do not resolve, +16, "
        "+12 and +4 % in the same three steps, and is told by a warning. "
        "Interface law and oil are inputs of the scene, not refinements, and each "
        "changes mu by more than all numerics. A viscosity that grows with pressure "
        "needs the limited shear stress: without, the film bears shear that no oil "
        "does, or has no solution. A front of cost and error has no meaning here, "
        "as no row is an approximation of another; what a row costs is in the "
        "table.")


def picture(chart, change, reasons):
    figure, axes = panels(1, width=9.2, height=5.4)
    panel = axes[0, 0]
    # Colours by the size of the change, 0.1 % to 100 % on a logarithmic scale
    strength = np.sign(change) * np.clip(
        np.log10(np.maximum(np.abs(change), 1e-9)) + 1., 0., 3.)
    panel.imshow(np.nan_to_num(strength), cmap="RdBu_r", vmin=-4.2, vmax=4.2,
                 aspect="auto")
    for (i, j), why in reasons.items():
        value = change[i, j]
        text = "failed" if why else f"{value:+.1f}" if abs(value) >= 0.05 else "0"
        dark = abs(np.nan_to_num(strength[i, j])) > 2.6
        panel.text(j, i, text, ha="center", va="center", size=8.5,
                   color="#aa0000" if why else "white" if dark else INK)
    panel.set_xticks(range(len(CORNERS)), [label(c) for c in CORNERS], size=8)
    panel.set_yticks(range(len(VARIANTS)), VARIANTS)
    panel.tick_params(length=0)
    panel.grid(False)
    for k in range(1, len(VARIANTS)):
        panel.axhline(k - 0.5, color="white", lw=1.5)
    panel.axhline(4.5, color=INK, lw=1)
    for side in panel.spines.values():
        side.set_visible(False)
    panel.set_title("Change of mu [%] against the default physics; "
                    "below the line with oil")
    chart.picture(figure)
