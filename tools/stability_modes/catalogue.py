"""All failure modes by name."""

from . import (contact, coupling, flow, fluid_structure, scenes, solid,
               surfaces)

# Points, elements and problems that no parameter file describes: they need
# stability_sweeps.
WITHOUT_SCENES = {mode.name: mode for mode in (
    contact.MODES + coupling.MODES + flow.MODES + solid.MODES +
    surfaces.MODES)}

MODES = {mode.name: mode for mode in sorted(
    list(WITHOUT_SCENES.values()) + fluid_structure.MODES + scenes.MODES +
    [surfaces.C27],
    key=lambda mode: int(mode.name[1:]))}
