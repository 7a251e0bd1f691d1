#include "lib/path/path_info.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/path/chords.h"

namespace gouge {
namespace {

using AxisKey = std::array<double, 3>;

// Returns a key of an axis. Adding zero turns -0 into 0, so that both count as one orientation.
AxisKey key_of(const Vec3& axis) { return {axis.x() + 0.0, axis.y() + 0.0, axis.z() + 0.0}; }

void extend(Box3& box, const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  box.extend(move.end.tip);
  if (move.curve_kind == CurveKind::none || !move.has_start) return;
  for (const Pose& pose : chords_of(path, index, PathInfo::kBoxError_mm)) box.extend(pose.tip);
}

void count_motion(const Toolpath& path, std::size_t index, PathInfo& info) {
  const Move& move = path.moves[index];
  if (!move.has_start) {
    ++info.alone;
    return;
  }
  const double turn = angle_between_deg(path.start_of(index).axis, move.end.axis);
  if (turn > info.largest_turn_deg) {
    info.largest_turn_deg = turn;
    info.largest_turn_move = index;
  }
  const double length = move_length_mm(path, index);
  const bool is_curve = move.curve_kind != CurveKind::none;
  const bool is_cycle_rapid = move.kind == MoveKind::cycle && move.feed_unit == FeedUnit::rapid;
  if (move.kind == MoveKind::rapid || is_cycle_rapid) {
    info.rapid_length_mm += length;
  } else if (move.kind == MoveKind::feed || move.kind == MoveKind::cycle || is_curve) {
    info.feed_length_mm += length;
  }
}

}  // namespace

double angle_between_rad(const Vec3& a, const Vec3& b) { return 2 * std::atan2((a - b).norm(), (a + b).norm()); }

double angle_between_deg(const Vec3& a, const Vec3& b) { return angle_between_rad(a, b) * 180 / std::numbers::pi; }

double move_length_mm(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  const Pose& start = path.start_of(index);
  if (move.curve_kind == CurveKind::arc) {
    return arc_length_mm(path.arcs[move.curve], start.tip, move.end.tip);
  }
  if (move.curve_kind == CurveKind::spline) return spline_length_mm(path.splines[move.curve]);
  return (move.end.tip - start.tip).norm();
}

PathInfo describe_path(const Toolpath& path) {
  PathInfo info;
  info.moves_of_tool.assign(path.tools.size(), 0);
  info.moves_of_operation.assign(path.operations.size(), 0);
  PagedVector<AxisKey> axes;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    ++info.moves_by_kind[static_cast<std::size_t>(move.kind)];
    extend(info.box, path, i);
    const AxisKey key = key_of(move.end.axis);
    if (axes.empty() || axes.back() != key) axes.push_back(key);
    const double tilt = angle_between_deg(path.moves.front().end.axis, move.end.axis);
    if (tilt > info.largest_tilt_deg) {
      info.largest_tilt_deg = tilt;
      info.largest_tilt_move = i;
    }
    count_motion(path, i, info);
    if (!move.not_checked_reason.empty()) ++info.not_checkable[std::string(move.not_checked_reason)];
    if (move.tool == kNone) {
      ++info.moves_without_tool;
    } else {
      ++info.moves_of_tool[move.tool];
    }
    if (move.operation != kNone) ++info.moves_of_operation[move.operation];
  }
  std::sort(axes.begin(), axes.end());
  info.orientations = static_cast<std::size_t>(std::unique(axes.begin(), axes.end()) - axes.begin());
  return info;
}

}  // namespace gouge
