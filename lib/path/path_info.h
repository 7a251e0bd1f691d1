#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/path/toolpath.h"

// Counts of a toolpath: for `gougecheck path info` and for reports. Lengths in mm, part
// coordinates.

namespace gouge {

struct PathInfo {
  std::array<std::size_t, 4> moves_by_kind{};  ///< index: MoveKind
  std::size_t alone = 0;                       ///< positions without a motion leading to them
  static constexpr double kBoxError_mm = 0.01;
  Box3 box;                      ///< of the tip's path, arcs to within kBoxError_mm; empty when there is none
  std::size_t orientations = 0;  ///< distinct tool axes
  double largest_turn_deg = 0;   ///< largest change of the axis in one move
  std::size_t largest_turn_move = kNone;
  double feed_length_mm = 0, rapid_length_mm = 0;    ///< of feed and arc moves along their paths, and of rapids
  std::map<std::string, std::size_t> not_checkable;  ///< reason -> moves
  std::vector<std::size_t> moves_of_tool;            ///< one entry per Toolpath::tools
  std::vector<std::size_t> moves_of_operation;       ///< one entry per Toolpath::operations
  std::size_t moves_without_tool = 0;
};

/// Returns the angle between two unit vectors, accurate for small and for nearly straight angles.
[[nodiscard]] double angle_between_rad(const Vec3& a, const Vec3& b);
[[nodiscard]] double angle_between_deg(const Vec3& a, const Vec3& b);

/// Returns the length of the tip's path over the move `index`; of a spline to about a thousandth. Requires a start.
[[nodiscard]] double move_length_mm(const Toolpath& path, std::size_t index);

/// Cost: one pass over the moves and a sort of their axes.
[[nodiscard]] PathInfo describe_path(const Toolpath& path);

}  // namespace gouge
