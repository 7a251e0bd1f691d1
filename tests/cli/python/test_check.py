"""What check, depth, correct and penetration say, against answers known by hand."""

import json
import threading

import numpy as np
import pytest

import gougecheck
from gougecheck import State
from shapes import FACES, TIPS, UP, VERTICES

MESH = gougecheck.Mesh(VERTICES, FACES, "block")
TOOL = gougecheck.Tool.ball(diameter=10, length=30, shank=[(10, 10, 20)], holder=[(32, 32, 40)])
PATH = gougecheck.Path(TIPS, UP)


def test_the_gouge_its_depth_and_its_witness():
    report = gougecheck.check(PATH, MESH, TOOL)
    assert len(report) == 5 and report.verdict == "gouges" and not report.is_clean
    assert report.state.tolist() == [State.CLEAN] * 4 + [State.GOUGE]
    assert report.count(State.GOUGE) == 1
    assert report.depth[4] <= 0.25 + 1e-9 <= report.depth_upper[4] + 1e-3
    assert report.depth[4] == pytest.approx(0.25, abs=1e-3)
    assert report.point[4, 2] == pytest.approx(0, abs=1e-9)
    assert FACES[report.triangle[4]].min() >= 4, "the top"
    assert report.body[4] == gougecheck.Body.CUTTER
    assert np.isnan(report.t[0]) and report.triangle[0] == -1
    assert "gouge: 0.250 mm cutter" in str(report)


def test_a_machine_turns_the_tool_by_its_joints():
    around = np.radians([50, 130])
    lean = np.radians(10)
    axes = np.column_stack([np.sin(lean) * np.cos(around), np.sin(lean) * np.sin(around), np.full(2, np.cos(lean))])
    path = gougecheck.Path(np.zeros((2, 3)), axes)
    post = gougecheck.Mesh(np.array([[x, y, z] for z in (50.0, 70.0) for x, y in ((-5, 27), (5, 27), (5, 47), (-5, 47))]),
                           FACES)
    assert gougecheck.check(path, post, TOOL).is_clean
    machine = "preset:linuxcnc-xyzac-trt"
    assert gougecheck.check(path, post, TOOL, machine=machine).verdict == "gouges"
    assert gougecheck.check(path, post, TOOL, machine=machine, feed_law="vector").is_clean
    assert gougecheck.check(path, post, TOOL, machine=machine, joint_limits=["A=0..5"]).verdict == "not-fully-checked"
    points = ["A=0,0,0", "C=0,0,0"]
    far = gougecheck.check(path, post, TOOL, machine=machine, zero="500,0,0", joint_points=points)
    assert far.verdict == "not-fully-checked"
    with pytest.raises(gougecheck.Error, match="joints C, A, X, Y, Z"):
        gougecheck.check(path, post, TOOL, machine=machine, joint_rates=["Q=1"])
    with pytest.raises(gougecheck.Error, match="preset"):
        gougecheck.check(path, post, TOOL, machine="preset:none")


def test_rapids_meet_what_is_left_of_the_stock():
    rapid = gougecheck.Path(np.array([[-20.0, 10, 2], [60, 10, 2]]), UP, rapids=np.array([True, True]))
    cut = gougecheck.Path(np.array([[-20.0, 10, 2], [60, 10, 2]]), UP)
    assert gougecheck.check(rapid, MESH, TOOL).is_clean
    met = gougecheck.check(rapid, MESH, TOOL, stock="part+6")
    assert met.verdict == "gouges" and "rapid into stock" in str(met)
    assert met.depth[1] <= 4 <= met.depth_upper[1]
    after = gougecheck.check(rapid, MESH, TOOL, stock="part+6", before=(cut, TOOL))
    assert after.is_clean, str(after)
    aside = gougecheck.check(rapid, MESH, TOOL, stock="part+6", before=[(cut, TOOL, "0,3,0")])
    assert aside.verdict == "gouges"
    assert gougecheck.check(rapid, MESH, TOOL, stock=MESH).is_clean
    assert gougecheck.check(rapid, MESH, TOOL, stock="part+6", stock_tolerance=10).is_clean
    with pytest.raises(gougecheck.Error, match="stock.shape"):
        gougecheck.check(rapid, MESH, TOOL, stock="barrel")
    with pytest.raises(TypeError, match="need stock"):
        gougecheck.check(rapid, MESH, TOOL, before=(cut, TOOL))
    with pytest.raises(TypeError, match="before"):
        gougecheck.check(rapid, MESH, TOOL, stock="box", before=[7])


def test_reports_are_views_that_outlive_their_names():
    depth = gougecheck.check(PATH, MESH, TOOL).depth
    assert depth[4] > 0.2 and not depth.flags.writeable


def test_the_result_does_not_depend_on_threads():
    a, b = (gougecheck.check(PATH, MESH, TOOL, threads=n) for n in (1, 3))
    for name in ("state", "depth", "depth_upper", "t", "point", "normal", "triangle"):
        assert getattr(a, name).tobytes() == getattr(b, name).tobytes(), name


def test_fixtures_and_options():
    below = gougecheck.Mesh(VERTICES - [0, 0, 50], FACES)
    report = gougecheck.check(PATH, below, TOOL, fixtures=[MESH])
    assert report.is_fixture[4] == 1 and report.mesh[4] == 0
    scene = gougecheck.Scene([below], [MESH])
    assert gougecheck.check(PATH, scene, TOOL, tolerance=0.3).is_clean
    with pytest.raises(TypeError, match="fixtures"):
        gougecheck.check(PATH, scene, TOOL, fixtures=[MESH])
    with pytest.raises(TypeError, match="path: expected a Path"):
        gougecheck.check("path.apt", MESH, TOOL)
    with pytest.raises(TypeError, match="part: "):
        gougecheck.check(PATH, "part.stl", TOOL)
    with pytest.raises(ValueError, match="rapids"):
        gougecheck.check(PATH, MESH, TOOL, rapids="fast")
    with pytest.raises(gougecheck.Error, match="tolerance: "):
        gougecheck.check(PATH, MESH, TOOL, tolerance=-1)


def test_a_fixture_may_have_a_clearance():
    below = gougecheck.Mesh(VERTICES - [0, 0, 50], FACES)
    beside = gougecheck.Mesh(VERTICES - [0, 0, 10], FACES)
    assert gougecheck.check(PATH, gougecheck.Scene([below], [beside]), TOOL).is_clean
    near = gougecheck.Scene([below], [beside], fixture_clearances=[20])
    report = gougecheck.check(PATH, near, TOOL)
    assert not report.is_clean and report.is_fixture.any()
    assert report.depth[4] == pytest.approx(20 - 9.75)
    with pytest.raises(gougecheck.Error, match="expected one for each"):
        gougecheck.Scene([below], [beside], [1, 2])
    with pytest.raises(gougecheck.Error, match=r"fixture_clearances\[0\]: expected a length"):
        gougecheck.Scene([below], [beside], [-1])
    with pytest.raises(TypeError, match=r"fixture_clearances\[0\]: expected a number"):
        gougecheck.Scene([below], [beside], ["1"])


def test_buried_is_never_clean():
    small = gougecheck.Tool.ball(diameter=1, length=2)
    report = gougecheck.check(gougecheck.Path(np.array([[20.0, 10, -8]]), UP), MESH, small)
    assert report.state[0] == State.BURIED and np.isnan(report.depth[0]) and report.reason(0)
    depths = gougecheck.depth(MESH, small, np.array([[20.0, 10, -8]]), UP)
    assert depths.state[0] == State.BURIED and np.isnan(depths.depth[0])


def test_depth_of_many_positions():
    z = np.linspace(2, -3, 101)
    tips = np.stack([np.full(101, 20.0), np.full(101, 10.0), z], axis=1)
    depths = gougecheck.depth(MESH, TOOL, tips, UP)
    truth = np.maximum(0, -z)
    assert np.all(depths.depth <= truth + 1e-9) and np.all(truth <= depths.depth_upper + 1e-9)
    assert np.all(depths.depth_upper - depths.depth <= 0.001 + 1e-12)
    assert np.all(depths.normal[z < -0.01, 2] > 0.9)
    assert np.array_equal(gougecheck.depth(MESH, TOOL, tips, UP, threads=1).depth, depths.depth)
    assert len(gougecheck.depth(MESH, TOOL, tips[0], UP)) == 1
    with pytest.raises(TypeError, match="tips: "):
        gougecheck.depth(MESH, TOOL, tips.astype(np.float32), UP)


def test_correct():
    correction = gougecheck.correct(PATH, MESH, TOOL)
    assert correction.after.is_clean and not correction.before.is_clean
    assert np.array_equal(correction.path.tips[:3], TIPS[:3]), "clean moves stay"
    assert correction.changes and not correction.uncorrected
    lift = max(correction.changes, key=lambda change: change.depth_before)
    assert lift.depth_before == pytest.approx(0.25, abs=0.02) and lift.depth_after <= 0.01
    assert gougecheck.check(correction.path, MESH, TOOL).is_clean


def test_penetration():
    pose = np.eye(4)
    pose[2, 3] = 9
    found = gougecheck.penetration(MESH, MESH, pose, find_shift=True)
    assert found.state == "penetrating" and found.depth <= 1 + 1e-9 and found.depth_upper >= 0.5
    freed = pose.copy()
    freed[:3, 3] += found.shift
    assert gougecheck.penetration(MESH, MESH, freed).state in ("free", "touching")
    pose[2, 3] = 12.5
    apart = gougecheck.penetration(MESH, MESH, pose)
    assert apart.state == "free" and apart.distance == pytest.approx(2.5) and apart.deepest is None
    with pytest.raises(gougecheck.Error, match="pose"):
        gougecheck.penetration(MESH, MESH, np.diag([2.0, 2, 2, 1]))
    with pytest.raises(TypeError, match="pose: "):
        gougecheck.penetration(MESH, MESH, np.eye(3))

    class Transform:  # of python-fcl
        def getRotation(self):
            return np.eye(3)

        def getTranslation(self):
            return np.array([0, 0, 12.5])

    assert gougecheck.penetration(MESH, MESH, Transform()).distance == apart.distance


def test_reports_are_written(tmp_path):
    report = gougecheck.check(PATH, MESH, TOOL)
    report.write(tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text())
    report.write(tmp_path / "moves.csv")
    assert len((tmp_path / "moves.csv").read_text().splitlines()) == 6
    with pytest.raises(gougecheck.Error, match="extension"):
        report.write(tmp_path / "report.pdf")


def test_files_of_a_batch_are_not_replaced(tmp_path):
    """A batch would refuse its folder as soon as another file lay in the place of one of its own."""
    (tmp_path / "summary.json").write_text("{}")
    (tmp_path / "corrected").mkdir()
    report = gougecheck.check(PATH, MESH, TOOL)
    for name in ["summary.json", "summary.csv", "corrected/a.csv"]:
        with pytest.raises(gougecheck.Error, match="nothing else writes; name another file"):
            report.write(tmp_path / name)
    report.write(tmp_path / "own.csv")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["corrected", "own.csv", "summary.json"]


def test_the_gil_is_released():
    """Checks from several threads at once: the same answer as one after the other."""
    results = [None] * 4

    def work(i):
        results[i] = gougecheck.check(PATH, MESH, TOOL, threads=1).depth.tobytes()

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(results)) == 1 and results[0] == gougecheck.check(PATH, MESH, TOOL).depth.tobytes()
