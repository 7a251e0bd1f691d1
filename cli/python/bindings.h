#pragma once

#include <pybind11/pybind11.h>

// One function for each source of the module. The order of the calls matters, as a docstring may only name types that
// are already bound.

namespace gougecheck::python {

void bind_errors(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_tools(pybind11::module_& module);
void bind_paths(pybind11::module_& module);
void bind_reports(pybind11::module_& module);
void bind_checks(pybind11::module_& module);
void bind_depths(pybind11::module_& module);
void bind_penetration(pybind11::module_& module);

}  // namespace gougecheck::python
