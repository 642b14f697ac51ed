#!/usr/bin/env python3
"""Prints a page, which is written as GitHub reads it, as Doxygen reads it:
formulas, and headings with labels that links can lead to."""

import pathlib
import re
import sys


def anchor(heading):
    """What GitHub makes of a heading."""
    text = re.sub(r"[`*]", "", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def label(page, heading_anchor):
    """Labels of Doxygen are those of all pages."""
    return f"{pathlib.Path(page).stem}-{heading_anchor}"


def main():
    page = sys.argv[1]
    text = pathlib.Path(page).read_text(encoding="utf-8")
    text = re.sub(r"^```math\n(.*?)^```$", r"\\f[\n\1\\f]", text,
                  flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"\$`([^`]*)`\$", r"\\f$\1\\f$", text)
    text = re.sub(r"^(##+ +)(.*)$",
                  lambda m: f"{m[0]} {{#{label(page, anchor(m[2]))}}}", text,
                  flags=re.MULTILINE)
    text = re.sub(r"\]\(([\w./-]*)#([\w-]+)\)",
                  lambda m: f"](#{label(m[1] or page, m[2])})", text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
