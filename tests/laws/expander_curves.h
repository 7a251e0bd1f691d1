#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/geom/vec.h"

// The curves of the mutation law's own reader, by points on them: arcs by turning their start, splines by de
// Boor's recursion. Written from docs/formats/arcs.md; no code of the product.

namespace gouge::laws {

/// Where the tip is after a quarter, a half and three quarters of its motion. Part coordinates, mm.
using CurvePoints = std::array<Vec3, 3>;

/// Content of an arc statement. Part coordinates, mm.
struct StatedArc {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit; the arc is right-handed about it
  std::optional<double> radius;
  std::optional<double> sweep_deg;
  int turns = 1;
  bool is_short_way = false;  ///< whichever sense is shorter
};

/// Empty, and why in `doubt`, where start and end contradict what is stated.
[[nodiscard]] std::optional<CurvePoints> arc_points(const StatedArc& arc, const Vec3& start, const Vec3& end,
                                                    std::string& uncertainty);

/// `arc` turned by `sweep_rad` in all, its height and radius changing evenly.
[[nodiscard]] CurvePoints turned_points(const Vec3& center, const Vec3& normal, double sweep_rad, const Vec3& start,
                                        const Vec3& end);

/// A cubic B-spline with simple ends; `inner_knots` without the closing 1.
[[nodiscard]] CurvePoints spline_points(const std::vector<Vec3>& control, const std::vector<double>& inner_knots);

}  // namespace gouge::laws
