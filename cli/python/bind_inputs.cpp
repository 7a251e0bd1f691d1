#include <gougecheck/mesh.h>
#include <gougecheck/path.h>
#include <gougecheck/tool.h>
#include <pybind11/stl.h>

#include <map>
#include <string>
#include <vector>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

ToolSegment segment_of(const py::handle& object, const std::string& name) {
  const bool is_tuple =
      py::isinstance<py::sequence>(object) && !py::isinstance<py::str>(object) && py::len(object) == 3;
  if (!is_tuple) refuse_argument(name, "(lower_diameter, upper_diameter, length)", object);
  const auto at = [&](std::size_t i) { return number_of(object[py::int_(i)], name + "[" + std::to_string(i) + "]"); };
  return {at(0), at(1), at(2)};
}

std::vector<double> lengths_of(const py::object& object) {
  const std::string name = "fixture_clearances";
  if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object))
    refuse_argument(name, "a list of lengths in mm", object);
  std::vector<double> lengths;
  for (const py::handle& item : object)
    lengths.push_back(number_of(item, name + "[" + std::to_string(lengths.size()) + "]"));
  return lengths;
}

std::vector<ToolSegment> segments_of(const py::object& object, const std::string& name) {
  std::vector<ToolSegment> segments;
  if (object.is_none()) return segments;
  if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object))
    refuse_argument(name, "a list of (lower_diameter, upper_diameter, length)", object);
  for (const py::handle& item : object)
    segments.push_back(segment_of(item, name + "[" + std::to_string(segments.size()) + "]"));
  return segments;
}

Tool make_tool(const std::string& shape, const py::kwargs& keywords) {
  const py::dict rest = keywords.attr("copy")();
  const py::object shank = rest.attr("pop")("shank", py::none()), holder = rest.attr("pop")("holder", py::none());
  std::map<std::string, double> dimensions;
  for (const auto& [key, value] : rest) dimensions[key.cast<std::string>()] = number_of(value, py::str(key));
  return {shape, dimensions, segments_of(shank, "shank"), segments_of(holder, "holder")};
}

// Returns the name of a tool, which may also be given as a number.
std::string tool_name(const py::object& name) {
  const bool is_number = py::hasattr(name, "__index__") && !py::isinstance<py::bool_>(name);
  return is_number ? std::string(py::str(name)) : text_of(name, "name");
}

ProgramOptions program_options(const py::kwargs& given) {
  Keywords keywords("read_program", given);
  ProgramOptions options;
  options.control = keywords.text("control", "");
  options.machine = keywords.text("machine", "");
  options.joint_limits = keywords.texts("joint_limits");
  options.joint_points = keywords.texts("joint_points");
  options.joint_rates = keywords.texts("joint_rates");
  options.zero = keywords.text("zero", "");
  options.tool_length = keywords.number_or_none("tool_length");
  options.offsets = keywords.texts("offsets");
  options.tool_lengths = keywords.text("tool_lengths", "");
  options.start = keywords.texts("start");
  options.tip_control_ends = keywords.texts("tip_control_ends");
  options.harmless_words = keywords.texts("harmless_words");
  options.block_delete = keywords.text("block_delete", "");
  options.home = keywords.text("home", "");
  options.plain_numbers = keywords.text("plain_numbers", "");
  options.rotary_turns = keywords.text("rotary_turns", "");
  options.tip_frame = keywords.text("tip_frame", "");
  options.joint_rapid_law = keywords.text("joint_rapid_law", "");
  options.unit = keywords.text("unit", "");
  keywords.finish();
  return options;
}

}  // namespace

void bind_meshes(py::module_& module) {
  py::class_<Mesh>(module, "Mesh",
                   "A triangulated surface in mm, exactly as given: Mesh(vertices, faces, name='mesh').\n\n"
                   "vertices: C-contiguous float64 of shape (n, 3). faces: C-contiguous integers of shape (m, 3), "
                   "counter-clockwise seen from outside, as trimesh has them. Both are copied; vertices with identical "
                   "coordinates become one. Immutable. The first check makes an index, which stays with the mesh.")
      .def(py::init([](const py::object& vertices, const py::object& faces, const py::object& its_name) {
             const std::string name = text_of(its_name, "name");
             const auto rows = rows_of(vertices, "vertices");
             const auto triangles = triangles_of(faces);
             const py::gil_scoped_release release;
             return Mesh(rows, triangles, name);
           }),
           py::arg("vertices"), py::arg("faces"), py::arg("name") = "mesh")
      .def_static(
          "read_stl",
          [](const py::object& file, const py::object& its_unit) {
            const std::string name = file_of(file), unit = text_of(its_unit, "unit");
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
  py::class_<Scene>(
      module, "Scene",
      "What stands still: Scene(parts, fixtures=[], fixture_clearances=[]), lists of Mesh. Parts must not be "
      "cut into, fixtures not be touched; a fixture with a clearance in mm is kept at that distance. Immutable; keep it when several checks use it, since it holds their index.")
      .def(py::init([](const py::object& parts, const py::object& fixtures, const py::object& clearances) {
             return Scene(meshes_of(parts, "parts"), meshes_of(fixtures, "fixtures"), lengths_of(clearances));
           }),
           py::arg("parts"), py::arg("fixtures") = py::tuple(), py::arg("fixture_clearances") = py::tuple())
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
          "from_json",
          [](const py::object& json, const py::object& name) {
            return Tool::from_json(text_of(json, "json"), tool_name(name));
          },
          py::arg("json"), py::arg("name") = "",
          "From the JSON of one tool, or of a library; name: which of its tools, a name or number.")
      .def_property_readonly("name", &Tool::name)
      .def_property_readonly("has_holder", &Tool::has_holder)
      .def_property_readonly("height", &Tool::height, "Tip to top, mm.")
      .def("to_json", &Tool::to_json, "A tool library that reads back as the same tool.")
      .def("__repr__", [](const Tool& self) { return "<gougecheck.Tool '" + self.name() + "'>"; });
  for (const std::string& shape : tool_shapes()) {
    if (shape == "profile") continue;  // the points of a profile are a list: use from_json
    const std::string doc = "A cutter of the shape '" + shape + "'; see docs/formats/tool_library.md for its keywords.";
    tool.def_static(
        shape.c_str(), [shape](const py::kwargs& keywords) { return make_tool(shape, keywords); }, doc.c_str());
  }
  py::class_<ToolLibrary>(
      module, "ToolLibrary",
      "The tools of paths that call several: ToolLibrary.read(file) or ToolLibrary.from_json(json).")
      .def_static(
          "read", [](const py::object& file) { return ToolLibrary::read(file_of(file)); }, py::arg("file"),
          "From a tool library file (docs/formats/tool_library.md).")
      .def_static(
          "from_json", [](const py::object& json) { return ToolLibrary::from_json(text_of(json, "json")); },
          py::arg("json"), "From the text of such a file.")
      .def_property_readonly("tools", &ToolLibrary::tools)
      .def(
          "tool", [](const ToolLibrary& self, const py::object& name) { return self.tool(tool_name(name)); },
          py::arg("name"), "The tool of that name, or of that number: '3' or 'T3'.");
}

void bind_paths(py::module_& module) {
  py::class_<Path>(module, "Path",
                   "A toolpath: Path(tips, axes, rapids=None, name='path').\n\ntips: C-contiguous float64 (n, 3), mm, "
                   "where the tool's tip is. axes: (n, 3), or (3,) for all, from the tip to the spindle, of any length "
                   "but 0. rapids: bool (n,), which moves are rapid. All are copied. Move 0 is the first position "
                   "alone; move i the motion from position i - 1: the tip on the straight line, the axis on the great "
                   "circle, both at constant speed. Immutable.")
      .def(py::init(
               [](const py::object& tips, const py::object& axes, const py::object& rapids, const py::object& name) {
                 return Path(rows_of(tips, "tips"), rows_of(axes, "axes", true), flags_of(rapids, "rapids"),
                             text_of(name, "name"));
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
        const std::string name = file_of(file);
        const py::gil_scoped_release release;
        return Path::read(name, unit);
      },
      py::arg("file"), py::arg("unit") = "",
      "A Path from CL data: APT, NX CLSF, CATIA, Creo, NCCS, Mastercam NCI and more, recognised by its content. unit: mm "
      "or inch, of a file that states none.");
  module.def(
      "read_program",
      [](const py::object& file, const py::kwargs& keywords) {
        const std::string name = file_of(file);
        const ProgramOptions options = program_options(keywords);
        const py::gil_scoped_release release;
        return Path::read_program(name, options);
      },
      py::arg("file"),
      "A Path from a program of a machine's control (G-code), as the control runs it. Keywords: control, machine, "
      "joint_limits, joint_points, joint_rates, zero, tool_length, offsets, tool_lengths, start, tip_control_ends, "
      "harmless_words, block_delete, home, plain_numbers, rotary_turns, tip_frame, joint_rapid_law, unit; each is the "
      "text or the list of texts of the option of 'gougecheck check'. A check needs the machine that is given here.");
}

}  // namespace gougecheck::python
