#include "lib/path/path_info.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/path/chords.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

using AxisKey = std::array<double, 3>;

// Returns a key of an axis. Adding zero turns -0 into 0, so that both count as one orientation.
AxisKey key_of(const Vec3& axis) { return {axis.x() + 0.0, axis.y() + 0.0, axis.z() + 0.0}; }

void extend(Box3& box, const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  box.extend(move.end.tip);
  if (move.curve_kind == CurveKind::none || !move.has_start) return;
  // Most curves end inside the box of those before, so coarse chords are enough to see that they do not enlarge it.
  constexpr double kCoarse_mm = 0.01;
  Box3 coarse;
  for (const Pose& pose : chords_of(path, index, kCoarse_mm)) coarse.extend(pose.tip);
  coarse.extend(Vec3(coarse.max().array() + kCoarse_mm));
  coarse.extend(Vec3(coarse.min().array() - kCoarse_mm));
  if (box.contains(coarse)) return;
  for (const Pose& pose : chords_of(path, index, PathInfo::kBoxError_mm)) box.extend(pose.tip);
}

/// Finds the largest of many angles between unit vectors. An angle takes long to compute, so that is done only for a chord
/// between the vectors that is not surely shorter than that of the largest angle.
class LargestAngle {
 public:
  /// Returns the angle if it is larger than all before it and than 0; else none.
  std::optional<double> note_deg(const Vec3& from, const Vec3& to) {
    constexpr double kSurelyShorter = 1 - Tolerance::kRounding;
    const double chord2 = (from - to).squaredNorm();
    if (!(chord2 > kSurelyShorter * chord2_)) return std::nullopt;
    const double angle = angle_between_deg(from, to);
    if (!(angle > largest_deg_)) return std::nullopt;
    largest_deg_ = angle;
    chord2_ = chord2;
    return angle;
  }

 private:
  double largest_deg_ = 0, chord2_ = 0;
};

void count_motion(const Toolpath& path, std::size_t index, LargestAngle& turns, PathInfo& info) {
  const Move& move = path.moves[index];
  if (!move.has_start) {
    ++info.alone;
    return;
  }
  if (const auto turn = turns.note_deg(path.start_of(index).axis, move.end.axis)) {
    info.largest_turn_deg = *turn;
    info.largest_turn_move = index;
  }
  const double length = move_length_mm(path, index);
  const bool is_curve = move.curve_kind != CurveKind::none;
  if (runs_rapid(move)) {
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
  LargestAngle turns, tilts;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    ++info.moves_by_kind[static_cast<std::size_t>(move.kind)];
    extend(info.box, path, i);
    const AxisKey key = key_of(move.end.axis);
    if (axes.empty() || axes.back() != key) axes.push_back(key);
    if (const auto tilt = tilts.note_deg(path.moves.front().end.axis, move.end.axis)) {
      info.largest_tilt_deg = *tilt;
      info.largest_tilt_move = i;
    }
    count_motion(path, i, turns, info);
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
