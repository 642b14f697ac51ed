"""Maps of outcomes: small multiples, one picture a mode."""

import os

import numpy as np

from .mode import OUTCOMES, number

# Of M. Okabe and K. Ito, told apart by all kinds of colour blindness; letters
# tell them in print, too.
COLOURS = dict(zip(OUTCOMES,
                   ("#009e73", "#56b4e9", "#d55e00", "#f0e442", "#000000")))
LETTERS = dict(zip(OUTCOMES, ("", "s", "W", "N", "H")))


def ordered(axis, rows):
    """Values of an axis: numbers by size, words as they come."""
    values = list(dict.fromkeys(row[axis.setting] for row in rows))
    try:
        return sorted(values, key=number)
    except ValueError:
        return values


def draw_map(mode, rows, folder):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    x, y, panels = (ordered(axis, rows)
                    for axis in (mode.x, mode.y, mode.panels))
    n_columns = min(3, len(panels))
    n_rows = -(-len(panels) // n_columns)
    width = max(2.6, 0.36 * len(x) + 0.9)
    height = max(1.5, 0.27 * len(y) + 0.95)
    figure, axes = plt.subplots(
        n_rows, n_columns, squeeze=False, sharex=True, sharey=True,
        figsize=(min(12., max(5.2, width * n_columns + 0.5)),
                 height * n_rows + 1.1))
    for axis, panel in zip(axes.flat, panels):
        codes = np.full((len(y), len(x)), np.nan)
        for row in rows:
            if row[mode.panels.setting] == panel:
                i = y.index(row[mode.y.setting])
                j = x.index(row[mode.x.setting])
                codes[i, j] = OUTCOMES.index(row["outcome"])
                letter = LETTERS[row["outcome"]]
                axis.text(j, i, letter, ha="center", va="center", fontsize=7,
                          color="white" if letter in "WH" else "black")
        axis.imshow(codes, cmap=ListedColormap(list(COLOURS.values())), vmin=0,
                    vmax=len(OUTCOMES) - 1, origin="lower", aspect="auto")
        axis.set_xticks(range(len(x)), [mode.x.name(v) for v in x],
                        fontsize=7, rotation=90 if len("".join(x)) > 30 else 0)
        axis.set_yticks(range(len(y)), [mode.y.name(v) for v in y], fontsize=7)
        axis.set_xticks(np.arange(len(x) + 1) - 0.5, minor=True)
        axis.set_yticks(np.arange(len(y) + 1) - 0.5, minor=True)
        axis.grid(which="minor", color="white", linewidth=1.5)
        axis.tick_params(which="both", length=0)
        axis.set_title(mode.panels.name(panel), fontsize=8)
    for axis in list(axes.flat)[len(panels):]:
        axis.axis("off")
    figure.supylabel(mode.y.label, fontsize=8)
    figure.suptitle(f"{mode.name}  {mode.title}", fontsize=9)
    found = [o for o in OUTCOMES if any(r["outcome"] == o for r in rows)]
    inch = 1. / figure.get_figheight()
    figure.tight_layout(rect=(0.01, 0.45 * inch, 1, 1))
    figure.supxlabel(mode.x.label, fontsize=8, y=0.28 * inch)
    figure.legend(handles=[Patch(color=COLOURS[o],
                                 label=o + (f" ({LETTERS[o]})" if LETTERS[o]
                                            else "")) for o in found],
                  loc="lower center", ncol=len(found), fontsize=7,
                  frameon=False)
    path = os.path.join(folder, f"{mode.name}.png")
    figure.savefig(path, dpi=130)
    plt.close(figure)
