#include <gougecheck/path.h>
#include <pybind11/stl.h>

#include <string>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

Path make_path(const py::args& args, const py::kwargs& given) {
  Keywords keywords("Path", {"tips", "axes", "rapids", "name"}, args, given);
  const py::object tips = keywords.required("tips"), axes = keywords.required("axes"),
                   rapids = keywords.object("rapids");
  const std::string name = keywords.text("name", "path");
  keywords.finish();
  return Path(rows_of(tips, "tips"), rows_of(axes, "axes", true), flags_of(rapids, "rapids"), name);
}

ReadFacts read_facts(Keywords& keywords) { return {keywords.text("unit", ""), keywords.text("cutcom", "")}; }

Path path_from_text(const py::args& args, const py::kwargs& given) {
  Keywords keywords("Path.from_text", {"text", "name", "unit"}, args, given);
  const py::object text = keywords.required("text");
  const std::string name = keywords.text("name", "toolpath");
  const ReadFacts facts = read_facts(keywords);
  keywords.finish();
  if (!py::isinstance<py::bytes>(text) && !py::isinstance<py::str>(text))
    refuse_argument("text", "bytes or a str", text);
  auto bytes = text.cast<std::string>();
  const py::gil_scoped_release release;
  return Path::from_text(std::move(bytes), name, facts);
}

ProgramOptions program_options(Keywords& keywords) {
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

void bind_paths(py::module_& module) {
  auto path = py::class_<Path>(
      module, "Path",
      "A toolpath: Path(tips, axes, rapids=None, name='path').\n\ntips: C-contiguous float64 (n, 3), mm, "
      "where the tool's tip is. axes: (n, 3), or (3,) for all, from the tip to the spindle, of any length "
      "but 0. rapids: bool (n,), which moves are rapid. All are copied. Move 0 is the first position "
      "alone; move i the motion from position i - 1: the tip on the straight line, the axis on the great "
      "circle, both at constant speed. Immutable.");
  add_pickling(path);
  path.def(py::init(&make_path))
      .def_static(
          "from_text", &path_from_text,
          "from_text(text, name='toolpath', unit='', *, cutcom='') -> Path\n\nA Path from the text of a file, bytes or str, as "
          "read_toolpath reads it. name stands for the file in messages and reports.")
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
      .def("__repr__", [](const Path& self) {
        return "<gougecheck.Path '" + self.name() + "' of " + std::to_string(self.size()) + " moves>";
      });
  module.def(
      "read_toolpath",
      [](const py::args& args, const py::kwargs& given) {
        Keywords keywords("read_toolpath", {"file", "unit"}, args, given);
        const std::string name = file_of(keywords.required("file"));
        const ReadFacts facts = read_facts(keywords);
        keywords.finish();
        const py::gil_scoped_release release;
        return Path::read(name, facts);
      },
      "read_toolpath(file, unit='', *, cutcom='') -> Path\n\nA Path from CL data: APT, NX CLSF, CATIA, Creo, NCCS, Mastercam NCI "
      "and more, recognised by its content. unit: mm or inch, of a file that states none. cutcom: 'centre' if positions "
      "under CUTCOM are those of the cutter centre; otherwise these moves are not checked.");
  module.def(
      "read_program",
      [](const py::args& args, const py::kwargs& given) {
        Keywords keywords("read_program", {"file"}, args, given);
        const std::string name = file_of(keywords.required("file"));
        const ProgramOptions options = program_options(keywords);
        const py::gil_scoped_release release;
        return Path::read_program(name, options);
      },
      "read_program(file, *, control='', ...) -> Path\n\nA Path from a program of a machine's control (G-code), as the control runs it. Keywords: control, machine, "
      "joint_limits, joint_points, joint_rates, zero, tool_length, offsets, tool_lengths, start, tip_control_ends, "
      "harmless_words, block_delete, home, plain_numbers, rotary_turns, tip_frame, joint_rapid_law, unit; each is the "
      "text or the list of texts of the option of 'gougecheck check'. A check needs the machine that is given here.");
}

}  // namespace gougecheck::python
