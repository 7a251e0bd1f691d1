#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/geom/pose.h"

// Texts of lengths, numbers and placements, as options and the library take them. Lengths are millimetres unless they
// have a unit: 0.5, 0.5mm, 0.02in, 0.02inch.

namespace gouge {

/// Returns the parts of a text between separators: one part if there is none.
[[nodiscard]] std::vector<std::string> split_text(const std::string& text, char separator);

/// Parses a length: 0.5, 0.5mm, 20 um, 0.02 in. The units are mm, cm, um, in and inch. Returns nothing for lengths beyond 100 m, the reach of a check (kFarthest_mm).
[[nodiscard]] std::optional<double> parse_length_mm(const std::string& text);

/// Returns advice if `text` is one number with a comma in place of its decimal point, else an empty text. It begins with
/// a semicolon, to follow an error.
[[nodiscard]] std::string decimal_comma_hint(const std::string& text);

/// A length between two others.
struct LengthRange {
  double middle_mm = 0, half_mm = 0;
};
/// Parses a length, or an interval of lengths: "120..120.1".
[[nodiscard]] std::optional<LengthRange> parse_length_range(const std::string& text);

/// Parses `count` numbers with commas between them: "1,0,-2.5".
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(const std::string& text, std::size_t count);

/// Parses "x,y,z" or "x,y,z,rx,ry,rz": lengths, then degrees about the fixed X, Y and Z axes in this order.
[[nodiscard]] std::optional<RigidTransform> parse_place(const std::string& text);

}  // namespace gouge
