#include "postproc/cldata/rewriting/rewritable_moves.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/rewriting/rewriters.h"

namespace gouge {
namespace {

bool is_same_hole(const MotionRecord& a, const MotionRecord& b) {
  return a.form == PositionForm::cycle && b.form == PositionForm::cycle && a.statement == b.statement &&
         a.point == b.point;
}

// Of the records of one hole [first, last).
bool is_shiftable(const Toolpath& path, const std::vector<MotionRecord>& records, std::size_t first, std::size_t last) {
  if (records[first].numbers == 0) return false;  // a step from somewhere
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

}  // namespace gouge
