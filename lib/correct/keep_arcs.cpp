#include "lib/correct/keep_arcs.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/contact/contacts.h"
#include "lib/correct/correct_pose.h"
#include "lib/correct/shift_arc.h"
#include "lib/geom/triangle.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr int kKeptPlaces = 16;
constexpr int kGrowths = 3;

/// Replaces the records of an arc's pieces by one record for the whole arc, with their largest depths.
void join_records(std::size_t move, const Vec3& shift, const Pose& end, bool is_inserted, Correction& correction) {
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
  joined.is_inserted = is_inserted;
  joined.shift_mm = shift;
  joined.pose = end;
  const auto slot = static_cast<std::size_t>(first - all.begin());
  std::erase_if(all, of_move);
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(slot), joined);
}

class ArcKeeper {
 public:
  ArcKeeper(const ArcKeeping& keeping, Correction& correction)
      : k_(keeping),
        correction_(correction),
        options_(keeping.checker.options()),
        change_of_(keeping.path.moves.size(), nullptr) {
    options_.tolerance_mm *= kMotionAimShare;
    options_.near_miss_mm = 0;
    for (PathChange& change : correction.changes) change_of_[change.move] = &change;
  }

  void run() {
    for (PathChange& change : correction_.changes) {
      const Move& move = k_.path.moves[change.move];
      if (!change.is_straightened || move.curve_kind != CurveKind::arc || !k_.can_rewrite[change.move]) continue;
      const bool is_kept = keep_whole(change, task_of(change.move)) || move_ends(change) || keep_split(change);
      if (!is_kept) continue;
      std::erase_if(correction_.uncorrected, [&](const Uncorrected& left) { return left.move == change.move; });
    }
  }

 private:
  [[nodiscard]] Pose end_of(std::size_t move) const {
    const PathChange* change = change_of_[move];
    return change != nullptr && change->new_end ? *change->new_end : k_.path.moves[move].end;
  }
  [[nodiscard]] const ToolVariants& tool_of(std::size_t move) const { return *k_.tools[k_.path.moves[move].tool]; }
  [[nodiscard]] ArcTask task_of(std::size_t i) const {
    const Move& move = k_.path.moves[i];
    return {k_.path.arcs[move.curve], k_.path.start_of(i), move.end, end_of(i - 1), end_of(i),
            run_kind(move),           &tool_of(i)};
  }

  bool keep_whole(PathChange& change, const ArcTask& task) {
    const std::optional<PathArc> arc = shift_arc(task, k_.checker);
    if (!arc) return false;
    change.is_straightened = false;
    change.inserted_before.clear();
    change.new_arc = arc;
    join_records(change.move, task.new_end.tip - task.end.tip, task.new_end, false, correction_);
    return true;
  }

  bool keep_split(PathChange& change) {
    if (!k_.can_split[change.move]) return false;
    const ArcTask task = task_of(change.move);
    std::optional<std::vector<ArcPiece>> pieces = split_arc(task, change.inserted_before, k_.checker);
    if (!pieces) return false;
    const Vec3 shift = task.new_end.tip - task.end.tip;
    join_records(change.move, shift, task.new_end, !change.new_end, correction_);
    change.new_arc = pieces->back().arc;
    change.is_straightened = !change.new_arc;
    pieces->pop_back();
    change.inserted_before.clear();
    for (const ArcPiece& piece : *pieces) {
      change.inserted_before.push_back(piece.end);
      change.inserted_arcs.push_back(piece.arc);
    }
    return true;
  }

  // Moves both ends farther in the directions of their shifts: by the larger of the two lifts, and to the radius that
  // the whole arc requires.
  bool move_ends(PathChange& change) {
    const std::size_t i = change.move;
    const bool are_moved = change.new_end && change_of_[i - 1] != nullptr && change_of_[i - 1]->new_end;
    if (!are_moved) return false;
    const ArcTask task = task_of(i);
    const Vec3& axis = task.arc.axis;
    const Vec3 first = task.new_start.tip - task.start.tip, last = task.new_end.tip - task.end.tip;
    const double rise_first = first.dot(axis), rise_last = last.dot(axis);
    const double rise = std::abs(rise_first) > std::abs(rise_last) ? rise_first : rise_last;
    const Vec3 out_first = outward(task.arc, task.start.tip), out_last = outward(task.arc, task.end.tip);
    const double sign = first.dot(out_first) + last.dot(out_last) < 0 ? -1 : 1;
    const double tolerance = k_.checker.options().tolerance_mm;
    const double radial = deepest(task) - kPositionAimShare * tolerance;
    if (std::abs(rise) > Tolerance::kSamePoint_mm && try_ends(change, task, rise * axis, rise * axis)) return true;
    for (int g = 0; g < kGrowths; ++g) {
      const double growth = sign * (radial + 0.1 * g * tolerance);
      const Vec3 s = rise * axis + growth * out_first, e = rise * axis + growth * out_last;
      if (try_ends(change, task, s, e)) return true;
    }
    return false;
  }

  [[nodiscard]] static Vec3 outward(const PathArc& arc, const Vec3& tip) {
    const Vec3 away = tip - arc.center;
    return (away - away.dot(arc.axis) * arc.axis).normalized();
  }

  [[nodiscard]] double deepest(const ArcTask& task) const {
    CheckOptions exact = options_;
    exact.tolerance_mm = 0;
    return k_.checker.check(options_.law.along(task.start, task.end, task.arc), task.kind, *task.tool, exact).depth_mm;
  }

  bool try_ends(PathChange& change, ArcTask task, const Vec3& by_first, const Vec3& by_last) {
    const std::size_t i = change.move;
    const bool is_full = task.start.tip == task.end.tip;
    task.new_start.tip = task.start.tip + by_first;
    task.new_end.tip = is_full ? task.new_start.tip : Vec3(task.end.tip + by_last);
    if (!may_end(i - 1, task.new_start) || !may_end(i, task.new_end)) return false;
    const std::optional<PathArc> before = refitted(i - 1, task.new_start);
    if (!before && !is_last_piece_kept(i - 1, task.new_start)) return false;
    if (!is_first_piece_kept(i + 1, task.new_end) || !keep_whole(change, task)) return false;
    if (before) change_of_[i - 1]->new_arc = before;
    put_end(i - 1, task.new_start);
    put_end(i, task.new_end);
    return true;
  }

  void put_end(std::size_t move, const Pose& pose) {
    change_of_[move]->new_end = pose;
    for (ChangeRecord& record : correction_.records) {
      if (record.move != move || record.is_inserted) continue;
      record.shift_mm = pose.tip - k_.path.moves[move].end.tip;
      record.pose = pose;
      record.depth_after_mm = k_.checker.measure(pose, run_kind(k_.path.moves[move]), tool_of(move)).depth_mm;
    }
  }

  // Returns whether the shift of an end is permitted.
  [[nodiscard]] bool may_end(std::size_t move, const Pose& pose) const {
    const Move& m = k_.path.moves[move];
    const Vec3 shift = pose.tip - m.end.tip;
    const double depth = k_.checker.measure(m.end, run_kind(m), tool_of(move)).depth_mm;
    const double side = k_.correct.max_side_shift_mm.value_or(kSideShiftsPerDepth * depth);
    return shift.norm() <= k_.correct.max_shift_mm && side_shift_mm(shift, m.end.axis) <= side &&
           why_not_shift(m.end, pose, run_kind(m), tool_of(move), k_.checker) == nullptr;
  }

  [[nodiscard]] bool is_plain(std::size_t move) const {
    const Move& m = k_.path.moves[move];
    const PathChange* change = change_of_[move];
    const bool is_straight = m.kind == MoveKind::feed || (change != nullptr && change->is_straightened);
    return m.has_start && m.not_checked_reason.empty() && is_straight && !(change != nullptr && change->has_arc());
  }

  [[nodiscard]] std::vector<Pose> stops_of(std::size_t move) const {
    std::vector<Pose> stops{end_of(move - 1)};
    if (change_of_[move] != nullptr)
      stops.insert(stops.end(), change_of_[move]->inserted_before.begin(), change_of_[move]->inserted_before.end());
    stops.push_back(end_of(move));
    return stops;
  }

  // Returns the arc of the move before, refitted to end at the new pose. That move has already become an arc to its old
  // end.
  [[nodiscard]] std::optional<PathArc> refitted(std::size_t move, const Pose& end) const {
    const PathChange* change = change_of_[move];
    if (change == nullptr || !change->new_arc || !change->inserted_before.empty()) return std::nullopt;
    ArcTask task = task_of(move);
    task.new_end = end;
    return shift_arc(task, k_.checker);
  }

  [[nodiscard]] bool is_last_piece_kept(std::size_t move, const Pose& pose) const {
    if (!is_plain(move)) return false;
    std::vector<Pose> stops = stops_of(move);
    stops.back() = pose;
    return is_piece_clean(stops[stops.size() - 2], pose, move) && keeps_programmed(move, stops);
  }

  [[nodiscard]] bool is_first_piece_kept(std::size_t move, const Pose& pose) const {
    if (move >= k_.path.moves.size() || !k_.path.moves[move].has_start) return true;
    if (!is_plain(move) || k_.path.moves[move].tool != k_.path.moves[move - 1].tool) return false;
    std::vector<Pose> stops = stops_of(move);
    stops.front() = pose;
    return is_piece_clean(pose, stops[1], move) && keeps_programmed(move, stops);
  }

  [[nodiscard]] bool is_piece_clean(const Pose& from, const Pose& to, std::size_t move) const {
    const Motion motion = options_.law.straight(from, to);
    return motion.is_defined() && k_.checker.is_clean(motion, MoveKind::feed, tool_of(move), options_);
  }

  // Returns whether the new feed stays on the programmed feed wherever that is clean.
  [[nodiscard]] bool keeps_programmed(std::size_t move, const std::vector<Pose>& stops) const {
    if (k_.path.moves[move].kind != MoveKind::feed) return true;
    const Motion programmed = options_.law.straight(k_.path.start_of(move), k_.path.moves[move].end);
    for (int i = 0; i <= kKeptPlaces; ++i) {
      const Pose there = programmed.at(static_cast<double>(i) / kKeptPlaces);
      double off = (stops.front().tip - there.tip).norm();
      for (std::size_t k = 1; k < stops.size(); ++k)
        off = std::min(off, distance_to_segment(there.tip, stops[k - 1].tip, stops[k].tip));
      if (off <= k_.checker.options().tolerance_mm) continue;
      if (k_.checker.is_clean(options_.law.at(there), MoveKind::feed, tool_of(move), options_)) return false;
    }
    return true;
  }

  const ArcKeeping& k_;
  Correction& correction_;
  CheckOptions options_;
  std::vector<PathChange*> change_of_;
};

}  // namespace

void keep_arcs(const ArcKeeping& keeping, Correction& correction) { ArcKeeper(keeping, correction).run(); }

}  // namespace gouge
