"""A chart: its runs, its tables of numbers, its picture and its page. A module
measures, which writes tables, and shows, which reads nothing but them."""

import csv
import datetime
import os
import platform

import matplotlib
import numpy as np

from .scene_runs import ROOT, RunError, RunKeeper, processor
from .style import distance_to_front, plt

NEAR = 1.25  # how far from the Pareto front is still near it


class Chart:
    """What a module draws with. `full` says that points need not be few; without
    a program it is shown from the tables that are there."""

    def __init__(self, name, to, program, full, jobs):
        self.name, self.program = name, program
        self.folder = os.path.join(os.path.abspath(to), name)
        self.source = os.path.join(ROOT, "parameter_files", "charts", name)
        if program is None:
            full = "full mode" in self.head()[0]
        self.full, self.mode = full, "full" if full else "quick"
        self.keeper = RunKeeper(os.path.join(self.folder, "runs", self.mode),
                                program, 3600 if full else 150, jobs)
        self.verdict = None
        os.makedirs(self.folder, exist_ok=True)

    def scenes(self, scenes, file="scene.prm"):
        """Runs the chart's parameter file with entries changed: {name:
        entries} to {name: Run}."""
        return self.keeper.scenes(scenes, os.path.join(self.source, file))

    def benchmark(self, program, *arguments):
        """Runs a benchmark of tools/benchmarks, which writes its tables into
        the run's folder."""
        name = " ".join((program, *arguments))
        folder = self.keeper.folder_of(name)
        return self.keeper.run(name, folder, name,
                               [self.program.benchmark(program), folder,
                                *arguments])

    def settings(self):
        """The entries that the chart's parameter files set, for the head of
        the table."""
        lines = []
        for name in sorted(os.listdir(self.source)):
            if not name.endswith(".prm"):
                continue
            section = []
            with open(os.path.join(self.source, name), encoding="utf-8") as file:
                for line in file:
                    line = line.split("#")[0].strip()
                    if line.startswith("subsection "):
                        section.append(line[11:])
                    elif line == "end":
                        section.pop()
                    elif line.startswith("set "):
                        key, value = line[4:].split("=", 1)
                        lines.append(f"{name}: {'/'.join(section)}/"
                                     f"{key.strip()} = {value.strip()}")
        return lines

    def table(self, rows, times=None, name="numbers.csv",
              clock="processor time"):
        """Writes rows (dictionaries) as CSV, with machine, versions and
        settings in its head. times: what a time of 1 is, by which clock."""
        head = [f"{self.name}, {self.mode} mode, "
                f"{datetime.date.today().isoformat()}",
                f"machine: {processor()}", f"program: {self.program.version}",
                f"Python {platform.python_version()}, numpy {np.__version__}, "
                f"matplotlib {matplotlib.__version__}"]
        if times:
            head.append(f"times: {clock}, 1 is {times}")
        head += self.settings()
        head += [f"failed: {run}: {why}" for run, why in self.keeper.failures]
        columns = list(dict.fromkeys(key for row in rows for key in row))
        with open(os.path.join(self.folder, name), "w", newline="",
                  encoding="utf-8") as file:
            file.writelines(f"# {line}\n" for line in head)
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            for row in rows:
                writer.writerow(_text(row.get(key, "")) for key in columns)

    def lines(self, name):
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            raise RunError(f"There is no table '{path}' to draw from; expected is "
                           "one that the chart has written before.")
        with open(path, encoding="utf-8") as file:
            return file.read().splitlines()

    def head(self):
        return [line[2:] for line in self.lines("numbers.csv")
                if line.startswith("# ")]

    def rows(self, name="numbers.csv"):
        """The rows of a table that has been written, numbers as numbers."""
        lines = [line for line in self.lines(name) if not line.startswith("#")]
        return [{key: _number(value) for key, value in row.items()}
                for row in csv.DictReader(lines)]

    def picture(self, figure):
        for ending, dpi in (("png", 110), ("svg", 72)):
            figure.savefig(os.path.join(self.folder, f"chart.{ending}"),
                           dpi=dpi, metadata={"Date": None}
                           if ending == "svg" else None)
        plt.close(figure)

    def judge(self, default, others, what="error"):
        """Whether the default (cost, error) lies on or near the Pareto front
        of others, {name: (cost, error)}; a sentence."""
        names = list(others)
        plain = what.split(" [")[0]
        factor, k = distance_to_front(default, [others[n] for n in names])
        if factor <= 1.:
            return f"The default lies on the Pareto front of cost and {plain}."
        where = "near" if factor <= NEAR else "OFF"
        sentence = (f"The default lies {where} the Pareto front of cost and "
                    f"{plain}: '{names[k]}' is better in both by a factor of at "
                    f"least {factor:.2f} (cost {others[names[k]][0]:.3g} against "
                    f"{default[0]:.3g}, {what} {others[names[k]][1]:.3g} "
                    f"against {default[1]:.3g}).")
        if where == "OFF":
            self.verdict = sentence
        return sentence

    def page(self, title, *paragraphs):
        """Writes README.md: title, picture, conclusion, what failed."""
        text = [f"# {title}", *paragraphs, f"![{title}](chart.png)"]
        failures = [line[8:] for line in self.head() if line.startswith("failed: ")]
        if failures:
            text.append("Without result, and marked in the chart:\n\n" + "\n".join(
                f"- {failure}" for failure in failures))
        text.append(f"Numbers, machine, versions and settings are in "
                    f"[numbers.csv](numbers.csv). Drawn in {self.mode} mode by\n\n"
                    f"    tools/charts{' --full' if self.full else ''} "
                    f"{self.name}")
        with open(os.path.join(self.folder, "README.md"), "w",
                  encoding="utf-8") as file:
            file.write("\n\n".join(text) + "\n")

    def report(self):
        """One line about what has been done, and one where it matters."""
        keeper = self.keeper
        made = (f"{keeper.n_new + keeper.n_kept} runs, {keeper.n_new} of them new, "
                f"{len(keeper.failures)} failed" if self.program else
                "drawn from its table")
        line = f"{self.name}: {made}; {os.path.join(self.folder, 'chart.png')}"
        return line if self.verdict is None else f"{line}\n  {self.verdict}"


def _text(value):
    if isinstance(value, float):
        return f"{value:.6g}"
    return value


def _number(text):
    try:
        return float(text)
    except ValueError:
        return text
