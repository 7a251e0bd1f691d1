"""check --export, read by others: export_test.py GOUGECHECK MAKE_SAMPLES FOLDER."""

import json
import math
import os
import shutil
import struct
import subprocess
import sys

from gltf_rules import Glb

PART = ["--part", "part.stl", "--fixture", "clamp.stl", "--tools", "tools.json"]
ALL = [word for ending in ("glb", "vtp", "ply") for word in ("--export", "scene." + ending)]


class Failures:
    def __init__(self):
        self.count = 0

    def check(self, is_right, words):
        print(("ok    " if is_right else "WRONG ") + words, flush=True)
        self.count += 0 if is_right else 1


def run(gougecheck, folder, words):
    return subprocess.run([gougecheck, *words], cwd=folder, capture_output=True, text=True, check=False)


def read(folder, name):
    with open(os.path.join(folder, name), "rb") as source:
        return source.read()


def ply_rows(data):
    """Vertices by name and faces of a binary PLY."""
    head, body = data.split(b"end_header\n", 1)
    sizes = {"double": ("d", 8), "float": ("f", 4), "uchar": ("B", 1), "int": ("i", 4)}
    counts, properties, element = {}, [], ""
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            properties.append((words[2], sizes[words[1]][0]))
    row = struct.Struct("<" + "".join(letter for _, letter in properties))
    vertices = [dict(zip([name for name, _ in properties], row.unpack_from(body, k * row.size))) for k in range(counts["vertex"])]
    face = struct.Struct("<Biii")
    faces = [face.unpack_from(body, counts["vertex"] * row.size + k * face.size)[1:] for k in range(counts["face"])]
    return vertices, faces, len(body) == counts["vertex"] * row.size + counts["face"] * face.size


def vtk_facts(file):
    for python in (sys.executable, "/usr/bin/python3"):
        done = subprocess.run([python, os.path.join(os.path.dirname(os.path.abspath(__file__)), "vtp_facts.py"), file],
                              capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return json.loads(done.stdout)
        if "No module named" not in done.stderr and python != sys.executable:
            raise RuntimeError(done.stderr)
    return None


def check_glb(folder, found, deepest):
    glb = Glb(read(folder, "scene.glb"))
    found.check(not glb.faults, f"glTF by its rules: {glb.faults[:3] or 'no fault'}")
    names = [mesh["name"] for mesh in glb.json["meshes"]]
    found.check({"part.stl", "clamp.stl", "path, gouge"} <= set(names), f"meshes are {names}")
    found.check(any(name.endswith(" holder") for name in names), "the tool is there with its holder")
    depth = max(value for (value,) in glb.attribute(names.index("part.stl"), "_DEPTH"))
    found.check(0.9 * deepest <= depth <= deepest + 1e-5, f"depth {depth} of {deepest}")
    return glb, names


def check_rules_can_fail(folder, found):
    data = read(folder, "scene.glb")
    size = struct.unpack_from("<I", data, 12)[0]
    text, start = data[20:20 + size].decode(), 28 + size
    root = json.loads(text)
    views, primitive = root["bufferViews"], root["meshes"][0]["primitives"][0]

    def first(accessor):
        return start + views[root["accessors"][accessor]["bufferView"]]["byteOffset"]

    def with_bytes(at, bytes_):
        return data[:at] + bytes_ + data[at + len(bytes_):]

    def with_json(change):
        changed = json.loads(text)
        change(changed)
        body = json.dumps(changed, separators=(",", ":")).encode()
        body += b" " * (-len(body) % 4)
        return struct.pack("<4sIIII", b"glTF", 2, 20 + len(body) + len(data) - start + 8, len(body), 0x4E4F534A) + body + data[start - 8:]

    wrong = {"an index out of range": with_bytes(first(primitive["indices"]), b"\xf0\xff\xff\x7f"),
             "a position beyond its max": with_bytes(first(primitive["attributes"]["POSITION"]), struct.pack("<f", 1e6)),
             "a normal twice as long": with_bytes(first(primitive["attributes"]["NORMAL"]), struct.pack("<fff", 0, 0, 2)),
             "a file cut short": data[:-4], "another length": with_bytes(8, struct.pack("<I", len(data) - 4)),
             "a view out of the buffer": with_json(lambda j: j["bufferViews"][-1].update(byteLength=10 ** 9)),
             "a node in a circle": with_json(lambda j: j["nodes"][0].update(children=[len(j["nodes"]) - 1])),
             "an empty list": with_json(lambda j: j.update(cameras=[], images=[], skins=[], materials=[])),
             "positions without max": with_json(lambda j: j["accessors"][primitive["attributes"]["POSITION"]].pop("max"))}
    for words, changed in wrong.items():
        found.check(Glb(changed).faults != [], "the rules find " + words)
    found.check(Glb(with_json(lambda j: None)).faults == [], "and nothing in the same file written again")


def check_ply(folder, found, glb, names):
    vertices, faces, is_whole = ply_rows(read(folder, "scene.ply"))
    found.check(is_whole, "PLY has what its head says")
    surfaces = [names.index("part.stl"), names.index("clamp.stl")]
    positions = [p for k in surfaces for p in glb.attribute(k, "POSITION")]
    depths = [d for k in surfaces for (d,) in glb.attribute(k, "_DEPTH")]
    found.check(len(vertices) == len(positions) and all(
        math.dist((v["x"], v["y"], v["z"]), p) < 1e-3 and v["depth"] == d for v, p, d in zip(vertices, positions, depths)),
        "PLY and glTF agree in every vertex")
    found.check(all(0 <= c < len(vertices) for face in faces for c in face), "faces are of vertices")
    found.check({v["mesh"] for v in vertices} == {0, 1}, "each mesh has its number")
    return vertices, faces


def check_vtk(folder, found, vertices, faces):
    facts = vtk_facts(os.path.join(folder, "scene.vtp"))
    if facts is None:
        print("skipped: VTK, as python3-vtk9 is not here", flush=True)
        return
    found.check(facts["errors"] == 0, "VTK opens the .vtp")
    points, kinds = facts["points"], facts["cell_data"]["kind"]
    found.check(all(tuple(p) == (v["x"], v["y"], v["z"]) for p, v in zip(points, vertices)), "its points are those of the PLY")
    same = all(facts["point_data"][name][k] == v[name] for name in ("depth", "overcut") for k, v in enumerate(vertices))
    found.check(same, "its depth and overcut too")
    found.check(set(kinds) == {0, 1, 2, 3}, f"kinds of cells: {sorted(set(kinds))}")
    found.check(len(kinds) == facts["lines"] + facts["polys"] and kinds.count(2) == facts["lines"], "lines are the path")
    triangles = [c for c, kind in zip(facts["corners"], kinds) if kind in (0, 1)]
    found.check([tuple(t) for t in triangles] == [tuple(f) for f in faces], "its triangles are those of the PLY")
    moves = [m for m, kind in zip(facts["cell_data"]["move"], kinds) if kind == 2]
    found.check(min(moves) > 0 and moves == sorted(moves), "each segment has its move")
    ply = vtk_facts(os.path.join(folder, "scene.ply"))
    found.check(ply["errors"] == 0 and len(ply["points"]) == len(vertices) and ply["polys"] == len(faces), "VTK opens the .ply")


def check_words(gougecheck, folder, found):
    for file in ("scene.obj", "scene", "-", ".glb"):
        done = run(gougecheck, folder, ["check", "pocket.apt", *PART, "--export", file])
        found.check(done.returncode == 2 and ".glb, .vtp or .ply" in done.stderr, f"--export {file}: {done.stderr.strip()}")
    done = run(gougecheck, folder, ["check", "pocket.apt", *PART, "--export", "a.glb", "--export", "./a.glb"])
    found.check(done.returncode == 2 and not os.path.exists(os.path.join(folder, "a.glb")), "one file for two is refused")
    shutil.copy(os.path.join(folder, "part.stl"), os.path.join(folder, "body.ply"))
    done = run(gougecheck, folder, ["check", "pocket.apt", "--part", "body.ply", "--tools", "tools.json", "--export", "body.ply"])
    found.check(done.returncode == 2 and "is the part itself" in done.stderr, "the part is not written over")
    done = run(gougecheck, folder, ["check", "pocket.apt", *PART, "--json", "r.json", "--export", "nowhere/a.glb"])
    found.check(done.returncode in (2, 3, 5) and not os.path.exists(os.path.join(folder, "r.json")), "all outputs or none")


def main():
    gougecheck, make_samples, folder = sys.argv[1:]
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([make_samples, folder], check=True, capture_output=True)
    folder, found = os.path.join(folder, "pocket"), Failures()
    done = run(gougecheck, folder, ["check", "pocket.apt", *PART, "--json", "result.json", "--threads", "1", *ALL])
    found.check(done.returncode == 1, "three exports of one check: " + done.stderr)
    result = json.loads(read(folder, "result.json"))
    deepest = result['totals']['worst_depth']
    glb, names = check_glb(folder, found, deepest)
    check_rules_can_fail(folder, found)
    vertices, faces = check_ply(folder, found, glb, names)
    check_vtk(folder, found, vertices, faces)
    once = [read(folder, name) for name in ALL[1::2]]
    run(gougecheck, folder, ["check", "pocket.apt", *PART, "--threads", "3", *ALL])
    found.check(once == [read(folder, name) for name in ALL[1::2]], "the same bytes with three threads")
    done = run(gougecheck, folder, ["correct", "pocket.apt", *PART, "-o", "fixed.apt", "--export", "fixed.glb"])
    found.check(done.returncode in (0, 1) and not Glb(read(folder, "fixed.glb")).faults, "correct exports the corrected path")
    check_words(gougecheck, folder, found)
    print("all right" if found.count == 0 else f"{found.count} wrong")
    sys.exit(1 if found.count else 0)


main()
