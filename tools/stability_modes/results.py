"""Results on disk: a CSV a mode, with machine, versions and settings in its
head, written as the cells come, so that a sweep can be gone on with."""

import csv
import datetime
import os
import platform

import numpy as np


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


class Results:
    """The rows of a mode, as text: settings, values, ended, sentence."""

    def __init__(self, folder, mode, version=None):
        """@param version only rows that it has computed count; any if none"""
        self.path = os.path.join(folder, f"{mode.name}.csv")
        self.mode, self.version = mode, version
        self.columns = (mode.settings() + mode.values +
                        ["ended", "outcome", "note", "sentence"])
        self.rows = {}
        self.head = []
        self.outdated = False
        self.read()

    def key(self, settings):
        return tuple(settings[name] for name in self.mode.settings())

    def read(self):
        """Takes over what is there, if its columns and its version fit."""
        if not os.path.exists(self.path):
            return
        with open(self.path, newline="", encoding="utf-8") as file:
            lines = file.read().splitlines()
        head = [line[2:] for line in lines if line.startswith("# ")]
        body = list(csv.DictReader(
            line for line in lines if not line.startswith("# ")))
        is_own = (self.version is None
                  or f"program: {self.version}" in head)
        if not is_own or not body or list(body[0]) != self.columns:
            self.outdated = True
            return
        self.head = [line for line in head
                     if line.startswith(("program", "machine", "tools", "date"))]
        self.rows = {self.key(row): row for row in body}

    def add(self, settings, measurement):
        row = {name: settings[name] for name in self.mode.settings()}
        for value in self.mode.values:
            found = measurement.values.get(value)
            row[value] = "" if found is None else f"{found:.6g}"
        row.update(ended=measurement.ended, sentence=measurement.sentence)
        self.rows[self.key(settings)] = row

    def judged(self):
        rows = list(self.rows.values())
        for row in rows:
            row["outcome"], row["note"] = self.mode.judge(row, rows)
        return rows

    def write(self):
        if not self.head:
            self.head = [
                f"program: {self.version}",
                f"machine: {processor()}, {os.cpu_count()} processors, "
                f"{platform.system()} {platform.release()}",
                f"tools: Python {platform.python_version()}, "
                f"numpy {np.__version__}",
                f"date: {datetime.date.today().isoformat()}"]
        about = [f"{self.mode.name}: {self.mode.title}",
                 f"swept: {self.mode.swept}", f"right: {self.mode.band}"]
        with open(self.path + ".part", "w", newline="",
                  encoding="utf-8") as file:
            file.writelines(f"# {line}\n" for line in about + self.head)
            writer = csv.DictWriter(file, self.columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.judged())
        os.replace(self.path + ".part", self.path)
