#pragma once

#include <string>

#include <pybind11/pybind11.h>

// One function for each source of the module. The order of the calls matters, as a docstring may only name types that
// are already bound.

namespace gougecheck::python {

void bind_errors(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_tools(pybind11::module_& module);
void bind_tool_libraries(pybind11::module_& module);
void bind_paths(pybind11::module_& module);
void bind_reports(pybind11::module_& module);
void bind_checks(pybind11::module_& module);
void bind_depths(pybind11::module_& module);
void bind_penetration(pybind11::module_& module);

/// Adds a constructor that throws a TypeError, which states how to get an object of the class.
template <class T>
void refuse_construction(pybind11::class_<T>& type, const std::string& name, const std::string& remedy) {
  type.def(pybind11::init([name, remedy](const pybind11::args&, const pybind11::kwargs&) -> T {
    throw pybind11::type_error(name + "() makes no object; " + remedy);
  }));
}

/// Adds pickling by the bytes of the object.
template <class T>
void add_pickling(pybind11::class_<T>& type) {
  type.def(pybind11::pickle([](const T& self) { return pybind11::bytes(self.to_bytes()); },
                            [](const pybind11::bytes& bytes) { return T::from_bytes(std::string(bytes)); }));
}

}  // namespace gougecheck::python
