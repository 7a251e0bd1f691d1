#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/check/check_options.h"
#include "lib/geom/pose.h"

// Values of command-line options. Lengths are millimetres unless they carry a unit: 0.5, 0.5mm, 0.02in, 0.02inch.

namespace gouge {

/// Returns the units an STL file may be in, as --stl-units takes them.
[[nodiscard]] std::vector<std::string> unit_words();

/// Parses a length. Nothing also for lengths beyond 100 m, which is as far as a check reaches (kFarthest_mm).
[[nodiscard]] std::optional<double> parse_length_mm(const std::string& text);

/// Parses "1,0,-2.5": `count` numbers with commas between.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(const std::string& text, std::size_t count);

/// Parses "x,y,z" or "x,y,z,rx,ry,rz": lengths, then degrees about the fixed X, Y and Z axes in this order.
[[nodiscard]] std::optional<RigidTransform> parse_place(const std::string& text);

/// The least a length may be; above the finest resolution is what double precision can certify.
enum class Minimum { zero, above_zero, finest_resolution };

/// Returns the length typed for `option`. Error (code usage): names the option, the typed text and the expected one.
[[nodiscard]] Result<double> understand_length(const std::string& option, const std::string& typed, Minimum least);

/// Does parse_place for the text typed for `option`. Error: as above.
[[nodiscard]] Result<RigidTransform> understand_place(const std::string& option, const std::string& typed);

/// Returns "OPTION 'TYPED': expected EXPECTED", code usage.
[[nodiscard]] Diagnostic usage_error(const std::string& option, const std::string& typed, const std::string& expected);

/// Reads "shank=0.5,holder=1" into the options. Returns the error, or nothing.
[[nodiscard]] std::optional<std::string> parse_clearance(const std::string& text, CheckOptions& options);

}  // namespace gouge
