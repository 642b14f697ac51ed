"""The page of a folder of sweeps: the table of all modes, and their maps."""

import os
import re

from .mode import OUTCOMES

HEAD = """# Where methods fail: the stability map

Written by `tools/stability`; do not edit. Each row is a failure mode that is
known from the literature or from other programs, swept over a range that goes
beyond what is sensible. A cell is *right* if the stated identity, formula or
reference is met within the stated band; it *ended with a sentence* if the
program ended with a non-zero status and one sentence, or ended with a warning
about this failure; it is *wrong* if it is outside of the band without a word,
*not finite*, or *hung*.

    tools/stability [--full] [MODE ...]

draws the maps again, and goes on where it was stopped.

| mode | failure | swept | """ + " | ".join(OUTCOMES) + """ | what it shows |
|""" + " --- |" * (4 + len(OUTCOMES)) + "\n"


def count(rows):
    return [sum(row["outcome"] == outcome for row in rows)
            for outcome in OUTCOMES]


def write_page(folder, tables):
    """@param tables list of (mode, rows, head of the CSV)"""
    text = HEAD
    total = [0] * len(OUTCOMES)
    for mode, rows, _ in tables:
        counts = count(rows)
        total = [a + b for a, b in zip(total, counts)]
        text += (f"| [{mode.name}](#{mode.name.lower()}) | {mode.title} | "
                 f"{mode.swept} | " + " | ".join(map(str, counts)) +
                 f" | {mode.conclusion} |\n")
    text += (f"| | {len(tables)} modes, {sum(total)} cells | | " +
             " | ".join(map(str, total)) + " | |\n")
    for mode, rows, head in tables:
        text += (f"\n## {mode.name}\n\n{mode.question} Swept: {mode.swept}. "
                 f"Right: {mode.band}. {mode.conclusion}\n\n"
                 f"![{mode.name}]({mode.name}.png)\n\n")
        told = {row["sentence"] for row in rows
                if row["outcome"] == OUTCOMES[1]}
        if told:
            # The file is one that the sweep has made.
            longest = re.sub(r"^scene\.prm(, line \d+)?[:,] ", "",
                             max(told, key=len))
            text += f"One of the sentences: {longest}\n\n"
        text += f"[{mode.name}.csv]({mode.name}.csv), " + "; ".join(
            line for line in head
            if line.startswith(("program", "machine", "date"))) + ".\n"
    path = os.path.join(folder, "README.md")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".part", path)
