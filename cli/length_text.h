#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/geom/rigid_transform.h"

// Values of command-line options. Lengths are millimetres unless they carry a unit: 0.5, 0.5mm, 0.02in, 0.02inch.

namespace gouge {

/// The finest --resolution, which double precision can certify.
inline constexpr double kFinestResolution_mm = 1e-6;

/// The units an STL file may be in, as --stl-units takes them.
[[nodiscard]] std::vector<std::string> unit_words();

/// Nothing also for lengths beyond 100 m, which is as far as a check reaches (kFarthest_mm).
[[nodiscard]] std::optional<double> parse_length_mm(const std::string& text);

/// "x,y,z" or "x,y,z,rx,ry,rz": lengths, then degrees about the fixed X, Y and Z axes in this order.
[[nodiscard]] std::optional<RigidTransform> parse_place(const std::string& text);

/// "shank=0.5,holder=1" into the options. Returns what is wrong, or nothing.
[[nodiscard]] std::optional<std::string> parse_clearance(const std::string& text, CheckOptions& options);

}  // namespace gouge
