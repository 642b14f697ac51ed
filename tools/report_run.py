"""The sections of a run's report: what summary.json, friction.csv, pictures and
parameters.prm of its folder say; and those of a sensitivity."""

import os
import shlex
import subprocess
import sys
import tempfile

from report_page import (HERE, ReportError, Section, bar, change_bar, command,
                         details, facts, interval_line, number, percent, picture,
                         program_line, read_json, read_text, table, tag, tiles,
                         warnings)

# Names of the groups of choices, as they stand behind a part of an interval.
GROUPS = {"preparation": "preparation", "profile": "profile for surface",
          "scene": "scene", "constants": "material constants"}

PICTURES = {
    "deformed_topography.png": "The deformed chip under the tool, coloured by "
                               "equivalent plastic strain; arrows: the force of "
                               "the tool on the chip. Of a patch the face of the "
                               "chip, and maps of its height, of the contact "
                               "pressure and of that of the oil.",
    "oil_flow.png": "Pressure and velocity of the oil in the gap; the height is "
                    "stretched.",
    "friction.png": "µ and contact fraction over time and sliding distance; the "
                    "averaging window is shaded.",
    "fluid_structure.png": "Speed and pressure of the fluid, and stress of the "
                           "body.",
    "history.png": "Displacement, forces, pressure, volume and iterations over "
                   "time."}


def value_of(document, *keys):
    """An entry of nested objects, or None."""
    for key in keys:
        document = document.get(key) if isinstance(document, dict) else None
    return document


def quantity(value, factor, unit, offset=0.):
    """A value of SI units in those of people, or None."""
    if not isinstance(value, (int, float)):
        return None
    return f"{number(factor * value + offset)} {unit}".strip()


def draw(script, folder, captions, *options):
    """The pictures that a script of tools draws of a folder, and what it says
    if it cannot."""
    with tempfile.TemporaryDirectory() as target:
        call = subprocess.run(
            [sys.executable, os.path.join(HERE, script), folder, "--to", target,
             *options], capture_output=True, text=True, check=False)
        shown = [picture(os.path.join(target, name), caption)
                 for name, caption in captions.items()
                 if os.path.exists(os.path.join(target, name))]
    if call.returncode != 0:
        reason = (call.stderr.strip().splitlines() or ["no reason is given"])[-1]
        shown.append(tag("p", f"Not all pictures could be drawn: {reason}",
                         class_="missing"))
    return shown


def groups_of(sensitivity):
    """Relative errors by group of choices: (name, below, above)."""
    spread = value_of(sensitivity, "spread")
    return [(GROUPS.get(name, name), float(value_of(part, "below") or 0.),
             float(value_of(part, "above") or 0.))
            for name, part in (spread or {}).items()
            if name != "all" and isinstance(part, dict)]


def sensitivity_beside(folder, given=None):
    """The result of `asperity sensitivity`, if it is there."""
    path = given or os.path.join(folder, "sensitivity.json")
    if given is None and not os.path.exists(path):
        return None
    return read_sensitivity(path)


def read_sensitivity(path):
    document = read_json(path, "a result of 'asperity sensitivity'")
    if not (isinstance(document.get("variations"), list)
            and isinstance(document.get("spread"), dict)
            and isinstance(document.get("mu"), (int, float))):
        raise ReportError(f"{path} has no mu, spread and variations; a result of "
                          "'asperity sensitivity' is expected.")
    return document


def lead_of_run(summary, sensitivity):
    """The line mu = ... +- ..., or why there is none."""
    mu = value_of(summary, "friction", "mu")
    if mu is None:
        return tag("p", "The run has no summary.json yet: it goes on, or was "
                        "stopped.")
    parts = []
    error = value_of(summary, "accuracy", "error")
    if error is not None:
        parts.append(("numerics", error * abs(mu), error * abs(mu)))
    parts += [(name, below * abs(mu), above * abs(mu))
              for name, below, above in groups_of(sensitivity)]
    spread = value_of(summary, "friction", "spread") or 0.
    parts.append(("spread over time", spread, spread))
    status = value_of(summary, "friction", "status")
    remark = None if value_of(summary, "friction", "valid") is not False else tag(
        "p", f"This mean is no friction coefficient: {status}.")
    return tag("div", interval_line(mu, parts), remark)


def result_section(summary):
    friction, load = summary.get("friction", {}), summary.get("load", {})
    window = value_of(friction, "window_sliding_distance") or [None, None]
    mechanisms = summary.get("mechanisms") or []
    oil = value_of(summary, "oil", "load_share")
    shown = [("friction coefficient µ", number(friction.get("mu")),
              f"{number(friction.get('mu_end'))} at the end"),
             ("numerical error",
              percent(value_of(summary, "accuracy", "error")),
              "mesh, steps, penalty" if "accuracy" in summary
              else "not estimated"),
             *corrected_tile(summary),
             ("contact fraction",
              percent(summary.get("contact_fraction"), 3), None),
             ("largest plastic strain",
              number(value_of(summary, "end", "max_plastic_strain"), 3),
              "at the end")]
    end = summary.get("end", {})
    rows = [
        ("pressure", quantity(load.get("pressure"), 1e-6, "MPa")),
        ("velocity", quantity(load.get("velocity"), 60., "m/min")),
        ("temperature", quantity(load.get("temperature"), 1., "°C", -273.15)),
        ("plastic strain of the chip before",
         quantity(load.get("plastic_strain"), 1., "")),
        ("µ is the mean over the sliding distance",
         None if window[0] is None else
         f"{number(1e6 * window[0], 3)} to {number(1e6 * window[1], 3)} µm"),
        ("what makes it", ", ".join(map(str, mechanisms)) or None),
        *[(f"of which {name.replace('_', ' ')}", number(friction[name]))
          for name in ("ploughing", "interface_shear", "oil_shear")
          if friction.get(name) and len(mechanisms) > 1],
        ("share of the load that the oil carries",
         None if oil is None else percent(oil, 3)),
        ("wetting", quantity(value_of(summary, "oil", "wetting"), 1., "")),
        ("largest contact pressure at the end",
         quantity(end.get("max_contact_pressure"), 1e-9, "GPa")),
        ("highest temperature at the end",
         quantity(end.get("max_temperature"), 1., "°C", -273.15)),
        ("tool", value_of(summary, "surfaces", "tool")),
        ("chip", value_of(summary, "surfaces", "chip")),
        ("period", quantity(value_of(summary, "surfaces", "period"), 1e6, "µm")),
        ("width", quantity(value_of(summary, "surfaces", "width"), 1e6, "µm")),
        ("force across the motion over the load",
         number(value_of(summary, "friction", "transverse"), 3)
         if value_of(summary, "surfaces", "width") else None),
        ("models", ", ".join(str(model) if model != "none" else "dry"
                             for model in (summary.get("models") or {}).values())
         or None),
        ("mesh", mesh_text(summary.get("mesh"))),
        ("cost", cost_text(summary.get("cost")))]
    return Section("Result", tiles(shown), facts(rows))


def corrected_tile(summary):
    mu = value_of(summary, "accuracy", "corrected_mu")
    if mu is None:
        return []
    error = percent(value_of(summary, "accuracy", "uncertainty"))
    return [("µ corrected for it", number(mu), f"± {error}")]


def mesh_text(mesh):
    if not isinstance(mesh, dict):
        return None
    return (f"degree {mesh.get('degree')}, {mesh.get('cells')} elements, "
            f"{mesh.get('unknowns')} unknowns; elements of "
            f"{number(1e6 * (mesh.get('contact_element') or 0.), 3)} µm in the "
            "contact")


def cost_text(cost):
    if not isinstance(cost, dict):
        return None
    return (f"{number(cost.get('wall_time'), 3)} s, {cost.get('steps')} steps, "
            f"{cost.get('newton_iterations')} Newton iterations")


def accuracy_section(summary):
    accuracy, mu = summary.get("accuracy"), value_of(summary, "friction", "mu")
    title = "Error by source"
    if value_of(summary, "surfaces", "width"):
        return Section(title, tag("p", "The numerical error of this µ was not "
                                  "estimated: scenes in three dimensions have no "
                                  "such estimate yet."))
    if not isinstance(accuracy, dict):
        return Section(title, tag("p", "The numerical error of this µ was not "
                                  "estimated: ", tag("code", "set Control = "
                                  "estimate"), " in the subsection Accuracy does "
                                  "that by three coarser runs."))
    total, wanted = accuracy.get("error") or 0., accuracy.get("wanted") or 0.
    largest = max(total, wanted, 1e-300)
    rows = [(name, percent(accuracy.get(key)),
             number(abs(mu or 0.) * (accuracy.get(key) or 0.), 2),
             bar((accuracy.get(key) or 0.) / largest, class_))
            for name, key, class_ in (
                ("mesh", "mesh", "bar"), ("time steps", "step", "bar"),
                ("penalty of the contact", "penalty", "bar"),
                ("together", "error", "bar total"),
                ("left if µ is corrected", "uncertainty", "bar"),
                ("wanted (Accuracy/Error)", "wanted", "bar wanted"))
            if isinstance(accuracy.get(key), (int, float))]
    left = accuracy.get("uncertainty")
    remark = ("This is within what is wanted." if total <= wanted else
              "This is more than what is wanted." if left is None else
              "This is more than what is wanted, and so is what is left if µ is "
              "corrected for it." if left > wanted else
              "This is more than what is wanted; what is left if µ is corrected "
              "for it, to " + number(accuracy.get("corrected_mu")) + ", is not.")
    return Section(title, tag("p", "Numerical error of µ, estimated by coarser "
                              "companions of the run. " + remark),
                   table(("source", "of µ", "in µ", ""), rows, (1, 2)))


def audit_section(summary):
    """The numbers that decide about models, and what they say."""
    rows = []
    for name, entry in (summary.get("audit") or {}).items():
        value = value_of(entry, "value") if isinstance(entry, dict) else entry
        rows.append((name, number(value, 3), value_of(entry, "meaning") or ""))
    unused = [f"{entry.get('entry')} (only with {entry.get('counts_with')})"
              for entry in summary.get("unused_entries") or []
              if isinstance(entry, dict)]
    return Section(
        "Audit", tag("p", "The scene in numbers, which say what models and mesh "
                     "have to know."),
        table(("number", "value", "what it says"), rows, (1,)),
        tag("p", "Not used by this scene: " + "; ".join(unused) + ".")
        if unused else None)


def choices_section(sensitivity):
    """What varying each choice does to mu, with bars by entry."""
    mu = sensitivity["mu"]
    rows = [row for row in sensitivity["variations"] if isinstance(row, dict)]
    changes = [row["mu"] / mu - 1. for row in rows
               if isinstance(row.get("mu"), (int, float))]
    largest = max([abs(change) for change in changes] + [1e-12])
    body = []
    for row in rows:
        at = row.get("mu")
        change = at / mu - 1. if isinstance(at, (int, float)) else None
        body.append((
            row.get("entry"), row.get("value"),
            GROUPS.get(row.get("kind"), row.get("kind")),
            number(at) if change is not None else row.get("reason", "no µ"),
            "" if change is None else
            f"{100. * change:+.1f} %".replace("-", "−"),
            "" if change is None else change_bar(-change, change, largest)))
    sums = [(name, f"−{percent(below)}", f"+{percent(above)}",
             f"{number(mu - below * abs(mu), 3)} to "
             f"{number(mu + above * abs(mu), 3)}")
            for name, below, above in groups_of(sensitivity)
            if below > 0. or above > 0.]
    return Section(
        "What is choice", tag("p", "Each of the entries below was changed alone, "
                              "by a run each; those with the largest effect "
                              "stand first."),
        table(("entry", "value", "group", "µ", "change", ""), body, (3, 4)),
        tag("h3", "Together, by group"),
        tag("p", "The largest changes of the entries of a group, added by their "
            "squares; material constants within 10 %."),
        table(("group", "below", "above", "µ"), sums, (1, 2, 3)))


def repeat_section(folder, program, file, call, remark):
    text = read_text(os.path.join(folder, file))
    path = os.path.join(folder, file)
    return Section(
        "How to repeat",
        command(f"{call} {shlex.quote(path)}") if text is not None else
        tag("p", f"The folder has no {file}.", class_="missing"),
        tag("p", remark) if text is not None else None,
        facts([("made by", program_line(program))]),
        details(file, text) if text is not None else None)


def report_run(folder, arguments):
    """Title, lead and sections of a run, its scripts."""
    summary = {}
    if os.path.exists(os.path.join(folder, "summary.json")):
        summary = read_json(os.path.join(folder, "summary.json"),
                            "the summary of a run")
    sensitivity = sensitivity_beside(folder, arguments.sensitivity)
    sections = []
    if "friction" in summary:
        sections += [result_section(summary), accuracy_section(summary)]
    if sensitivity is not None:
        sections.append(choices_section(sensitivity))
    if "audit" in summary:
        sections.append(audit_section(summary))
    sections.append(Section("Pictures", *draw("plot_run.py", folder, PICTURES)))
    if "warnings" in summary:
        sections.append(Section("Warnings", warnings(summary["warnings"])))
    if "friction" not in summary and summary:
        sections.insert(0, numbers_section(summary))
    sections.append(repeat_section(
        folder, summary.get("program"), "parameters.prm", "asperity",
        "The file has every entry; its Output/Output directory is where the run "
        "goes, and a new run replaces what is there."))
    is_scene = os.path.exists(os.path.join(folder, "friction.csv"))
    lead = (lead_of_run(summary, sensitivity) if is_scene else
            tag("p", "A fluid-structure problem without contact."))
    return "run", lead, sections, []


def numbers_section(summary):
    """All numbers and texts of a summary that is not that of a scene."""
    rows = []

    def collect(prefix, value):
        if isinstance(value, dict):
            for key, entry in value.items():
                collect(f"{prefix}/{key}" if prefix else key, entry)
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            rows.append((prefix, number(value, 6)))
        elif isinstance(value, str):
            rows.append((prefix, value))

    collect("", {key: value for key, value in summary.items()
                 if key not in ("program", "warnings")})
    return Section("Result", tag("p", "In SI units."), facts(rows))


def report_sensitivity(path, _):
    """Title, lead and sections of a result of `asperity sensitivity`."""
    document = read_sensitivity(path)
    mu = document["mu"]
    lead = interval_line(mu, [(name, below * abs(mu), above * abs(mu))
                              for name, below, above in groups_of(document)])
    return ("sensitivity", lead,
            [choices_section(document),
             Section("How to repeat", command("asperity sensitivity FILE.prm"),
                     tag("p", "FILE.prm is the scene whose Output/Output "
                         "directory is the folder of the file."),
                     facts([("made by", program_line(document.get("program")))]))],
            [])
