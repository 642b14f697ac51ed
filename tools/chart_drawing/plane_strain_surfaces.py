"""The surfaces of the chart of plane strain: their maps and what a run of a patch
or of a profile of them sets."""

import dataclasses
import os

import numpy as np

from . import rough_surfaces as rough
from .scene_runs import ROOT

PROFILES = 4  # of a window, at equal distances
MAPS = {"blasted": os.path.join(ROOT, "parameter_files", "surfaces",
                                "blasted_tool.x3p"),
        "ground": os.path.join(os.path.dirname(ROOT), "shared", "surfaces",
                               "sensofar_plu1_unidirectional.x3p")}


@dataclasses.dataclass
class Surface:
    """A window in whose map the rows are profiles along the motion."""
    kind: str
    seed: int  # which realisation or place
    length: float  # of the window along the motion [um]
    heights: np.ndarray  # [um]

    @property
    def name(self):
        return f"{self.kind} {self.seed}"


def synthetic(seed):
    """Str = 1, which a patch stretches across the motion."""
    return Surface("synthetic", seed, 5., rough.synthetic(seed, 5.))


def tool(kind, seed):
    """10 um of a tool of the repository, waves from 5 um on, as its friction
    laws have it, in the middle of a quarter of its map."""
    heights, spacing = rough.read_x3p(MAPS[kind])
    heights = rough.smooth(rough.without_form(heights, 1), 5. / spacing)
    n = round(10. / spacing)
    place = [tuple(size * (1 + 2 * half) // 4 - n // 2 for size, half in
                   zip(heights.shape[::-1], (quarter % 2, quarter // 2)))
             for quarter in (0, 3, 1, 2)][seed - 1]
    return Surface(kind, seed, 10., rough.window(heights, place, (n, n)))


def ground(seed):
    """48 x 192 points of the measured ground surface, waves from 12 points on;
    scaled to 5 um along the motion, and to the slopes of the synthetic ones."""
    heights, _ = rough.read_x3p(MAPS["ground"])
    heights = rough.smooth(rough.without_form(heights, 2), 12)
    start = [(100, 50), (360, 300), (600, 150)][seed - 1]
    part = rough.window(heights, start, (48, 192))
    return Surface("ground", seed, 5.,
                   part * rough.SLOPE / rough.slope(part, 5.))


def width_over_length(surface, stretch):
    return 4. if surface.kind == "ground" else stretch


def shear(factor):
    """Conduction, which patches do not have, is left out of profiles, too."""
    if factor == 0.:
        return {}
    return {"Interface/Shear law": "shear factor",
            "Interface/Shear factor": factor, "Heat/Model": "adiabatic"}


def oil(wetting):
    """Part of the void at the first touch that oil fills, all of one pressure."""
    if wetting == 0.:
        return {}
    return {"Lubrication/Model": "pocket", "Lubrication/Wetting": wetting,
            "Lubrication/Oil amount": "part of void at touch"}


def common(surface, path, interface, elements):
    """Entries of patch and profile alike; interface is the shear factor and the
    wetting, elements also has the time steps."""
    spans = elements["spans"]
    topography = {
        "File": path, "Lateral unit": "um", "Height unit": "um",
        "Spacing x": f"{surface.length / rough.SAMPLES:.8g} um",
        "F-operator": "none", "Profile length": f"{surface.length:.8g} um"}
    factor, wetting = interface
    return {"Tool/Kind": "measured", **shear(factor), **oil(wetting),
            **{f"Tool/Topography/{key}": value
               for key, value in topography.items()},
            "Geometry/Chip height": f"{1.3 * surface.length:.8g} um",
            "Mesh/Strip depth": f"{surface.length / spans:.8g} um",
            "Mesh/Spans": spans,
            "Protocol/Sliding distance": f"{0.5 * surface.length:.8g} um",
            "Protocol/Ramp steps": elements["ramp"],
            "Protocol/Slide steps": elements["slide"]}


def patch(surface, path, stretch, interface, elements):
    width = surface.length * width_over_length(surface, stretch)
    return {**common(surface, path, interface, elements),
            "Tool/Topography/Spacing y": f"{width / rough.SAMPLES:.8g} um",
            "Geometry/Width": f"{width:.8g} um",
            "Mesh/Spans across": elements["across"]}


def profile(surface, path, row, interface, elements):
    return {**common(surface, path, interface, elements),
            "Tool/Topography/Spacing y": f"{surface.length / rough.SAMPLES:.8g} um",
            "Geometry/Dimension": 2,
            "Tool/Topography/Profile direction": "0 deg",
            "Tool/Topography/Profile start": "0 um",
            "Tool/Topography/Periodic continuation": "none",
            "Tool/Topography/Profile position": f"row {row}"}
