#include <string_view>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

// CYCLE/OFF where no cycle is in force: one may have begun anywhere behind the last word that no cycle has.
void doubt_moves_before_stray_end(States& s) {
  Moves& moves = s.in.path.moves;
  std::string_view reason;
  for (std::size_t i = s.cycle.first_possible_hole(); i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::feed || !moves[i].not_checked_reason.empty()) continue;
    if (reason.empty()) {
      reason = s.in.because(Reasons::kCycleStrayEnd);
      s.cycle.note_stray_end();
    }
    moves[i].not_checked_reason = reason;
  }
  if (!reason.empty()) s.chain.lose_last_pose(Reasons::kAfterCycle);
}

}  // namespace

void take_cycle(States& s) {
  if (s.in.arguments.empty()) {
    s.in.count_unknown();
    return distrust(s, Word::cycle);
  }
  s.feed_units.note(s.in.arguments, s.in.line());
  const std::string_view what = s.in.arguments.front().text;
  if (equals_ignoring_case(what, "INIT") || equals_ignoring_case(what, "CLEAR")) {
    if (s.cycle.is_on()) s.cycle.contradict();  // does it end the one in force? no document says
    return;
  }
  // Whether the control or the post-processor makes the moves.
  if (s.in.dialect.cycle_form == CycleForm::ncl && equals_ignoring_case(what, "AUTO")) return;
  const bool is_end = equals_ignoring_case(what, "OFF") || equals_ignoring_case(what, "NOMORE");
  if (!is_end || s.in.arguments.size() > 1) {
    s.cycle.begin(s.frame.mm_per_unit());
    const auto& drill = s.cycle.drill();
    if (drill && drill->csink_mm > 0) s.cycle.set_countersink(s.tool.countersink_depth(drill->csink_mm));
    return;
  }
  if (s.cycle.end()) doubt_moves_before_stray_end(s);
  s.cycle.bound_holes();
}

}  // namespace gouge
