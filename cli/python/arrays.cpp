#include "cli/python/arrays.h"

#include <algorithm>
#include <cstring>

namespace gougecheck::python {
namespace {

[[noreturn]] void refuse(const py::handle& object, const std::string& name, const std::string& wanted,
                         const std::string& remedy) {
  std::string found;
  if (py::isinstance<py::array>(object)) {
    const auto array = py::reinterpret_borrow<py::array>(object);
    found = std::string(py::str(array.dtype())) + " of shape " + std::string(py::str(array.attr("shape")));
    if ((array.flags() & py::array::c_style) == 0) found += ", not C-contiguous";
  } else {
    found = py::str(py::type::handle_of(object).attr("__name__"));
  }
  throw py::type_error(name + ": expected a C-contiguous " + wanted + ", got " + found + "; " + remedy);
}

bool is_contiguous(const py::array& array) {
  return (array.flags() & py::array::c_style) != 0 && (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0;
}

template <class T>
bool copy_triangles(const py::array& array, std::vector<Triangle>& triangles) {
  if (!py::isinstance<py::array_t<T>>(array)) return false;
  const auto* values = static_cast<const T*>(array.data());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const T value = values[3 * i + k];
      if (value < 0 || static_cast<std::uint64_t>(value) > 0xFFFFFFFFU) {
        throw py::index_error("faces: row " + std::to_string(i) + " has the index " + std::to_string(value) +
                              "; expected one of the vertices, counted from 0");
      }
      triangles[i][k] = static_cast<std::uint32_t>(value);
    }
  }
  return true;
}

Transform from_matrix(const py::array& array) {
  const auto* m = static_cast<const double*>(array.data());
  Transform pose;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) pose.rotation[3 * row + column] = m[4 * row + column];
    pose.shift[row] = m[4 * row + 3];
  }
  constexpr double kLastRow[] = {0, 0, 0, 1};
  if (!std::equal(kLastRow, kLastRow + 4, m + 12))
    throw py::value_error("pose: expected (0, 0, 0, 1) as the last row of the matrix");
  return pose;
}

}  // namespace

std::span<const Vec3> rows_of(const py::handle& object, const std::string& name, bool may_be_one) {
  const std::string wanted = std::string("float64 array of shape (n, 3)") + (may_be_one ? " or (3,)" : "");
  const std::string remedy = "numpy.ascontiguousarray(" + name + ", dtype=float) makes one";
  if (!py::isinstance<py::array_t<double>>(object)) refuse(object, name, wanted, remedy);
  const auto array = py::reinterpret_borrow<py::array>(object);
  const bool is_table = array.ndim() == 2 && array.shape(1) == 3;
  const bool is_one = may_be_one && array.ndim() == 1 && array.shape(0) == 3;
  if ((!is_table && !is_one) || !is_contiguous(array)) refuse(object, name, wanted, remedy);
  return {static_cast<const Vec3*>(array.data()), is_one ? 1 : static_cast<std::size_t>(array.shape(0))};
}

std::vector<Triangle> triangles_of(const py::handle& object) {
  const std::string wanted = "array of int32, int64, uint32 or uint64 of shape (n, 3)";
  const std::string remedy = "numpy.ascontiguousarray(faces, dtype=int) makes one";
  if (!py::isinstance<py::array>(object)) refuse(object, "faces", wanted, remedy);
  const auto array = py::reinterpret_borrow<py::array>(object);
  if (array.ndim() != 2 || array.shape(1) != 3 || !is_contiguous(array)) refuse(object, "faces", wanted, remedy);
  std::vector<Triangle> triangles(static_cast<std::size_t>(array.shape(0)));
  if (!copy_triangles<std::int64_t>(array, triangles) && !copy_triangles<std::int32_t>(array, triangles) &&
      !copy_triangles<std::uint32_t>(array, triangles) && !copy_triangles<std::uint64_t>(array, triangles))
    refuse(object, "faces", wanted, remedy);
  return triangles;
}

std::span<const bool> flags_of(const py::handle& object, const std::string& name) {
  if (object.is_none()) return {};
  const std::string remedy = "numpy.ascontiguousarray(" + name + ", dtype=bool) makes one";
  if (!py::isinstance<py::array_t<bool>>(object)) refuse(object, name, "bool array of shape (n,)", remedy);
  const auto array = py::reinterpret_borrow<py::array>(object);
  if (array.ndim() != 1 || !is_contiguous(array)) refuse(object, name, "bool array of shape (n,)", remedy);
  return {static_cast<const bool*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

Transform pose_of(const py::handle& object) {
  if (object.is_none()) return {};
  if (py::isinstance<py::array_t<double>>(object)) {
    const auto array = py::reinterpret_borrow<py::array>(object);
    if (array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4 && is_contiguous(array))
      return from_matrix(array);
  } else if (py::hasattr(object, "getRotation") && py::hasattr(object, "getTranslation")) {
    const auto rotation = py::array_t<double, py::array::c_style | py::array::forcecast>(object.attr("getRotation")());
    const auto shift = py::array_t<double, py::array::c_style | py::array::forcecast>(object.attr("getTranslation")());
    if (rotation.size() == 9 && shift.size() == 3) {
      Transform pose;
      std::memcpy(pose.rotation.data(), rotation.data(), sizeof pose.rotation);
      std::memcpy(pose.shift.data(), shift.data(), sizeof pose.shift);
      return pose;
    }
  }
  refuse(object, "pose", "float64 array of shape (4, 4), or a Transform of python-fcl", "numpy.eye(4) is the identity");
}

py::array view(std::span<const Vec3> rows, const py::handle& owner) {
  py::array array(py::dtype::of<double>(), {rows.size(), std::size_t{3}}, {sizeof(Vec3), sizeof(double)},
                  static_cast<const void*>(rows.data()), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array view(std::span<const Triangle> rows, const py::handle& owner) {
  py::array array(py::dtype::of<std::uint32_t>(), {rows.size(), std::size_t{3}},
                  {sizeof(Triangle), sizeof(std::uint32_t)}, static_cast<const void*>(rows.data()), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array copy(const Vec3& vector) { return py::array_t<double>(3, vector.data()); }

}  // namespace gougecheck::python
