"""What plane strain errs: patches of rough surfaces against their profiles."""

import math
import os

from . import plane_strain_results as results
from . import plane_strain_surfaces as surfaces
from . import rough_surfaces as rough
from .style import BLUE, GREEN, GREY, INK, PURPLE, RED, log_axis, panels

TITLE = "Plane strain: what a profile errs against a patch of the surface"
# Elements along and across the motion in a window, and time steps.
DEFAULT = {"spans": 24, "across": 12, "ramp": 32, "slide": 80}
QUICK = {"spans": 16, "across": 12, "ramp": 8, "slide": 20}
FINER = "three quarters of the element length"
SLOWER = "half the time step"
REFINED = {FINER: {**DEFAULT, "spans": 32, "across": 16},
           SLOWER: {**DEFAULT, "ramp": 64, "slide": 160}}
COLOURS_OF = {"synthetic": BLUE, "blasted": RED,
              "ground": PURPLE}


WETTING = 0.8  # of the cases with oil
DRY, SHEARED, OILED = (0., 0.), (0.5, 0.), (0., WETTING)


def cases(full):
    """(surface, stretches, (share m, wetting), settings, elements)"""
    if not full:
        return [(surfaces.synthetic(1), (1, 20), DRY, "", QUICK)]
    tools = [(surfaces.tool("blasted", 1), (1,)),
             (surfaces.tool("blasted", 2), (1,))]
    if os.path.exists(surfaces.MAPS["ground"]):
        tools.append((surfaces.ground(1), (1,)))
    synthetic = [(surfaces.synthetic(seed), (1, 5, 20)) for seed in (1, 2, 3)]
    found = [(surface, stretches, interface, "", DEFAULT)
             for interface in (DRY, SHEARED)
             for surface, stretches in synthetic + tools]
    found += [(surface, stretches, OILED, "", DEFAULT)
              for surface, stretches in synthetic[:1] + tools]
    found += [(surfaces.synthetic(1), (1, 20), DRY, settings, elements)
              for settings, elements in REFINED.items()]
    found += [(surfaces.synthetic(2), (1,), DRY, FINER, REFINED[FINER]),
              (surfaces.synthetic(1), (1,), SHEARED, SLOWER, REFINED[SLOWER])]
    return found


def runs_of(chart):
    """{run: (columns of its row, entries)}"""
    runs = {}
    for surface, stretches, interface, settings, elements in cases(chart.full):
        path = os.path.join(chart.folder, "maps",
                            f"{surface.name.replace(' ', '_')}.txt")
        rough.write_map(path, surface.heights)
        rows = range(0, rough.SAMPLES, rough.SAMPLES // surfaces.PROFILES)
        found = [("profile", row,
                  surfaces.profile(surface, path, row, interface, elements))
                 for row in rows]
        found += [("patch", stretch, surfaces.patch(surface, path, stretch,
                                                    interface, elements))
                  for stretch in stretches]
        factor, wetting = interface
        for kind, number, entries in found:
            name = ", ".join(filter(None, (
                surface.name, f"m {factor:g}", f"oil {wetting:g}" if wetting else
                "", f"{kind} {number}", settings)))
            runs[name] = ({"surface": surface.kind, "seed": surface.seed,
                           "m": factor, "wetting": wetting, "kind": kind,
                           "stretch or row": number, "settings": settings},
                          entries)
    return runs


def measure(chart):
    runs = runs_of(chart)
    made = chart.scenes({name: entries for name, (_, entries) in runs.items()})
    chart.table([{"run": name, **columns, "mu": made[name].mu,
                  "contact fraction": made[name].value("contact_fraction"),
                  "oil share": made[name].value("oil", "load_share"),
                  "Str": made[name].value("surfaces", "Str"),
                  "time": made[name].seconds,
                  "failed": made[name].failure or ""}
                 for name, (columns, _) in runs.items()], "1 s")


def show(chart):
    rows = chart.rows()
    groups = results.groups(rows)
    picture(chart, groups)
    chart.page(TITLE, *conclusion(groups), dry_table(groups), *of_oil(groups),
               *numerics(rows))


def per_cent(values):
    """-40 to +12, or one number."""
    values = [round(v) for v in values if math.isfinite(v)]
    if not values:
        return ""
    low, high = min(values), max(values)
    return f"{low:+d}" if low == high else f"{low:+d} to {high:+d}"


def dry_table(groups):
    lines = ["| surface | Str | m | windows | mu of the patch | mean over profiles "
             "[%] (by window) | one profile [%] (root mean square) | contact "
             "fraction of the patch | its mean over profiles [%] |",
             "|" + " --- |" * 9]
    for key, group in groups["mu"].items():
        factor, wetting = group.interface
        if wetting:
            continue
        area = groups["contact fraction"][key]
        cells = (group.surface, f"{group.ratio:g}", f"{factor:g}",
                 len(group.patches), f"{group.patch:.3f}",
                 f"{group.bias():+.0f} ({per_cent(group.of_means().values())})",
                 f"{per_cent(group.of_profiles())} ({group.typical():.0f})",
                 f"{area.patch:.3f}", f"{area.bias():+.0f}")
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def oil_table(groups):
    """Values, since those of patches with much oil are near zero."""
    lines = ["| surface | Str | windows | mu: patch | profiles | contact fraction: "
             "patch | profiles | part of the load that oil carries: patch | "
             "profiles |", "|" + " --- |" * 9]
    for key, group in groups["mu"].items():
        if not group.interface[1]:
            continue
        cells = [group.surface, f"{group.ratio:g}", len(group.patches)]
        for of_quantity in groups.values():
            of = of_quantity[key]
            cells += [f"{of.patch:.3f}", f"{of.of_all_profiles():.3f} "
                      f"({span(of.all_profiles())})"]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def span(values):
    return f"{min(values):.3f} to {max(values):.3f}"


def numerics(rows):
    """What finer settings change of patches and of profiles, in the mean."""
    sentences = []
    for settings in REFINED:
        for kind in ("patch", "profile"):
            of = {finer: {(row["surface"], row["seed"], results.interface_of(row),
                           row["stretch or row"]): row["mu"] for row in rows
                          if row["kind"] == kind and row["settings"] == finer
                          and math.isfinite(row["mu"])}
                  for finer in ("", settings)}
            for interface in sorted({key[2] for key in of[settings]}):
                pairs = [(mu, of[""][key]) for key, mu in of[settings].items()
                         if key[2] == interface and key in of[""]]
                if not pairs:
                    continue
                change = results.error(results.mean([mu for mu, _ in pairs]),
                                       results.mean([mu for _, mu in pairs]))
                sentences.append(
                    f"{settings} changes mu of {len(pairs)} "
                    f"{'patches' if kind == 'patch' else 'profiles'} "
                    f"{name_of(interface)} by {change:+.1f} %")
    return ["Numerical error, in the mean: " + "; ".join(sentences) + "."
            ] if sentences else []


def name_of(interface):
    factor, wetting = interface
    if wetting:
        return f"with oil in {100. * wetting:g} % of the void"
    return "without shear" if factor == 0. else f"with m = {factor:g}"


def listed(groups):
    """Errors of the mean over profiles over Str."""
    return ", ".join(f"{g.bias():+.0f} % at {g.ratio:g}" for g in groups)


def verdict(groups):
    """From which Str on plane strain can be used; groups over Str."""
    of_mean = results.fair_up_to(groups, lambda g: g.bias())
    of_one = results.fair_up_to(groups, lambda g: g.typical())
    lowest = min(g.ratio for g in groups)
    return " and ".join(
        f"{what} stays within {results.FAIR:.0f} % " +
        (f"at no Str from {lowest:g} on" if up_to is None else
         f"up to Str = {up_to:g}")
        for what, up_to in (("the mean over profiles", of_mean),
                            ("one profile (root mean square)", of_one)))


def conclusion(groups):
    yield ("Patches of rough surfaces under 300 MPa against profiles of the same "
           "surfaces in plane strain, on the same elements along the motion and in "
           "the same steps, after sliding by half a window. Synthetic surfaces are "
           "Gaussian and the same ones at each Str: they are stretched across the "
           "motion, which leaves their profiles as they are. A window is as long as "
           "one to two asperities.")
    for interface in interfaces(groups):
        if interface[1]:
            continue
        of_surface = {surface: sorted((g for (s, i, _), g in groups["mu"].items()
                                       if i == interface and s == surface),
                                      key=lambda g: -g.ratio)
                      for surface in COLOURS_OF}
        synthetic = of_surface.pop("synthetic")
        if not synthetic:
            continue
        name = name_of(interface)
        text = (f"**{name[0].upper()}{name[1:]}** "
                "mu of the mean over profiles is off that of the patches by "
                f"{listed(synthetic)} (Str); one profile is off by " + ", ".join(
                    f"{g.typical():.0f} %" for g in synthetic)
                + " (root mean square)")
        text += f": {verdict(synthetic)}. "
        yield text + " ".join(of_tool(group) for found in of_surface.values()
                              for group in found)
    areas = [g.bias() for g in groups["contact fraction"].values()
             if not g.interface[1]]
    yield (f"The contact fraction is off by {per_cent(areas)} % in the mean over "
           "profiles. One to three windows stand for a point of the table: these are "
           "sizes of an error, and no corrections.")


def of_oil(groups):
    """What a profile has beside a patch whose void has the same part of oil."""
    shares = [g for g in groups["oil share"].values() if g.interface[1]]
    if not shares:
        return
    patches = [g.patch for g in shares]
    profiles = [g.of_all_profiles() for g in shares]
    yield (f"**{name_of(shares[0].interface)[0].upper()}"
           f"{name_of(shares[0].interface)[1:]}** at the first touch, which is of "
           "one pressure, the oil of these patches carries "
           f"{100. * min(patches):.0f} to {100. * max(patches):.0f} % of the load, "
           "that of the mean over their profiles "
           f"{100. * min(profiles):.0f} to {100. * max(profiles):.0f} %. A ridge "
           "without end bears more than a hill after the same approach, so that the "
           "tool stops before the oil fills what is left under it. So a wetting by "
           "which a profile has the measured friction is not that of the surface.")
    yield oil_table(groups)


def of_tool(group):
    n = len(group.patches)
    return (f"The {group.surface} surface ({n} window{'s' if n > 1 else ''}): "
            f"{group.bias():+.0f} % in the mean over profiles, one profile "
            f"{per_cent(group.of_profiles())} %.")


def interfaces(groups):
    return list(dict.fromkeys(interface for _, interface, _ in groups["mu"]))


def picture(chart, groups):
    found = interfaces(groups)
    figure, axes = panels(len(found), 2, width=4.6, height=3.5)
    for column, interface in zip(axes.T, found):
        quantities = ("mu", "oil share" if interface[1] else "contact fraction")
        for panel, quantity in zip(column, quantities):
            chosen = [g for (_, i, _), g in groups[quantity].items()
                      if i == interface]
            (draw_values if interface[1] else draw)(
                panel, chosen, f"{quantity}, {name_of(interface)}")
    axes[1, 0].legend(loc="upper left", fontsize=7)
    chart.picture(figure)


def draw_values(panel, groups, title):
    """Over Str: of patches as squares, of profiles as specks and, their mean, as
    circles."""
    for group in groups:
        colour = COLOURS_OF[group.surface]
        values = group.all_profiles()
        panel.plot([0.93 * group.ratio] * len(values), values, "_", color=colour,
                   alpha=0.35, ms=6)
        panel.plot(group.ratio, group.of_all_profiles(), "o", color=colour, mfc="w")
        panel.plot(group.ratio, group.patch, "s", color=colour)
    panel.set_ylim(bottom=0.)
    over_ratio(panel, title)
    panel.plot([], [], "s", color=GREY, label="patches")
    panel.plot([], [], "o", color=GREY, mfc="w", label="mean over profiles")
    panel.legend(loc="center left", fontsize=7)


def over_ratio(panel, title):
    panel.set_title(title)
    panel.set_xscale("log")
    panel.set_xlabel("texture aspect ratio Str")
    log_axis(panel.xaxis, [0.05, 0.1, 0.2, 0.5, 1])


def draw(panel, groups, title):
    """Errors over Str: of single profiles as specks, of the mean over the
    profiles of each surface as dots, its mean over surfaces as squares."""
    panel.axhline(0., color=INK, lw=0.9)
    panel.axhspan(-results.FAIR, results.FAIR, color=GREEN, alpha=0.12, lw=0)
    for surface, colour in COLOURS_OF.items():
        found = sorted((g for g in groups if g.surface == surface),
                       key=lambda group: group.ratio)
        xs = [group.ratio for group in found]
        if not xs:
            continue
        for group in found:
            errors = group.of_profiles()
            panel.plot([0.93 * group.ratio] * len(errors), errors, "_",
                       color=colour, alpha=0.35, ms=6)
            errors = list(group.of_means().values())
            panel.plot([group.ratio] * len(errors), errors, "o", color=colour,
                       alpha=0.5, ms=3.5)
        line = "-" if surface == "synthetic" else ""
        panel.plot(xs, [group.bias() for group in found], "s" + line,
                   color=colour, label=f"{surface}: mean over profiles")
    panel.set_ylabel("error of plane strain [%]")
    over_ratio(panel, title)
