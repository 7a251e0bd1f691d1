#include <utility>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/further_readings.h"
#include "postproc/cldata/interpreting/word_handlers.h"

// OPSKIP: a switch of the control decides whether statements between ON and OFF run. Behind OFF both readings are
// joined: a state that differs between them is unknown.

namespace gouge {
namespace {

void begin_skip(States& s) {
  std::optional<Pose> start;
  const bool is_start_known = s.chain.is_start_certain() && !s.retracted && s.open_places.empty();
  if (is_start_known && s.cutcom.reason().empty()) start = s.chain.last_pose();
  s.before_skip.emplace(BeforeSkip{s.uncertainties.reason(), start, s.chain, s.axes, s.feed, s.cutcom, s.uncertainties,
                                   s.clear_plane_mm, s.arc_slope_mm, s.frame_changes, s.blocks.number()});
  s.skip_begin = s.in.moves();
  if (s.curve.may_go_on()) contradict_skip(s);
}

bool changes_more_than_motion(const States& s, const BeforeSkip& before) {
  return !s.uncertainties.is_same(before.uncertainties, Uncertainty::skip) || !s.cutcom.is_same(before.cutcom) ||
         s.frame_changes != before.frame_changes || s.blocks.number() != before.block || s.curve.may_go_on();
}

bool has_moved(const States& s, const MotionChain& before) {
  return s.in.moves() > s.skip_begin || s.chain.last_pose().has_value() != before.last_pose().has_value() ||
         s.chain.unknown_start() != before.unknown_start();
}

// Makes the start of the next motion unknown: the last position of the skip, or the one before it.
void lose_start(States& s, const BeforeSkip& before) {
  const bool is_run_known = s.chain.is_start_certain() && !s.retracted && s.open_places.empty();
  s.skip_start = is_run_known ? before.start : std::nullopt;
  s.skip_reason = before.reason;
  s.is_behind_skip = true;
  const std::optional<Pose>& here = s.chain.last_pose() ? s.chain.last_pose() : before.chain.last_pose();
  if (here) s.chain.stand(Pose(*here), before.reason);
  s.retracted.reset();
  s.open_places.clear();
  s.homed_axes = {};
  s.cycle.leave_hole();
}

void join_readings(States& s, const BeforeSkip& before) {
  s.axes.join(before.axes);
  if (!s.feed.has_kind_of(before.feed)) s.feed.doubt_kind();
  if (before.feed.is_spindle_stopped()) s.feed.stop_spindle(true);
  if (s.clear_plane_mm != before.clear_plane_mm) s.clear_plane_mm.reset();
  if (s.arc_slope_mm != before.arc_slope_mm) s.arc_slope_mm = kUnknownSlope;
  if (has_moved(s, before.chain)) {
    lose_start(s, before);
  } else {
    s.chain.keep_link(before.chain);
  }
  s.skip_reason = before.reason;
}

}  // namespace

void contradict_skip(States& s) {
  if (s.uncertainties.has(Uncertainty::skip)) s.skips_more_than_motion = true;
}

// Takes OPSKIP. If a tool, a frame, a cycle or another lasting state begins or ends between ON and OFF, all that follows
// is unknown.
void take_opskip(States& s) {
  const bool is_on = s.in.has("ON");
  const bool is_understood = is_on != s.in.has("OFF");
  const bool was_on = s.uncertainties.has(Uncertainty::skip);
  if (!is_understood) s.in.count_unknown();
  if (is_understood && s.skips_more_than_motion) return;
  if (is_understood && was_on && !is_on && changes_more_than_motion(s, *s.before_skip)) return contradict_skip(s);
  switch_uncertainty(s, Uncertainty::skip, is_on || !is_understood, Reasons::kSkipped);
  s.skips_more_than_motion = !is_understood;
  if (!is_understood || is_on == was_on) return;
  is_on ? begin_skip(s) : join_readings(s, *s.before_skip);
}

void find_start_behind_skip(States& s, const Position& position) {
  const bool is_straight = position.form == PositionForm::go_to && position.uncertainty == nullptr;
  const bool is_read = s.is_behind_skip && s.skip_start && s.cutcom.reason().empty();
  if (is_straight && is_read && s.chain.unknown_start() == s.skip_reason) s.chain.find_start();
}

void find_start_for_link(States& s) {
  if (s.is_behind_skip && s.chain.unknown_start() == s.skip_reason) s.chain.find_start();
}

void lose_way_behind_skip(States& s, std::size_t moves) {
  if (moves <= s.skip_begin) return;
  Move& last = s.in.path.moves[moves - 1];
  const bool is_same = s.skip_start && (s.skip_start->tip - last.end.tip).norm() <= Tolerance::kSamePoint_mm &&
                       (s.skip_start->axis - last.end.axis).norm() <= Tolerance::kExactDirection;
  if (is_same) return;
  if (last.not_checked_reason.empty() || last.is_covered()) last.not_checked_reason = s.skip_reason;
  last.cover = Cover::none;
}

void emit_from_before_skip(States& s, const Position& position) {
  if (!std::exchange(s.is_behind_skip, false)) return;
  Move& last = s.in.path.moves.back();
  if (last.begins_stretch) lose_way_behind_skip(s, s.in.moves() - 1);
  if (last.is_linked && last.not_checked_reason.empty()) last.not_checked_reason = s.skip_reason;
  if (!last.has_start) return;
  open_last_move(s, s.skip_reason);
  Move reading = s.in.path.moves.back();
  const Pose end = reading.end;
  reading.end = *s.skip_start;
  reading.has_start = false;
  push_reading(s, position, reading);
  reading.end = end;
  reading.has_start = true;
  push_reading(s, position, reading);
}

}  // namespace gouge
