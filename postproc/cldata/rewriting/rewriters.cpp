#include "postproc/cldata/rewriting/rewriters.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/dialect.h"

namespace gouge {

namespace {

bool is_same_hole(const MotionRecord& a, const MotionRecord& b) {
  return a.form == PositionForm::cycle && b.form == PositionForm::cycle && a.statement == b.statement &&
         a.point == b.point;
}

// Returns whether the records [first, last) of one hole can be shifted.
bool is_shiftable(const Toolpath& path, const std::vector<MotionRecord>& records, std::size_t first, std::size_t last) {
  if (records[first].numbers == 0) return false;  // a step from an earlier position
  for (std::size_t i = first; i < last; ++i) {
    const std::string_view reason = path.moves[i].not_checked_reason;
    if (kind_of(reason) != ReasonKind::none && kind_of(reason) != ReasonKind::around_hole) return false;
  }
  if (last == records.size()) return true;
  const bool is_step_next = records[last].form == PositionForm::godlta ||
                            (records[last].form == PositionForm::cycle && records[last].numbers == 0);
  const bool is_arc_next = path.moves[last].kind == MoveKind::arc && path.moves[last].has_start;
  return !is_step_next && !is_arc_next;
}

bool states_axes(const Toolpath& path, const std::vector<MotionRecord>& records) {
  constexpr std::size_t kPointAndAxis = 6;
  const bool is_any_tilted = std::any_of(path.moves.begin(), path.moves.end(), [](const Move& move) {
    return !move.end.axis.isApprox(Vec3::UnitZ(), Tolerance::kRounding);
  });
  return is_any_tilted || std::any_of(records.begin(), records.end(),
                                      [](const MotionRecord& record) { return record.numbers >= kPointAndAxis; });
}

}  // namespace

RewritableMoves rewritable_moves(const Toolpath& path, const MotionRecords& read, const ArcText& arcs) {
  const std::vector<MotionRecord>& records = read.of_move;
  const std::vector<bool> none(records.size(), false);
  const Dialect dialect = dialect_or_apt(path.dialect);
  RewritableMoves can;
  can.arc = can.split = can.hole = none;
  can.has_axes = dialect.is_binary || states_axes(path, records);
  can.has_rapids = can_say_rapid(path.dialect);
  if (!dialect.has_apt_words) return can;
  for (std::size_t first = 0, last = 0; first < records.size(); first = last) {
    last = first + 1;
    while (last < records.size() && is_same_hole(records[first], records[last])) ++last;
    if (records[first].form == PositionForm::cycle) can.hole[first] = is_shiftable(path, records, first, last);
    can.arc[first] = arcs.is_writable(first);
    can.split[first] = can.arc[first] && records[first].form == PositionForm::go_to;
  }
  return can;
}

bool can_say_rapid(std::string_view dialect) {
  const Dialect traits = dialect_or_apt(dialect);
  return traits.has_apt_words && !traits.has_positions_alone;
}

namespace {

std::optional<Diagnostic> check_changes(const Toolpath& path, const std::vector<PathChange>& changes) {
  std::vector<bool> is_named(path.moves.size(), false);
  const bool is_rapid_sayable = can_say_rapid(path.dialect);
  for (const PathChange& change : changes) {
    const std::string name = "move " + std::to_string(change.move);
    if (change.move >= path.moves.size() || is_named[change.move]) {
      return make_error("write-move",
                        name + " is " + (change.move >= path.moves.size() ? "not in the path" : "named twice") +
                            "; expected one change for a move of the path",
                        path.file);
    }
    is_named[change.move] = true;
    const Move& move = path.moves[change.move];
    const bool changes_it = change.new_end || !change.inserted_before.empty();
    if (change.hole_shift_mm && (changes_it || change.is_straightened || change.new_arc)) {
      return make_error("write-move", name + " has a shifted hole and another change; expected one of both", path.file);
    }
    const std::size_t at_rapid = change.at_rapid.size();
    const bool may_be_rapid = move.kind == MoveKind::feed || (move.kind == MoveKind::arc && change.is_straightened);
    if (at_rapid != 0 && (at_rapid != change.inserted_before.size() + 1 || !may_be_rapid)) {
      return make_error(
          "write-move",
          name + " has " + std::to_string(at_rapid) + " entries of what is reached at rapid for " +
              std::to_string(change.inserted_before.size()) +
              " inserted positions; expected one each and one for its end, and only of a feed or a straightened curve",
          path.file, move.line);
    }
    if (at_rapid != 0 && !is_rapid_sayable) {
      return make_error("write-move", name + " is to be reached at rapid, which this dialect cannot say of one motion",
                        path.file, move.line);
    }
    const std::size_t arcs = change.inserted_arcs.size();
    if (arcs != 0 && (arcs != change.inserted_before.size() || move.curve_kind != CurveKind::arc)) {
      return make_error("write-arc",
                        name + " has " + std::to_string(arcs) + " arcs for " +
                            std::to_string(change.inserted_before.size()) +
                            " inserted positions; expected one entry each, and only of an arc",
                        path.file);
    }
    if (change.new_arc && change.is_straightened) {
      return make_error("write-arc", name + " is to be an arc and straight; expected one of both", path.file);
    }
    if (changes_it && is_unread(move.not_checked_reason)) {
      return make_error("write-move", name + " is a statement that is not understood, so it cannot be changed",
                        path.file, move.line);
    }
    const bool is_straight = move.kind == MoveKind::feed || move.kind == MoveKind::rapid ||
                             (change.is_straightened && move.curve_kind != CurveKind::none) || change.new_arc;
    if (!is_straight && changes_it) {
      return make_error("write-arc", name + " is an arc, a curve or a cycle; only straight moves can be changed",
                        path.file, move.line);
    }
    if (!move.has_start && !change.inserted_before.empty()) {
      return make_error("write-alone", name + " has no start; positions can be inserted only into a motion", path.file,
                        move.line);
    }
  }
  return std::nullopt;
}

// Finds a change that the dialect cannot state. Only text dialects can rewrite arcs and holes.
std::optional<Diagnostic> find_unsaid(const Toolpath& path, const std::vector<PathChange>& changes) {
  const bool is_text = dialect_or_apt(path.dialect).has_apt_words;
  for (const PathChange& change : changes) {
    if (is_text || (!change.has_arc() && !change.hole_shift_mm)) continue;
    return make_error("write-arc", "arcs and holes of this dialect cannot be rewritten; straighten or leave them",
                      path.file, path.moves[change.move].line);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes) {
  if (auto error = check_changes(path, changes)) return error;
  return find_unsaid(path, changes);
}

}  // namespace gouge
