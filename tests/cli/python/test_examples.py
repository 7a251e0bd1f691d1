"""The examples and the first check of docs/guide/python.md run as written."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(os.environ["GOUGE_SOURCE_DIR"])


def run(*arguments, cwd):
    done = subprocess.run([sys.executable, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_lead_angle(tmp_path):
    found = re.search(r"least lead angle: (\d+\.\d+) degrees", run(SOURCE / "samples/python/lead_angle.py", cwd=tmp_path))
    assert 0 < float(found[1]) < 60


def test_sampling_misses(tmp_path):
    out = run(SOURCE / "samples/python/sampling_misses.py", cwd=tmp_path)
    assert out.count("vertices at 2 poses a move: 0.000 mm") == 2, out
    assert len(re.findall(r"the check: [1-9]\d*\.\d+|the check: 0\.[1-9]", out)) == 2, out
    assert out.count(", gouge") == 2


def test_depth_along_path(tmp_path):
    pytest.importorskip("matplotlib")
    assert "gouge" in run(SOURCE / "samples/python/depth_along_path.py", "depth.png", cwd=tmp_path)
    assert (tmp_path / "depth.png").read_bytes().startswith(b"\x89PNG")


def test_the_first_check_of_the_documentation(tmp_path):
    text = (SOURCE / "docs/guide/python.md").read_text()
    code = re.search(r"```python\n(.*?)```", text, re.DOTALL)[1]
    assert len(code.strip().splitlines()) <= 10
    (tmp_path / "first.py").write_text(code)
    expected = re.search(r"```text\n(.*?)```", text, re.DOTALL)[1]
    assert run("first.py", cwd=tmp_path) == expected
