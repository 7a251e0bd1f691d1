#!/usr/bin/env python3
"""Compares what two builds of gougecheck write, byte for byte.

    tests/compare_outputs.py OLD NEW SAMPLES [--data FOLDER] [--scenes N] [--seed N]

OLD and NEW are programs, SAMPLES a folder that make_samples wrote. Each sample is checked and corrected with all
outputs; so are N random scenes, and each toolpath of FOLDER against a block under it. A change that must not change any
result ends with "0 outputs differ". New fields of a result are named with --ignore NAME and are left out of JSON files;
--without FILE leaves out a file whose format has changed.
"""

import argparse
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CHECK = ("--json check.json --csv check.csv --sarif check.sarif --junit check.xml --certificate check.gcc "
         "--progress never").split()
CORRECT = ("--json correct.json --csv correct.csv --sarif correct.sarif --junit correct.xml "
           "--progress never").split()


def triangles(stl, corners, faces):
    for face in faces:
        stl.append("facet normal 0 0 0\nouter loop")
        stl.extend("vertex %.6f %.6f %.6f" % tuple(corners[k]) for k in face)
        stl.append("endloop\nendfacet")


def block(low, high):
    corners = [[(low, high)[k >> 2 & 1][0], (low, high)[k >> 1 & 1][1], (low, high)[k & 1][2]] for k in range(8)]
    return corners, [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6),
                     (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def write_stl(path, solids):
    stl = ["solid part"]
    for corners, faces in solids:
        triangles(stl, corners, faces)
    path.write_text("\n".join(stl + ["endsolid part", ""]))


def relief(rng, size):
    """A closed block with an uneven top, from -size to size."""
    n = 9
    at = [-size + 2 * size * k / (n - 1) for k in range(n)]
    corners = [[x, y, rng.uniform(-6, 0)] for x in at for y in at] + [[x, y, -20] for x in at for y in at]
    faces = []
    top = lambda i, j: i * n + j
    low = lambda i, j: n * n + i * n + j
    for i in range(n - 1):
        for j in range(n - 1):
            faces += [(top(i, j), top(i + 1, j), top(i + 1, j + 1)), (top(i, j), top(i + 1, j + 1), top(i, j + 1))]
            faces += [(low(i, j), low(i + 1, j + 1), low(i + 1, j)), (low(i, j), low(i, j + 1), low(i + 1, j + 1))]
    for k in range(n - 1):
        for a, b in (((k, 0), (k + 1, 0)), ((n - 1, k), (n - 1, k + 1)), ((k + 1, n - 1), (k, n - 1)),
                     ((0, k + 1), (0, k))):
            faces += [(top(*a), low(*a), low(*b)), (top(*a), low(*b), top(*b))]
    return corners, faces


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def write_scene(folder, rng):
    """A part with an uneven top, at times a fixture or a head, a tool with shank and holder, and a path over them."""
    write_stl(folder / "part.stl", [relief(rng, 30)])
    options = ["--part", "part.stl", "--tools", "tools.json"]
    if rng.random() < 0.4:
        x = rng.uniform(-20, 10)
        write_stl(folder / "jaw.stl", [block((x, 12, 0), (x + 12, 28, rng.uniform(4, 30)))])
        options += ["--fixture", "jaw.stl"]
    if rng.random() < 0.3:
        write_stl(folder / "head.stl", [block((-30, -25, 70), (30, 25, 110))])
        options += ["--head", "head.stl"]
    options += rng.choice([[], [], ["--rapid", "dogleg"], ["--rapid", "skip"], ["--clearance", "shank=0.5,holder=1"],
                           ["--near-miss", "0.5"], ["--stock-to-leave", "0.2"], ["--find-cures"]])
    d = rng.choice([4.0, 6.0, 8.0, 10.0])
    cutter = rng.choice([{"shape": "flat", "diameter": d, "length": 20}, {"shape": "ball", "diameter": d, "length": 20},
                         {"shape": "bull", "diameter": d, "corner_radius": d / 5, "length": 20}])
    tool = {"number": 1, "name": "tool 1", "cutter": cutter,
            "shank": [{"lower_diameter": d, "upper_diameter": d, "length": 20}],
            "holder": [{"lower_diameter": 30, "upper_diameter": 30, "length": 30}]}
    (folder / "tools.json").write_text(json.dumps({"units": "mm", "tools": [tool]}))
    lean = rng.choice([0.0, 0.15, 0.5])
    lines = ["UNITS/MM", "LOADTL/1"]
    at = [rng.uniform(-25, 25), rng.uniform(-25, 25), 40]
    for k in range(rng.randint(5, 60)):
        step = rng.choice([1, 5, 25])
        at = [max(-30, min(30, at[0] + rng.uniform(-step, step))), max(-30, min(30, at[1] + rng.uniform(-step, step))),
              rng.uniform(-5, 5) if rng.random() < 0.8 else rng.uniform(5, 40)]
        axis = unit([rng.uniform(-lean, lean), rng.uniform(-lean, lean), 1])
        if rng.random() < 0.15:
            lines.append("RAPID")
        lines.append("GOTO/" + ",".join("%.6f" % x for x in at + axis))
    (folder / "path.apt").write_text("\n".join(lines + ["FINI", ""]))
    return "path.apt", options


def job_of_toolpath(folder, program, toolpath):
    """Options for a block under the lowest cut of a toolpath and its tools; nothing where it cannot be read."""
    told = subprocess.run([program, "path", "info", str(toolpath), "--json", "-"], capture_output=True, text=True)
    if told.returncode not in (0, 1, 4) or not told.stdout:
        return None
    info = json.loads(told.stdout)
    scale = 25.4 if info["unit"] == "inch" else 1.0
    low, high = ([scale * x for x in info["box"][end]] for end in ("from", "to"))
    top = low[2] + 0.05  # what cuts deepest comes out as a shallow gouge
    write_stl(folder / "part.stl", [block([low[0] - 5, low[1] - 5, low[2] - 20], [high[0] + 5, high[1] + 5, top])])
    numbers = sorted({tool["number"] for tool in info["tools"] if tool["number"] is not None} or {1})
    tools = [{"number": n, "name": "tool %d" % n, "cutter": {"shape": "ball", "diameter": 6, "length": 20},
              "holder": [{"lower_diameter": 30, "upper_diameter": 30, "length": 60}]} for n in numbers]
    (folder / "tools.json").write_text(json.dumps({"units": "mm", "tools": tools}))
    return [str(toolpath), "--part", "part.stl", "--tools", "tools.json"]


def run(program, folder, arguments):
    """Exit status and everything that was printed; files are written into the folder."""
    env = dict(os.environ, SOURCE_DATE_EPOCH="1700000000", NO_COLOR="1")
    done = subprocess.run([program, *arguments], cwd=folder, env=env, capture_output=True, text=True, timeout=1800)
    (folder / ("printed_%s.txt" % arguments[0])).write_text("%d\n%s\n%s" % (done.returncode, done.stdout, done.stderr))


def without(value, names):
    if isinstance(value, dict):
        return {k: without(v, names) for k, v in value.items() if k not in names}
    return [without(v, names) for v in value] if isinstance(value, list) else value


def content(path, ignored):
    data = path.read_bytes()
    if path.suffix == ".xml":
        return re.sub(rb' time="[^"]*"', b"", data)  # JUnit states how long the check took
    if ignored and path.suffix in (".json", ".sarif"):
        return json.dumps(without(json.loads(data), ignored))
    return data


def files(folder):
    return {str(p.relative_to(folder)): p for p in sorted(folder.rglob("*")) if p.is_file()}


def differences(a, b, ignored, left_out):
    first, second = files(a), files(b)
    for name in left_out:
        first.pop(name, None), second.pop(name, None)
    return [name for name in sorted(first.keys() | second.keys())
            if name not in first or name not in second or content(first[name], ignored) != content(second[name], ignored)]


class Comparison:
    def __init__(self, arguments):
        self.programs = [str(Path(p).resolve()) for p in (arguments.old, arguments.new)]
        self.ignored, self.left_out = set(arguments.ignore), arguments.without
        self.work = Path(tempfile.mkdtemp(prefix="compare_outputs."))

    def job(self, name, commands, prepare):
        """`prepare(folder)` puts the inputs into a folder and answers the arguments that every command has."""
        # Both run in a folder of the same name, as reports have the names of their files.
        kept = []
        for k, program in enumerate(self.programs):
            folder = self.work / name / "job"
            folder.mkdir(parents=True)
            arguments = prepare(folder)
            if arguments is None:
                return name, None
            for command, outputs in commands:
                run(program, folder, [command, *arguments, *outputs])
            kept.append(folder.rename(self.work / name / str(k)))
        different = differences(kept[0], kept[1], self.ignored, self.left_out)
        if not different:
            subprocess.run(["rm", "-rf", str(self.work / name)], check=False)
        return name, different


def sample_jobs(samples):
    for line in (samples / "index.txt").read_text().splitlines():
        name, _, _, toolpath, *options = line.split()

        def prepare(folder, source=samples / name, arguments=(toolpath, *options)):
            for file in source.iterdir():
                if file.is_file():
                    (folder / file.name).write_bytes(file.read_bytes())
            return list(arguments)

        yield "sample_" + name, prepare, True


def scene_jobs(count, seed):
    for number in range(count):

        def prepare(folder, number=number):
            toolpath, options = write_scene(folder, random.Random(seed * 1_000_003 + number))
            return [toolpath, *options]

        yield "scene_%d" % number, prepare, number % 20 == 0


def toolpath_jobs(data, program):
    for toolpath in sorted(p for p in data.rglob("*") if p.is_file()):
        name = "data_" + "_".join(toolpath.relative_to(data).parts)
        yield name, lambda folder, toolpath=toolpath: job_of_toolpath(folder, program, toolpath), False


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("samples", type=Path)
    parser.add_argument("--data", type=Path)
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--ignore", action="append", default=[])
    parser.add_argument("--without", action="append", default=[])
    arguments = parser.parse_args()
    comparison = Comparison(arguments)
    jobs = list(sample_jobs(arguments.samples.resolve())) + list(scene_jobs(arguments.scenes, arguments.seed))
    if arguments.data:
        jobs += list(toolpath_jobs(arguments.data.resolve(), comparison.programs[0]))

    def compare(job):
        name, prepare, has_report = job
        report = [["--report", "report_" + c] if has_report else [] for c in ("check", "correct")]
        commands = [("check", CHECK + report[0]), ("correct", ["-o", "corrected.out", "--force", *CORRECT, *report[1]])]
        return comparison.job(name, commands[:1] if name.startswith("data_") else commands, prepare)

    compared = different = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, found in pool.map(compare, jobs):
            if found is None:
                continue
            compared += 1
            different += len(found)
            if found:
                print("%s: %s" % (name, ", ".join(found)))
    print("%d jobs compared, %d outputs differ" % (compared, different))
    if different:
        print("both outputs of each are in %s" % comparison.work)
    sys.exit(0 if compared and not different else 1)


if __name__ == "__main__":
    main()
