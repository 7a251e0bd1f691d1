"""The findings of a report as objects, and its view in a notebook."""

import dataclasses
import html.parser

import numpy as np
import pytest

import gougecheck
from gougecheck import Body, State
from shapes import FACES, TIPS, UP, VERTICES

MESH = gougecheck.Mesh(VERTICES, FACES, "block <1>")
TOOL = gougecheck.Tool.ball(diameter=10, length=30, holder=[(32, 32, 40)], name="ball 10")
REPORT = gougecheck.check(gougecheck.Path(TIPS, UP), MESH, TOOL)
APT = b"""PARTNO OPERATION ROUGH
UNITS/MM
LOADTL/7
CUTTER/10
MULTAX
GOTO/-10,10,5,0,0,1
GOTO/50,10,5,0,0,1
GOTO/50,12,-0.25,0,0,1
GOTO/-10,12,-0.25,0,0,1
FINI
"""


def test_a_gouge_as_an_object():
    (finding,) = REPORT.findings
    assert (finding.state, finding.line, finding.move, finding.moves) == (State.GOUGE, 5, 4, 1)
    assert isinstance(finding.state, State)
    assert finding.depth == REPORT.depth[4] and finding.depth_upper == REPORT.depth_upper[4]
    assert finding.body is Body.CUTTER and finding.against == "block <1>" and finding.tool == "ball 10"
    assert finding.t == REPORT.t[4]
    tip = (1 - finding.t) * TIPS[3] + finding.t * TIPS[4]
    assert np.allclose(finding.tip, tip) and finding.axis == (0, 0, 1)
    assert np.array_equal(finding.point, REPORT.point[4]) and np.array_equal(finding.normal, REPORT.normal[4])
    assert finding.clearance is None and "0.250 mm" in str(finding) and str(finding).startswith("line 5: gouge")
    assert finding in REPORT.findings and dataclasses.asdict(finding)["depth"] == finding.depth
    with pytest.raises(dataclasses.FrozenInstanceError):
        finding.depth = 0


def test_a_finding_has_the_line_and_the_tool_of_its_file():
    (finding,) = gougecheck.check(gougecheck.Path.from_text(APT, "part.apt"), MESH, TOOL).findings
    assert finding.line == 9 and finding.tool == "7"


def test_buried_near_and_open_moves_are_findings_too():
    small = gougecheck.Tool.ball(diameter=1, length=2)
    (buried,) = gougecheck.check(gougecheck.Path(np.array([[20.0, 10, -8]]), UP), MESH, small).findings
    assert buried.state is State.BURIED and buried.depth is None and buried.tip == (20, 10, -8)
    assert buried.body is None and buried.point is None
    above = gougecheck.Path(np.array([[20.0, 10, 0.2]]), UP, rapids=np.array([True]))
    (near,) = gougecheck.check(above, MESH, TOOL, near_miss=1).findings
    assert near.state is State.NEAR and near.clearance == pytest.approx(0.2, abs=0.01) and near.depth is None
    rapid = gougecheck.Path(TIPS[:2], UP, rapids=np.array([True, True]))
    skipped = gougecheck.check(rapid, MESH, TOOL, rapids="skip").findings
    assert [finding.state for finding in skipped] == [State.NOT_CHECKED] and skipped[0].moves == 2
    assert not gougecheck.check(gougecheck.Path(TIPS[:2], UP), MESH, TOOL).findings


class Text(html.parser.HTMLParser):
    """Collects the text of the cells, and tests that every element is closed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.cells, self.words = [], [], ""
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attributes):
        self.open.append(tag)
        if tag in ("td", "th"):
            self.cells.append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words += data
        if self.open and self.open[-1] in ("td", "th"):
            self.cells[-1] += data


def test_the_view_of_a_notebook_has_the_verdict_and_the_findings():
    text = REPORT._repr_html_()
    read = Text(text)
    assert read.words.startswith("gouges 5 moves: 4 clean, 1 gouge; deepest 0.250 mm")
    row = dict(zip(read.cells[:len(read.cells) // 2], read.cells[len(read.cells) // 2:]))
    assert row["Line"] == "5" and row["State"] == "gouge" and row["Depth, mm"] == "0.250"
    assert row["Body"] == "cutter" and row["Tool"] == "ball 10" and row["Against"] == "block <1>"
    assert "Operation" not in row, "columns without any text are left out"
    assert "<1>" not in text and "<script" not in text and "<style" not in text


def test_the_view_shows_the_deepest_first_and_counts_the_rest():
    pecks = np.array([[20.0, 10, 5 if i % 2 == 0 else -0.1 - 0.01 * i] for i in range(121)])
    report = gougecheck.check(gougecheck.Path(pecks, UP), MESH, TOOL)
    read = Text(report._repr_html_())
    depth = read.cells.index("Depth, mm")
    columns = read.cells.index("Point, mm") + 1
    depths = [float(text) for text in read.cells[columns + depth::columns]]
    more = len(report.findings) - len(depths)
    assert depths == sorted(depths, reverse=True) and len(depths) == min(50, len(report.findings))
    assert (f"and {more} more; report.findings lists all" in read.words) == (more > 0)


def test_the_view_states_what_is_not_established():
    clean = gougecheck.check(gougecheck.Path(TIPS[:2], UP), MESH, TOOL)
    assert Text(clean._repr_html_()).words.startswith("clean 2 moves: 2 clean")
    bare = gougecheck.Path.from_text("MULTAX\nGOTO/-10,10,0.5,0,0,1\nGOTO/50,10,0.5,0,0,1\n")
    report = gougecheck.check(bare, MESH, TOOL, strict=True)
    read = Text(report._repr_html_())
    assert report.verdict == "not-fully-checked" and read.words.startswith("not fully checked")
    assert "Not established:" in read.words
