#include "lib/path/motion_chords.h"

#include <algorithm>
#include <cmath>

#include "lib/path/chords.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr double kChord_mm = 1e-4;  // of arcs and splines

Pose beginning_of(const Toolpath& path, std::size_t move) {
  return path.moves[move].has_start ? path.start_of(move) : path.moves[move].end;
}

// The position of a motion that is not checked is known where the next motion begins there.
bool has_known_end(const Toolpath& path, std::size_t move) {
  if (path.moves[move].not_checked_reason.empty()) return true;
  return move + 1 < path.moves.size() && path.moves[move + 1].has_start;
}

/// Returns the share of an even turn at which it is nearest to an axis, if that is within the turn.
double nearest_turn(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 pole = from.cross(to);
  const double angle_rad = angle_between_rad(from, to);
  if (pole.norm() <= 0 || angle_rad <= 0) return 0;
  const Vec3 across = pole.normalized().cross(from);
  return std::clamp(std::atan2(axis.dot(across), axis.dot(from)) / angle_rad, 0.0, 1.0);
}

}  // namespace

bool is_checked_feed(const Move& move) { return !runs_rapid(move) && move.not_checked_reason.empty(); }

std::vector<MotionChord> chords_of_move(const Toolpath& path, std::size_t move) {
  const Move& of = path.moves[move];
  Pose from = beginning_of(path, move);
  if (!of.has_start || of.curve_kind == CurveKind::none) return {{from, of.end, move}};
  std::vector<MotionChord> chords;
  for (const Pose& to : chords_of(path, move, kChord_mm)) {
    chords.push_back({from, to, move});
    from = to;
  }
  return chords;
}

std::vector<MotionChord> chords_of_feeds(const Toolpath& path) {
  std::vector<MotionChord> feeds;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_checked_feed(path.moves[i])) continue;
    const std::vector<MotionChord> chords = chords_of_move(path, i);
    feeds.insert(feeds.end(), chords.begin(), chords.end());
  }
  return feeds;
}

std::vector<MotionChord> chords_of_rapids(const Toolpath& path) {
  std::vector<MotionChord> rapids;
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (runs_rapid(path.moves[i]) && has_known_end(path, i))
      rapids.push_back({beginning_of(path, i), path.moves[i].end, i});
  return rapids;
}

PoseDistance distance_from(const Pose& pose, const MotionChord& chord) {
  const Vec3 way = chord.to.tip - chord.from.tip;
  const double squared = way.squaredNorm();
  const auto at = [&](double t) {
    return PoseDistance{(chord.from.tip + t * way - pose.tip).norm(),
                        angle_between_rad(axis_between(chord.from.axis, chord.to.axis, t), pose.axis)};
  };
  if (squared > 0) return at(std::clamp((pose.tip - chord.from.tip).dot(way) / squared, 0.0, 1.0));
  const PoseDistance first = at(0), last = at(1), between = at(nearest_turn(pose.axis, chord.from.axis, chord.to.axis));
  return std::min({first, last, between},
                  [](const PoseDistance& a, const PoseDistance& b) { return a.axis_rad < b.axis_rad; });
}

double tip_bound_mm(const Pose& pose, const MotionChord& chord) {
  return (pose.tip - chord.to.tip).norm() - chord.length_mm();
}

}  // namespace gouge
