#pragma once

#include <optional>
#include <string>
#include <vector>

#include <gougecheck/mesh.h>
#include <pybind11/pybind11.h>

// Converts Python arguments into those of the library, or throws a TypeError that names the argument, its value and the
// expected kind.

namespace gougecheck::python {

namespace py = pybind11;

/// Throws the TypeError "NAME: expected WANTED, got VALUE (TYPE)".
[[noreturn]] void refuse_argument(const std::string& name, const std::string& wanted, const py::handle& got);

/// Returns a number; an int or a NumPy scalar is accepted, but no bool and no text.
[[nodiscard]] double number_of(const py::handle& object, const std::string& name);
/// Returns the text of a str.
[[nodiscard]] std::string text_of(const py::handle& object, const std::string& name);
/// Returns a whole number of 0 to `most`; `wanted` describes it.
[[nodiscard]] std::size_t index_of(const py::handle& object, const std::string& name, const std::string& wanted,
                                   std::size_t most);
/// Returns the path in a str or an object with __fspath__.
[[nodiscard]] std::string file_of(const py::handle& object, const std::string& name = "file");
/// Returns the meshes of a Mesh or a sequence of them.
[[nodiscard]] std::vector<Mesh> meshes_of(const py::handle& object, const std::string& name,
                                          const std::string& wanted = "a Mesh or a list of Mesh");
/// Returns an object of the bound class T; `wanted` is its name in messages: "a Tool".
template <class T>
[[nodiscard]] const T& bound(const py::handle& object, const std::string& name, const std::string& wanted) {
  if (!py::isinstance<T>(object)) refuse_argument(name, wanted, object);
  return object.cast<const T&>();
}

/// The arguments of one call of `function`. Each is taken by its name; `finish` refuses the rest.
class Keywords {
 public:
  /// Takes a call whose arguments all have their names.
  Keywords(std::string function, const py::kwargs& given);
  /// Takes a call whose first arguments may stand without their names, in the order of `names`. Throws a TypeError if
  /// there are more of them, or if one is given twice.
  Keywords(std::string function, const std::vector<const char*>& names, const py::args& args, const py::kwargs& given);

  [[nodiscard]] double number(const char* name, double otherwise);
  [[nodiscard]] std::optional<double> number_or_none(const char* name);
  [[nodiscard]] std::string text(const char* name, const std::string& otherwise);
  /// Returns a sequence of texts; empty if it is not given.
  [[nodiscard]] std::vector<std::string> texts(const char* name);
  [[nodiscard]] bool flag(const char* name, bool otherwise);
  /// Returns a whole number of 0 or more.
  [[nodiscard]] unsigned count(const char* name, unsigned otherwise);
  /// Returns the object unchanged. Throws a TypeError if it is not given.
  [[nodiscard]] py::object required(const char* name);
  /// Returns the object unchanged; None if it is not given.
  [[nodiscard]] py::object object(const char* name);

  /// Requires that every keyword was taken. Otherwise throws a TypeError that names one that was not.
  void finish() const;

 private:
  std::string function_;
  std::string positions_;  // the names of `names`, with commas
  py::dict left_;
  std::vector<std::string> known_;
};

}  // namespace gougecheck::python
