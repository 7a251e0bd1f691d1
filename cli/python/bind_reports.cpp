#include <gougecheck/report.h>
#include <pybind11/stl.h>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

const char* verdict_name(Verdict verdict) {
  constexpr const char* kNames[] = {"clean", "gouges", "not-fully-checked"};
  return kNames[static_cast<std::size_t>(verdict)];
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
  py::class_<Assumption>(module, "Assumption",
                         "A fact that a verdict rests on beside the motion and the surfaces, and how it is known.")
      .def_readonly("fact", &Assumption::fact, "'path-unit', 'tool', 'placement', ...")
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
      .def_property_readonly("assumptions", &Report::assumptions, "The facts that the verdict rests on: Assumption.")
      .def_property_readonly("worst_depth", &Report::worst_depth, "mm, of all moves; 0 where none is deep.")
      .def(
          "count", [](const Report& self, int state) { return self.count(static_cast<State>(state)); },
          py::arg("state"), "How many moves are in that gougecheck.State.")
      .def(
          "reason",
          [](const Report& self, std::size_t move) {
            if (move >= self.size()) throw py::index_error("the path has " + std::to_string(self.size()) + " moves");
            return self.reason(move);
          },
          py::arg("move"), "Why a move is not checked, not certified or buried; '' where there is nothing to say.")
      .def_property_readonly("notes", &Report::notes, py::call_guard<py::gil_scoped_release>(),
                             "What the verdict does not cover, and what was noticed of the inputs.")
      .def(
          "write",
          [](const Report& self, const py::object& file) {
            const auto name = file_of(file);
            const py::gil_scoped_release release;
            self.write(name);
          },
          py::arg("file"),
          "Writes the report as the extension says: .json, .csv, .sarif, .xml (JUnit), .html (without pictures) or .txt.")
      .def("__len__", &Report::size)
      .def("__str__", &Report::text, py::call_guard<py::gil_scoped_release>())
      .def("__repr__", [](const Report& self) {
        return "<gougecheck.Report of " + std::to_string(self.size()) + " moves: " + verdict_name(self.verdict()) + ">";
      });
  module.def(
      "state_name", [](int state) { return gougecheck::state_name(static_cast<State>(state)); }, py::arg("state"),
      "clean, near, gouge, buried, not-checked or not-certified.");
}

}  // namespace gougecheck::python
