"""The rules of glTF 2.0 (Khronos, ISO/IEC 12113:2022) for a .glb file: gltf_rules.py FILE prints what breaks them.

Written from the specification, without regard to the writer; numbers of sections are those of its version 2.0.1.
"""

import json
import math
import struct
import sys

SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
LETTERS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
ROOT_KEYS = {"accessors", "animations", "asset", "buffers", "bufferViews", "cameras", "extensions", "extensionsRequired",
             "extensionsUsed", "extras", "images", "materials", "meshes", "nodes", "samplers", "scene", "scenes", "skins",
             "textures"}
# Of an attribute: the types and the components (with whether they are normalized) that section 3.7.2.1 allows.
ATTRIBUTES = {"POSITION": ({"VEC3"}, {(5126, False)}), "NORMAL": ({"VEC3"}, {(5126, False)}),
              "TANGENT": ({"VEC4"}, {(5126, False)}),
              "COLOR_0": ({"VEC3", "VEC4"}, {(5126, False), (5121, True), (5123, True)})}


class Glb:
    def __init__(self, data):
        self.faults, self.json, self.binary = [], {}, b""
        self.read_chunks(data)
        if not self.faults:
            self.check_all()

    def require(self, is_right, words):
        if not is_right:
            self.faults.append(words)
        return is_right

    def read_chunks(self, data):
        """Section 4.4: header, a chunk of JSON, then at most one of bytes, each on four bytes."""
        if not self.require(len(data) >= 20, "shorter than a header and a chunk"):
            return
        magic, version, length = struct.unpack_from("<4sII", data)
        self.require(magic == b"glTF", "magic is not glTF")
        self.require(version == 2, "version is not 2")
        self.require(length == len(data), "length is not that of the file")
        at, kinds = 12, []
        while at < len(data):
            if not self.require(at % 4 == 0 and at + 8 <= len(data), "a chunk does not begin on four bytes"):
                return
            size, kind = struct.unpack_from("<II", data, at)
            if not self.require(size % 4 == 0 and at + 8 + size <= len(data), "a chunk is not whole, or not padded"):
                return
            body = data[at + 8:at + 8 + size]
            kinds.append(kind)
            if kind == 0x4E4F534A:
                text = body.decode("utf-8")  # throws where it is not
                self.require(not text.startswith("\ufeff"), "a byte order mark")
                self.require(text.rstrip(" ").endswith("}"), "JSON is not padded with blanks")
                self.json = json.loads(text, object_pairs_hook=self.unique, parse_constant=self.no_constant)
            elif kind == 0x004E4942:
                self.binary = body
            at += 8 + size
        self.require(kinds in ([0x4E4F534A], [0x4E4F534A, 0x004E4942]), f"chunks are {kinds}")

    def unique(self, pairs):
        self.require(len({key for key, _ in pairs}) == len(pairs), "a key stands twice in an object")
        return dict(pairs)

    def no_constant(self, name):
        self.faults.append(name + " is no JSON")
        return 0

    def items(self, name):
        """Lists are never empty (section 3.1); what refers to them is in range."""
        found = self.json.get(name, [])
        self.require(isinstance(found, list) and (name not in self.json or len(found) > 0), name + " is empty or no list")
        return found

    def is_index(self, value, name):
        return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < len(self.json.get(name, []))

    def check_all(self):
        self.require(set(self.json) <= ROOT_KEYS, f"unknown keys {set(self.json) - ROOT_KEYS}")
        self.require(self.json.get("asset", {}).get("version") == "2.0", "asset.version is not 2.0")
        for needed in ("extensionsUsed", "extensionsRequired"):
            self.require(needed not in self.json, needed + " is not looked at here")
        self.check_buffers()
        self.check_accessors()
        self.check_materials()
        self.check_meshes()
        self.check_nodes()
        self.check_used()

    def check_buffers(self):
        buffers = self.items("buffers")
        self.require(len(buffers) <= 1, "more than the buffer of the file")
        for buffer in buffers:
            size = buffer["byteLength"]
            self.require("uri" not in buffer and size >= 1, "the first buffer is that of the file")
            self.require(size <= len(self.binary) <= size + 3, "the chunk is up to three bytes longer than the buffer")
            self.require(not any(self.binary[size:]), "padded with zeros")
        for k, view in enumerate(self.items("bufferViews")):
            if not self.require(self.is_index(view["buffer"], "buffers"), f"view {k}: no such buffer"):
                continue
            first, size = view.get("byteOffset", 0), view["byteLength"]
            self.require(first >= 0 and size >= 1 and first + size <= buffers[view["buffer"]]["byteLength"],
                         f"view {k}: outside of the buffer")
            self.require(view.get("target") in (None, 34962, 34963), f"view {k}: target")
            stride = view.get("byteStride")
            self.require(stride is None or (4 <= stride <= 252 and stride % 4 == 0 and view.get("target") != 34963),
                         f"view {k}: stride")

    def check_accessors(self):
        self.values = []
        for k, one in enumerate(self.items("accessors")):
            self.values.append([])
            ok = one.get("componentType") in SIZES and one.get("type") in WIDTHS and one.get("count", 0) >= 1 and self.is_index(
                one.get("bufferView"), "bufferViews")
            if not self.require(ok, f"accessor {k}: type, count or view"):
                continue
            view = self.json["bufferViews"][one["bufferView"]]
            part, width = SIZES[one["componentType"]], WIDTHS[one["type"]]
            first, stride = one.get("byteOffset", 0), view.get("byteStride", part * width)
            self.require(first % part == 0 and (first + view.get("byteOffset", 0)) % part == 0 and stride % part == 0,
                         f"accessor {k}: not aligned to its component")
            self.require(first + stride * (one["count"] - 1) + part * width <= view["byteLength"], f"accessor {k}: outside of its view")
            self.require(not one.get("normalized") or one["componentType"] not in (5125, 5126), f"accessor {k}: normalized")
            start = first + view.get("byteOffset", 0)
            form = struct.Struct("<" + LETTERS[one["componentType"]] * width)
            if stride == form.size:
                self.values[k] = list(form.iter_unpack(self.binary[start:start + form.size * one["count"]]))
            else:
                self.values[k] = [form.unpack_from(self.binary, start + stride * i) for i in range(one["count"])]
            if one["componentType"] == 5126:
                self.require(all(math.isfinite(x) for value in self.values[k] for x in value), f"accessor {k}: not finite")
            for name, choose in (("min", min), ("max", max)):
                if name in one:
                    held = [choose(value[c] for value in self.values[k]) for c in range(width)]
                    self.require(list(map(float, one[name])) == list(map(float, held)), f"accessor {k}: {name} is {one[name]}, held {held}")

    def check_materials(self):
        for k, one in enumerate(self.items("materials")):
            rough = one.get("pbrMetallicRoughness", {})
            factors = [*rough.get("baseColorFactor", [1, 1, 1, 1]), rough.get("metallicFactor", 1), rough.get("roughnessFactor", 1)]
            self.require(len(factors) == 6 and all(0 <= f <= 1 for f in factors), f"material {k}: a factor is not in 0 to 1")

    def check_meshes(self):
        for k, mesh in enumerate(self.items("meshes")):
            self.require(len(mesh.get("primitives", [])) > 0, f"mesh {k}: without primitives")
            for primitive in mesh.get("primitives", []):
                self.check_primitive(f"mesh {k}", primitive)

    def check_primitive(self, name, primitive):
        attributes, accessors = primitive.get("attributes", {}), self.json["accessors"]
        if not self.require(attributes and all(self.is_index(a, "accessors") for a in attributes.values()), name + ": attributes"):
            return
        self.require("POSITION" in attributes, name + ": no positions")
        self.require(len({accessors[a]["count"] for a in attributes.values()}) == 1, name + ": attributes differ in count")
        for attribute, index in attributes.items():
            one = accessors[index]
            if not attribute.startswith("_"):
                types, components = ATTRIBUTES.get(attribute, (set(), set()))
                self.require(one["type"] in types and (one["componentType"], bool(one.get("normalized"))) in components,
                             f"{name}: {attribute} has a wrong type")
            else:
                self.require(attribute.upper() == attribute and one["componentType"] != 5125, f"{name}: {attribute}")
            view = self.json["bufferViews"][one["bufferView"]]
            width = SIZES[one["componentType"]] * WIDTHS[one["type"]]
            self.require(view.get("byteStride", width) % 4 == 0, f"{name}: {attribute} is not on four bytes")
            self.require(view.get("target") == 34962, f"{name}: target of {attribute}")
        count = accessors[attributes["POSITION"]]["count"]
        self.require({"min", "max"} <= set(accessors[attributes["POSITION"]]), name + ": positions without min and max")
        for value in self.values[attributes["NORMAL"]] if "NORMAL" in attributes else []:
            if not self.require(abs(math.hypot(*value) - 1) < 1e-4, f"{name}: a normal is {math.hypot(*value)} long"):
                break
        self.require("material" not in primitive or self.is_index(primitive["material"], "materials"), name + ": material")
        mode, drawn = primitive.get("mode", 4), count
        self.require(mode in range(7), name + ": mode")
        if "indices" in primitive and self.require(self.is_index(primitive["indices"], "accessors"), name + ": indices"):
            one = accessors[primitive["indices"]]
            self.require(one["type"] == "SCALAR" and one["componentType"] in (5121, 5123, 5125) and not one.get("normalized"),
                         name + ": type of indices")
            self.require(self.json["bufferViews"][one["bufferView"]].get("target") == 34963, name + ": target of indices")
            indices = [value[0] for value in self.values[primitive["indices"]]]
            self.require(max(indices) < count, name + ": an index is out of range")
            self.require(max(indices) < 256 ** SIZES[one["componentType"]] - 1, name + ": an index restarts the primitive")
            self.require(len(set(indices)) == count, name + ": vertices that nothing draws")
            drawn = len(indices)
            if mode == 4:
                self.require(all(len(set(indices[i:i + 3])) == 3 for i in range(0, drawn - 2, 3)), name + ": a triangle is a line")
        self.require(drawn % {1: 2, 4: 3}.get(mode, 1) == 0, name + ": number of vertices")

    def check_nodes(self):
        nodes, parents = self.items("nodes"), {}
        for k, node in enumerate(nodes):
            self.require("mesh" not in node or self.is_index(node["mesh"], "meshes"), f"node {k}: mesh")
            self.require(not ("matrix" in node and {"translation", "rotation", "scale"} & set(node)), f"node {k}: matrix beside parts")
            self.require(abs(math.hypot(*node.get("rotation", [0, 0, 0, 1])) - 1) < 5e-4, f"node {k}: rotation is no unit quaternion")
            self.require(len(node.get("rotation", [0] * 4)) == 4 and len(node.get("scale", [1] * 3)) == 3, f"node {k}: transform")
            children = node.get("children", [])
            self.require("children" not in node or (children and len(set(children)) == len(children)), f"node {k}: children")
            for child in children:
                self.require(self.is_index(child, "nodes") and child != k and child not in parents, f"node {k}: not a tree")
                parents[child] = k
        for k in range(len(nodes)):
            seen, at = set(), k
            while at in parents and at not in seen:
                seen.add(at)
                at = parents[at]
            self.require(at not in parents, f"node {k}: in a circle")
        for scene in self.items("scenes"):
            roots = scene.get("nodes", [])
            self.require("nodes" not in scene or roots, "a scene with an empty list")
            self.require(all(self.is_index(n, "nodes") and n not in parents for n in roots), "a node of a scene is no root")
        self.require("scene" not in self.json or self.is_index(self.json["scene"], "scenes"), "scene")

    def check_used(self):
        """Nothing lies in the file that nothing uses."""
        primitives = [p for mesh in self.json.get("meshes", []) for p in mesh["primitives"]]
        used = {"meshes": {n["mesh"] for n in self.json.get("nodes", []) if "mesh" in n},
                "materials": {p["material"] for p in primitives if "material" in p},
                "accessors": {a for p in primitives for a in [*p["attributes"].values(), *([p["indices"]] if "indices" in p else [])]},
                "bufferViews": {a["bufferView"] for a in self.json.get("accessors", [])}}
        for name, indices in used.items():
            self.require(indices == set(range(len(self.json.get(name, [])))), name + ": not all are used")

    def attribute(self, mesh, name):
        index = self.json["meshes"][mesh]["primitives"][0]["attributes"].get(name)
        return None if index is None else self.values[index]


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as source:
        faults = Glb(source.read()).faults
    print("\n".join(faults) or "no fault")
    sys.exit(1 if faults else 0)
