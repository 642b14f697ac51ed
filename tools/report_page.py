"""What the pages of tools/report are made of: escaped text, tables, pictures and
bars, and the page itself, which needs nothing but its own file."""

import base64
import html
import json
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


class ReportError(Exception):
    """A folder or file is none that can be reported; the message is for the
    user."""


class Html(str):
    """Text that is HTML already; all other text is escaped."""


def tag(name, *content, **attributes):
    """An element; None among content and attributes is left out."""
    words = "".join(f' {key.rstrip("_")}="{html.escape(str(value))}"'
                    for key, value in attributes.items() if value is not None)
    inner = "".join(part if isinstance(part, Html) else html.escape(str(part))
                    for part in content if part is not None)
    if name in ("img", "input", "br", "meta"):
        return Html(f"<{name}{words}>")
    return Html(f"<{name}{words}>{inner}</{name}>")


def join(parts, between=""):
    return Html(between.join(parts))


def number(value, digits=4):
    """As people write it: 0.02313, 1.2e-5, 8 100."""
    try:
        value = float(value)
    except (TypeError, ValueError):
        return "–"
    if not math.isfinite(value):
        return "–"
    text = f"{value:.{digits}g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        if 0 <= int(exponent) < 7:
            return f"{value:.0f}".replace("-", "−")
        text = f"{mantissa}e{int(exponent)}"
    return text.replace("-", "−")


def percent(share, digits=2):
    return "–" if share is None else f"{number(100. * share, digits)} %"


def error_text(below, above):
    """"± 0.002", or "+0.065 −0.016" where the ends differ."""
    above_text, below_text = number(above, 2), number(below, 2)
    if above_text == below_text:
        return f"± {above_text}"
    return f"+{above_text} −{below_text}"


def interval_line(mu, parts, symbol="µ"):
    """mu = 0.31 ± 0.002 (numerics) ± 0.04 (preparation) ...
    @param parts name, error below and above, absolute"""
    words = [tag("span", f"{error_text(below, above)} ",
                 tag("small", f"({name})"), class_="error")
             for name, below, above in parts if below > 0. or above > 0.]
    return tag("p", tag("strong", f"{symbol} = {number(mu)}"), " ",
               join(words, " "), class_="interval")


def table(head, rows, numeric=(), class_=None):
    """@param numeric columns that are set flush right"""
    def row(cells, name):
        return tag("tr", *[tag(name, cell, class_="number" if i in numeric
                               else None) for i, cell in enumerate(cells)])
    body = [tag("tbody", *[row(cells, "td") for cells in rows])]
    if head:
        body.insert(0, tag("thead", row(head, "th")))
    return tag("div", tag("table", *body, class_=class_), class_="scroll")


def facts(pairs):
    """A table of names and values; what is None is left out."""
    return table(None, [(name, value) for name, value in pairs
                        if value is not None], class_="facts")


def tiles(pairs):
    """Large numbers: (name, value, remark)."""
    return tag("div", *[tag("div", tag("span", name, class_="name"),
                            tag("span", value, class_="value"),
                            tag("span", remark, class_="remark"), class_="tile")
                        for name, value, remark in pairs], class_="tiles")


def bar(share, class_="bar"):
    """A bar of a share of the width of its cell."""
    width = 100. * min(max(share, 0.), 1.)
    return tag("span", tag("i", style=f"width:{width:.1f}%"), class_=class_)


def change_bar(below, above, largest):
    """A bar on both sides of a middle line: changes from -below to +above."""
    left = 50. - 50. * max(below, 0.) / largest
    width = 50. * (max(below, 0.) + max(above, 0.)) / largest
    return tag("span", tag("i", style=f"left:{left:.1f}%;width:{width:.1f}%"),
               class_="change")


class Section:
    """A part of the page with its title, which the list of contents shows."""

    def __init__(self, title, *content):
        self.title = title
        self.anchor = "".join(c for c in title.lower().replace(" ", "-")
                              if c.isalnum() or c == "-")
        self.html = tag("section", tag("h2", title), *content, id=self.anchor)


def picture(path, caption):
    """A PNG or SVG as a part of the page."""
    kind = "svg+xml" if path.endswith(".svg") else "png"
    try:
        with open(path, "rb") as file:
            data = base64.b64encode(file.read()).decode()
    except OSError as error:
        return tag("p", f"{path} cannot be read: {error.strerror}.",
                   class_="missing")
    return tag("figure", tag("img", src=f"data:image/{kind};base64,{data}",
                             alt=caption), tag("figcaption", caption))


def warnings(texts):
    if not texts:
        return tag("p", "None.")
    return tag("ul", *[tag("li", text) for text in texts], class_="warnings")


def details(title, text):
    """A text that is shown on demand."""
    return tag("details", tag("summary", title), tag("pre", text))


def command(*words):
    return tag("pre", "\n".join(words), class_="command")


def program_line(program):
    """asperity 0.1.0 (52be1e8, Release, deal.II 9.4.1, ...)"""
    if not isinstance(program, dict):
        return "unknown"
    rest = [value if key in ("git_revision", "build_type") else f"{key} {value}"
            for key, value in program.items() if key != "asperity"]
    return f"asperity {program.get('asperity', '')} ({', '.join(rest)})"


def script(text):
    """JavaScript as a part of the page, which it must not end."""
    text = text.replace("</", "<\\/").replace("<!--", "<\\!--")
    return Html(f"<script>\n{text}\n</script>\n")


def data_script(name, value):
    """A value as a constant of the page's scripts."""
    text = json.dumps(value).replace("<", "\\u003c")
    return Html(f"<script>const {name} = {text};</script>\n")


def own_file(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return file.read()


def page(kind, title, lead, sections, scripts=()):
    """The whole document."""
    contents = tag("nav", *[tag("a", part.title, href="#" + part.anchor)
                            for part in sections])
    return ("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
            "<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, "
            "initial-scale=1\">\n"
            + tag("title", f"{title}: {kind}")
            + f"\n<style>\n{own_file('report_page.css')}</style>\n</head>\n<body>\n"
            + tag("header", tag("p", f"Asperity · {kind}", class_="kind"),
                  tag("h1", title), lead)
            + contents + tag("main", *[join([part.html, "\n"]) for part in sections])
            + "\n" + "".join(scripts) + "</body>\n</html>\n")


def read_json(path, what):
    try:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
    except (OSError, UnicodeDecodeError) as error:
        raise ReportError(f"{path} cannot be read: {error}.")
    except ValueError as error:
        raise ReportError(f"{path} is not JSON ({error}); {what} is expected.")
    if not isinstance(document, dict):
        raise ReportError(f"{path} holds no object; {what} is expected.")
    return document


def read_text(path):
    """The text of a file, or None."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return None
