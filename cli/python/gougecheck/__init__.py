"""Certified gouge check and correction of 5-axis toolpaths, on NumPy arrays.

Lengths are millimetres in part coordinates, angles degrees. Arrays that come in are C-contiguous float64 of shape
(n, 3) and are read where they are; anything else is a TypeError. Arrays that go out are read-only views that keep
their owner alive. Depths are positive inside, as in trimesh.proximity.signed_distance and in python-fcl's contacts.

    report = gougecheck.check(path, mesh, tool)

checks the whole motion of every move against the whole surface of every triangle.
"""

from gougecheck._core import (
    Assumption, Change, Correction, Depths, Error, Mesh, Note, Path, Penetration, Report, Scene, Tool, ToolLibrary,
    Uncorrected, __version__, check, correct, depth, penetration, read_program, read_toolpath, state_name)
from gougecheck._finding import Body, Finding, State

__all__ = [
    "Assumption", "Body", "Change", "Correction", "Depths", "Error", "Finding", "Mesh", "Note", "Path", "Penetration", "Report",
    "Scene", "State", "Tool", "ToolLibrary", "Uncorrected", "__version__", "check", "correct", "depth", "penetration",
    "read_program", "read_toolpath", "state_name"]
