#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gougecheck/export.h>

// Types that all headers share. Lengths are in mm, points in part coordinates, angles in degrees.

namespace gougecheck {

/// A point or direction: x, y, z. An array of them has the layout of a C-contiguous float64 array of shape (n, 3) in
/// NumPy.
using Vec3 = std::array<double, 3>;

/// Indices into the vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// The map x -> rotation * x + shift. The rotation is stored by rows and must be a proper one.
struct Transform {
  std::array<double, 9> rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vec3 shift = {0, 0, 0};
};

/// A note about an input or a result; never an error.
struct Note {
  bool is_warning = false;
  std::string code;  ///< stable, as in docs/errors.md
  std::string text;  ///< "file:line: warning: ... [code]"
};

/// A fact on which a verdict rests besides the motion and the surfaces, and how it is known. docs/guide/assumptions.md
/// has the table of facts.
struct Assumption {
  std::string fact;      ///< "path-unit", "tool", "placement", ...
  std::string object;    ///< the object if there are several: "T3", "part.stl"; else empty
  std::string state;     ///< "stated", "derived", "default", "contradicted" or "unknown"
  bool is_open = false;  ///< because of this fact the verdict is not clean
  std::string value;     ///< the value that was used
  std::string evidence;  ///< the reason for the value, or the contradiction
  std::string remedy;    ///< how to establish it
};

/// An error of this library: input that cannot be used. what() is one line: file, line, the text found, the text
/// expected.
class GOUGECHECK_EXPORT Error : public std::runtime_error {
 public:
  Error(std::string code, const std::string& what, std::string file = {}, std::size_t line = 0);
  ~Error() override;

  /// Returns the code, stable and in kebab-case, as in docs/errors.md.
  [[nodiscard]] const std::string& code() const { return code_; }
  [[nodiscard]] const std::string& file() const { return file_; }  ///< empty: the error concerns no file
  [[nodiscard]] std::size_t line() const { return line_; }         ///< counted from 1; 0: the error concerns no line

 private:
  std::string code_, file_;
  std::size_t line_;
};

}  // namespace gougecheck
