#include <gougecheck/check.h>
#include <gougecheck/penetration.h>
#include <pybind11/stl.h>

#include <limits>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

/// Contacts as a structure of arrays.
struct Depths {
  std::vector<std::uint8_t> state;
  std::vector<double> depth, depth_upper;
  std::vector<Vec3> point, normal;
  std::vector<std::int64_t> triangle;
  std::vector<std::int8_t> body;

  explicit Depths(const std::vector<Contact>& contacts) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const Contact& contact : contacts) {
      const bool has_witness = contact.triangle >= 0;
      const bool has_depth = contact.state != State::buried && contact.state != State::not_checked;
      state.push_back(static_cast<std::uint8_t>(contact.state));
      depth.push_back(has_depth ? contact.depth : kNone);
      depth_upper.push_back(has_depth ? contact.depth_upper : kNone);
      point.push_back(has_witness ? contact.point : Vec3{kNone, kNone, kNone});
      normal.push_back(has_witness ? contact.normal : Vec3{kNone, kNone, kNone});
      triangle.push_back(contact.triangle);
      body.push_back(has_witness ? static_cast<std::int8_t>(contact.body) : std::int8_t{-1});
    }
  }
};

template <class T>
void add_view(py::class_<Depths>& depths, const char* name, std::vector<T> Depths::*member, const char* doc) {
  depths.def_property_readonly(
      name,
      [member](const py::object& self) { return view(std::span<const T>(self.cast<const Depths&>().*member), self); },
      doc);
}

Depths find_depths(const py::args& args, const py::kwargs& given) {
  Keywords keywords("depth", {"mesh", "tool", "tips", "axes"}, args, given);
  const py::object part = keywords.required("mesh"), tool = keywords.required("tool"), tips = keywords.required("tips"),
                   axes = keywords.required("axes");
  CheckOptions options;
  options.resolution = keywords.number("resolution", options.resolution);
  options.threads = keywords.count("threads", options.threads);
  keywords.finish();
  if (!py::isinstance<Mesh>(part) && !py::isinstance<Scene>(part)) refuse_argument("mesh", "a Mesh or a Scene", part);
  const Tool& its_tool = bound<Tool>(tool, "tool", "a Tool");
  const Scene scene = py::isinstance<Mesh>(part) ? Scene(part.cast<Mesh>()) : part.cast<Scene>();
  const auto tip_rows = rows_of(tips, "tips", true), axis_rows = rows_of(axes, "axes", true);
  const py::gil_scoped_release release;
  return Depths(DepthQuery(scene, its_tool, options).at(tip_rows, axis_rows, options.threads));
}

py::object vector_or_none(const std::optional<Vec3>& vector) { return vector ? py::object(copy(*vector)) : py::none(); }

}  // namespace

void bind_depths(py::module_& module) {
  auto depths = py::class_<Depths>(
      module, "Depths",
      "How deep a tool is at each of many positions, as a structure of arrays: read-only views that keep it alive.");
  refuse_construction(depths, "Depths", "depth(mesh, tool, tips, axes) returns them");
  add_view(depths, "state", &Depths::state,
           "uint8 (n,): values of gougecheck.State; tolerance 0: any depth is a gouge.");
  add_view(depths, "depth", &Depths::depth,
           "float64 (n,), mm, positive inside, 0 outside; NaN where the tool is buried or the position not checked.");
  add_view(depths, "depth_upper", &Depths::depth_upper, "float64 (n,), mm: depth <= true depth <= depth_upper.");
  add_view(depths, "point", &Depths::point, "float64 (n, 3), mm: the deepest point of the surface; NaN without one.");
  add_view(depths, "normal", &Depths::normal,
           "float64 (n, 3), unit: the direction in which the tool must move away; NaN without a point.");
  add_view(depths, "triangle", &Depths::triangle, "int64 (n,): face as given; -1 without a point.");
  add_view(depths, "body", &Depths::body, "int8 (n,): values of gougecheck.Body; -1 without a point.");
  depths.def("__len__", [](const Depths& self) { return self.state.size(); });
  module.def(
      "depth", &find_depths,
      "depth(mesh, tool, tips, axes, *, resolution=0.001, threads=0) -> Depths\n\n"
      "How deep the tool is at each position, alone, without the motion between them: over the whole surface, not "
      "at vertices. mesh: a Mesh or a Scene. tips, axes: C-contiguous float64 (n, 3), mm, read where they are; "
      "either may be one of shape (3,). Depths are positive inside. The GIL is released.");
}

void bind_penetration(py::module_& module) {
  auto type = py::class_<Penetration>(
      module, "Penetration",
      "Two bodies that stand still: state 'free', 'touching', 'penetrating' or 'not-certified'; "
      "lengths in mm, coordinates of a; depths are positive inside.");
  refuse_construction(type, "Penetration", "penetration(a, b) returns one");
  type.def_property_readonly("state", [](const Penetration& self) { return gougecheck::state_name(self.state); })
      .def_readonly("depth", &Penetration::depth,
                    "Largest distance of a point in both bodies to the surface of one; depth <= true depth <= "
                    "depth_upper.")
      .def_readonly("depth_upper", &Penetration::depth_upper)
      .def_readonly("distance", &Penetration::distance, "Of the surfaces; 0 where they meet.")
      .def_property_readonly("point_a", [](const Penetration& self) { return copy(self.point_a); })
      .def_property_readonly("point_b", [](const Penetration& self) { return copy(self.point_b); })
      .def_property_readonly(
          "deepest", [](const Penetration& self) { return vector_or_none(self.deepest); }, "float64 (3,) or None.")
      .def_property_readonly(
          "normal", [](const Penetration& self) { return vector_or_none(self.normal); },
          "float64 (3,) or None: the direction in which b moves away from a, as python-fcl's contact normals from a to "
          "b.")
      .def_property_readonly(
          "shift", [](const Penetration& self) { return vector_or_none(self.shift); },
          "float64 (3,) or None: takes b out of a, proved; where find_shift asked for it.")
      .def_readonly("a_is_inside_b", &Penetration::a_is_inside_b)
      .def_readonly("b_is_inside_a", &Penetration::b_is_inside_a)
      .def_readonly("reason", &Penetration::reason, "Of 'not-certified'.")
      .def("__repr__", [](const Penetration& self) {
        return std::string("<gougecheck.Penetration: ") + gougecheck::state_name(self.state) + ">";
      });
  module.def(
      "penetration",
      [](const py::args& args, const py::kwargs& given) {
        Keywords keywords("penetration", {"a", "b", "pose"}, args, given);
        const py::object a = keywords.required("a"), b = keywords.required("b"), pose = keywords.object("pose");
        PenetrationOptions options;
        options.tolerance = keywords.number("tolerance", options.tolerance);
        options.resolution = keywords.number("resolution", options.resolution);
        options.find_shift = keywords.flag("find_shift", options.find_shift);
        keywords.finish();
        const Mesh &one = bound<Mesh>(a, "a", "a Mesh"), &other = bound<Mesh>(b, "b", "a Mesh");
        const Transform placed = pose_of(pose);
        const py::gil_scoped_release release;
        return penetration(one, other, placed, options);
      },
      "penetration(a, b, pose=None, *, tolerance=0.01, resolution=0.001, find_shift=False) -> Penetration\n\n"
      "Whether two bodies penetrate and how deep, b placed by pose: None, a homogeneous float64 (4, 4) as trimesh has "
      "it, or a Transform of python-fcl. 'free' and 'touching' are proved. The GIL is released.");
}

}  // namespace gougecheck::python
