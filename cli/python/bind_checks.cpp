#include <gougecheck/check.h>
#include <pybind11/stl.h>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

const char* const kOptions =
    "\n\npart: a Mesh, a list of them, or a Scene, which then has the fixtures. tool: a Tool, or a ToolLibrary for a "
    "path that calls several. tolerance: depth a move may have; resolution: the certified gap; stock_to_leave, "
    "shank_clearance, holder_clearance: grow that body; near_miss: report what comes nearer, 0: nothing; all in mm. "
    "rapids: 'straight', 'dogleg' or 'skip'. machine: a machine file or 'preset:NAME', whose control moves the tool axis; "
    "feed_law, rapid_law: 'vector', 'axis' or 'joint' in place of the control's, of rapids also 'independent'; tool_length: "
    "from the gauge point to the tip, for a rotary head, to within tool_length_slack; joint_limits, joint_points, joint_rates: lists such as ['A=-30..120'], "
    "['A=0,0,50'], ['A=3600'] in place of facts of the machine file; zero: the part zero in machine coordinates, 'x,y,z' or "
    "'x,y,z,rx,ry,rz'. tip_tolerance, mm, and axis_tolerance, degrees: how far a control "
    "that smooths the path may depart from its law. threads: 0 for all; the result is the same at any number. assume: facts to "
    "take as stated, such as 'path-unit', 'placement', 'tool=T3'; strict: clean only where no fact is taken by default. "
    "The GIL is released.";

Rapids rapids_called(const std::string& name) {
  constexpr const char* kNames[] = {"straight", "dogleg", "skip"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (name == kNames[i]) return static_cast<Rapids>(i);
  }
  throw py::value_error("rapids: expected 'straight', 'dogleg' or 'skip', got '" + name + "'");
}

/// The arguments that check and correct share.
struct Asked {
  const Path& path;
  Scene scene;
  const Tool* tool;
  const ToolLibrary* library;
  CheckOptions options;
};

Scene scene_of(const py::object& part, const py::object& fixtures) {
  const bool has_fixtures = !fixtures.is_none() && (!py::isinstance<py::sequence>(fixtures) || py::len(fixtures) > 0);
  if (py::isinstance<Scene>(part)) {
    if (has_fixtures) throw py::type_error("fixtures: the Scene given as part has its own");
    return part.cast<Scene>();
  }
  if (py::isinstance<Mesh>(part) && !has_fixtures) return part.cast<Mesh>();
  std::vector<Mesh> parts = meshes_of(part, "part", "a Mesh, a list of Mesh or a Scene");
  return Scene(std::move(parts), has_fixtures ? meshes_of(fixtures, "fixtures") : std::vector<Mesh>());
}

const std::vector<const char*> kFirst = {"path", "part", "tool"};

/// The first arguments, in their order.
struct First {
  py::object path, part, tool;

  explicit First(Keywords& keywords)
      : path(keywords.required(kFirst[0])), part(keywords.required(kFirst[1])), tool(keywords.required(kFirst[2])) {}
};

Asked asked(const First& first, const py::object& fixtures, const CheckOptions& options) {
  const auto& [path, part, tool] = first;
  const Path& its_path = bound<Path>(path, "path", "a Path (read_toolpath(file) makes one)");
  const bool is_tool = py::isinstance<Tool>(tool);
  static const ToolLibrary kOfPath = ToolLibrary::empty();
  if (tool.is_none()) return {its_path, scene_of(part, fixtures), nullptr, &kOfPath, options};
  const ToolLibrary* library =
      is_tool ? nullptr : &bound<ToolLibrary>(tool, "tool", "a Tool, a ToolLibrary, or None for the tools of the path");
  return {its_path, scene_of(part, fixtures), is_tool ? tool.cast<const Tool*>() : nullptr, library, options};
}

// Takes the options that check and correct share, except near_miss.
CheckOptions take_options(Keywords& keywords) {
  const CheckOptions defaults;
  CheckOptions options;
  options.tolerance = keywords.number("tolerance", defaults.tolerance);
  options.resolution = keywords.number("resolution", defaults.resolution);
  options.stock_to_leave = keywords.number("stock_to_leave", defaults.stock_to_leave);
  options.shank_clearance = keywords.number("shank_clearance", defaults.shank_clearance);
  options.holder_clearance = keywords.number("holder_clearance", defaults.holder_clearance);
  options.rapids = rapids_called(keywords.text("rapids", "straight"));
  options.machine = keywords.text("machine", "");
  options.feed_law = keywords.text("feed_law", "");
  options.rapid_law = keywords.text("rapid_law", "");
  options.tool_length = keywords.number_or_none("tool_length");
  options.tool_length_slack = keywords.number("tool_length_slack", options.tool_length_slack);
  options.joint_limits = keywords.texts("joint_limits");
  options.joint_points = keywords.texts("joint_points");
  options.joint_rates = keywords.texts("joint_rates");
  options.zero = keywords.text("zero", "");
  options.tip_tolerance = keywords.number("tip_tolerance", options.tip_tolerance);
  options.axis_tolerance = keywords.number("axis_tolerance", options.axis_tolerance);
  options.threads = keywords.count("threads", defaults.threads);
  options.assume = keywords.texts("assume");
  options.strict = keywords.flag("strict", defaults.strict);
  return options;
}

/// Returns the sequence in an argument; a single object counts as one of one element.
std::vector<py::object> items_of(const py::object& object) {
  if (object.is_none()) return {};
  const bool is_list = py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object);
  if (!is_list) return {object};
  std::vector<py::object> items;
  for (const py::handle& item : object) items.push_back(py::reinterpret_borrow<py::object>(item));
  return items;
}

EarlierProgram program_of(const py::object& object, const std::string& name) {
  const char* const kWanted = "(Path, tool) or (Path, tool, place), the tool a Tool or a ToolLibrary";
  if (!py::isinstance<py::tuple>(object) || (py::len(object) != 2 && py::len(object) != 3))
    refuse_argument(name, kWanted, object);
  const py::tuple parts = object;
  const py::object tool = parts[1];
  std::variant<Tool, ToolLibrary> tools =
      tool.is_none() || !py::isinstance<Tool>(tool)
          ? std::variant<Tool, ToolLibrary>(bound<ToolLibrary>(tool, name + "[1]", "a Tool or a ToolLibrary"))
          : tool.cast<const Tool&>();
  EarlierProgram program{bound<Path>(parts[0], name + "[0]", "a Path"), std::move(tools)};
  if (parts.size() == 3) program.place = text_of(parts[2], name + "[2]");
  return program;
}

// Takes the stock: a text for a shape, or closed meshes.
std::optional<Stock> take_stock(Keywords& keywords) {
  const py::object shape = keywords.object("stock"), before = keywords.object("before");
  const std::optional<double> tolerance = keywords.number_or_none("stock_tolerance"),
                              resolution = keywords.number_or_none("stock_resolution");
  if (shape.is_none()) {
    if (!before.is_none() || tolerance || resolution)
      throw py::type_error("before, stock_tolerance and stock_resolution need stock");
    return std::nullopt;
  }
  Stock stock;
  if (py::isinstance<py::str>(shape))
    stock.shape = shape.cast<std::string>();
  else
    stock.meshes = meshes_of(shape, "stock", "'box', 'box=2', 'part+3', a Mesh or a list of Mesh");
  const bool is_one = py::isinstance<py::tuple>(before) && py::len(before) > 0 &&
                      py::isinstance<Path>(py::object(py::tuple(before)[0]));
  for (const py::object& item : is_one ? std::vector<py::object>{before} : items_of(before))
    stock.before.push_back(program_of(item, "before[" + std::to_string(stock.before.size()) + "]"));
  stock.tolerance = tolerance.value_or(stock.tolerance);
  stock.resolution = resolution;
  return stock;
}

Report run_check(const py::args& args, const py::kwargs& given) {
  Keywords keywords("check", kFirst, args, given);
  const First first(keywords);
  const py::object fixtures = keywords.object("fixtures");
  CheckOptions options = take_options(keywords);
  options.near_miss = keywords.number("near_miss", options.near_miss);
  options.stock = take_stock(keywords);
  keywords.finish();
  const Asked a = asked(first, fixtures, options);
  const py::gil_scoped_release release;
  return a.tool != nullptr ? check(a.path, a.scene, *a.tool, a.options) : check(a.path, a.scene, *a.library, a.options);
}

Correction run_correct(const py::args& args, const py::kwargs& given) {
  Keywords keywords("correct", kFirst, args, given);
  const First first(keywords);
  const py::object fixtures = keywords.object("fixtures");
  CorrectOptions how;
  how.strategy = keywords.text("strategy", how.strategy);
  how.max_shift = keywords.number("max_shift", how.max_shift);
  how.max_side_shift = keywords.number_or_none("max_side_shift");
  how.max_tilt = keywords.number("max_tilt", how.max_tilt);
  how.rapid_clearance = keywords.number("rapid_clearance", how.rapid_clearance);
  const CheckOptions options = take_options(keywords);
  keywords.finish();
  const Asked a = asked(first, fixtures, options);
  const py::gil_scoped_release release;
  return a.tool != nullptr ? correct(a.path, a.scene, *a.tool, a.options, how)
                           : correct(a.path, a.scene, *a.library, a.options, how);
}

void bind_corrections(py::module_& module) {
  auto change = py::class_<Change>(module, "Change", "A position that was changed or added.");
  refuse_construction(change, "Change", "changes of a Correction hold them");
  change.def_readonly("move", &Change::move, "Of the path as it was.")
      .def_readonly("is_inserted", &Change::is_inserted)
      .def_property_readonly(
          "shift", [](const Change& self) { return copy(self.shift); }, "float64 (3,), mm.")
      .def_readonly("tilt", &Change::tilt, "Degrees.")
      .def_readonly("depth_before", &Change::depth_before, "mm.")
      .def_readonly("depth_after", &Change::depth_after, "mm.");
  auto uncorrected = py::class_<Uncorrected>(module, "Uncorrected", "A move that still gouges or is buried, and why.");
  refuse_construction(uncorrected, "Uncorrected", "uncorrected of a Correction holds them");
  uncorrected.def_readonly("move", &Uncorrected::move, "Of the path as it was.")
      .def_readonly("depth", &Uncorrected::depth, "mm.")
      .def_readonly("reason", &Uncorrected::reason);
  auto correction = py::class_<Correction>(module, "Correction", "A corrected path, checked like any other.");
  refuse_construction(correction, "Correction", "correct(path, part, tool) returns one");
  correction.def_readonly("path", &Correction::path)
      .def_readonly("before", &Correction::before, "The Report on the path as it was.")
      .def_readonly("after", &Correction::after, "The Report on the corrected path.")
      .def_readonly("changes", &Correction::changes)
      .def_readonly("uncorrected", &Correction::uncorrected)
      .def("__repr__", [](const Correction& self) {
        return "<gougecheck.Correction of " + std::to_string(self.changes.size()) + " positions, " +
               std::to_string(self.uncorrected.size()) + " moves left>";
      });
}

}  // namespace

void bind_checks(py::module_& module) {
  static const std::string check_doc =
      std::string(
          "check(path, part, tool, *, fixtures=(), tolerance=0.01, resolution=0.001, ...) -> Report\n\n"
          "Checks the whole motion of every move against the whole surface of every triangle: no gouge deeper "
          "than tolerance + resolution is missed, every gouge has a witness, and clean is proved.") +
      kOptions +
      " stock: the material before the path, 'box', 'box=2' (about the parts), 'part+3', or closed meshes; rapids must be "
      "clear of what is left of it, other moves with shank and holder. before: programs that cut it earlier, (path, tool) "
      "or (path, tool, place). stock_tolerance, stock_resolution: mm.";
  module.def("check", &run_check, check_doc.c_str());
  bind_corrections(module);
  static const std::string correct_doc =
      std::string(
          "correct(path, part, tool, *, strategy='auto', max_shift=20, ...) -> Correction\n\n"
          "A path without the gouges, as far as the limits allow; no clean move becomes anything else, none "
          "becomes deeper. strategy: 'auto', 'weighted', 'normal', 'axis', 'tilt' or 'trim'. max_shift, "
          "max_side_shift (None: by the depth), rapid_clearance: mm. max_tilt: degrees.") +
      kOptions;
  module.def("correct", &run_correct, correct_doc.c_str());
}

}  // namespace gougecheck::python
