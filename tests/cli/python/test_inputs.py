"""Arrays in: read where they are, or refused by a clear TypeError."""

import gc
import os
import sys

import numpy as np
import pytest

import gougecheck
from shapes import FACES, TIPS, UP, VERTICES


@pytest.mark.parametrize("wrong", [
    VERTICES.astype(np.float32), VERTICES.T, np.asfortranarray(VERTICES), VERTICES[::2], VERTICES[:, :2], VERTICES[0],
    VERTICES.tolist(), None, VERTICES.astype(">f8")])
def test_vertices_of_another_kind_are_a_type_error(wrong):
    with pytest.raises(TypeError, match="vertices: expected a C-contiguous float64 array of shape .*ascontiguousarray"):
        gougecheck.Mesh(wrong, FACES)


def test_the_remedy_of_the_message_works():
    wrong = np.asfortranarray(VERTICES.astype(np.float32))
    mesh = gougecheck.Mesh(np.ascontiguousarray(wrong, dtype=float), FACES)
    assert np.array_equal(mesh.vertices[mesh.faces], VERTICES[FACES])


@pytest.mark.parametrize("kind", [np.int32, np.int64, np.uint32, np.uint64])
def test_faces_of_any_integer(kind):
    assert gougecheck.Mesh(VERTICES, FACES.astype(kind)).is_solid


@pytest.mark.parametrize("wrong", [FACES.astype(float), FACES.T, FACES.tolist(), FACES.astype(np.int8)])
def test_faces_of_another_kind_are_a_type_error(wrong):
    with pytest.raises(TypeError, match="faces: expected"):
        gougecheck.Mesh(VERTICES, wrong)


def test_indices_out_of_range():
    faces = FACES.copy()
    faces[3, 1] = -1
    with pytest.raises(IndexError, match="row 3 has the index -1"):
        gougecheck.Mesh(VERTICES, faces)
    faces[3, 1] = 8
    with pytest.raises(gougecheck.Error, match="face 3 names vertex 8") as caught:
        gougecheck.Mesh(VERTICES, faces)
    assert caught.value.code == "mesh-corner"
    assert isinstance(caught.value, ValueError)


def test_tips_and_axes():
    path = gougecheck.Path(TIPS, UP)
    assert np.array_equal(path.tips, TIPS)
    assert np.array_equal(path.axes, np.tile(UP, (5, 1)))
    with pytest.raises(TypeError, match="tips: "):
        gougecheck.Path(TIPS.astype(int), UP)
    with pytest.raises(TypeError, match="axes: .* or \\(3,\\)"):
        gougecheck.Path(TIPS, [0, 0, 1])
    with pytest.raises(TypeError, match="rapids: "):
        gougecheck.Path(TIPS, UP, np.zeros(5))
    with pytest.raises(gougecheck.Error, match="path-count"):
        gougecheck.Path(TIPS, np.tile(UP, (4, 1)))
    with pytest.raises(gougecheck.Error, match="position 2: the axis"):
        gougecheck.Path(TIPS, np.array([UP, UP, UP * 0, UP, UP]))


def test_a_reader_names_the_one_that_reads_the_file(tmp_path):
    program, toolpath = tmp_path / "p.nc", tmp_path / "p.apt"
    program.write_text("%\nO1\nG21 G90 G17 G94\nG0 X0 Y0 Z5\nG1 Z1 F100\nM30\n%\n")
    toolpath.write_text("PARTNO/1\nUNITS/MM\nGOTO/0,0,5\nGOTO/1,0,5\nFINI\n")
    with pytest.raises(gougecheck.Error, match="read it with read_program and the control"):
        gougecheck.read_toolpath(program)
    with pytest.raises(gougecheck.Error, match="Python: read_toolpath"):
        gougecheck.read_program(toolpath, control="haas")


def test_tools_by_shape_and_from_json():
    tool = gougecheck.Tool.bull_nose(diameter=16, corner_radius=2, length=25, shank=[(16, 16, 20)])
    assert tool.height == 45 and not tool.has_holder
    assert gougecheck.Tool.from_json(tool.to_json()).to_json() == tool.to_json()
    with pytest.raises(TypeError, match="the tool has no corner_radius; the dimensions of the shape bull_nose are"):
        gougecheck.Tool.bull_nose(diameter=16, length=25)
    with pytest.raises(TypeError, match="there is no dimension 'diametre'"):
        gougecheck.Tool.ball(diametre=10, length=30)
    with pytest.raises(TypeError, match=r"Tool\.ball\(\): .*there is no dimension 'lenght'; .* diameter and length"):
        gougecheck.Tool.ball(diameter=10, length=30, lenght=5)
    with pytest.raises(TypeError, match="taper"):
        gougecheck.Tool.ball(diameter=16, length=25, taper=3)


@pytest.mark.parametrize("keywords, message", [
    (dict(diameter="10", length=30), "diameter: expected a number, got '10' (str)"),
    (dict(diameter=None, length=30), "diameter: expected a number, got None (NoneType)"),
    (dict(diameter=10, length=True), "length: expected a number, got True (bool)"),
    (dict(diameter=10, length=30, name=5), "name: expected a str, got 5 (int)"),
    (dict(diameter=10, length=30, holder="ER16"),
     "holder: expected a list of (lower_diameter, upper_diameter, length), got 'ER16' (str)"),
    (dict(diameter=10, length=30, holder=[32, 32, 40]),
     "holder[0]: expected (lower_diameter, upper_diameter, length), got 32 (int)"),
    (dict(diameter=10, length=30, shank=[(10, 10, 5), (10, "ten", 5)]), "shank[1][1]: expected a number, got 'ten' (str)"),
])
def test_a_dimension_of_another_kind_is_a_type_error_that_names_it(keywords, message):
    with pytest.raises(TypeError) as caught:
        gougecheck.Tool.ball(**keywords)
    assert str(caught.value) == message


def test_numbers_of_any_kind_are_dimensions():
    tool = gougecheck.Tool.ball(diameter=np.float32(10), length=np.int64(30), holder=([20, 20, 10],))
    assert tool.height == 40


def test_arguments_of_another_kind_are_type_errors_that_name_them():
    mesh, path = gougecheck.Mesh(VERTICES, FACES), gougecheck.Path(TIPS, UP)
    tool = gougecheck.Tool.ball(diameter=2, length=8)
    calls = {
        "path: expected a Path": lambda: gougecheck.check("a.apt", mesh, tool),
        "part: expected a Mesh, a list of Mesh or a Scene, got 'p.stl'": lambda: gougecheck.check(path, "p.stl", tool),
        "part\\[1\\]: expected a Mesh, got 3": lambda: gougecheck.check(path, [mesh, 3], tool),
        "tool: expected a Tool, a ToolLibrary, or None for the tools of the path": lambda: gougecheck.check(path, mesh, 7),
        "tolerance: expected a number, got '0.01'": lambda: gougecheck.check(path, mesh, tool, tolerance="0.01"),
        "tolerance: expected a number, got None": lambda: gougecheck.check(path, mesh, tool, tolerance=None),
        "threads: expected a whole number of 0 or more, got -1": lambda: gougecheck.check(path, mesh, tool, threads=-1),
        "threads: expected a whole number of 0 or more, got 1.5":
            lambda: gougecheck.check(path, mesh, tool, threads=1.5),
        "rapids: expected a str, got 3": lambda: gougecheck.check(path, mesh, tool, rapids=3),
        "check\\(\\) has no keyword 'tolerence'; it has path, part, tool, fixtures, tolerance, ":
            lambda: gougecheck.check(path, mesh, tool, tolerence=0.02),
        "; did you mean tolerance\\?$": lambda: gougecheck.check(path, mesh, tool, tolerence=0.02),
        "check\\(\\) has no keyword 'zzz'; it has [a-z_, ]*$": lambda: gougecheck.check(path, mesh, tool, zzz=1),
        "fixtures: expected a Mesh or a list of Mesh": lambda: gougecheck.check(path, mesh, tool, fixtures="f.stl"),
        "max_side_shift: expected a number": lambda: gougecheck.correct(path, mesh, tool, max_side_shift="1"),
        "strategy: expected a str": lambda: gougecheck.correct(path, mesh, tool, strategy=None),
        "mesh: expected a Mesh or a Scene": lambda: gougecheck.depth(path, tool, TIPS, UP),
        "tool: expected a Tool, got": lambda: gougecheck.depth(mesh, path, TIPS, UP),
        "resolution: expected a number": lambda: gougecheck.depth(mesh, tool, TIPS, UP, resolution="fine"),
        "b: expected a Mesh": lambda: gougecheck.penetration(mesh, path),
        "find_shift: expected True or False": lambda: gougecheck.penetration(mesh, mesh, find_shift="yes"),
        "file: expected the name of a file": lambda: gougecheck.read_toolpath(5),
        "unit: expected a str": lambda: gougecheck.Mesh.read_stl("p.stl", 25.4),
        "parts: expected a Mesh or a list of Mesh": lambda: gougecheck.Scene("p.stl"),
        "name: expected a str, got 4": lambda: gougecheck.Mesh(VERTICES, FACES, 4),
        "json: expected a str": lambda: gougecheck.Tool.from_json({"cutter": 1}),
    }
    for message, call in calls.items():
        with pytest.raises(TypeError, match=message):
            call()


def test_a_tool_of_a_library_is_found_by_its_number_as_a_number():
    library = gougecheck.ToolLibrary.from_json(
        '{"units": "mm", "tools": [{"number": 3, "cutter": {"shape": "ball", "diameter": 8, "length": 20}}]}')
    assert library.tool(3).to_json() == library.tool("T3").to_json()
    with pytest.raises(TypeError, match="name: expected a str"):
        library.tool(None)


def test_views_are_read_only_and_keep_their_owner():
    mesh = gougecheck.Mesh(VERTICES, FACES)
    vertices = mesh.vertices
    owner = vertices.base
    assert owner is mesh
    del mesh, owner
    gc.collect()
    assert np.array_equal(np.sort(vertices, axis=0), np.sort(VERTICES, axis=0))
    with pytest.raises(ValueError, match="read-only"):
        vertices[0, 0] = 1
    assert vertices.flags.c_contiguous and vertices.dtype == np.float64
    again = gougecheck.Mesh(vertices, FACES)  # views go in as they come out
    assert np.array_equal(np.sort(again.vertices, axis=0), np.sort(vertices, axis=0))


def test_reading_a_toolpath(tmp_path):
    file = tmp_path / "path.apt"
    file.write_bytes(gougecheck.Path(TIPS, UP).text)
    path = gougecheck.read_toolpath(file)
    assert np.array_equal(path.tips, TIPS) and len(path) == 5
    assert path.lines[0] == 4
    file.write_text("GOTO/1,2\n")
    with pytest.raises(gougecheck.Error) as caught:
        gougecheck.read_toolpath(file)
    assert caught.value.line == 1 and caught.value.file == os.fspath(file)
    with pytest.raises(gougecheck.Error, match="file-not-found"):
        gougecheck.read_toolpath(tmp_path / "none.apt")


def test_stubs_are_those_of_the_module():
    """Every public name of the module is in the stub, and the other way round."""
    import ast

    stub = ast.parse(open(os.path.join(os.path.dirname(gougecheck.__file__), "__init__.pyi")).read())
    stubbed = {node.name: node for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    names = {name for name in gougecheck.__all__ if name != "__version__"}
    assert set(stubbed) == names
    for name, node in stubbed.items():
        if not isinstance(node, ast.ClassDef) or name in ("Error", "State", "Body", "Finding"):
            continue
        members = {m.name for m in node.body if isinstance(m, ast.FunctionDef) and not m.name.startswith("_")}
        real = {m for m in vars(getattr(gougecheck, name)) if not m.startswith("_")}
        assert members == real, name


def test_everything_has_a_docstring():
    for name in gougecheck.__all__:
        if name != "__version__":
            assert getattr(gougecheck, name).__doc__, name
    assert sys.modules["gougecheck"].__doc__


def test_a_program_is_read_as_its_control_runs_it(tmp_path):
    file = tmp_path / "p.ngc"
    file.write_text("G21 G90 G17 G94 G61\nG0 X0 Y0 Z5\nG1 Z1 F100\nM2\n")
    path = gougecheck.read_program(file, control="linuxcnc")
    assert np.allclose(path.tips, [[0, 0, 5], [0, 0, 1]])
    with pytest.raises(TypeError, match="read_program"):
        gougecheck.read_program(file, kontrol="linuxcnc")
    with pytest.raises(gougecheck.Error, match="--control|gcode-control"):
        gougecheck.read_program(file)
