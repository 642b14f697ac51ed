"""Runs of the program, kept with their settings and made once."""

import concurrent.futures
import csv
import hashlib
import json
import os
import platform
import re
import shutil
import signal
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
QUIET = {"Output/Picture interval": 0, "Output/Checkpoint interval": 0}
STOPPED = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)


class RunError(Exception):
    """The charts cannot be drawn; the message is for the user."""

    def __init__(self, message, status=2):
        super().__init__(message)
        self.status = status


def processor():
    """Name of the processor and number of cores."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            name = re.search(r"model name\s*: (.*)", file.read())[1]
    except (OSError, TypeError):
        name = platform.processor() or platform.machine()
    return f"{name}, {os.cpu_count()} cores, {platform.system()}"


def write_scene(file, entries, include=None):
    """Writes a parameter file with entries given by their paths, after another
    file, if one is included."""
    with open(file, "w", encoding="utf-8") as out:
        if include is not None:
            out.write(f"include {include}\n")
        for path, value in entries.items():
            *sections, key = path.split("/")
            out.write("".join(f"subsection {name}\n" for name in sections))
            out.write(f"  set {key} = {value}\n" + "end\n" * len(sections))


def content_of(file):
    """Text of a parameter file, included ones in its place and digests of the
    files that it names, without its own path or the place of its output."""
    folder = os.path.dirname(os.path.abspath(file))
    lines = []
    with open(file, encoding="utf-8") as text:
        for line in text:
            words = line.split("#")[0].split()
            other = os.path.join(folder, words[-1]) if words else ""
            if words[:1] == ["include"] or words[:3] == ["set", "Base", "scene"]:
                lines.append(content_of(other))
            elif words[:3] == ["set", "File", "="] and os.path.exists(other):
                with open(other, "rb") as data:
                    digest = hashlib.md5(data.read()).hexdigest()
                lines.append(f"file {digest}\n")
            elif words and words[:3] != ["set", "Output", "directory"]:
                lines.append(" ".join(words) + "\n")
    return "".join(lines)


class Program:
    """The program and its benchmarks."""

    def __init__(self, path):
        self.path = os.path.abspath(path)
        try:
            done = subprocess.run([self.path, "--version"], capture_output=True,
                                  text=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            raise RunError(f"The program '{path}' cannot be run; expected is "
                           "that of a build, by default build/asperity "
                           "(cmake --build build --target asperity).")
        self.version = done.stdout.strip()

    def benchmark(self, name):
        path = os.path.join(os.path.dirname(self.path), "tools", "benchmarks",
                            name)
        if not os.access(path, os.X_OK):
            raise RunError(f"There is no benchmark '{path}', which this chart "
                           "needs; expected is that it has been built "
                           f"(cmake --build build --target {name}).")
        return path


class Run:
    """A run that has been made. `failure` is the program's sentence about a
    run that failed, otherwise None; `seconds` are processor time."""

    def __init__(self, folder, record):
        self.folder = folder
        self.failure = record["failure"]
        self.seconds = record["seconds"]
        self.memory = record["memory"]
        self.summary = {}
        path = os.path.join(folder, "summary.json")
        if self.failure is None and os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                self.summary = json.load(file)

    @property
    def failed(self):
        return self.failure is not None

    @property
    def mu(self):
        return self.value("friction", "mu")

    @property
    def newton(self):
        return self.value("cost", "newton_iterations")

    def value(self, *names):
        """A number of summary.json; not a number if the run failed."""
        value = self.summary
        for name in names:
            value = value.get(name, {})
        return value if isinstance(value, (int, float)) else float("nan")

    def rows(self, name):
        """The rows of a table that the run has written, by heading."""
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            return []
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


class RunKeeper:
    """Makes the runs of a chart, or takes those that are there already."""

    def __init__(self, folder, program, limit, jobs):
        """limit: processor seconds after which a run counts as failed."""
        self.folder = os.path.abspath(folder)
        self.program = program
        self.limit = limit
        self.jobs = max(jobs, 1)
        self.n_kept = self.n_new = 0
        self.failures = []

    def scenes(self, scenes, include):
        """Runs the scene of a file with entries changed: {name: entries} to
        {name: Run}."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            made = {name: pool.submit(self.scene, name, entries, include)
                    for name, entries in scenes.items()}
            try:
                return {name: run.result() for name, run in made.items()}
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise

    def folder_of(self, name):
        folder = os.path.join(self.folder,
                              name.replace(" ", "_").replace("/", "_"))
        os.makedirs(folder, exist_ok=True)
        return folder

    def scene(self, name, entries, include):
        folder = self.folder_of(name)
        file = os.path.join(folder, "scene.prm")
        write_scene(file, {**QUIET, **entries,
                           "Output/Output directory": folder}, include)
        return self.run(name, folder, content_of(file),
                        [self.program.path, file])

    def campaign(self, name, entries, include):
        """A campaign of a file with entries changed; one that was stopped goes
        on by itself. Its results are in the run's subfolder `campaign`."""
        folder = self.folder_of(name)
        file = os.path.join(folder, "campaign.prm")
        write_scene(file, {**entries, "Campaign/Output directory":
                           os.path.join(folder, "campaign")}, include)
        settings = content_of(file)
        record = os.path.join(folder, "settings.txt")
        if not os.path.exists(record) or open(
                record, encoding="utf-8").read() != settings:
            shutil.rmtree(os.path.join(folder, "campaign"), ignore_errors=True)
            with open(record, "w", encoding="utf-8") as out:
                out.write(settings)
        return self.run(name, folder, settings,
                        [self.program.path, "characterize", file])

    def run(self, name, folder, settings, command):
        """Runs a command whose results go into the folder, unless the record
        there is of the same settings."""
        path = os.path.join(folder, "run.json")
        what = {"settings": settings, "program": self.program.version,
                "machine": processor(), "limit": self.limit}
        record = {}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                record = json.load(file)
        if any(record.get(key) != value for key, value in what.items()):
            record = {**what, **self.execute(name, folder, command)}
            with open(path + ".new", "w", encoding="utf-8") as file:
                json.dump(record, file, indent=1)
            os.replace(path + ".new", path)
            self.n_new += 1
        else:
            self.n_kept += 1
        run = Run(folder, record)
        if run.failed:
            self.failures.append((name, run.failure))
        return run

    def execute(self, name, folder, command):
        limited = ["sh", "-c", f'ulimit -t {self.limit}; exec "$@"', "sh"]
        with open(os.path.join(folder, "messages.txt"), "w+",
                  encoding="utf-8") as messages, \
                open(os.path.join(folder, "output.txt"), "w",
                     encoding="utf-8") as output:
            process = subprocess.Popen(
                limited + command, stdout=output, stderr=messages, cwd=ROOT,
                env={**os.environ, "OMP_NUM_THREADS": "1",
                     "OPENBLAS_NUM_THREADS": "1"})
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = code = os.waitstatus_to_exitcode(status)
            messages.seek(0)
            lines = messages.read().strip().splitlines()
        if code < 0 and -code in STOPPED:
            raise RunError(f"The run '{name}' was stopped by signal {-code}; "
                           "the same command goes on from there.", 1)
        failure = None
        if code == -signal.SIGXCPU:
            failure = f"not done after {self.limit} s of processor time"
        elif code < 0:
            failure = f"ended by signal {-code}"
        elif code > 0:
            failure = (lines[-1] if lines else f"exit status {code}"
                       ).replace("Error: ", "").replace(folder + "/", "")
        seconds = used.ru_utime + used.ru_stime
        return {"failure": failure, "seconds": seconds,
                "memory": 1024 * used.ru_maxrss}
