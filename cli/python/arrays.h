#pragma once

#include <span>
#include <string>
#include <vector>

#include <gougecheck/types.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

// Exchange of NumPy arrays without copies. An input array is read in place, or refused with a TypeError. An output
// array is a read-only view that keeps its owner alive.

namespace gougecheck::python {

namespace py = pybind11;

/// Returns the rows of a C-contiguous float64 array of shape (n, 3), valid as long as `object`. With `may_be_one` the
/// shape may also be (3,).
[[nodiscard]] std::span<const Vec3> rows_of(const py::handle& object, const std::string& name, bool may_be_one = false);
/// Returns the triangles of a C-contiguous array of integers of shape (n, 3), none negative. Copies it if it is not
/// uint32.
[[nodiscard]] std::vector<Triangle> triangles_of(const py::handle& object);
/// Returns the flags of a C-contiguous array of bool of shape (n,), or none for None.
[[nodiscard]] std::span<const bool> flags_of(const py::handle& object, const std::string& name);
/// Returns the pose in `object`: None, a homogeneous float64 array of shape (4, 4) as in trimesh, or an object with
/// getRotation and getTranslation. The Transform of python-fcl is such an object.
[[nodiscard]] Transform pose_of(const py::handle& object);

template <class T>
[[nodiscard]] py::array view(std::span<const T> values, const py::handle& owner) {
  py::array array(py::dtype::of<T>(), {values.size()}, {sizeof(T)}, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}
[[nodiscard]] py::array view(std::span<const Vec3> rows, const py::handle& owner);
[[nodiscard]] py::array view(std::span<const Triangle> rows, const py::handle& owner);
/// Returns a new array of shape (3,) with its own memory.
[[nodiscard]] py::array copy(const Vec3& vector);

}  // namespace gougecheck::python
