#!/usr/bin/python3
"""tools/charts end to end, on scenes that are made tiny on their way to the program.

    tests/command_line/charts.py PROGRAM

Draws one chart, some of whose runs fail; draws it again, when no run may be made
twice; again after one run's record is gone; and reads the sentences about a chart
and programs that do not exist. Then it draws every chart without a program from the
tables of parameter_files/charts, whose pages must say what the tables do, and again
with a run that failed. Exit status 77 (skipped) without matplotlib.
"""

import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHARTS = ROOT / "tools" / "charts"
RESULTS = ROOT / "parameter_files" / "charts"
CHART = "3_time_steps"

# Counts its runs, refuses those of 48 steps, and makes the others tiny.
TINY = """#!/bin/sh
if [ "$1" = --version ]; then echo tiny 1; exit; fi
echo run >> {folder}/runs
if grep -q 'Slide steps = 48' "$1"; then
  echo 'Error: Refused.' >&2; exit 1
fi
cat > "$1.tiny.prm" <<END
include $1
subsection Mesh
  set Spans = 16
  set Refinement levels = 0
end
subsection Load
  set Pressure = 5 MPa
end
subsection Protocol
  set End time = 0.01 us
  set Ramp steps = 2
  set Slide steps = 2
end
END
exec {program} "$1.tiny.prm"
"""


def expect(truth, what):
    if not truth:
        sys.exit(f"FAILED: {what}")


class Test:
    def __init__(self, program, folder):
        self.folder = pathlib.Path(folder)
        self.program = self.folder / "asperity"
        self.program.write_text(TINY.format(folder=folder, program=program))
        self.program.chmod(0o755)

    def charts(self, *arguments):
        """(exit status, output, messages, runs that were made)"""
        count = self.folder / "runs"
        count.write_text("")
        done = subprocess.run(
            [CHARTS, "--to", self.folder / "to", *arguments],
            capture_output=True, text=True, check=False)
        return (done.returncode, done.stdout, done.stderr,
                len(count.read_text().splitlines()))

    def draw(self):
        status, output, messages, n_runs = self.charts(
            "--asperity", self.program, "--jobs", "1", CHART)
        expect(status == 0, f"{CHART} is drawn: {messages}")
        return output, n_runs

    def refuses(self, sentence, *arguments):
        status, _, messages, n_runs = self.charts(*arguments)
        expect(status == 2 and n_runs == 0, f"{arguments} are refused")
        expect(messages.startswith("Error: " + sentence) and
               messages.count("\n") == 1, f"'{messages}' is one sentence and "
               f"begins with '{sentence}'")

    def reads_results(self, n_runs):
        chart = self.folder / "to" / CHART
        lines = (chart / "numbers.csv").read_text().splitlines()
        head = [line for line in lines if line.startswith("#")]
        for part in ("# machine: ", "# program: tiny 1",
                     "# scene.prm: Mesh/Spans = 80", "# times: "):
            expect(any(line.startswith(part) for line in head),
                   f"the head of the table says '{part}'")
        rows = list(csv.DictReader(lines[len(head):]))
        expect(len(rows) == n_runs, f"{len(rows)} rows for {n_runs} runs")
        failed = {row["run"] for row in rows if row["failed"]}
        expect(failed == {"quasi-static, 12 + 48 steps",
                          "dynamic, 12 + 48 steps"}, f"{failed} have failed")
        expect(all(row["failed"] == "Refused." for row in rows
                   if row["run"] in failed), "the reasons are in the table")
        page = (chart / "README.md").read_text()
        expect("- dynamic, 12 + 48 steps: Refused." in page,
               "the page lists what failed")
        reads_picture(chart)

    def redraws(self):
        """Each chart from the numbers that are in the repository."""
        to = self.folder / "redrawn"
        names = sorted(path.parent.name
                       for path in RESULTS.glob("[0-9]*_*/numbers.csv"))
        for name in names:
            (to / name).mkdir(parents=True)
            for table in (RESULTS / name).glob("*.csv"):
                shutil.copy(table, to / name)
        for failed in (False, True):
            if failed:
                for name in names:
                    fail_last_run(to / name / "numbers.csv")
            status, output, messages, _ = self.charts("--to", to, "--redraw",
                                                          *names)
            expect(status == 0, f"the charts are redrawn: {messages}")
            for name in names:
                expect(f"{name}: drawn from its table" in output,
                       f"{name} is redrawn: {output}")
                reads_picture(to / name)
                page = (to / name / "README.md").read_text()
                if failed:
                    expect("\n- a run: Refused." in page, f"{name} says what failed")
                else:
                    expect(page == (RESULTS / name / "README.md").read_text(),
                           f"the page of {name} says what its table does")
        table = to / names[0] / "numbers.csv"
        table.unlink()
        self.refuses(f"There is no table '{table}' to draw from; expected is ",
                     "--to", to, "--redraw", names[0])


def reads_picture(chart):
    picture = (chart / "chart.png").read_bytes()
    expect(picture.startswith(b"\x89PNG") and len(picture) > 10000,
           f"there is a picture in {chart}")
    expect("<svg" in (chart / "chart.svg").read_text(), "also as SVG")


def fail_last_run(path):
    """Takes the numbers of the last row of a table away."""
    lines = path.read_text().splitlines()
    head = [line for line in lines if line.startswith("#")]
    rows = list(csv.DictReader(lines[len(head):]))
    for key in rows[-1]:
        if key.startswith(("mu", "time", "iterations", "error", "change of mu",
                           "off", "test", "factorisation", "memory")):
            rows[-1][key] = "nan"
    rows[-1]["failed"] = "Refused."
    with open(path, "w", newline="", encoding="utf-8") as file:
        file.writelines(f"{line}\n" for line in head)
        file.write("# failed: a run: Refused.\n")
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(rows)


def main(program):
    if subprocess.run(["/usr/bin/python3", "-c", "import matplotlib"],
                      capture_output=True, check=False).returncode != 0:
        print("There is no matplotlib here; nothing was tested.")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        test = Test(os.path.abspath(program), folder)
        output, n_runs = test.draw()
        expect(n_runs > 5 and f"{n_runs} runs, {n_runs} of them new" in output,
               f"'{output}' tells the {n_runs} runs")
        test.reads_results(n_runs)
        output, again = test.draw()
        expect(again == 0 and f"{n_runs} runs, 0 of them new" in output,
               f"no run is made twice, but {again} were")
        record = next((test.folder / "to" / CHART / "runs").glob("*/ref*/run.json"))
        record.unlink()
        expect(test.draw()[1] == 1, "a stopped chart goes on with what is missing")
        record.write_text(record.read_text().replace("Spans = 80", "Spans = 81"))
        expect(test.draw()[1] == 1, "a run with other settings is made again")
        test.refuses("There is no chart '12'; expected is the number or the "
                     "beginning of the name of one of 1_error_over_time, ",
                     "--asperity", test.program, "12")
        missing = test.folder / "missing"
        test.refuses(f"The program '{missing}' cannot be run; expected is ",
                     "--asperity", missing, "3")
        benchmark = test.folder / "tools" / "benchmarks" / "contact_benchmarks"
        test.refuses(f"There is no benchmark '{benchmark}', ", "--asperity",
                     test.program, "2")
        test.redraws()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
