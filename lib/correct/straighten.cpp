#include "lib/correct/straighten.h"

#include <algorithm>

#include "lib/path/chords.h"

namespace gouge {
namespace {

bool is_curve(const Move& move) {
  return move.curve_kind != CurveKind::none && move.has_start && move.not_checked_reason.empty();
}

/// Which curves a correction may have to change.
class CurveChoice {
 public:
  CurveChoice(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
              const MotionChecker& checker)
      : path_(path),
        result_(result),
        tools_(tools),
        checker_(checker),
        options_(checker.options()),
        is_chosen_(path.moves.size(), false) {
    options_.tolerance_mm *= kSurelyStays;
    options_.near_miss_mm = 0;
  }

  // A gouging move may move its end and the end of the move before it, where those are too deep themselves; both are
  // ends of curves beside it.
  std::vector<bool> run() {
    const std::size_t count = path_.moves.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (result_.verdicts[i].state != MoveState::gouge) continue;
      choose(i);
      if (is_curve_at(i + 1) && path_.moves[i + 1].has_start && may_move(i)) choose(i + 1);
      if (i > 0 && is_curve_at(i - 1) && path_.moves[i].has_start && may_move(i - 1)) choose(i - 1);
    }
    // Positions of one statement share the arc that describes them.
    for (std::size_t i = 1; i < count; ++i) {
      if (is_chosen_[i - 1] && path_.moves[i].statement == path_.moves[i - 1].statement) choose(i);
    }
    for (std::size_t i = count; i-- > 1;) {
      if (is_chosen_[i] && path_.moves[i].statement == path_.moves[i - 1].statement) choose(i - 1);
    }
    return is_chosen_;
  }

 private:
  // Of the tolerance: what a correction leaves alone is deeper than this.
  static constexpr double kSurelyStays = 0.7;

  [[nodiscard]] bool is_curve_at(std::size_t i) const { return i < path_.moves.size() && is_curve(path_.moves[i]); }
  void choose(std::size_t i) {
    if (is_curve_at(i)) is_chosen_[i] = true;
  }
  [[nodiscard]] bool may_move(std::size_t i) const {
    const Move& move = path_.moves[i];
    return checker_.check(Motion(move.end), move.kind, *tools_[move.tool], options_, true).state != MoveState::clean;
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  const MotionChecker& checker_;
  CheckOptions options_;
  std::vector<bool> is_chosen_;
};

}  // namespace

std::optional<StraightenedPath> straighten(const Toolpath& path, const CheckResult& result,
                                           const std::vector<const ToolVariants*>& tools,
                                           const MotionChecker& checker) {
  const CheckOptions& options = checker.options();
  const std::vector<bool> is_chosen = CurveChoice(path, result, tools, checker).run();
  if (std::none_of(is_chosen.begin(), is_chosen.end(), [](bool chosen) { return chosen; })) return std::nullopt;
  const double error = std::max(kChordShare * options.tolerance_mm, kLeastChordError_mm);
  StraightenedPath straight;
  straight.path.file = path.file;
  straight.path.tools = path.tools;
  straight.path.operations = path.operations;
  straight.path.arcs = path.arcs;
  straight.path.splines = path.splines;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_chosen[i]) {
      straight.path.moves.push_back(path.moves[i]);
      straight.origin.push_back(i);
      straight.result.verdicts.push_back(result.verdicts[i]);
      continue;
    }
    Pose from = path.start_of(i);
    for (const Pose& to : chords_of(path, i, error)) {
      Move chord = path.moves[i];
      chord.kind = MoveKind::feed;
      chord.curve_kind = CurveKind::none;
      chord.end = to;
      const Motion motion(from, to);
      from = to;
      straight.result.verdicts.push_back(checker.check(motion, chord.kind, *tools[chord.tool], options, true));
      straight.path.moves.push_back(std::move(chord));
      straight.origin.push_back(i);
    }
  }
  return straight;
}

namespace {

/// A move of the path as it was, with what its pieces became.
struct Whole {
  PathChange change;
  bool is_changed = false, was_curve = false;
};

// Positions of one statement share the arc that describes them: they stay or go together.
std::vector<PathChange> chosen_changes(const Toolpath& path, std::vector<Whole> wholes) {
  const auto shares = [&](std::size_t a, std::size_t b) {
    return wholes[a].was_curve && wholes[b].was_curve &&
           path.moves[wholes[a].change.move].statement == path.moves[wholes[b].change.move].statement;
  };
  for (std::size_t i = 1; i < wholes.size(); ++i) {
    const Whole& before = wholes[i - 1];
    const bool is_start_moved = before.is_changed && before.change.new_end.has_value();
    if (wholes[i].was_curve && (is_start_moved || (before.is_changed && shares(i - 1, i)))) wholes[i].is_changed = true;
  }
  for (std::size_t i = wholes.size(); i-- > 1;) {
    if (wholes[i].is_changed && shares(i - 1, i)) wholes[i - 1].is_changed = true;
  }
  std::vector<PathChange> changes;
  for (Whole& whole : wholes) {
    if (whole.is_changed) changes.push_back(std::move(whole.change));
  }
  return changes;
}

}  // namespace

Correction restore_curves(const StraightenedPath& straightened, const Toolpath& path, const CheckResult& result,
                          Correction correction) {
  std::vector<const PathChange*> change_of(straightened.path.moves.size(), nullptr);
  for (const PathChange& change : correction.changes) change_of[change.move] = &change;
  Correction restored;
  std::vector<Whole> wholes;
  for (std::size_t first = 0, last = 0; first < straightened.origin.size(); first = last) {
    Whole whole;
    PathChange& all = whole.change;
    all.move = straightened.origin[first];
    for (last = first; last < straightened.origin.size() && straightened.origin[last] == all.move; ++last) {
      const PathChange* change = change_of[last];
      whole.is_changed = whole.is_changed || change != nullptr;
      if (change != nullptr) {
        all.inserted_before.insert(all.inserted_before.end(), change->inserted_before.begin(),
                                   change->inserted_before.end());
      }
      const bool has_new_end = change != nullptr && change->new_end;
      const Pose& end = has_new_end ? *change->new_end : straightened.path.moves[last].end;
      const bool is_last = last + 1 == straightened.origin.size() || straightened.origin[last + 1] != all.move;
      if (!is_last) all.inserted_before.push_back(end);
      if (is_last && has_new_end) all.new_end = end;
    }
    whole.was_curve = is_curve(path.moves[all.move]) && straightened.path.moves[first].curve_kind == CurveKind::none;
    all.is_straightened = whole.was_curve;
    wholes.push_back(std::move(whole));
  }
  restored.changes = chosen_changes(path, std::move(wholes));
  for (ChangeRecord& record : correction.records) {
    const std::size_t piece = record.move;
    record.move = straightened.origin[piece];
    const bool is_within = piece + 1 < straightened.origin.size() && straightened.origin[piece + 1] == record.move;
    record.is_inserted = record.is_inserted || is_within;
    restored.records.push_back(record);
  }
  for (Uncorrected& left : correction.uncorrected) {
    left.move = straightened.origin[left.move];
    const bool is_reported = !restored.uncorrected.empty() && restored.uncorrected.back().move == left.move;
    if (is_reported) continue;
    if (result.verdicts[left.move].state == MoveState::gouge) left.depth_mm = result.verdicts[left.move].depth_mm;
    restored.uncorrected.push_back(left);
  }
  return restored;
}

}  // namespace gouge
