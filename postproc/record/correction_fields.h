#pragma once

#include "postproc/record/correction_record.h"
#include "postproc/record/field_kinds.h"
#include "postproc/record/words.h"

// The fields of the section "correction", described like the other ones in result_fields.h.

namespace gouge {

template <typename F, RecordOf<CauseRecord> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.word("state", r.state, state_words());
  f.length("depth", r.depth_mm, Sign::non_negative);
  f.word("body", r.body, body_words());
  f.optional_word("against", r.against, against_words());
  f.optional_text("mesh", r.mesh);
}

template <typename F, RecordOf<CorrectedRecord> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.text("strategy", r.strategy);
  f.flag("is_inserted", r.is_inserted);
  f.point("shift", r.shift_mm);
  f.length("shift_length", r.shift_length_mm, Sign::non_negative);
  f.number("tilt_rad", r.tilt_rad, Sign::non_negative);
  f.length("depth_before", r.depth_before_mm, Sign::non_negative);
  f.length("depth_after", r.depth_after_mm, Sign::non_negative);
  f.count("iterations", r.iterations);
  f.optional_object("cause", r.cause);
  f.optional_text("old_record", r.old_record);
  f.optional_text("new_record", r.new_record);
}

template <typename F, RecordOf<Uncorrected> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.length("depth", r.depth_mm, Sign::any);
  f.text("reason", r.reason);
  f.flag("is_changed", r.is_changed);
}

template <typename F, RecordOf<Uncut> R>
void describe(F& f, R& r) {
  f.count("first_move", r.first_move);
  f.count("last_move", r.last_move);
  f.count("first_line", r.first_line);
  f.count("last_line", r.last_line);
  f.count("positions", r.positions);
  f.length("length", r.length_mm, Sign::non_negative);
  f.word("kind", r.kind, uncut_words());
}

template <typename F, RecordOf<StockStretch> R>
void describe(F& f, R& r) {
  f.count("first_move", r.first_move);
  f.count("last_move", r.last_move);
  f.count("first_line", r.first_line);
  f.count("last_line", r.last_line);
  f.length("thickness", r.most.thickness_mm, Sign::non_negative);
  f.flag("is_more", r.most.is_more);
  f.flag("is_proved", r.most.is_proved);
  f.point("point", r.most.point);
}

template <typename F, RecordOf<LowRapid> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.length("keeps", r.keeps_mm, Sign::any);
}

template <typename F, RecordOf<WrittenStatement> R>
void describe(F& f, R& r) {
  f.word("kind", r.kind, written_words());
  f.count("line", r.line);
}

/// Describes an angle; it is relative to a length to the power `power`.
template <typename F, RecordOf<AngleRecord> R>
void describe_angle(F& f, R& r, int power) {
  f.per_length("rad", r.rad, power);
  f.optional_count("move", r.move);
  f.optional_count("line", r.line);
}

template <typename F, RecordOf<AngleRecord> R>
void describe(F& f, R& r) {
  describe_angle(f, r, 0);
}

/// An angle relative to a length.
template <typename R>
struct PerLength {
  R& angle;
};
template <typename R>
PerLength(R&) -> PerLength<R>;

template <typename F, typename R>
void describe(F& f, const PerLength<R>& r) {
  describe_angle(f, r.angle, 1);
}

template <typename F, RecordOf<AxisQualityRecord> R>
void describe(F& f, R& r) {
  PerLength turn_per_length{r.turn_per_mm};
  f.object("largest_turn_per_length", turn_per_length);
  f.object("largest_turn", r.turn);
  f.count("turns_on_the_spot", r.turns_on_the_spot);
  f.object("largest_turn_on_the_spot", r.turn_on_the_spot);
  f.per_length("bending", r.bending_per_mm3, 3);
  f.optional_number("feed_seconds", r.feed_seconds, Sign::non_negative);
  f.optional_number("feed_seconds_with_max_rotary_speed", r.limited_feed_seconds, Sign::non_negative);
  f.count("moves_without_feed", r.moves_without_feed);
}

template <typename F, RecordOf<PositionCounts> R>
void describe(F& f, R& r) {
  f.count("moved", r.moved);
  f.count("inserted", r.inserted);
  f.count("tilted", r.tilted);
}

template <typename F, RecordOf<QualityRecord> R>
void describe(F& f, R& r) {
  f.object("before", r.before);
  f.object("after", r.after);
  f.optional_number("max_rotary_speed_deg_per_min", r.max_rotary_deg_per_min, Sign::non_negative);
  f.object("largest_tilt", r.largest_tilt);
  f.object("positions", r.positions);
  f.count("tilted_runs", r.tilted_runs);
}

template <typename F, RecordOf<StraightenedRecord> R>
void describe(F& f, R& r) {
  f.count("curves", r.curves);
  f.count("straight_moves", r.straight_moves);
}

template <typename F, RecordOf<UncutSumRecord> R>
void describe(F& f, R& r) {
  f.count("positions", r.positions);
  f.length("length", r.length_mm, Sign::non_negative);
  f.count("holes", r.holes);
  f.list("stretches", r.stretches);
}

template <typename F, RecordOf<CorrectionRecord> R>
void describe(F& f, R& r) {
  f.text("output_file", r.output_file);
  f.text("strategy", r.strategy);
  f.optional_length("max_shift", r.max_shift_mm, Sign::any);
  f.optional_length("max_side_shift", r.max_side_shift_mm, Sign::non_negative);
  f.length("rapid_clearance", r.rapid_clearance_mm, Sign::non_negative);
  f.optional_object("quality", r.quality);
  f.object("straightened", r.straightened);
  f.object("uncut", r.uncut);
  f.list("stock", r.stock);
  f.list("low_rapids", r.low_rapids);
  f.list("changes", r.changes);
  f.list("uncorrected", r.uncorrected);
  f.list("written", r.written);
}

}  // namespace gouge
