#include "lib/correct/shift_arc.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "lib/correct/free_pose.h"

namespace gouge {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kAimShare = 0.8;  // of the tolerance
constexpr double kHeightShare = 0.2;
constexpr double kTooDeepShare = 0.5;
constexpr double kMostOfIt = 0.9;
constexpr double kSweepChange_rad = 0.2;
constexpr double kSamePlace_mm = 1e-9, kSameAxis = 1e-12;
constexpr double kLeastRadius_mm = 1e-3;
constexpr int kPlaces = 16;

Vec3 across(const Vec3& way, const Vec3& axis) {
  return way - way.dot(axis) * axis;
}

class ArcShift {
 public:
  ArcShift(const ArcTask& task, const MotionChecker& checker)
      : task_(task), checker_(checker), options_(checker.options()) {
    is_full_ = (task.start.tip - task.end.tip).norm() <= kSamePlace_mm;
    options_.tolerance_mm *= kAimShare;
    options_.near_miss_mm = 0;
  }

  [[nodiscard]] std::optional<PathArc> run() const {
    const bool keeps_axes = (task_.start.axis - task_.new_start.axis).norm() <= kSameAxis &&
                            (task_.end.axis - task_.new_end.axis).norm() <= kSameAxis;
    if (!keeps_axes || std::abs(task_.arc.sweep_rad) > kTurn + 1e-9) return std::nullopt;
    const bool ends_meet = task_.new_start.tip == task_.new_end.tip;
    if (is_full_ != ends_meet) return std::nullopt;
    const Vec3 shift = 0.5 * (task_.new_start.tip - task_.start.tip + task_.new_end.tip - task_.end.tip);
    const Vec3 along = shift.dot(task_.arc.axis) * task_.arc.axis;
    for (const Vec3& way : {shift, along}) {
      const std::optional<PathArc> arc = about(task_.arc.center + way);
      if (arc && is_good(*arc)) return arc;
    }
    return std::nullopt;
  }

 private:
  // The arc about the place nearest to `center` that is equally far from both ends.
  [[nodiscard]] std::optional<PathArc> about(Vec3 center) const {
    const Vec3& axis = task_.arc.axis;
    const Vec3 &s = task_.new_start.tip, &e = task_.new_end.tip;
    const double rise = (e - s).dot(axis) - (task_.end.tip - task_.start.tip).dot(axis);
    if (std::abs(rise) > kHeightShare * checker_.options().tolerance_mm) return std::nullopt;
    PathArc arc = task_.arc;
    if (!is_full_) {
      const Vec3 chord = across(e - s, axis);
      const double length = chord.norm();
      if (!(length > kLeastRadius_mm)) return std::nullopt;
      const Vec3 middle = 0.5 * (s + e);
      center -= (center - middle).dot(chord) / (length * length) * chord;
    }
    const Vec3 from = across(s - center, axis), to = across(e - center, axis);
    if (!(from.norm() > kLeastRadius_mm)) return std::nullopt;
    arc.center = center;
    if (is_full_) return arc;
    const double sign = arc.sweep_rad < 0 ? -1 : 1;
    double sweep = sign * std::atan2(axis.dot(from.cross(to)), from.dot(to));
    if (sweep <= 0) sweep += kTurn;
    if (std::abs(sweep - std::abs(task_.arc.sweep_rad)) > kSweepChange_rad) return std::nullopt;
    arc.sweep_rad = sign * sweep;
    return arc;
  }

  [[nodiscard]] bool is_good(const PathArc& arc) const {
    const Motion motion(task_.new_start, task_.new_end, arc);
    return checker_.is_clean(motion, task_.kind, *task_.tool, options_) && is_shift_allowed(motion);
  }

  [[nodiscard]] bool is_shift_allowed(const Motion& motion) const {
    const Motion before(task_.start, task_.end, task_.arc);
    double farthest = 0;
    int too_deep = 0;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = static_cast<double>(i) / kPlaces;
      const Pose from = before.at(t), to = motion.at(t);
      farthest = std::max(farthest, (to.tip - from.tip).norm());
      const MoveVerdict verdict = checker_.measure(from, task_.kind, *task_.tool);
      too_deep += verdict.depth_mm > kTooDeepShare * checker_.options().tolerance_mm ? 1 : 0;
      if (why_not_shift(from, {to.tip, from.axis}, task_.kind, *task_.tool, checker_) != nullptr)
        return false;
    }
    return farthest <= checker_.options().tolerance_mm || too_deep >= kMostOfIt * (kPlaces + 1);
  }

  const ArcTask& task_;
  const MotionChecker& checker_;
  CheckOptions options_;
  bool is_full_ = false;
};

/// One record for the whole arc, by the deepest of those of its pieces.
void join_records(std::size_t move, const Vec3& shift, Correction& correction) {
  std::vector<ChangeRecord>& all = correction.records;
  const auto of_move = [move](const ChangeRecord& record) { return record.move == move; };
  const auto first = std::find_if(all.begin(), all.end(), of_move);
  if (first == all.end()) return;
  ChangeRecord joined = *first;
  for (const ChangeRecord& record : all) {
    if (!of_move(record)) continue;
    joined.depth_before_mm = std::max(joined.depth_before_mm, record.depth_before_mm);
    joined.depth_after_mm = std::max(joined.depth_after_mm, record.depth_after_mm);
    joined.iterations = std::max(joined.iterations, record.iterations);
  }
  joined.is_inserted = false;
  joined.shift_mm = shift;
  const auto place = static_cast<std::size_t>(first - all.begin());
  std::erase_if(all, of_move);
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), joined);
}

}  // namespace

std::optional<PathArc> shift_arc(const ArcTask& task, const MotionChecker& checker) {
  return ArcShift(task, checker).run();
}

void keep_arcs(const Toolpath& path, const std::vector<bool>& can_rewrite,
               const std::vector<const ToolForms*>& tools, const MotionChecker& checker,
               Correction& correction) {
  std::map<std::size_t, const PathChange*> change_of;
  for (const PathChange& change : correction.changes) change_of[change.move] = &change;
  const auto end_of = [&](std::size_t move) {
    const auto found = change_of.find(move);
    return found != change_of.end() && found->second->new_end ? *found->second->new_end
                                                              : path.moves[move].end;
  };
  for (PathChange& change : correction.changes) {
    const Move& move = path.moves[change.move];
    if (!change.is_straightened || move.curve_kind != CurveKind::arc || !can_rewrite[change.move]) continue;
    ArcTask task{path.arcs[move.curve],   path.start_of(change.move), move.end,
                 end_of(change.move - 1), end_of(change.move),        move.kind,
                 tools[move.tool]};
    const std::optional<PathArc> arc = shift_arc(task, checker);
    if (!arc) continue;
    change.is_straightened = false;
    change.inserted_before.clear();
    change.new_arc = arc;
    join_records(change.move, task.new_end.tip - task.end.tip, correction);
    std::erase_if(correction.uncorrected, [&](const Uncorrected& left) { return left.move == change.move; });
  }
}

}  // namespace gouge
