#include "lib/correct/reworked_path.h"

#include <algorithm>

#include "lib/base/tolerance.h"

namespace gouge {

bool is_curve(const Move& move) {
  return move.curve_kind != CurveKind::none && move.has_start && move.not_checked_reason.empty();
}

Toolpath without_moves(const Toolpath& path) {
  Toolpath bare;
  bare.file = path.file;
  bare.unit = path.unit;
  bare.tools = path.tools;
  bare.operations = path.operations;
  bare.arcs = path.arcs;
  bare.splines = path.splines;
  return bare;
}

void ReworkedPath::add(const Move& move, std::size_t from, bool moved, const MoveVerdict& verdict) {
  path.moves.push_back(move);
  origin.push_back(from);
  is_moved.push_back(moved);
  result.verdicts.push_back(verdict);
}

ReworkedPath with_positions(const Toolpath& path, const CheckResult& result, const ReworkedPath* base,
                            const std::vector<NewPosition>& positions, const std::vector<const ToolVariants*>& tools,
                            const MotionChecker& checker) {
  const Moves& moves = base != nullptr ? base->path.moves : path.moves;
  const MoveVerdicts& verdicts = base != nullptr ? base->result.verdicts : result.verdicts;
  const CheckOptions& options = checker.options();
  ReworkedPath moved;
  moved.path = without_moves(path);
  const auto add = [&](const Move& move, std::size_t origin) {
    const Motion motion = move.has_start ? options.law.between(moved.path.moves.back().end, move.end, move.kind)
                                         : options.law.at(move.end);
    const bool is_whole = move.kind == MoveKind::rapid || move.is_spindle_stopped();
    // A cut gets no credit here for what it removes itself, so one that is not known to meet stock may seem to.
    const bool has_stock = is_whole || checker.meets_stock(origin);
    const MotionChecker in_place = has_stock ? checker.for_move(origin, is_whole) : checker;
    moved.add(move, origin, true, in_place.check(motion, move.kind, *tools[move.tool], options, true));
  };
  auto next = positions.begin();
  bool is_start_moved = false;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::size_t origin = base != nullptr ? base->origin[i] : i;
    const Move& move = moves[i];
    if ((next == positions.end() || next->move != i) && !(is_start_moved && move.has_start)) {
      is_start_moved = false;
      moved.add(move, origin, base != nullptr && base->is_moved[i], verdicts[i]);
      continue;
    }
    is_start_moved = false;
    for (; next != positions.end() && next->move == i; ++next) {
      Move piece = move;
      piece.end = next->pose;
      piece.kind = next->kind;
      add(piece, origin);
      is_start_moved = next->is_end;
    }
    if (!is_start_moved) add(move, origin);
  }
  return moved;
}

namespace {

bool is_kept_pose(const Pose& a, const Pose& b) {
  return (a.tip - b.tip).cwiseAbs().maxCoeff() <= Tolerance::kRounding &&
         (a.axis - b.axis).cwiseAbs().maxCoeff() <= Tolerance::kRounding;
}

/// A move of the original path, with the changes of its pieces.
struct Whole {
  PathChange change;
  bool is_changed = false, was_curve = false;
};

// Returns the changes to make. Positions of one statement share the arc that describes them, so they stay or change
// together.
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

Correction restore_moves(const ReworkedPath& reworked, const Toolpath& path, const CheckResult& result,
                         Correction correction) {
  std::vector<const PathChange*> change_of(reworked.path.moves.size(), nullptr);
  for (const PathChange& change : correction.changes) change_of[change.move] = &change;
  Correction restored;
  std::vector<Whole> wholes;
  for (std::size_t first = 0, last = 0; first < reworked.origin.size(); first = last) {
    Whole whole;
    PathChange& all = whole.change;
    all.move = reworked.origin[first];
    for (last = first; last < reworked.origin.size() && reworked.origin[last] == all.move; ++last) {
      const PathChange* change = change_of[last];
      whole.is_changed = whole.is_changed || change != nullptr || reworked.is_moved[last];
      if (change != nullptr) {
        all.inserted_before.insert(all.inserted_before.end(), change->inserted_before.begin(),
                                   change->inserted_before.end());
      }
      // Positions that a later stage inserts before the end of a piece are reached in the same way as that end.
      const bool is_rapid =
          reworked.path.moves[last].kind == MoveKind::rapid && path.moves[all.move].kind != MoveKind::rapid;
      all.at_rapid.resize(all.inserted_before.size(), is_rapid);
      const bool has_new_end = change != nullptr && change->new_end;
      const Pose& end = has_new_end ? *change->new_end : reworked.path.moves[last].end;
      const bool is_last = last + 1 == reworked.origin.size() || reworked.origin[last + 1] != all.move;
      if (!is_last) all.inserted_before.push_back(end);
      all.at_rapid.push_back(is_rapid);
      if (is_last && (has_new_end || !is_kept_pose(end, path.moves[all.move].end))) all.new_end = end;
    }
    if (std::ranges::find(all.at_rapid, true) == all.at_rapid.end()) all.at_rapid.clear();
    whole.was_curve = is_curve(path.moves[all.move]) && reworked.path.moves[first].curve_kind == CurveKind::none;
    whole.is_changed = whole.is_changed || all.new_end.has_value();
    all.is_straightened = whole.was_curve;
    wholes.push_back(std::move(whole));
  }
  restored.changes = chosen_changes(path, std::move(wholes));
  for (ChangeRecord& record : correction.records) {
    const std::size_t piece = record.move;
    record.move = reworked.origin[piece];
    const bool is_within = piece + 1 < reworked.origin.size() && reworked.origin[piece + 1] == record.move;
    record.is_inserted = record.is_inserted || is_within;
    restored.records.push_back(record);
  }
  for (Uncorrected& left : correction.uncorrected) {
    left.move = reworked.origin[left.move];
    const bool is_reported = !restored.uncorrected.empty() && restored.uncorrected.back().move == left.move;
    if (is_reported) continue;
    if (result.verdicts[left.move].state == MoveState::gouge) left.depth_mm = result.verdicts[left.move].depth_mm;
    restored.uncorrected.push_back(left);
  }
  return restored;
}

}  // namespace gouge
