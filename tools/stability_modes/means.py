"""The programs that a sweep asks: asperity, and stability_sweeps for points,
elements and problems that no parameter file describes."""

import csv
import json
import os
import re
import select
import shutil
import signal
import subprocess
import tempfile
import threading
import time

from .mode import Measurement, exceeds

# The limit of a cell is processor time, so that a busy machine makes no hang;
# one that waits for ever ends after this many times the limit.
BUSY = 20

SWEEPS = "tools/benchmarks/stability_sweeps"


class Scene:
    """A run of the program that has ended: exit status, the sentence it has
    ended with, its warnings and its folder."""

    def __init__(self, status, output, errors, folder):
        self.status, self.output, self.folder = status, output, folder
        self.errors = errors.strip()
        self.warnings = re.findall(r"^Warning: (.*)$", output, re.M)

    def summary(self):
        with open(os.path.join(self.folder, "summary.json"),
                  encoding="utf-8") as file:
            return json.load(file)

    def rows(self, table):
        with open(os.path.join(self.folder, table), newline="",
                  encoding="utf-8") as file:
            return [{name.split(" [")[0]: float(value)
                     for name, value in row.items()}
                    for row in csv.DictReader(file)]

    def is_sentence(self):
        """Whether it ended as it should when it cannot go on: a status of 1 or
        2 and one sentence."""
        return (self.status in (1, 2) and self.errors.startswith("Error: ")
                and self.errors.count("\n") == 0)


def parameter_file(entries, include=None):
    lines = [f"include {include}"] if include else []
    for path, value in entries.items():
        *sections, key = path.split("/")
        lines += [f"subsection {name}" for name in sections]
        lines += [f"  set {key} = {value}"] + ["end"] * len(sections)
    return "\n".join(lines) + "\n"


class Means:
    def __init__(self, root, asperity, sweeps, limit):
        self.root, self.asperity, self.sweeps = root, asperity, sweeps
        self.limit = limit  # processor time of one cell [s]
        self.local = threading.local()
        self.processes = []
        self.audits = {}

    def file(self, path):
        return os.path.join(self.root, "parameter_files", path)

    def version(self):
        return subprocess.run([self.asperity, "--version"], check=True,
                              capture_output=True, text=True).stdout.strip()

    def environment(self):
        return {**os.environ, "OMP_NUM_THREADS": "1"}

    def run(self, entries, read, include=None, command="run", about="",
            also=None, output="Output/Output directory"):
        """Runs a scene and measures it.
        @param read turns the Scene into values, with its folder still there
        @param about expression that the warnings about this failure fit
        @param also other files in the folder of the scene: {name: text}
        @param output the entry of the folder of results"""
        with tempfile.TemporaryDirectory(prefix="stability_") as folder:
            for name, text in (also or {}).items():
                with open(os.path.join(folder, name), "w",
                          encoding="utf-8") as file:
                    file.write(text)
            results = os.path.join(folder, "results")
            entries = {**entries, output: results}
            with open(os.path.join(folder, "scene.prm"), "w",
                      encoding="utf-8") as file:
                file.write(parameter_file(entries, include))
            try:
                done = subprocess.run(
                    ["prlimit", f"--cpu={self.limit:.0f}:{self.limit + 9:.0f}",
                     self.asperity, command, "scene.prm"], cwd=folder,
                    capture_output=True, text=True, check=False,
                    timeout=BUSY * self.limit, env=self.environment())
            except subprocess.TimeoutExpired:
                return self.hung()
            if done.returncode == -signal.SIGXCPU:
                return self.hung()
            scene = Scene(done.returncode, done.stdout, done.stderr, results)
            if scene.is_sentence():
                return Measurement("reported",
                                   sentence=scene.errors[len("Error: "):])
            if scene.status != 0:
                return Measurement("failed",
                                   sentence=f"status {scene.status}: "
                                            f"{scene.errors[:200]}")
            values = read(scene)
            told = [w for w in scene.warnings if about and re.search(about, w)]
            return Measurement("warned" if told else "values", values,
                               " ".join(told))

    def audit(self, entries, about):
        """What the program says of such a scene before it computes anything:
        the warnings that fit an expression."""
        key = (tuple(entries.items()), about)
        if key not in self.audits:
            found = self.run(entries, lambda scene: {}, command="check",
                             about=about)
            self.audits[key] = found.sentence
        return self.audits[key]

    def sweep(self, name, cell, audit=None, bands=None):
        """A cell of stability_sweeps. Of values beyond their bands the audit
        (entries, expression) of a scene with the same settings is asked."""
        process = getattr(self.local, "process", None)
        if process is None or process.poll() is not None:
            process = subprocess.Popen(
                [self.sweeps], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL, env=self.environment())
            self.local.process = process
            self.processes.append(process)
        line = " ".join([name] + [f"{k}={v}" for k, v in cell.items()])
        process.stdin.write(line.encode() + b"\n")
        process.stdin.flush()
        before, start = processor_time(process.pid), time.monotonic()
        while not select.select([process.stdout], [], [], 1.)[0]:
            if (processor_time(process.pid) - before > self.limit
                    or time.monotonic() - start > BUSY * self.limit):
                process.kill()
                process.wait()
                return self.hung()
        reply = process.stdout.readline()
        if not reply:
            return Measurement(
                "failed", sentence=f"stability_sweeps ended with status "
                                   f"{process.wait()}")
        answer = json.loads(reply)
        for ended in ("reported", "failed"):
            if ended in answer:
                return Measurement(ended, sentence=sentence(answer[ended]))
        values = {value: float("nan") if found is None else found
                  for value, found in answer["values"].items()}
        if answer["warning"]:
            return Measurement("warned", values, sentence(answer["warning"]))
        if audit and exceeds(values, bands):
            told = self.audit(*audit)
            if told:
                return Measurement("warned", values, told)
        return Measurement("values", values)

    def hung(self):
        return Measurement("hung", sentence=f"{self.limit:g} s")

    def close(self):
        for process in self.processes:
            process.stdin.close()
            process.wait()


def processor_time(pid):
    """Of a process, in seconds."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def sentence(text):
    """One line of text."""
    return " ".join(text.split())


def find_program(path):
    found = shutil.which(path)
    return os.path.abspath(found) if found else None
