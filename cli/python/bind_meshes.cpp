#include <gougecheck/mesh.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "cli/python/arguments.h"
#include "cli/python/arrays.h"
#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

std::vector<double> lengths_of(const py::object& object) {
  const std::string name = "fixture_clearances";
  if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object))
    refuse_argument(name, "a list of lengths in mm", object);
  std::vector<double> lengths;
  for (const py::handle& item : object)
    lengths.push_back(number_of(item, name + "[" + std::to_string(lengths.size()) + "]"));
  return lengths;
}

Mesh make_mesh(const py::args& args, const py::kwargs& given) {
  Keywords keywords("Mesh", {"vertices", "faces", "name"}, args, given);
  const py::object vertices = keywords.required("vertices"), faces = keywords.required("faces");
  const std::string name = keywords.text("name", "mesh");
  keywords.finish();
  const auto rows = rows_of(vertices, "vertices");
  const auto triangles = triangles_of(faces);
  const py::gil_scoped_release release;
  return Mesh(rows, triangles, name);
}

Scene make_scene(const py::args& args, const py::kwargs& given) {
  Keywords keywords("Scene", {"parts", "fixtures", "fixture_clearances"}, args, given);
  std::vector<Mesh> parts = meshes_of(keywords.required("parts"), "parts");
  const py::object fixtures = keywords.object("fixtures"), clearances = keywords.object("fixture_clearances");
  keywords.finish();
  return Scene(std::move(parts), fixtures.is_none() ? std::vector<Mesh>() : meshes_of(fixtures, "fixtures"),
               clearances.is_none() ? std::vector<double>() : lengths_of(clearances));
}

py::tuple scene_state(const Scene& scene) {
  const auto listed = [](std::span<const Mesh> meshes) {
    return py::cast(std::vector<Mesh>(meshes.begin(), meshes.end()));
  };
  const auto clearances = scene.fixture_clearances();
  return py::make_tuple(listed(scene.parts()), listed(scene.fixtures()),
                        std::vector<double>(clearances.begin(), clearances.end()));
}

Scene scene_of_state(const py::tuple& state) {
  return Scene(state[0].cast<std::vector<Mesh>>(), state[1].cast<std::vector<Mesh>>(),
               state[2].cast<std::vector<double>>());
}

}  // namespace

void bind_meshes(py::module_& module) {
  auto mesh = py::class_<Mesh>(
      module, "Mesh",
      "A triangulated surface in mm, exactly as given: Mesh(vertices, faces, name='mesh').\n\n"
      "vertices: C-contiguous float64 of shape (n, 3). faces: C-contiguous integers of shape (m, 3), "
      "counter-clockwise seen from outside, as trimesh has them. Both are copied; vertices with identical "
      "coordinates become one. Immutable. The first check makes an index, which stays with the mesh.");
  add_pickling(mesh);
  mesh.def(py::init(&make_mesh))
      .def_static(
          "read_stl",
          [](const py::args& args, const py::kwargs& given) {
            Keywords keywords("Mesh.read_stl", {"file", "unit"}, args, given);
            const std::string name = file_of(keywords.required("file")), unit = keywords.text("unit", "");
            keywords.finish();
            const py::gil_scoped_release release;
            return Mesh::read_stl(name, unit);
          },
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
      .def("__repr__", [](const Mesh& self) {
        return "<gougecheck.Mesh '" + self.name() + "' of " + std::to_string(self.faces().size()) + " triangles>";
      });
  py::class_<Scene>(
      module, "Scene",
      "What stands still: Scene(parts, fixtures=[], fixture_clearances=[]), lists of Mesh. Parts must not be "
      "cut into, fixtures not be touched; a fixture with a clearance in mm is kept at that distance. Immutable; keep it when several checks use it, since it holds their index.")
      .def(py::init(&make_scene))
      .def(py::pickle(&scene_state, &scene_of_state))
      .def("__repr__", [](const Scene& scene) {
        return "<gougecheck.Scene of " + std::to_string(scene.parts().size()) + " parts and " +
               std::to_string(scene.fixtures().size()) + " fixtures>";
      });
}

}  // namespace gougecheck::python
