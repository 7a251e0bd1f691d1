#include <gougecheck/types.h>
#include <gougecheck/version.h>
#include <pybind11/pybind11.h>

#include "cli/python/bindings.h"

namespace gougecheck::python {
namespace {

namespace py = pybind11;

py::str note_text(const Note& note) { return note.text; }

// Sets the module of the classes to the one that users import, as messages and pickles name it.
void name_public_module(const py::module_& module) {
  for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>()) {
    if (py::isinstance<py::type>(value)) py::setattr(value, "__module__", py::str("gougecheck"));
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  // A ValueError that has code, file and line besides the message.
  static PyObject* const error = PyErr_NewExceptionWithDoc(
      "gougecheck.Error",
      "Input that cannot be used. Attributes: code (stable, as in docs/errors.md), file (str, "
      "empty where no file is concerned) and line (int, from 1; 0 where there is none).",
      PyExc_ValueError, nullptr);
  module.attr("Error") = py::handle(error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const py::cast_error& e) {
      PyErr_SetString(PyExc_TypeError, e.what());
    } catch (const gougecheck::Error& e) {
      py::object instance = py::reinterpret_borrow<py::object>(error)(e.what());
      instance.attr("code") = e.code();
      instance.attr("file") = e.file();
      instance.attr("line") = e.line();
      PyErr_SetObject(error, instance.ptr());
    }
  });
  auto note = py::class_<Note>(module, "Note", "Something to know about an input or a result; never an error.");
  refuse_construction(note, "Note", "notes of inputs and reports hold them");
  note.def_readonly("is_warning", &Note::is_warning)
      .def_readonly("code", &Note::code, "Stable, as in docs/errors.md.")
      .def_readonly("text", &Note::text, "One line: file, line, what was noticed.")
      .def("__str__", &note_text)
      .def("__repr__", [](const Note& self) { return "<gougecheck.Note " + self.code + ">"; });
}

}  // namespace gougecheck::python

PYBIND11_MODULE(_core, module) {
  using namespace gougecheck::python;
  pybind11::options options;
  options.disable_function_signatures();
  module.attr("__version__") = gougecheck::version();
  bind_errors(module);
  bind_meshes(module);
  bind_tools(module);
  bind_tool_libraries(module);
  bind_paths(module);
  bind_reports(module);
  bind_checks(module);
  bind_depths(module);
  bind_penetration(module);
  name_public_module(module);
}
