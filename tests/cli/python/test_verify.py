"""`gougecheck verify` repeats the checks of files, and asks for the files of everything that was in memory."""

import os
import pickle
import subprocess

import pytest

import gougecheck
from shapes import FACES, VERTICES

PROGRAM = os.environ["GOUGE_PROGRAM"]
TOOLS = '{"units":"mm","tools":[{"number":1,"name":"mill","cutter":{"shape":"flat","diameter":10,"length":90}}]}'
CROSSING = "UNITS/MM\nLOADTL/1\nRAPID\nGOTO/-80,10,60\nGOTO/-80,10,-5\nGOTO/80,10,-5\nFINI\n"
TURN = "G21 G90 G17 G94 G61\nT1 M6\n#<way>=1\nG0 X60 Y0 Z-8 A0 C0\nG1 C90 F500\nM2\n"


def stl(scale=1.0, shift=(0, 0, 0)):
    """Returns the block of the tests as text, scaled, then moved."""
    corner = ["vertex " + " ".join(str(c * scale + s) for c, s in zip(v, shift)) for v in VERTICES]
    facets = ["facet normal 0 0 0\nouter loop\n" + "\n".join(corner[i] for i in face) + "\nendloop\nendfacet\n"
              for face in FACES]
    return "solid block\n" + "".join(facets) + "endsolid block\n"


class Shop:
    """A folder with the files of one check."""

    def __init__(self, folder):
        self.folder = folder

    def file(self, name, text):
        (self.folder / name).write_text(text)
        return str(self.folder / name)

    def verify(self, report):
        """Returns the exit status and the output of `gougecheck verify`."""
        result = self.folder / "result.json"
        report.write(str(result))
        ran = subprocess.run([PROGRAM, "verify", str(result)], capture_output=True, text=True)
        return ran.returncode, ran.stdout + ran.stderr


@pytest.fixture
def shop(tmp_path):
    return Shop(tmp_path)


def read_all(shop):
    return (gougecheck.read_toolpath(shop.file("a.apt", CROSSING)), gougecheck.Mesh.read_stl(shop.file("p.stl", stl())),
            gougecheck.ToolLibrary.read(shop.file("t.json", TOOLS)))


def test_a_check_of_files_is_repeated(shop):
    path, part, tools = read_all(shop)
    report = gougecheck.check(path, part, tools, tolerance=0.02, strict=True, assume=["placement"])
    assert report.verdict == "gouges"
    for one in (report, pickle.loads(pickle.dumps(report))):
        status, text = shop.verify(one)
        assert status == 0 and "not refuted" in text, text
    saved = [pickle.loads(pickle.dumps(thing)) for thing in (path, part, tools)]
    assert shop.verify(gougecheck.check(*saved))[0] == 0


def test_a_file_that_changed_is_refuted(shop):
    report = gougecheck.check(*read_all(shop))
    shop.file("p.stl", stl(2))
    status, text = shop.verify(report)
    assert status == 1 and "is not the file that was checked" in text


@pytest.mark.parametrize("unit", ["inch", ""])
def test_inches(shop, unit):
    """The block of 40 mm in inches; without a unit it is that of the path."""
    inches = "UNITS/INCHES\nLOADTL/1\nRAPID\nGOTO/-3,0.4,2\nGOTO/-3,0.4,-0.2\nGOTO/3,0.4,-0.2\nFINI\n"
    path = gougecheck.read_toolpath(shop.file("a.apt", inches))
    part = shop.file("p.stl", stl(1 / 25.4))
    mesh = gougecheck.Mesh.read_stl(part, unit) if unit else gougecheck.Mesh.read_stl(part)
    report = gougecheck.check(path, mesh, gougecheck.ToolLibrary.read(shop.file("t.json", TOOLS)))
    assert report.verdict == "gouges"
    status, text = shop.verify(report)
    assert status == 0, text


def test_fixtures_with_clearances(shop):
    path, part, tools = read_all(shop)
    fixture = gougecheck.Mesh.read_stl(shop.file("jaw,left.stl", stl(1, (0, -30, 0))))
    report = gougecheck.check(path, gougecheck.Scene([part], [fixture], fixture_clearances=[16.5]), tools)
    status, text = shop.verify(report)
    assert status == 0, text


def test_stock_and_the_programs_before(shop):
    path, part, tools = read_all(shop)
    earlier = gougecheck.read_toolpath(shop.file("before.apt", CROSSING.replace(",-5\n", ",2\n")))
    other = gougecheck.ToolLibrary.read(shop.file("before.json", TOOLS.replace(":10,", ":16,")))
    blank = gougecheck.Mesh.read_stl(shop.file("blank.stl", stl(1.3)))
    for stock in ("part+6", blank):
        report = gougecheck.check(path, part, tools, stock=stock, before=[(earlier, other, "0,1,0")])
        status, text = shop.verify(report)
        assert status in (0, 4) and "refuted:" not in text.replace("not refuted", ""), text
    in_memory = gougecheck.Tool.flat(name="mill", diameter=16, length=90)
    status, text = shop.verify(gougecheck.check(path, part, tools, stock="part+6", before=(earlier, in_memory)))
    assert status == 3 and "tools of the program" in text, text


def test_a_program_with_its_machine(shop):
    _, part, tools = read_all(shop)
    facts = {"machine": "preset:linuxcnc-xyzac-trt", "joint_points": ["A=0,0,-50", "C=0,0,0"]}
    path = gougecheck.read_program(shop.file("turn.ngc", TURN), offsets=["G54=0,0,0"], **facts)
    report = gougecheck.check(path, part, tools, **facts)
    status, text = shop.verify(report)
    assert status in (0, 4) and "refuted:" not in text.replace("not refuted", ""), text


def test_a_program_with_lengths_of_tools(shop):
    _, part, tools = read_all(shop)
    lengths = shop.file("lengths.csv", "tool,length\n1,100\n")
    text = "G21 G90 G17 G94 G40 G49 G80\nT1 M6\nG54\nG43 H1\nG0 X-80. Y10. Z60.\nG1 Z-5. F500.\nX80.\nM30\n"
    path = gougecheck.read_program(shop.file("p.nc", text), control="haas", tool_lengths=lengths,
                                   offsets=["G54=0,0,0"])
    report = gougecheck.check(path, part, tools)
    assert report.verdict == "gouges"
    status, text = shop.verify(report)
    assert status == 0, text


def test_what_was_in_memory_is_named(shop):
    path, part, tools = read_all(shop)
    block = gougecheck.Mesh(VERTICES, FACES, "block")
    tool = gougecheck.Tool.flat(name="mill", diameter=10, length=90)
    inches = gougecheck.Mesh.read_stl(shop.file("i.stl", stl(1 / 25.4, (0, 9, 0))), "inch")
    for report, named in ((gougecheck.check(path, block, tools), "part block"),
                          (gougecheck.check(path, part, tool), "tool"),
                          (gougecheck.check(path, gougecheck.Scene([part], [inches]), tools), "part "),
                          (gougecheck.correct(path, part, tools).after, "toolpath"),
                          (gougecheck.check(path, part, tools, stock=block), "stock ")):
        status, text = shop.verify(report)
        assert status == 3 and named in text and "verify-input" in text, text


def test_tools_of_the_path(shop):
    _, part, _ = read_all(shop)
    path = gougecheck.read_toolpath(shop.file("c.apt", CROSSING.replace("LOADTL/1", "CUTTER/10,0,5,0,0,0,90\nLOADTL/1")))
    report = gougecheck.check(path, part, None)
    assert report.verdict == "gouges" and report.exit_status == 1
    assert not any("not in the library" in note.text for note in report.notes)
    status, text = shop.verify(report)
    assert status == 0, text
    with pytest.raises(gougecheck.Error, match="no-tool"):
        gougecheck.check(gougecheck.read_toolpath(shop.file("a.apt", CROSSING)), part, None)
