#include "lib/correct/straighten.h"

#include <algorithm>

#include "lib/path/chords.h"

namespace gouge {
namespace {

bool is_curve(const Move& move) {
  return move.curve_kind != CurveKind::none && move.has_start && move.not_checked_reason.empty();
}

// A gouging move may move its end and the end of the move before it; both are ends of curves beside it.
std::vector<bool> choose_curves(const Toolpath& path, const CheckResult& result) {
  const std::size_t count = path.moves.size();
  std::vector<bool> is_chosen(count, false);
  const auto choose = [&](std::size_t i) {
    if (i < count && is_curve(path.moves[i])) is_chosen[i] = true;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (result.verdicts[i].state != MoveState::gouge) continue;
    choose(i);
    choose(i + 1);
    if (i > 0) choose(i - 1);
  }
  // Positions of one statement share the arc that describes them.
  for (std::size_t i = 1; i < count; ++i) {
    if (is_chosen[i - 1] && path.moves[i].statement == path.moves[i - 1].statement) choose(i);
  }
  for (std::size_t i = count; i-- > 1;) {
    if (is_chosen[i] && path.moves[i].statement == path.moves[i - 1].statement) choose(i - 1);
  }
  return is_chosen;
}

}  // namespace

bool needs_straightening(const Toolpath& path, const CheckResult& result) {
  const std::vector<bool> is_chosen = choose_curves(path, result);
  return std::any_of(is_chosen.begin(), is_chosen.end(), [](bool chosen) { return chosen; });
}

StraightenedPath straighten(const Toolpath& path, const CheckResult& result,
                            const std::vector<const ToolForms*>& tools, const PreparedScene& scene,
                            const CheckOptions& options, const HeadChecker* heads) {
  const std::vector<bool> is_chosen = choose_curves(path, result);
  const double error =
      std::clamp(kChordShare * options.tolerance_mm, kLeastChordError_mm, kMostChordError_mm);
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
      MoveVerdict verdict = check_move(motion, chord.kind, *tools[chord.tool], scene, options);
      if (heads != nullptr) heads->check(motion, options, verdict);
      straight.result.verdicts.push_back(std::move(verdict));
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

Correction restore_curves(const StraightenedPath& straightened, const Toolpath& path,
                          const CheckResult& result, Correction correction) {
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
      const bool is_last =
          last + 1 == straightened.origin.size() || straightened.origin[last + 1] != all.move;
      if (!is_last) all.inserted_before.push_back(end);
      if (is_last && has_new_end) all.new_end = end;
    }
    whole.was_curve =
        is_curve(path.moves[all.move]) && straightened.path.moves[first].curve_kind == CurveKind::none;
    all.is_straightened = whole.was_curve;
    wholes.push_back(std::move(whole));
  }
  restored.changes = chosen_changes(path, std::move(wholes));
  for (ChangeRecord& record : correction.records) {
    const std::size_t piece = record.move;
    record.move = straightened.origin[piece];
    const bool is_within =
        piece + 1 < straightened.origin.size() && straightened.origin[piece + 1] == record.move;
    record.is_inserted = record.is_inserted || is_within;
    restored.records.push_back(record);
  }
  for (Uncorrected& left : correction.uncorrected) {
    left.move = straightened.origin[left.move];
    const bool is_told = !restored.uncorrected.empty() && restored.uncorrected.back().move == left.move;
    if (is_told) continue;
    if (result.verdicts[left.move].state == MoveState::gouge)
      left.depth_mm = result.verdicts[left.move].depth_mm;
    restored.uncorrected.push_back(left);
  }
  return restored;
}

}  // namespace gouge
