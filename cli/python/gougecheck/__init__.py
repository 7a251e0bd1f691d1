"""Certified gouge check and correction of 5-axis toolpaths, on NumPy arrays.

Lengths are millimetres in part coordinates, angles degrees. Arrays that come in are C-contiguous float64 of shape
(n, 3) and are read where they are; anything else is a TypeError. Arrays that go out are read-only views that keep
their owner alive. Depths are positive inside, as in trimesh.proximity.signed_distance and in python-fcl's contacts.

    report = gougecheck.check(path, mesh, tool)

checks the whole motion of every move against the whole surface of every triangle.
"""

import enum

from gougecheck._core import (
    Assumption, Change, Correction, Depths, Error, Mesh, Note, Path, Penetration, Report, Scene, Tool, ToolLibrary,
    Uncorrected, __version__, check, correct, depth, penetration, read_program, read_toolpath, state_name)


class State(enum.IntEnum):
    """The state of a move: the values of Report.state and Depths.state."""

    CLEAN = 0
    NEAR = 1  #: nearer than near_miss
    GOUGE = 2
    BURIED = 3  #: inside a solid with no surface inside the tool
    NOT_CHECKED = 4  #: see Report.reason
    NOT_CERTIFIED = 5  #: not proved within the budget


class Body(enum.IntEnum):
    """The body of the tool that is nearest to a witness: the values of Report.body and Depths.body."""

    CUTTER = 0
    SHANK = 1
    HOLDER = 2
    HEAD = 3


__all__ = [
    "Assumption", "Body", "Change", "Correction", "Depths", "Error", "Mesh", "Note", "Path", "Penetration", "Report", "Scene",
    "State", "Tool", "ToolLibrary", "Uncorrected", "__version__", "check", "correct", "depth", "penetration",
    "read_program", "read_toolpath", "state_name"]
