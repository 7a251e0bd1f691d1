#include <gougecheck/check.h>
#include <pybind11/stl.h>

#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

const char* const kOptions =
    "\n\npart: a Mesh, a list of them, or a Scene, which then has the fixtures. tool: a Tool, or a ToolLibrary for a "
    "path that calls several. tolerance: depth a move may have; resolution: the certified gap; stock_to_leave, "
    "shank_clearance, holder_clearance: grow that body; near_miss: report what comes nearer, 0: nothing; all in mm. "
    "rapids: 'straight', 'dogleg' or 'skip'. threads: 0 for all; the result is the same at any number. assume: facts to "
    "take as stated, such as 'path-unit', 'placement', 'tool=T3'; strict: clean only where no fact is taken by default. "
    "The GIL is released.";

Rapids rapids_called(const std::string& name) {
  constexpr const char* kNames[] = {"straight", "dogleg", "skip"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (name == kNames[i]) return static_cast<Rapids>(i);
  }
  throw py::value_error("rapids: expected 'straight', 'dogleg' or 'skip', got '" + name + "'");
}

std::vector<Mesh> meshes_of(const py::object& object, const std::string& expected) {
  if (py::isinstance<Mesh>(object)) return {object.cast<Mesh>()};
  if (!py::isinstance<py::sequence>(object)) throw py::type_error(expected);
  std::vector<Mesh> meshes;
  for (const py::handle& item : object) {
    if (!py::isinstance<Mesh>(item)) throw py::type_error(expected);
    meshes.push_back(item.cast<Mesh>());
  }
  return meshes;
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
  std::vector<Mesh> parts = meshes_of(part, "part: expected a Mesh, a list of Mesh or a Scene");
  return Scene(std::move(parts),
               meshes_of(fixtures.is_none() ? py::tuple() : fixtures, "fixtures: expected a list of Mesh"));
}

Asked asked(const py::object& path, const py::object& part, const py::object& tool, const py::object& fixtures,
            const CheckOptions& options) {
  if (!py::isinstance<Path>(path)) throw py::type_error("path: expected a Path; read_toolpath(file) makes one");
  const bool is_tool = py::isinstance<Tool>(tool);
  if (!is_tool && !py::isinstance<ToolLibrary>(tool)) throw py::type_error("tool: expected a Tool or a ToolLibrary");
  return {path.cast<const Path&>(), scene_of(part, fixtures), is_tool ? tool.cast<const Tool*>() : nullptr,
          is_tool ? nullptr : tool.cast<const ToolLibrary*>(), options};
}

CheckOptions options_of(double tolerance, double resolution, double stock_to_leave, double shank_clearance,
                        double holder_clearance, double near_miss, const std::string& rapids, unsigned threads,
                        const std::vector<std::string>& assume, bool strict) {
  return {tolerance, resolution, stock_to_leave, shank_clearance, holder_clearance, near_miss, rapids_called(rapids),
          threads,   assume,     strict};
}

Report run_check(const py::object& path, const py::object& part, const py::object& tool, const py::object& fixtures,
                 double tolerance, double resolution, double stock, double shank, double holder, double near,
                 const std::string& rapids, unsigned threads, const std::vector<std::string>& assume, bool strict) {
  const Asked a = asked(path, part, tool, fixtures,
                        options_of(tolerance, resolution, stock, shank, holder, near, rapids, threads, assume, strict));
  const py::gil_scoped_release release;
  return a.tool != nullptr ? check(a.path, a.scene, *a.tool, a.options) : check(a.path, a.scene, *a.library, a.options);
}

Correction run_correct(const py::object& path, const py::object& part, const py::object& tool,
                       const py::object& fixtures, const std::string& strategy, double max_shift,
                       const std::optional<double>& max_side_shift, double max_tilt, double rapid_clearance,
                       double tolerance, double resolution, double stock, double shank, double holder,
                       const std::string& rapids, unsigned threads, const std::vector<std::string>& assume,
                       bool strict) {
  const Asked a = asked(path, part, tool, fixtures,
                        options_of(tolerance, resolution, stock, shank, holder, 0, rapids, threads, assume, strict));
  const CorrectOptions how{strategy, max_shift, max_side_shift, max_tilt, rapid_clearance};
  const py::gil_scoped_release release;
  return a.tool != nullptr ? correct(a.path, a.scene, *a.tool, a.options, how)
                           : correct(a.path, a.scene, *a.library, a.options, how);
}

void bind_corrections(py::module_& module) {
  py::class_<Change>(module, "Change", "A position that was changed or added.")
      .def_readonly("move", &Change::move, "Of the path as it was.")
      .def_readonly("is_inserted", &Change::is_inserted)
      .def_property_readonly(
          "shift", [](const Change& self) { return copy(self.shift); }, "float64 (3,), mm.")
      .def_readonly("tilt", &Change::tilt, "Degrees.")
      .def_readonly("depth_before", &Change::depth_before, "mm.")
      .def_readonly("depth_after", &Change::depth_after, "mm.");
  py::class_<Uncorrected>(module, "Uncorrected", "A move that still gouges or is buried, and why.")
      .def_readonly("move", &Uncorrected::move, "Of the path as it was.")
      .def_readonly("depth", &Uncorrected::depth, "mm.")
      .def_readonly("reason", &Uncorrected::reason);
  py::class_<Correction>(module, "Correction", "A corrected path, checked like any other.")
      .def_readonly("path", &Correction::path)
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
      kOptions;
  module.def("check", &run_check, py::arg("path"), py::arg("part"), py::arg("tool"), py::kw_only(),
             py::arg("fixtures") = py::tuple(), py::arg("tolerance") = 0.01, py::arg("resolution") = 0.001,
             py::arg("stock_to_leave") = 0.0, py::arg("shank_clearance") = 0.0, py::arg("holder_clearance") = 0.0,
             py::arg("near_miss") = 0.0, py::arg("rapids") = "straight", py::arg("threads") = 0,
             py::arg("assume") = std::vector<std::string>(), py::arg("strict") = false, check_doc.c_str());
  bind_corrections(module);
  static const std::string correct_doc =
      std::string(
          "correct(path, part, tool, *, strategy='auto', max_shift=20, ...) -> Correction\n\n"
          "A path without the gouges, as far as the limits allow; no clean move becomes anything else, none "
          "becomes deeper. strategy: 'auto', 'weighted', 'normal', 'axis', 'tilt' or 'trim'. max_shift, "
          "max_side_shift (None: by the depth), rapid_clearance: mm. max_tilt: degrees.") +
      kOptions;
  module.def("correct", &run_correct, py::arg("path"), py::arg("part"), py::arg("tool"), py::kw_only(),
             py::arg("fixtures") = py::tuple(), py::arg("strategy") = "auto", py::arg("max_shift") = 20.0,
             py::arg("max_side_shift") = py::none(), py::arg("max_tilt") = 30.0, py::arg("rapid_clearance") = 1.0,
             py::arg("tolerance") = 0.01, py::arg("resolution") = 0.001, py::arg("stock_to_leave") = 0.0,
             py::arg("shank_clearance") = 0.0, py::arg("holder_clearance") = 0.0, py::arg("rapids") = "straight",
             py::arg("threads") = 0, py::arg("assume") = std::vector<std::string>(), py::arg("strict") = false,
             correct_doc.c_str());
}

}  // namespace gougecheck::python
