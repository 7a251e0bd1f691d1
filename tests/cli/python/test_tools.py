"""Tools with names, and libraries as collections: our own, and those of Fusion, FreeCAD and NX."""

import os
from pathlib import Path

import pytest

import gougecheck
from shapes import FACES, TIPS, UP, VERTICES

CORPUS = Path(os.environ["GOUGE_SOURCE_DIR"]) / "tests/corpus/tool"
BALL = gougecheck.Tool.ball(diameter=10, length=30, name="ball 10")
FLAT = gougecheck.Tool.flat(diameter=8, length=20, name="flat 8")


def test_a_tool_has_a_name_of_its_own():
    assert BALL.name == "ball 10"
    assert gougecheck.Tool.ball(diameter=10, length=30).name == "ball"
    report = gougecheck.check(gougecheck.Path(TIPS, UP), gougecheck.Mesh(VERTICES, FACES), BALL)
    assert "ball 10" in str(report)


def test_a_library_is_a_collection_of_tools():
    library = gougecheck.ToolLibrary([BALL, FLAT])
    assert len(library) == 2
    assert [tool.name for tool in library] == ["ball 10", "flat 8"]
    assert library["flat 8"].to_json() == FLAT.to_json()
    assert "ball 10" in library and "ball 12" not in library
    with pytest.raises(gougecheck.Error, match="no tool called 'ball 12'") as caught:
        library["ball 12"]
    assert caught.value.code == "library-which"
    with pytest.raises(TypeError, match="name: expected a str"):
        library[None]
    again = gougecheck.ToolLibrary.from_json(library.to_json())
    assert [tool.to_json() for tool in again] == [BALL.to_json(), FLAT.to_json()]


def test_a_tool_is_found_by_its_number():
    library = gougecheck.ToolLibrary.from_json(
        '{"units": "mm", "tools": [{"number": 3, "cutter": {"shape": "ball", "diameter": 8, "length": 20}}]}')
    assert library[3].to_json() == library["T3"].to_json()
    assert 3 in library and "3" in library and 4 not in library


@pytest.mark.parametrize("file", ["fusion-mill.json", "fusion-mill.tools", "freecad/shop.fctl", "freecad/bull_6.fctb",
                                  "nx/metric/tool_database.dat"])
def test_libraries_of_other_programs_are_read_as_such(file):
    library = gougecheck.ToolLibrary.read(CORPUS / file)
    assert len(library) > 0 and all(tool.height > 0 for tool in library)
    assert all(note.code and note.text for note in library.notes)


def test_facts_that_a_library_of_another_program_leaves_open(tmp_path):
    file = tmp_path / "tool_database.dat"  # without the folder that states the unit
    file.write_bytes((CORPUS / "nx/metric/tool_database.dat").read_bytes())
    with pytest.raises(gougecheck.Error, match="unit"):
        gougecheck.ToolLibrary.read(file)
    metric = gougecheck.ToolLibrary.read(file, unit="mm")
    inches = gougecheck.ToolLibrary.read(file, unit="inch")
    assert next(iter(inches)).height == pytest.approx(25.4 * next(iter(metric)).height)
    with pytest.raises(gougecheck.Error, match="unit 'feet': expected mm or inch"):
        gougecheck.ToolLibrary.read(file, unit="feet")
    with pytest.raises(gougecheck.Error, match="stickout: expected a length above 0"):
        gougecheck.ToolLibrary.read(file, unit="mm", stickout=-1)


def test_facts_about_our_own_library_are_refused(tmp_path):
    file = tmp_path / "tools.json"
    file.write_text(gougecheck.ToolLibrary([BALL]).to_json())
    assert len(gougecheck.ToolLibrary.read(file)) == 1
    with pytest.raises(gougecheck.Error, match="library of another program"):
        gougecheck.ToolLibrary.read(file, unit="mm")
