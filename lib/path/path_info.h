#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/path/toolpath.h"

// Counts of a toolpath, for `gougecheck path info` and for reports. Lengths are in mm, positions in part coordinates.

namespace gouge {

struct PathInfo {
  std::array<std::size_t, 4> moves_by_kind{};  ///< indexed by MoveKind
  std::size_t alone = 0;                       ///< number of positions without a motion that leads to them
  static constexpr double kBoxError_mm = 4e-5;
  Box3 box;                      ///< box of the tip's path, arcs to within kBoxError_mm; empty without moves
  std::size_t orientations = 0;  ///< number of distinct tool axes
  double largest_tilt_deg = 0;   ///< largest angle between the axis at a position and that at the first one
  std::size_t largest_tilt_move = kNone;
  double largest_turn_deg = 0;  ///< largest change of the axis in one move
  std::size_t largest_turn_move = kNone;
  double feed_length_mm = 0, rapid_length_mm = 0;    ///< path length of feed and arc moves, and path length of rapids
  std::map<std::string, std::size_t> not_checkable;  ///< number of moves for each reason
  std::vector<std::size_t> moves_of_tool;            ///< one entry for each of Toolpath::tools
  std::vector<std::size_t> moves_of_operation;       ///< one entry for each of Toolpath::operations
  std::size_t moves_without_tool = 0;
};

/// Returns the angle between two unit vectors, accurate for small and for nearly straight angles.
[[nodiscard]] double angle_between_rad(const Vec3& a, const Vec3& b);
[[nodiscard]] double angle_between_deg(const Vec3& a, const Vec3& b);

/// Returns the length of the tip's path over the move `index`; for a spline to about a thousandth. Requires a start.
[[nodiscard]] double move_length_mm(const Toolpath& path, std::size_t index);

/// Counts the moves of a path. Cost: one pass over the moves and a sort of their axes.
[[nodiscard]] PathInfo describe_path(const Toolpath& path);

}  // namespace gouge
