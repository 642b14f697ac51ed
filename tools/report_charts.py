"""The sections of a report of charts: each folder's README.md, pictures and
tables."""

import csv
import os
import re

from report_page import (Html, ReportError, Section, command, details, join,
                         picture, read_text, table, tag)

MOST_ROWS = 200  # of a table that are shown


def inline(text):
    """Code, strong words and links of a line of Markdown; the latter only as
    text, since what they point at is not in the page."""
    parts = re.split(r"(`[^`]+`|\*\*[^*]+\*\*|!?\[[^\]]*\]\([^)]*\))", text)
    shown = []
    for part in parts:
        link = re.fullmatch(r"(!?)\[([^\]]*)\]\(([^)]*)\)", part)
        if part.startswith("`") and part.endswith("`") and len(part) > 2:
            shown.append(tag("code", part[1:-1]))
        elif part.startswith("**") and part.endswith("**") and len(part) > 4:
            shown.append(tag("strong", part[2:-2]))
        elif link:
            if link.group(1):
                continue  # a picture, which the folder shows itself
            if re.match(r"https?://", link.group(3)):
                shown.append(tag("a", link.group(2), href=link.group(3)))
            else:
                shown.append(tag("span", link.group(2)))
        else:
            shown.append(tag("span", part) if part else Html(""))
    return join(shown)


def markdown(text):
    """Headings, paragraphs, lists, tables and code of a README.md; its first
    heading is left out, since it is the title."""
    blocks = re.split(r"\n\s*\n", text.strip())
    shown = []
    for number, block in enumerate(blocks):
        lines = block.splitlines()
        heading = re.match(r"#+\s*(.*)", lines[0])
        if heading:
            if number > 0:
                shown.append(tag("h3", inline(heading.group(1))))
            lines = lines[1:]
        if not lines:
            continue
        if all(line.startswith("    ") or not line.strip() for line in lines):
            shown.append(command(*[line[4:] for line in lines]))
        elif lines[0].lstrip().startswith("|") and len(lines) > 1:
            cells = [[inline(cell.strip()) for cell in
                      line.strip().strip("|").split("|")] for line in lines]
            shown.append(table(cells[0], cells[2:]))
        elif re.match(r"\s*([-*]|\d+\.)\s", lines[0]):
            items = re.split(r"\n\s*(?:[-*]|\d+\.)\s+", "\n" + "\n".join(lines))
            shown.append(tag("ul", *[tag("li", inline(" ".join(item.split())))
                                     for item in items if item.strip()]))
        else:
            shown.append(tag("p", inline(" ".join(" ".join(lines).split()))))
    return shown


def table_of(path):
    """A CSV as a table, its comments in front; what is too long is cut."""
    name, text = os.path.basename(path), read_text(path)
    if text is None:
        return tag("p", f"{name} cannot be read.", class_="missing")
    comments = [line.lstrip("# ") for line in text.splitlines()
                if line.startswith("#")]
    try:
        rows = list(csv.reader(line for line in text.splitlines()
                               if line.strip() and not line.startswith("#")))
    except csv.Error as error:
        return tag("p", f"{name} is no table: {error}.", class_="missing")
    cut = "" if len(rows) <= MOST_ROWS + 1 else (
        f", the first {MOST_ROWS} of {len(rows) - 1} rows")
    return tag("details", tag("summary", name + cut),
               tag("pre", "\n".join(comments)) if comments else None,
               table(rows[0], rows[1:MOST_ROWS + 1]) if rows else None)


def pictures_of(folder, names):
    """PNG files, and SVG where there is no PNG of the name."""
    shown = [name for name in names if name.endswith(".png")]
    shown += [name for name in names if name.endswith(".svg")
              and name[:-4] + ".png" not in names]
    return [picture(os.path.join(folder, name),
                    name[:-4].replace("_", " ")) for name in shown]


def is_chart(folder):
    if not os.path.isdir(folder):
        return False
    names = os.listdir(folder)
    return (any(name.endswith((".png", ".svg")) for name in names)
            and any(name.endswith(".csv") for name in names)
            and not {"friction.csv", "runs.csv"} & set(names))


def chart_section(folder):
    """Title, text, pictures and tables of a folder."""
    names = sorted(os.listdir(folder))
    text = read_text(os.path.join(folder, "README.md")) or ""
    heading = re.match(r"#+\s*(.*)", text.strip())
    base = os.path.basename(os.path.abspath(folder))
    name = re.sub(r"^(\d+)_", r"\1 ", base).replace("_", " ")
    title = heading.group(1) if heading else name
    said = (markdown(text) if text.strip() else
            [tag("p", "The folder has no README.md.", class_="missing")])
    shown = pictures_of(folder, names) or [
        tag("p", "The folder has no picture yet.", class_="missing")]
    return Section(title, *said, *shown,
                   *[table_of(os.path.join(folder, name)) for name in names
                     if name.endswith(".csv")],
                   *[details(name, read_text(os.path.join(folder, name)) or "")
                     for name in names
                     if name.endswith((".json", ".prm"))])


def folders_of_charts(folder):
    """Folders of charts in order; empty if there are none."""
    found = [os.path.join(folder, name) for name in os.listdir(folder)
             if re.match(r"\d+_", name) or is_chart(os.path.join(folder, name))]
    return sorted((path for path in found if os.path.isdir(path)), key=chart_key)


def chart_key(path):
    number, _, rest = os.path.basename(path).partition("_")
    return (int(number) if number.isdigit() else 10**6, rest, path)


def report_charts(folder, _):
    """Lead and sections of a folder of charts, or of a single one."""
    folders = [folder] if is_chart(folder) else folders_of_charts(folder)
    text = read_text(os.path.join(folder, "README.md"))
    lead = tag("p", f"{len(folders)} charts.") if is_chart(folder) or not text \
        else tag("div", *markdown(text)[:1])
    sections = [chart_section(path) for path in folders]
    if not sections:
        raise ReportError(f"{folder} has no charts.")
    return "charts", lead, sections, []
