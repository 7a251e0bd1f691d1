"""Wrong calls: every message is one line of ours that names the argument and what is expected."""

import numpy as np
import pytest

import gougecheck
from shapes import FACES, TIPS, UP, VERTICES

MESH = gougecheck.Mesh(VERTICES, FACES, "block")
PATH = gougecheck.Path(TIPS, UP)
TOOL = gougecheck.Tool.ball(diameter=10, length=30)
REPORT = gougecheck.check(PATH, MESH, TOOL)
LIBRARY = gougecheck.ToolLibrary([TOOL])

CALLS = {
    "check() needs 'tool'; its first arguments are path, part, tool": lambda: gougecheck.check(PATH, MESH),
    "check() needs 'path'; its first": lambda: gougecheck.check(),
    "check() takes at most 3 arguments without their names (path, part, tool); got 4":
        lambda: gougecheck.check(PATH, MESH, TOOL, 0.01),
    "check() got 'path' twice, without its name and with it": lambda: gougecheck.check(PATH, MESH, TOOL, path=PATH),
    "correct() needs 'part'": lambda: gougecheck.correct(PATH, tool=TOOL),
    "depth() needs 'tool'; its first arguments are mesh, tool, tips, axes": lambda: gougecheck.depth(MESH),
    "penetration() needs 'b'": lambda: gougecheck.penetration(MESH),
    "read_toolpath() needs 'file'": lambda: gougecheck.read_toolpath(),
    "unit: expected a str, got 5 (int)": lambda: gougecheck.read_toolpath("a.apt", 5),
    "read_program() takes at most 1 arguments": lambda: gougecheck.read_program("a.nc", "haas"),
    "Mesh() needs 'faces'; its first arguments are vertices, faces, name": lambda: gougecheck.Mesh(VERTICES),
    "Mesh.read_stl() has no keyword 'units'; it has file, unit": lambda: gougecheck.Mesh.read_stl("a.stl", units="mm"),
    "Path() has no keyword 'nam'; it has tips, axes, rapids, name": lambda: gougecheck.Path(TIPS, UP, nam="x"),
    "Path.from_text() needs 'text'": lambda: gougecheck.Path.from_text(),
    "text: expected bytes or a str": lambda: gougecheck.Path.from_text(5),
    "Scene() needs 'parts'": lambda: gougecheck.Scene(),
    "Tool() makes no object; use the shape, such as Tool.ball(diameter=10, length=30)": lambda: gougecheck.Tool(),
    "Tool.ball() takes only dimensions with their names, such as diameter=10; got 2 without":
        lambda: gougecheck.Tool.ball(10, 30),
    "Tool.from_json() needs 'json'": lambda: gougecheck.Tool.from_json(),
    "ToolLibrary() needs 'tools'": lambda: gougecheck.ToolLibrary(),
    "tools: expected a list of Tool (ToolLibrary.read(file) reads a file), got 't.json' (str)":
        lambda: gougecheck.ToolLibrary("t.json"),
    "tools[1]: expected a Tool, got 3 (int)": lambda: gougecheck.ToolLibrary([TOOL, 3]),
    "ToolLibrary.read() needs 'file'": lambda: gougecheck.ToolLibrary.read(),
    "stickout: expected a number, got 'far' (str)": lambda: gougecheck.ToolLibrary.read("t.json", stickout="far"),
    "ToolLibrary.tool() needs 'name'": lambda: LIBRARY.tool(),
    "Report() makes no object; check(path, part, tool) returns one": lambda: gougecheck.Report(),
    "Depths() makes no object": lambda: gougecheck.Depths(),
    "Correction() makes no object": lambda: gougecheck.Correction(),
    "Penetration() makes no object": lambda: gougecheck.Penetration(),
    "Note() makes no object": lambda: gougecheck.Note(),
    "state: expected a State, 0 to 5, got 'gouge' (str)": lambda: REPORT.count("gouge"),
    "Report.count() needs 'state'": lambda: REPORT.count(),
    "move: expected the index of a move, 0 to 4, got '1' (str)": lambda: REPORT.reason("1"),
    "Report.write() needs 'file'": lambda: REPORT.write(),
    "state_name() needs 'state'": lambda: gougecheck.state_name(),
}


@pytest.mark.parametrize("message", CALLS)
def test_a_wrong_call_is_a_type_error_of_one_line(message):
    with pytest.raises(TypeError) as caught:
        CALLS[message]()
    assert str(caught.value).startswith(message)
    for word in ("incompatible", "_core", "Invoked with", "\n", "No constructor"):
        assert word not in str(caught.value)


@pytest.mark.parametrize("call", [lambda: REPORT.count(6), lambda: REPORT.count(-1), lambda: gougecheck.state_name(77),
                                  lambda: REPORT.reason(5), lambda: REPORT.reason(-1)])
def test_a_number_out_of_range_is_an_index_error(call):
    with pytest.raises(IndexError, match="expected (a State, 0 to 5|the index of a move, 0 to 4), got"):
        call()


def test_names_of_arguments_may_be_given():
    named = gougecheck.check(tool=TOOL, part=MESH, path=PATH)
    assert named.depth.tobytes() == REPORT.depth.tobytes()
    assert REPORT.count(state=gougecheck.State.GOUGE) == REPORT.count(2) == 1
    assert gougecheck.state_name(np.uint8(2)) == "gouge"


def test_classes_have_the_name_of_the_module():
    for name in ("Mesh", "Path", "Tool", "ToolLibrary", "Report", "Finding", "State"):
        assert getattr(gougecheck, name).__module__ == "gougecheck"
