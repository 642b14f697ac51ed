"""Read the output directory of a run: pictures, friction.csv, summary.json."""

import base64
import csv
import json
import os
import re
import struct
import xml.etree.ElementTree as xml
import zlib

import numpy as np


class RunError(Exception):
    """Something is missing from the output; the message is for the user."""


class Vtu:
    """Points, cells and point data of a VTU file with zlib-compressed arrays,
    of all its pieces together."""

    TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4",
             "Int64": "<i8", "UInt8": "u1"}

    def __init__(self, path):
        try:
            pieces = xml.parse(path).getroot().findall("UnstructuredGrid/Piece")
            points = [self._array(p.find("Points/DataArray")) for p in pieces]
            self.in_space = np.concatenate(points)
            self.points = self.in_space[:, :2]
            first = np.cumsum([0] + [len(p) for p in points])
            self.cells = np.concatenate([self._cells(p) + n
                                         for p, n in zip(pieces, first)])
            self.fields = {
                a.get("Name"): np.concatenate([
                    self._array(b) for p in pieces for b in p.find("PointData")
                    if b.get("Name") == a.get("Name")])
                for a in pieces[0].find("PointData")}
        except (OSError, AttributeError, IndexError, ValueError, xml.ParseError,
                zlib.error, struct.error) as error:
            raise RunError(f"{path} cannot be read as a VTU file: {error}")

    def field(self, name):
        if name not in self.fields:
            raise RunError(f"The field '{name}' is not among those of the "
                           f"picture: {', '.join(self.fields)}.")
        values = self.fields[name]
        return values[:, 0] if values.shape[1] == 1 else values[:, :2]

    @classmethod
    def _cells(cls, piece):
        """Points of each cell, numbered within the piece."""
        cells = {a.get("Name"): cls._array(a).ravel()
                 for a in piece.find("Cells")}
        return cells["connectivity"].reshape(-1, int(cells["offsets"][0]))

    @classmethod
    def _array(cls, element):
        text = "".join(element.text.split())
        # The head is encoded by itself: number of blocks, size of a block and
        # of the last one, then the compressed sizes (VTK file formats).
        n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
        n_letters = 4 * (-(-4 * (3 + n_blocks) // 3))
        head = struct.unpack(f"<{3 + n_blocks}I",
                             base64.b64decode(text[:n_letters]))
        body = base64.b64decode(text[n_letters:])
        content, position = b"", 0
        for size in head[3:]:
            content += zlib.decompress(body[position:position + size])
            position += size
        values = np.frombuffer(content, cls.TYPES[element.get("type")])
        return values.reshape(-1, int(element.get("NumberOfComponents", "1")))


def steps_of(directory, name):
    """Steps of the record of one part of the scene: {step: (time, path)}."""
    path = os.path.join(directory, name + ".pvd")
    try:
        sets = xml.parse(path).getroot().iter("DataSet")
        found = {}
        for entry in sets:
            step = int(re.search(r"_(\d+)\.vtu$", entry.get("file")).group(1))
            found[step] = (float(entry.get("timestep")),
                           os.path.join(directory, entry.get("file")))
    except (OSError, AttributeError, xml.ParseError) as error:
        raise RunError(f"{path} cannot be read: {error}")
    return found


def part_at(directory, name, step):
    """The picture of a part at a step, or the newest before it (the tool does
    not move and may be written once)."""
    steps = steps_of(directory, name)
    past = [s for s in steps if s <= step]
    if not past:
        raise RunError(f"{directory} holds no picture of the {name} up to "
                       f"step {step}.")
    return Vtu(steps[max(past)][1])


def read_friction(directory):
    """Columns of friction.csv by name without unit, as arrays."""
    path = os.path.join(directory, "friction.csv")
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        values = np.array(rows[1:], dtype=float)
    except (OSError, ValueError) as error:
        raise RunError(f"{path} cannot be read: {error}")
    if len(rows) < 2:
        raise RunError(f"{path} holds no step yet.")
    return {name.split(" [")[0]: values[:, i] for i, name in enumerate(rows[0])}


def read_summary(directory):
    try:
        with open(os.path.join(directory, "summary.json"),
                  encoding="utf-8") as file:
            return json.load(file)
    except OSError:
        return {}  # the run goes on, or was stopped
    except ValueError as error:
        raise RunError(f"{directory}/summary.json is not JSON: {error}")


def heading(directory, summary):
    """Name and load of a run."""
    name = os.path.basename(os.path.abspath(directory))
    load = summary.get("load", {})
    try:
        return (f"{name}: {load['pressure'] * 1e-6:.4g} MPa, "
                f"{load['velocity'] * 60:.4g} m/min, "
                f"{load['temperature'] - 273.15:.4g} °C")
    except (KeyError, TypeError):
        return name
