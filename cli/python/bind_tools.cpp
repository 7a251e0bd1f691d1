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

std::vector<ToolSegment> segments_of(const py::object& object, const std::string& name) {
  std::vector<ToolSegment> segments;
  if (object.is_none()) return segments;
  if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object))
    refuse_argument(name, "a list of (lower_diameter, upper_diameter, length)", object);
  for (const py::handle& item : object)
    segments.push_back(segment_of(item, name + "[" + std::to_string(segments.size()) + "]"));
  return segments;
}

Tool make_tool(const std::string& shape, const py::args& args, const py::kwargs& given) {
  const py::dict rest = given.attr("copy")();
  const auto taken = [&](const char* name) { return rest.attr("pop")(name, py::none()); };
  const py::object shank = taken("shank"), holder = taken("holder"), name = taken("name");
  if (!args.empty())
    throw py::type_error("Tool." + shape + "() takes only dimensions with their names, such as diameter=10; got " +
                         std::to_string(args.size()) + " without");
  std::map<std::string, double> dimensions;
  for (const auto& [key, value] : rest) dimensions[key.cast<std::string>()] = number_of(value, py::str(key));
  const std::vector<ToolSegment> shank_segments = segments_of(shank, "shank"),
                                 holder_segments = segments_of(holder, "holder");
  try {
    return {shape, dimensions, shank_segments, holder_segments, name.is_none() ? std::string() : text_of(name, "name")};
  } catch (const Error& error) {
    if (error.code() != "tool-dimension-name") throw;
    throw py::type_error("Tool." + shape + "(): " + error.what());  // keywords that do not exist, or are missing
  }
}

// Returns the name of a tool, which may also be given as a number.
std::string tool_name(const py::object& name) {
  const bool is_number = py::hasattr(name, "__index__") && !py::isinstance<py::bool_>(name);
  return is_number ? std::string(py::str(name)) : text_of(name, "name");
}

Tool tool_from_json(const py::args& args, const py::kwargs& given) {
  Keywords keywords("Tool.from_json", {"json", "name"}, args, given);
  const std::string json = text_of(keywords.required("json"), "json");
  const py::object name = keywords.object("name");
  keywords.finish();
  return Tool::from_json(json, name.is_none() ? "" : tool_name(name));
}

ToolLibrary make_library(const py::args& args, const py::kwargs& given) {
  Keywords keywords("ToolLibrary", {"tools"}, args, given);
  const py::object tools = keywords.required("tools");
  keywords.finish();
  if (!py::isinstance<py::iterable>(tools) || py::isinstance<py::str>(tools))
    refuse_argument("tools", "a list of Tool (ToolLibrary.read(file) reads a file)", tools);
  std::vector<Tool> all;
  for (const py::handle& tool : tools)
    all.push_back(bound<Tool>(tool, "tools[" + std::to_string(all.size()) + "]", "a Tool"));
  return ToolLibrary(all);
}

ToolLibrary read_library(const py::args& args, const py::kwargs& given) {
  Keywords keywords("ToolLibrary.read", {"file"}, args, given);
  const std::string file = file_of(keywords.required("file"));
  const ImportFacts facts = {keywords.number_or_none("stickout"), keywords.text("unit", "")};
  keywords.finish();
  const py::gil_scoped_release release;
  return ToolLibrary::read(file, facts);
}

ToolLibrary library_from_json(const py::args& args, const py::kwargs& given) {
  Keywords keywords("ToolLibrary.from_json", {"json"}, args, given);
  const std::string json = text_of(keywords.required("json"), "json");
  keywords.finish();
  return ToolLibrary::from_json(json);
}

Tool tool_of(const ToolLibrary& library, const py::args& args, const py::kwargs& given) {
  Keywords keywords("ToolLibrary.tool", {"name"}, args, given);
  const py::object name = keywords.required("name");
  keywords.finish();
  return library.tool(tool_name(name));
}

}  // namespace

void bind_tools(py::module_& module) {
  auto tool = py::class_<Tool>(
      module, "Tool",
      "A tool assembly, a solid of revolution: Tool.ball(diameter=10, length=30, shank=[(10, 10, 20)], "
      "holder=[(32, 32, 40)]).\n\nOne static method for each shape of docs/formats/tool_library.md, "
      "with its dimensions as keywords, in mm and degrees. shank and holder: lists of "
      "(lower_diameter, upper_diameter, length) from the cutter up. name: the name in reports, that of the shape by default. Immutable.");
  refuse_construction(tool, "Tool", "use the shape, such as Tool.ball(diameter=10, length=30), or Tool.from_json");
  tool.def(py::pickle([](const Tool& self) { return self.to_json(); },
                      [](const std::string& json) { return Tool::from_json(json); }));
  tool.def_static("from_json", &tool_from_json,
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
        shape.c_str(), [shape](const py::args& args, const py::kwargs& given) { return make_tool(shape, args, given); },
        doc.c_str());
  }
}

void bind_tool_libraries(py::module_& module) {
  auto library = py::class_<ToolLibrary>(
      module, "ToolLibrary",
      "The tools of paths that call several: ToolLibrary(tools), ToolLibrary.read(file) or ToolLibrary.from_json(json).\n\n"
      "len(library) counts the tools, a loop goes through them, and library[3], library['T3'] or library['name'] is one "
      "of them.");
  add_pickling(library);
  library.def(py::init(&make_library))
      .def_static("read", &read_library,
                  "read(file, *, stickout=None, unit='') -> ToolLibrary\n\nFrom a tool library of gougecheck, Fusion, "
                  "FreeCAD or NX, recognised by its content. stickout: mm, tip to holder, of imported tools whose file "
                  "does not state it. unit: mm or inch, of an NX library that states none. notes: what was assumed.")
      .def_static("from_json", &library_from_json,
                  "from_json(json) -> ToolLibrary\n\nFrom the text of a library file of "
                  "gougecheck.")
      .def_property_readonly("tools", &ToolLibrary::tools)
      .def_property_readonly("notes", &ToolLibrary::notes, "What the reader assumed or left out.")
      .def("to_json", &ToolLibrary::to_json, "A tool library of gougecheck that reads back as the same tools.")
      .def("tool", &tool_of, "tool(name) -> Tool\n\nThe tool of that name, or of that number: '3' or 'T3'.")
      .def("__getitem__", [](const ToolLibrary& self, const py::object& name) { return self.tool(tool_name(name)); })
      .def("__contains__", [](const ToolLibrary& self, const py::object& name) { return self.has(tool_name(name)); })
      .def("__len__", [](const ToolLibrary& self) { return self.tools().size(); })
      .def("__iter__", [](const ToolLibrary& self) { return py::iter(py::cast(self.tools())); })
      .def("__repr__", [](const ToolLibrary& self) {
        return "<gougecheck.ToolLibrary of " + std::to_string(self.tools().size()) + " tools>";
      });
}

}  // namespace gougecheck::python
