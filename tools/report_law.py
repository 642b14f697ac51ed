"""The sections of a campaign's report: its friction law, evaluated in the page by
the law as the program exports it, how good it is, and what it rests on."""

import os
import shutil
import subprocess
import tempfile

from campaign_data import UNITS
from report_page import (HERE, Html, ReportError, Section, data_script, facts,
                         number, own_file, percent, program_line, read_json,
                         script, table, tag, tiles, warnings)
from report_run import (draw, groups_of, choices_section, repeat_section,
                        sensitivity_beside, value_of)

PICTURES = {
    "friction_law.png": "The law over pressure and velocity; dots: the runs near "
                        "each temperature, in the colours of the law; hatched: "
                        "not to be trusted.",
    "beyond_the_data.png": "The law in and outside of the range of its runs, with "
                           "its 95 % intervals.",
    "test_runs.png": "What the law says of runs that it has not learnt from, over "
                     "what was computed.",
    "error_over_runs.png": "Error of the laws of growing numbers of runs.",
    "sensitivity.png": "Which input matters how much: shares of the variance of "
                       "µ."}


def shown(entry, key):
    """An end of an input's range in the units of people."""
    factor, offset = UNITS.get(entry["unit"], (1., 0.))
    unit = {"1": "", "degC": "°C", "um": "µm"}.get(entry["unit"], entry["unit"])
    if entry["unit"] not in UNITS and entry["unit"] != "1":
        unit = "(SI)"
    return f"{number(factor * entry[key] + offset, 6)} {unit}".strip()


def find_program(given):
    beside = os.path.join(HERE, "..", "build", "asperity")
    program = given or (beside if os.path.exists(beside)
                        else shutil.which("asperity"))
    if program is None:
        raise ReportError("The program that exports the law is missing: "
                          "build/asperity was not found; build it, or give it "
                          "with --program.")
    return program


def exported_law(path, document, arguments):
    """The law as JavaScript. It is always made anew, of a law whose checksum the
    program has tested: a script that lies in the folder may be anything."""
    settings = []
    for entry in document["inputs"]:
        if (entry["symbol"] not in ("p", "v", "T")
                and entry.get("reference") is None):
            middle = 0.5 * (entry["lower"] + entry["upper"])
            settings += ["--set", f"{entry['name']} = {as_written(entry, middle)}"]
    with tempfile.TemporaryDirectory() as target:
        try:
            call = subprocess.run(
                [find_program(arguments.program), "export", path, target,
                 *settings], capture_output=True, text=True, check=False)
            with open(os.path.join(target, "friction_law.js"),
                      encoding="utf-8") as file:
                return file.read()
        except FileNotFoundError:
            said = call.stderr.strip().splitlines() if "call" in locals() else []
            raise ReportError(f"{path} cannot be exported"
                              f": {said[-1] if said else 'no program'}")


def as_written(entry, value):
    """A value of an input with its unit, as the program reads it."""
    factor, offset = UNITS.get(entry["unit"], (1., 0.))
    unit = "" if entry["unit"] == "1" else " " + entry["unit"]
    return f"{factor * value + offset:.12g}{unit}"


def law_section(document):
    """Sliders and answers; report_law.js fills them."""
    rows = [("95 % interval of another run", tag("span", id="law-run")),
            ("95 % interval of the whole surface",
             tag("span", id="law-surface")),
            ("shear limit k of the chip", tag("span", id="law-k")),
            ("shear stress min(µ p, k)", tag("span", id="law-tau"))]
    answer = tag("div", tag("span", "µ = ", tag("span", id="law-mu"),
                            class_="mu"), tag("span", id="law-trust",
                                              class_="trust"),
                 tag("p", id="law-why", class_="why"),
                 table(None, rows), class_="answer")
    keys = [("run", "rgba(18,53,91,.25)", "95 % of a run"),
            ("surface", "rgba(18,53,91,.1)", "95 % of the surface"),
            ("box", "rgba(217,164,65,.25)", "range of the data")]
    key = tag("div", *[tag("span", tag("i", style=f"background:{colour}"), text)
                       for _, colour, text in keys],
              tag("span", "full line: trusted"), class_="key")
    plot = tag("div", tag("label", "µ over ", tag("select", id="law-over")),
               Html('<svg id="law-plot" class="plot" viewBox="0 0 560 330" '
                    'role="img" aria-label="mu over one input"></svg>'), key)
    return Section(
        "The law", tag("noscript", "The sliders need JavaScript."),
        tag("p", id="law-line", class_="interval"),
        tag("div", tag("div", tag("div", id="law-sliders"), answer), plot,
            class_="law"),
        tag("p", mechanisms_text(document), class_="why"))


def mechanisms_text(document):
    found = document.get("mechanisms") or []
    if not found:
        return "Which mechanisms are in this µ is not known."
    text = "In this µ: " + ", ".join(map(str, found)) + "."
    if "interface shear" not in found and "measurements" not in found:
        text += " Adhesion, the shear of the dry interface, is not."
    return text


def quality_section(document, summary):
    """How good the law is, and what it rests on."""
    runs, test = summary.get("runs", {}), summary.get("test", {})
    topography = document.get("topography", {})
    n = len(value_of(document, "data", "y") or [])
    tested = test.get("runs") or 0
    top = [("training points", f"{n}", f"{runs.get('failed', 0)} runs failed"),
           ("error, leave one out",
            percent(document.get("leave_one_out_error")), "mean, relative"),
           ("error on test runs",
            percent(test.get("mean_relative_error")) if tested else "–",
            f"{tested} runs, largest {percent(test.get('largest_relative_error'))}"
            if tested else "no test runs"),
           ("test runs in the 95 % interval",
            percent(test.get("coverage_95"), 3) if tested else "–", None)]
    profiles = topography.get("profiles", 1)
    rows = [("what it gives", value_of(document, "output", "name")),
            ("model", model_text(document)),
            ("profiles of the surface", str(profiles) if profiles > 1 else
             "one: how far others differ is not known"),
            ("they differ by (standard deviation)",
             percent(topography.get("scatter")) if profiles > 1 else None),
            ("mean over the whole surface within (95 %)",
             percent(topography.get("error")) if profiles > 1 else None),
            ("a patch of the surface lies off these profiles in plane strain "
             "by", plane_strain_text(document)),
            ("base scene", summary.get("base_scene")),
            *[(f"for comparison: {name}",
               f"{law['law']}, error {percent(law.get('leave_one_out_error'))}")
              for name, law in (summary.get("power_laws") or {}).items()
              if isinstance(law, dict) and "law" in law]]
    ranges = [(entry["name"], entry["symbol"], shown(entry, "lower"),
               shown(entry, "upper"), entry["scale"],
               percent(value_of(summary, "sensitivity", entry["symbol"], "ST"), 3))
              for entry in document["inputs"]]
    return Section("How good it is", tiles(top), facts(rows),
                   tag("h3", "Inputs"),
                   table(("entry", "symbol", "from", "to", "scale",
                          "share of the variance"), ranges, (2, 3, 5)))


def plane_strain_text(document):
    for choice in document.get("choices") or []:
        if choice.get("kind") == "plane strain":
            return (f"-{percent(choice.get('below'))} to "
                    f"+{percent(choice.get('above'))}")
    return None


def model_text(document):
    if document.get("model") == "piecewise power law":
        return "piecewise power law over the velocity, fitted to measurements"
    kernel = {"rbf": "squared exponential", "matern_3_2": "Matérn 3/2",
              "matern_5_2": "Matérn 5/2"}.get(document.get("kernel"), "?")
    text = f"Gaussian process, {kernel}"
    if document.get("pressure_over_strength"):
        text += ", over pressure over shear strength"
    return text


def read_law(folder):
    path = os.path.join(folder, "friction_law.json")
    if not os.path.exists(path):
        raise ReportError(f"{folder} is the folder of a campaign without a law "
                          "yet; 'asperity characterize' goes on with it and "
                          "writes friction_law.json.")
    document = read_json(path, "a friction law")
    try:
        for entry in document["inputs"]:
            for key in ("name", "symbol", "unit", "lower", "upper", "scale"):
                entry[key]
        document["output"]["name"]
    except (KeyError, TypeError):
        raise ReportError(f"{path} is no friction law; the file that 'asperity "
                          "characterize' wrote is expected.")
    return path, document


def report_law(folder, arguments):
    """Lead, sections and scripts of a campaign's report."""
    path, document = read_law(folder)
    law = exported_law(path, document, arguments)
    summary = {}
    if os.path.exists(os.path.join(folder, "summary.json")):
        summary = read_json(os.path.join(folder, "summary.json"),
                            "the summary of a campaign")
    sensitivity = sensitivity_beside(folder, arguments.sensitivity)
    ranges = ", ".join(f"{shown(entry, 'lower')} to {shown(entry, 'upper')}"
                       for entry in document["inputs"])
    lead = tag("p", "A friction law over "
               + ", ".join(entry["name"].split("/")[-1].lower()
                           for entry in document["inputs"])
               + f": {ranges}.")
    said = list(summary.get("warnings") or document.get("warnings") or [])
    sections = [law_section(document), quality_section(document, summary)]
    if sensitivity is not None:
        sections.append(choices_section(sensitivity))
    sections += [
        Section("Pictures", *draw("plot_law.py", folder, PICTURES)),
        Section("Warnings", warnings(said)),
        repeat_section(
            folder, value_of(document, "provenance", "program"), "campaign.prm",
            "asperity characterize",
            "The file has every entry of the campaign, and base_scene.prm beside "
            "it those of the scene. In the same folder the campaign goes on from "
            "its runs; another Campaign/Output directory computes all anew.")]
    scripts = [script(law), data_script("report_choices", groups_of(sensitivity)),
               script(own_file("report_law.js"))]
    return "friction law", lead, sections, scripts
