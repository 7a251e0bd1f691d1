#include <gougecheck/report.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

const char* verdict_name(Verdict verdict) {
  constexpr const char* kNames[] = {"clean", "gouges", "not-fully-checked"};
  return kNames[static_cast<std::size_t>(verdict)];
}

py::object number_or_none(double value) { return std::isnan(value) ? py::object(py::none()) : py::float_(value); }

py::tuple point_of(const Vec3& v) { return py::make_tuple(v[0], v[1], v[2]); }

py::object point_or_none(const std::optional<Vec3>& v) { return v ? py::object(point_of(*v)) : py::none(); }

/// Returns the findings as objects of the class in Python, which pickles, compares and prints them.
py::list findings_of(const Report& report) {
  const std::vector<Finding> findings = report.findings();
  const py::object type = py::module_::import("gougecheck").attr("Finding");
  py::list all;
  for (const Finding& f : findings) {
    using namespace pybind11::literals;
    all.append(type("state"_a = static_cast<int>(f.state), "line"_a = f.line, "move"_a = f.move, "moves"_a = f.moves,
                    "depth"_a = number_or_none(f.depth), "depth_upper"_a = number_or_none(f.depth_upper),
                    "overcut"_a = number_or_none(f.overcut), "clearance"_a = number_or_none(f.clearance),
                    "body"_a = f.body ? py::object(py::int_(static_cast<int>(*f.body))) : py::none(),
                    "against"_a = f.against, "tool"_a = f.tool, "operation"_a = f.operation,
                    "t"_a = number_or_none(f.t), "tip"_a = point_of(f.tip), "axis"_a = point_of(f.axis),
                    "point"_a = point_or_none(f.point), "normal"_a = point_or_none(f.normal), "message"_a = f.message));
  }
  return all;
}

State state_of(const py::handle& object) {
  constexpr std::size_t kMaxState = 5;
  return static_cast<State>(index_of(object, "state", "a State, 0 to 5", kMaxState));
}

std::size_t count_of(const Report& report, const py::args& args, const py::kwargs& given) {
  Keywords keywords("Report.count", {"state"}, args, given);
  const py::object state = keywords.required("state");
  keywords.finish();
  return report.count(state_of(state));
}

std::string reason_of(const Report& report, const py::args& args, const py::kwargs& given) {
  Keywords keywords("Report.reason", {"move"}, args, given);
  const py::object move = keywords.required("move");
  keywords.finish();
  const std::string most = std::to_string(report.size() - 1);
  return report.reason(index_of(move, "move", "the index of a move, 0 to " + most, report.size() - 1));
}

void write_to(const Report& report, const py::args& args, const py::kwargs& given) {
  Keywords keywords("Report.write", {"file"}, args, given);
  const std::string file = file_of(keywords.required("file"));
  keywords.finish();
  const py::gil_scoped_release release;
  report.write(file);
}

std::string name_of_state(const py::args& args, const py::kwargs& given) {
  Keywords keywords("state_name", {"state"}, args, given);
  const py::object state = keywords.required("state");
  keywords.finish();
  return gougecheck::state_name(state_of(state));
}

/// Adds a property that is a view into the report.
template <class T>
void add_view(py::class_<Report>& report, const char* name, std::span<const T> (Report::*get)() const,
              const char* doc) {
  report.def_property_readonly(
      name, [get](const py::object& self) { return view((self.cast<const Report&>().*get)(), self); }, doc);
}

}  // namespace

void bind_reports(py::module_& module) {
  auto assumption = py::class_<Assumption>(
      module, "Assumption", "A fact that a verdict rests on beside the motion and the surfaces, and how it is known.");
  refuse_construction(assumption, "Assumption", "assumptions of a Report holds them");
  assumption.def_readonly("fact", &Assumption::fact, "'path-unit', 'tool', 'placement', ...")
      .def_readonly("object", &Assumption::object, "Which of several: 'T3', 'part.stl'; else ''.")
      .def_readonly("state", &Assumption::state, "'stated', 'derived', 'default', 'contradicted' or 'unknown'.")
      .def_readonly("is_open", &Assumption::is_open, "The verdict is not clean because of it.")
      .def_readonly("value", &Assumption::value, "What was taken.")
      .def_readonly("evidence", &Assumption::evidence, "Why, or what speaks against it.")
      .def_readonly("remedy", &Assumption::remedy, "How to establish it.")
      .def("__repr__", [](const Assumption& self) {
        return "<gougecheck.Assumption " + self.fact + (self.object.empty() ? "" : " " + self.object) + ": " +
               self.value + " (" + self.state + ")>";
      });
  auto report = py::class_<Report>(
      module, "Report",
      "What a check says, one entry a move, as a structure of arrays: read-only views that keep the report alive. For "
      "every move depth <= true depth <= depth_upper. Lengths in mm; depths are positive inside, as distances of "
      "trimesh.proximity.signed_distance and penetration depths of python-fcl are, and 0 outside.");
  refuse_construction(report, "Report", "check(path, part, tool) returns one");
  add_pickling(report);
  report.def_property_readonly(
      "state",
      [](const py::object& self) {
        const auto states = self.cast<const Report&>().state();
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(states.data());
        return view(std::span(bytes, states.size()), self);
      },
      "uint8 (n,): values of gougecheck.State.");
  add_view(
      report, "depth", &Report::depth,
      "float64 (n,), mm: how deep a point of the surface is in the tool, realised by the witness; 0 outside, NaN of "
      "buried and not checked moves.");
  add_view(report, "depth_upper", &Report::depth_upper, "float64 (n,), mm: what is certified; NaN as depth.");
  add_view(report, "t", &Report::t, "float64 (n,): the witness's instant of the move, in [0, 1]; NaN without one.");
  add_view(report, "triangle", &Report::triangle, "int64 (n,): the witness's face, as given; -1 without one.");
  add_view(report, "mesh", &Report::mesh, "int32 (n,): index of its mesh among the parts or fixtures; -1 without one.");
  add_view(report, "body", &Report::body, "int8 (n,): values of gougecheck.Body; -1 without a witness.");
  add_view(report, "is_fixture", &Report::is_fixture,
           "int8 (n,): 1 where the witness is on a fixture, 0 on a part, -1 without one.");
  add_view(report, "overcut", &Report::overcut,
           "float64 (n,), mm: how far below the surface the tool reached, at least; NaN where it was not measured.");
  report
      .def_property_readonly(
          "point", [](const py::object& self) { return view(self.cast<const Report&>().point(), self); },
          "float64 (n, 3), mm: the witness's point of the surface; NaN without one.")
      .def_property_readonly(
          "normal", [](const py::object& self) { return view(self.cast<const Report&>().normal(), self); },
          "float64 (n, 3), unit: the direction in which the tool must move away; NaN without a witness.")
      .def_property_readonly(
          "verdict", [](const Report& self) { return verdict_name(self.verdict()); },
          "'clean', 'gouges' or 'not-fully-checked'.")
      .def_property_readonly("is_clean", &Report::is_clean,
                             "Every move is proved clean, and no fact that this rests on is open.")
      .def_property_readonly(
          "exit_status", &Report::exit_status,
          "The exit status of 'gougecheck check' for this verdict: 0 clean, 1 gouges, 4 not fully checked.")
      .def_property_readonly("assumptions", &Report::assumptions, "The facts that the verdict rests on: Assumption.")
      .def_property_readonly("worst_depth", &Report::worst_depth, "mm, of all moves; 0 where none is deep.")
      .def_property_readonly(
          "findings", &findings_of,
          "A list of Finding: gouges, buried tools and near misses in the order of the path, then one "
          "for each reason why moves are open.")
      .def("count", &count_of, "count(state) -> int\n\nHow many moves are in that gougecheck.State.")
      .def(
          "reason", &reason_of,
          "reason(move) -> str\n\nWhy a move is not checked, not certified or buried; '' where there is nothing to say.")
      .def_property_readonly("notes", &Report::notes, py::call_guard<py::gil_scoped_release>(),
                             "What the verdict does not cover, and what was noticed of the inputs.")
      .def(
          "write", &write_to,
          "write(file)\n\nWrites the report as the extension says: .json, .csv, .sarif, .xml (JUnit), .html (without pictures) or .txt.")
      .def("_repr_html_",
           [](const py::object& self) { return py::module_::import("gougecheck._notebook").attr("html_of")(self); })
      .def("__len__", &Report::size)
      .def("__str__", &Report::text, py::call_guard<py::gil_scoped_release>())
      .def("__repr__", [](const Report& self) {
        return "<gougecheck.Report of " + std::to_string(self.size()) + " moves: " + verdict_name(self.verdict()) + ">";
      });
  module.def("state_name", &name_of_state,
             "state_name(state) -> str\n\nclean, near, gouge, buried, not-checked or not-certified.");
}

}  // namespace gougecheck::python
