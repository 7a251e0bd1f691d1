#include "cli/python/arguments.h"

#include <utility>

namespace gougecheck::python {
namespace {

// Returns the text of a value, shortened for a message.
std::string shown(const py::handle& object) {
  constexpr std::size_t kMost = 60;
  const std::string text = py::repr(object).cast<std::string>();
  const std::string type = py::str(py::type::handle_of(object).attr("__name__"));
  return (text.size() > kMost ? text.substr(0, text.find_last_of(" ,", kMost)) + " ..." : text) + " (" + type + ")";
}

// Returns "; did you mean tolerance?"; empty if no name is similar.
std::string similar_word(const std::string& name, const std::vector<std::string>& names) {
  py::list list;
  for (const std::string& one : names) list.append(one);
  const py::list found = py::module_::import("difflib").attr("get_close_matches")(name, list, 1);
  return found.empty() ? "" : "; did you mean " + std::string(py::str(found[0])) + "?";
}

}  // namespace

void refuse_argument(const std::string& name, const std::string& wanted, const py::handle& got) {
  throw py::type_error(name + ": expected " + wanted + ", got " + shown(got));
}

double number_of(const py::handle& object, const std::string& name) {
  const bool is_number = !py::isinstance<py::bool_>(object) && !py::isinstance<py::str>(object) &&
                         (py::hasattr(object, "__float__") || py::hasattr(object, "__index__"));
  if (!is_number) refuse_argument(name, "a number", object);
  const double value = PyFloat_AsDouble(object.ptr());
  if (PyErr_Occurred() == nullptr) return value;
  PyErr_Clear();
  refuse_argument(name, "a number", object);
}

std::string text_of(const py::handle& object, const std::string& name) {
  if (!py::isinstance<py::str>(object)) refuse_argument(name, "a str", object);
  return object.cast<std::string>();
}

std::size_t index_of(const py::handle& object, const std::string& name, const std::string& wanted, std::size_t most) {
  if (py::isinstance<py::bool_>(object) || !py::hasattr(object, "__index__")) refuse_argument(name, wanted, object);
  const std::size_t value = PyLong_AsSize_t(py::object(object.attr("__index__")()).ptr());
  const bool is_too_large = PyErr_Occurred() != nullptr;
  PyErr_Clear();
  if (is_too_large || value > most)
    throw py::index_error(name + ": expected " + wanted + ", got " + std::string(py::str(object)));
  return value;
}

std::string file_of(const py::handle& object, const std::string& name) {
  if (py::isinstance<py::str>(object)) return object.cast<std::string>();
  if (!py::isinstance<py::bytes>(object) && !py::hasattr(object, "__fspath__"))
    refuse_argument(name, "the name of a file, a str or a path", object);
  return py::module_::import("os").attr("fsdecode")(object).cast<std::string>();
}

std::vector<Mesh> meshes_of(const py::handle& object, const std::string& name, const std::string& wanted) {
  if (py::isinstance<Mesh>(object)) return {object.cast<Mesh>()};
  if (!py::isinstance<py::sequence>(object) || py::isinstance<py::str>(object)) refuse_argument(name, wanted, object);
  std::vector<Mesh> meshes;
  for (const py::handle& item : object)
    meshes.push_back(bound<Mesh>(item, name + "[" + std::to_string(meshes.size()) + "]", "a Mesh"));
  return meshes;
}

Keywords::Keywords(std::string function, const py::kwargs& given)
    : Keywords(std::move(function), {}, py::args(), given) {}

Keywords::Keywords(std::string function, const std::vector<const char*>& names, const py::args& args,
                   const py::kwargs& given)
    : function_(std::move(function)), left_(given.attr("copy")()) {
  for (const char* name : names) positions_ += (positions_.empty() ? "" : ", ") + std::string(name);
  if (args.size() > names.size()) {
    const std::string most = names.empty() ? "only arguments with their names, such as name=value"
                                           : "at most " + std::to_string(names.size()) +
                                                 " arguments without their names (" + positions_ + ")";
    throw py::type_error(function_ + "() takes " + most + "; got " + std::to_string(args.size()));
  }
  for (std::size_t i = 0; i < args.size(); ++i) {
    if (left_.contains(names[i]))
      throw py::type_error(function_ + "() got '" + names[i] + "' twice, without its name and with it");
    left_[names[i]] = args[i];
  }
}

py::object Keywords::required(const char* name) {
  if (!left_.contains(name))
    throw py::type_error(function_ + "() needs '" + name + "'; its first arguments are " + positions_);
  return object(name);
}

py::object Keywords::object(const char* name) {
  known_.emplace_back(name);
  return left_.contains(name) ? py::object(left_.attr("pop")(name)) : py::none();
}

double Keywords::number(const char* name, double otherwise) {
  const bool is_given = left_.contains(name);
  const py::object value = object(name);
  return is_given ? number_of(value, name) : otherwise;
}

std::optional<double> Keywords::number_or_none(const char* name) {
  const py::object value = object(name);
  return value.is_none() ? std::nullopt : std::optional(number_of(value, name));
}

std::string Keywords::text(const char* name, const std::string& otherwise) {
  const bool is_given = left_.contains(name);
  const py::object value = object(name);
  return is_given ? text_of(value, name) : otherwise;
}

std::vector<std::string> Keywords::texts(const char* name) {
  const bool is_given = left_.contains(name);
  const py::object value = object(name);
  if (!is_given) return {};
  if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value))
    refuse_argument(name, "a list of str", value);
  std::vector<std::string> all;
  for (const py::handle& item : value) all.push_back(text_of(item, name));
  return all;
}

bool Keywords::flag(const char* name, bool otherwise) {
  const bool is_given = left_.contains(name);
  const py::object value = object(name);
  if (!is_given) return otherwise;
  if (!py::isinstance<py::bool_>(value)) refuse_argument(name, "True or False", value);
  return value.cast<bool>();
}

unsigned Keywords::count(const char* name, unsigned otherwise) {
  const bool is_given = left_.contains(name);
  const py::object value = object(name);
  if (!is_given) return otherwise;
  const bool is_whole = !py::isinstance<py::bool_>(value) && py::hasattr(value, "__index__");
  if (!is_whole) refuse_argument(name, "a whole number of 0 or more", value);
  try {
    return value.cast<unsigned>();
  } catch (const py::cast_error&) {
    refuse_argument(name, "a whole number of 0 or more", value);
  }
}

void Keywords::finish() const {
  if (left_.empty()) return;
  const std::string name = py::str(left_.begin()->first);
  std::string known;
  for (const std::string& one : known_) known += (known.empty() ? "" : ", ") + one;
  throw py::type_error(function_ + "() has no keyword '" + name + "'; it has " + (known.empty() ? "none" : known) +
                       similar_word(name, known_));
}

}  // namespace gougecheck::python
