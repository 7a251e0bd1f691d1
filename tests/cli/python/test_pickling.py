"""Objects that go to another process and come back: the same to the bit, or one clear error."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest

import gougecheck
from shapes import FACES, TIPS, UP, VERTICES

MESH = gougecheck.Mesh(VERTICES, FACES, "block")
TOOL = gougecheck.Tool.ball(diameter=10, length=30, shank=[(10, 10, 20)], holder=[(32, 32, 40)], name="ball 10")
AXES = np.array([[0.1, 0.2, 1], [0.3, -0.1, 1], [0, 0, 1], [0.01, 0, 1], [0, 0.02, 3.0]])
PATH = gougecheck.Path(TIPS, AXES, np.array([True, False, False, False, False]), "p")
ARRAYS = ("state", "depth", "depth_upper", "t", "point", "normal", "triangle", "mesh", "body", "is_fixture", "overcut")


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def same(a, b):
    return all(getattr(a, name).tobytes() == getattr(b, name).tobytes() for name in ARRAYS)


def test_a_path_from_memory_keeps_every_bit():
    path = again(PATH)
    assert path.tips.tobytes() == PATH.tips.tobytes() and path.axes.tobytes() == PATH.axes.tobytes()
    assert path.name == "p" and path.text == PATH.text
    assert again(path).axes.tobytes() == PATH.axes.tobytes()
    assert gougecheck.Path(PATH.tips, PATH.axes).axes.tobytes() == PATH.axes.tobytes()


def test_a_path_from_a_file_is_read_again_from_its_text(tmp_path):
    file = tmp_path / "a.apt"
    file.write_text("MULTAX\nGOTO/0,0,1,0,0,1\nGOTO/1,0,1,0,0,1\n")
    for unit in ("", "inch"):
        path = gougecheck.read_toolpath(file, unit)
        other = again(path)
        assert other.tips.tobytes() == path.tips.tobytes() and other.name == path.name and other.text == path.text
        assert [note.text for note in other.notes] == [note.text for note in path.notes]
        a, b = (gougecheck.check(p, MESH, TOOL) for p in (path, other))
        assert same(a, b) and str(a) == str(b)


def test_positions_of_the_cutter_centre_are_checked_if_stated(tmp_path):
    file = tmp_path / "a.apt"
    file.write_text("UNITS/MM\nMULTAX\nGOTO/10,10,9,0,0,1\nCUTCOM/LEFT\nGOTO/10,10,-0.2,0,0,1\nGOTO/12,10,-0.2,0,0,1\nFINI\n")
    with pytest.raises(gougecheck.Error, match="cutcom 'center': expected centre"):
        gougecheck.read_toolpath(file, cutcom="center")
    path = gougecheck.read_toolpath(file, cutcom="centre")
    for p in (path, again(path)):
        assert gougecheck.check(p, MESH, TOOL).count(gougecheck.State.NOT_CHECKED) == 0
    unstated = gougecheck.check(gougecheck.read_toolpath(file), MESH, TOOL)
    assert unstated.count(gougecheck.State.NOT_CHECKED) > 0


def test_a_program_says_what_to_do(tmp_path):
    file = tmp_path / "p.ngc"
    file.write_text("G21 G90 G17 G94 G61\nG0 X0 Y0 Z5\nG1 Z1 F100\nM2\n")
    with pytest.raises(gougecheck.Error, match="pass a program by the name of its file") as caught:
        pickle.dumps(gougecheck.read_program(file, control="linuxcnc"))
    assert caught.value.code == "path-not-saved" and caught.value.file == str(file)


def test_a_corrected_path_goes_by_its_text():
    path = gougecheck.correct(gougecheck.Path(TIPS, UP), MESH, TOOL).path
    with pytest.raises(gougecheck.Error, match="a corrected path by its text, for Path.from_text"):
        pickle.dumps(path)
    other = again(gougecheck.Path.from_text(path.text, path.name))
    assert other.tips.tobytes() == path.tips.tobytes()


def test_a_mesh_keeps_its_faces_and_what_was_noticed(tmp_path):
    faces = np.insert(FACES[:-1], 3, [5, 5, 6], axis=0)  # one without area, and a hole
    mesh = gougecheck.Mesh(VERTICES, faces, "hole")
    other = again(mesh)
    for name in ("vertices", "faces", "given_face"):
        assert getattr(other, name).tobytes() == getattr(mesh, name).tobytes(), name
    assert other.name == "hole" and not other.is_solid
    assert [note.text for note in other.notes] == [note.text for note in mesh.notes] != []
    assert same(gougecheck.check(PATH, mesh, TOOL), gougecheck.check(PATH, other, TOOL))


def test_a_mesh_of_unknown_unit_still_takes_that_of_its_path(tmp_path):
    file = tmp_path / "m.stl"
    lines = ["solid m"]
    for face in FACES:
        corners = "".join("vertex %g %g %g\n" % tuple(VERTICES[corner]) for corner in face)
        lines.append("facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet")
    file.write_text("\n".join(lines + ["endsolid m\n"]))
    mesh = gougecheck.Mesh.read_stl(file)
    path = gougecheck.Path.from_text("UNITS/INCHES\nMULTAX\nGOTO/10,10,1,0,0,1\nGOTO/20,10,-0.1,0,0,1\n")
    a, b = (gougecheck.check(path, m, TOOL) for m in (mesh, again(mesh)))
    assert a.worst_depth == b.worst_depth == pytest.approx(2.54, abs=0.01)


def test_tools_and_libraries():
    assert again(TOOL).to_json() == TOOL.to_json() and again(TOOL).name == "ball 10"
    library = gougecheck.ToolLibrary([TOOL, gougecheck.Tool.flat(diameter=8, length=20)])
    assert again(library).to_json() == library.to_json()
    scene = again(gougecheck.Scene([MESH], [MESH], [1.5]))
    assert repr(scene) == "<gougecheck.Scene of 1 parts and 1 fixtures>"


def test_a_report_has_all_that_it_had(tmp_path):
    open_mesh = gougecheck.Mesh(VERTICES, FACES[:-1], "open")
    for report in (gougecheck.check(PATH, MESH, TOOL), gougecheck.check(PATH, open_mesh, TOOL, near_miss=2)):
        other = again(again(report))
        assert same(report, other) and len(other) == len(report)
        for name in ("verdict", "is_clean", "worst_depth", "findings"):
            assert getattr(other, name) == getattr(report, name), name
        assert str(other) == str(report) and other._repr_html_() == report._repr_html_()
        assert [repr(fact) for fact in other.assumptions] == [repr(fact) for fact in report.assumptions]
        assert [note.text for note in other.notes] == [note.text for note in report.notes]
        for state in gougecheck.State:
            assert other.count(state) == report.count(state)
        assert [other.reason(i) for i in range(len(other))] == [report.reason(i) for i in range(len(report))]
        for extension in ("json", "csv", "sarif", "xml", "html", "txt"):
            a, b = tmp_path / f"a.{extension}", tmp_path / f"b.{extension}"
            report.write(a)
            other.write(b)
            assert a.read_bytes() == b.read_bytes(), extension
        with pytest.raises(gougecheck.Error, match="extension"):
            other.write(tmp_path / "report.pdf")


def test_copies():
    assert copy.deepcopy(MESH).vertices.tobytes() == MESH.vertices.tobytes()
    assert copy.copy(PATH).tips.tobytes() == PATH.tips.tobytes()


def depth_of(arguments):
    path, mesh, tool = arguments
    return gougecheck.check(path, mesh, tool, threads=1)


def test_checks_in_other_processes():
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        (report,) = pool.map(depth_of, [(PATH, MESH, TOOL)])
    assert same(report, gougecheck.check(PATH, MESH, TOOL))


def test_an_error_keeps_its_code():
    with pytest.raises(gougecheck.Error) as caught:
        gougecheck.Path.from_text("GOTO/1,2\n", "a.apt")
    error = again(caught.value)
    assert (error.code, error.file, error.line) == (caught.value.code, "a.apt", 1)


def test_other_bytes_are_refused():
    state = MESH.__getstate__()
    for kind, bytes_given in ((gougecheck.Mesh, state[:-20]), (gougecheck.Path, state), (gougecheck.Mesh, b""),
                              (gougecheck.Report, b"\xa0"), (gougecheck.ToolLibrary, state)):
        with pytest.raises(gougecheck.Error, match="make the object again from its files") as caught:
            kind.__new__(kind).__setstate__(bytes_given)
        assert caught.value.code == "saved-bytes"
