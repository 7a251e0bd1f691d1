#include <gougecheck/mesh.h>
#include <gougecheck/path.h>
#include <gougecheck/tool.h>
#include <pybind11/stl.h>

#include <tuple>

#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

using Segments = std::vector<std::tuple<double, double, double>>;

std::vector<ToolSegment> segments_of(const Segments& tuples) {
  std::vector<ToolSegment> segments;
  for (const auto& [lower, upper, length] : tuples) segments.push_back({lower, upper, length});
  return segments;
}

Segments taken(const py::dict& keywords, const char* name) {
  if (!keywords.contains(name)) return {};
  const py::object value = keywords.attr("pop")(name);
  return value.cast<Segments>();
}

Tool make_tool(const std::string& shape, const py::kwargs& keywords) {
  const py::dict rest = keywords.attr("copy")();
  const Segments shank = taken(rest, "shank"), holder = taken(rest, "holder");
  return {shape, rest.cast<std::map<std::string, double>>(), segments_of(shank), segments_of(holder)};
}

std::string path_text(const py::object& file) {
  return py::module_::import("os").attr("fspath")(file).cast<std::string>();
}

}  // namespace

void bind_meshes(py::module_& module) {
  py::class_<Mesh>(module, "Mesh",
                   "A triangulated surface in mm, exactly as given: Mesh(vertices, faces, name='mesh').\n\n"
                   "vertices: C-contiguous float64 of shape (n, 3). faces: C-contiguous integers of shape (m, 3), "
                   "counter-clockwise seen from outside, as trimesh has them. Both are copied; vertices with identical "
                   "coordinates become one. Immutable. The first check makes an index, which stays with the mesh.")
      .def(py::init([](const py::object& vertices, const py::object& faces, const std::string& name) {
             const auto rows = rows_of(vertices, "vertices");
             const auto triangles = triangles_of(faces);
             const py::gil_scoped_release release;
             return Mesh(rows, triangles, name);
           }),
           py::arg("vertices"), py::arg("faces"), py::arg("name") = "mesh")
      .def_static(
          "read_stl",
          [](const py::object& file, const std::string& unit) {
            const std::string name = path_text(file);
            const py::gil_scoped_release release;
            return Mesh::read_stl(name, unit);
          },
          py::arg("file"), py::arg("unit") = "",
          "A mesh from a binary or ASCII STL file. unit: um, mm, cm, m or inch, what its numbers are; '': a check takes "
          "that of its path, and all else takes mm.")
      .def_property_readonly(
          "vertices", [](const py::object& self) { return view(self.cast<const Mesh&>().vertices(), self); },
          "float64 (n, 3), mm, after joining; a read-only view.")
      .def_property_readonly(
          "faces", [](const py::object& self) { return view(self.cast<const Mesh&>().faces(), self); },
          "uint32 (m, 3); a read-only view.")
      .def_property_readonly(
          "given_face", [](const py::object& self) { return view(self.cast<const Mesh&>().given_face(), self); },
          "uint32 (m,): by face its index among the faces as given; a read-only view.")
      .def_property_readonly("name", &Mesh::name)
      .def_property_readonly("is_solid", &Mesh::is_solid,
                             "It separates inside from outside, so that a buried tool is found.")
      .def_property_readonly("notes", &Mesh::notes, "What was noticed: open edges, wrong orientations.")
      .def("__repr__", [](const Mesh& mesh) {
        return "<gougecheck.Mesh '" + mesh.name() + "' of " + std::to_string(mesh.faces().size()) + " triangles>";
      });
  py::class_<Scene>(module, "Scene",
                    "What stands still: Scene(parts, fixtures=[]), lists of Mesh. Parts must not be cut into, fixtures "
                    "not be touched. Immutable; keep it when several checks use it, since it holds their index.")
      .def(py::init<std::vector<Mesh>, std::vector<Mesh>>(), py::arg("parts"),
           py::arg("fixtures") = std::vector<Mesh>())
      .def("__repr__", [](const Scene& scene) {
        return "<gougecheck.Scene of " + std::to_string(scene.parts().size()) + " parts and " +
               std::to_string(scene.fixtures().size()) + " fixtures>";
      });
}

void bind_tools(py::module_& module) {
  auto tool = py::class_<Tool>(
      module, "Tool",
      "A tool assembly, a solid of revolution: Tool.ball(diameter=10, length=30, shank=[(10, 10, 20)], "
      "holder=[(32, 32, 40)]).\n\nOne static method for each shape of docs/formats/tool_library.md, "
      "with its dimensions as keywords, in mm and degrees. shank and holder: lists of "
      "(lower_diameter, upper_diameter, length) from the cutter up. Immutable.");
  tool.def_static(
          "from_json", [](const std::string& json, const std::string& name) { return Tool::from_json(json, name); },
          py::arg("json"), py::arg("name") = "",
          "From the JSON of one tool, or of a library; name: which of its tools, a name or number.")
      .def_property_readonly("name", &Tool::name)
      .def_property_readonly("has_holder", &Tool::has_holder)
      .def_property_readonly("height", &Tool::height, "Tip to top, mm.")
      .def("to_json", &Tool::to_json, "A tool library that reads back as the same tool.")
      .def("__repr__", [](const Tool& self) { return "<gougecheck.Tool '" + self.name() + "'>"; });
  for (const std::string& shape : tool_shapes()) {
    if (shape == "profile") continue;  // its points are a list: from_json
    const std::string doc = "A cutter of the shape '" + shape + "'; see docs/formats/tool_library.md for its keywords.";
    tool.def_static(
        shape.c_str(), [shape](const py::kwargs& keywords) { return make_tool(shape, keywords); }, doc.c_str());
  }
  py::class_<ToolLibrary>(
      module, "ToolLibrary",
      "The tools of paths that call several: ToolLibrary.read(file) or ToolLibrary.from_json(json).")
      .def_static(
          "read", [](const py::object& file) { return ToolLibrary::read(path_text(file)); }, py::arg("file"),
          "From a tool library file (docs/formats/tool_library.md).")
      .def_static(
          "from_json", [](const std::string& json) { return ToolLibrary::from_json(json); }, py::arg("json"),
          "From the text of such a file.")
      .def_property_readonly("tools", &ToolLibrary::tools)
      .def(
          "tool", [](const ToolLibrary& self, const std::string& name) { return self.tool(name); }, py::arg("name"),
          "The tool of that name, or of that number: '3' or 'T3'.");
}

void bind_paths(py::module_& module) {
  py::class_<Path>(module, "Path",
                   "A toolpath: Path(tips, axes, rapids=None, name='path').\n\ntips: C-contiguous float64 (n, 3), mm, "
                   "where the tool's tip is. axes: (n, 3), or (3,) for all, from the tip to the spindle, of any length "
                   "but 0. rapids: bool (n,), which moves are rapid. All are copied. Move 0 is the first position "
                   "alone; move i the motion from position i - 1: the tip on the straight line, the axis on the great "
                   "circle, both at constant speed. Immutable.")
      .def(py::init(
               [](const py::object& tips, const py::object& axes, const py::object& rapids, const std::string& name) {
                 return Path(rows_of(tips, "tips"), rows_of(axes, "axes", true), flags_of(rapids, "rapids"), name);
               }),
           py::arg("tips"), py::arg("axes"), py::arg("rapids") = py::none(), py::arg("name") = "path")
      .def_property_readonly(
          "tips", [](const py::object& self) { return view(self.cast<const Path&>().tips(), self); },
          "float64 (n, 3), mm: where the moves end; a read-only view.")
      .def_property_readonly(
          "axes", [](const py::object& self) { return view(self.cast<const Path&>().axes(), self); },
          "float64 (n, 3), unit; a read-only view.")
      .def_property_readonly(
          "lines", [](const py::object& self) { return view(self.cast<const Path&>().lines(), self); },
          "uint32 (n,): the line of the file a move's statement begins on, from 1; a read-only view.")
      .def_property_readonly("name", &Path::name)
      .def_property_readonly("notes", &Path::notes, "What the reader had to say.")
      .def_property_readonly(
          "text",
          [](const Path& self) {
            const std::string text = self.text();
            return py::bytes(text);
          },
          "bytes: its file; of a path from memory APT that reads back as the same positions.")
      .def("__len__", &Path::size)
      .def("__repr__", [](const Path& path) {
        return "<gougecheck.Path '" + path.name() + "' of " + std::to_string(path.size()) + " moves>";
      });
  module.def(
      "read_toolpath",
      [](const py::object& file, const std::string& unit) {
        const std::string name = path_text(file);
        const py::gil_scoped_release release;
        return Path::read(name, unit);
      },
      py::arg("file"), py::arg("unit") = "",
      "A Path from CL data: APT, NX CLSF, CATIA, Creo, NCCS, Mastercam NCI and more, recognised by its content. unit: mm "
      "or inch, of a file that states none.");
}

}  // namespace gougecheck::python
