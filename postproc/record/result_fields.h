#pragma once

#include "postproc/record/correction_fields.h"
#include "postproc/record/field_kinds.h"
#include "postproc/record/result_record.h"
#include "postproc/record/words.h"

// The fields of a result in the order of the file, each with its name, its kind and its limits. The writer
// (write_record.cpp), the reader (read_record.cpp) and the schema (record_schema.cpp) visit this description. So a new
// field is added only here.
//
// `f` visits the fields of one object. Fields of the kind `length` are in the unit of the toolpath in the file. `Sign`
// limits a number. A field of an `optional_` kind is null if it has no value.

namespace gouge {

inline constexpr int kArea = -2;  ///< the power of an area in per_length

template <typename F, RecordOf<Assumption> R>
void describe(F& f, R& r) {
  f.word("fact", r.subject, subject_words());
  f.text("object", r.object);
  f.word("state", r.basis, basis_words());
  f.flag("is_open", r.is_open);
  f.text("value", r.value);
  f.text("evidence", r.evidence);
  f.text("remedy", r.remedy);
  f.text("file", r.file);
  f.count("line", r.line);
}

template <typename F, RecordOf<InputFile> R>
void describe(F& f, R& r) {
  f.word("role", r.role, role_words());
  f.text("name", r.name);
  f.count("bytes", r.bytes);
  f.text("checksum", r.checksum);
}

template <typename F, RecordOf<OptionsRecord> R>
void describe(F& f, R& r) {
  f.length("tolerance", r.tolerance_mm, Sign::non_negative);
  f.length("resolution", r.resolution_mm, Sign::non_negative);
  f.length("stock_to_leave", r.stock_to_leave_mm, Sign::any);
  f.length("shank_clearance", r.shank_clearance_mm, Sign::non_negative);
  f.length("holder_clearance", r.holder_clearance_mm, Sign::non_negative);
  f.length("near_miss", r.near_miss_mm, Sign::non_negative);
  f.word("rapid", r.rapid, rapid_words());
  f.option_texts("more", r.more);
}

template <typename F, RecordOf<MovesByKind> R>
void describe(F& f, R& r) {
  f.count("feed", r.feed);
  f.count("rapid", r.rapid);
  f.count("arc", r.arc);
  f.count("cycle", r.cycle);
}

template <typename F, RecordOf<ToolpathRecord> R>
void describe(F& f, R& r) {
  f.text("file", r.file);
  f.text("dialect", r.dialect);
  f.flag("unit_is_stated", r.is_unit_stated);
  f.count("moves", r.moves);
  f.object("moves_by_kind", r.moves_by_kind);
  f.count("operations", r.operations);
  f.counts_by_word("words_not_understood", r.words_not_understood);
}

template <typename F, RecordOf<MeshRecord> R>
void describe(F& f, R& r) {
  f.text("name", r.name);
  f.count("triangles", r.triangles);
  f.count("vertices", r.vertices);
  f.count("dropped_triangles", r.dropped);
  f.flag("is_closed", r.is_closed);
  f.text("meaning", r.meaning);
}

template <typename F, RecordOf<ToolRecord> R>
void describe(F& f, R& r) {
  f.optional_count("number", r.number);
  f.text("name", r.name);
  f.text("defined_in", r.defined_in);
  f.text("description", r.description);
  f.count("line", r.line);
  f.text("key", r.key);
  f.optional_text("identity", r.identity);
  f.words("bodies", r.bodies, body_words());
}

template <typename F, RecordOf<TotalsRecord> R>
void describe(F& f, R& r) {
  f.count("moves", r.moves);
  f.count("clean", r.clean);
  f.count("near", r.near);
  f.count("gouge", r.gouge);
  f.count("buried", r.buried);
  f.count("not_checked", r.not_checked);
  f.count("not_certified", r.not_certified);
  f.count("left_out_as_asked", r.left_out_as_asked);
  f.length("worst_depth", r.worst_depth_mm, Sign::non_negative);
  f.length("worst_overcut", r.worst_overcut_mm, Sign::non_negative);
  f.optional_length("worst_overcut_upper", r.worst_overcut_upper_mm, Sign::non_negative);
  f.optional_count("worst_move", r.worst_move);
  f.optional_length("largest_gap", r.largest_gap_mm, Sign::any);
  f.count("wide_gaps", r.wide_gaps);
  f.optional_length("largest_overcut_gap", r.largest_overcut_gap_mm, Sign::non_negative);
  f.count("wide_overcut_gaps", r.wide_overcut_gaps);
}

template <typename F, RecordOf<LawRecord> R>
void describe(F& f, R& r) {
  f.text("law", r.law);
  f.flag("is_rapid", r.is_rapid);
  f.count("gouges", r.gouges);
  f.count("open", r.open);
  f.optional_length("depth", r.depth_mm, Sign::non_negative);
  f.optional_count("line", r.line);
  f.text("missing", r.missing);
}

template <typename F, RecordOf<AnyTurnCounts> R>
void describe(F& f, R& r) {
  f.count("rapids", r.rapids);
  f.count("proved_rapids", r.proved_rapids);
  f.count("others", r.others);
  f.count("proved_others", r.proved_others);
}

template <typename F, RecordOf<StockContactRecord> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.number("clear_until", r.clear_until, Sign::non_negative);
  f.number("contact_at", r.contact_at, Sign::non_negative);
  f.optional_count("cut_move", r.cut_move);
  f.optional_count("cut_line", r.cut_line);
  f.optional_text("cut_file", r.cut_file);
  f.optional_length("missed_by", r.missed_by_mm, Sign::any);
}

template <typename F, RecordOf<StockLeftRecord> R>
void describe(F& f, R& r) {
  f.length("cell", r.cell_mm, Sign::non_negative);
  f.number("perhaps_mm3", r.perhaps_mm3, Sign::non_negative);
  f.number("surely_mm3", r.surely_mm3, Sign::non_negative);
  f.optional_length("apart", r.apart_mm, Sign::non_negative);
  f.count("sliver_cells", r.sliver_cells);
}

template <typename F, RecordOf<StockRecord> R>
void describe(F& f, R& r) {
  f.length("tolerance", r.tolerance_mm, Sign::non_negative);
  f.length("resolution", r.resolution_mm, Sign::non_negative);
  f.count("examined", r.examined);
  f.count("clear", r.clear);
  f.list("contacts", r.contacts);
  f.object_if_any("left", r.left);
}

template <typename F, RecordOf<ExcessPlaceRecord> R>
void describe(F& f, R& r) {
  f.optional_length("height", r.height_mm, Sign::non_negative);
  f.length("height_upper", r.height_upper_mm, Sign::non_negative);
  f.point("point", r.point_mm);
  f.direction("normal", r.normal);
  f.text("part", r.part);
  f.count("facet", r.facet);
  f.per_length("area", r.area_mm2, kArea);
  f.per_length("area_upper", r.area_upper_mm2, kArea);
  f.optional_count("unknown_move", r.unknown_move);
  f.optional_count("unknown_line", r.unknown_line);
  f.optional_text("unknown_file", r.unknown_file);
}

template <typename F, RecordOf<ExcessRecord> R>
void describe(F& f, R& r) {
  f.length("asked", r.asked_mm, Sign::non_negative);
  f.length("resolution", r.resolution_mm, Sign::non_negative);
  f.per_length("surface", r.surface_mm2, kArea);
  f.list("places", r.places);
}

template <typename F, RecordOf<ClosenessRecord> R>
void describe(F& f, R& r) {
  f.count("cuts", r.cuts, 1);
  f.count("positions", r.positions, 1);
  f.optional_length("nearest", r.nearest_mm, Sign::non_negative);
  f.optional_length("median", r.median_mm, Sign::non_negative);
}

template <typename F, RecordOf<NeedRecord> R>
void describe(F& f, R& r) {
  f.optional_length("needed", r.needed_mm, Sign::any);
  f.optional_count("move", r.move);
  f.optional_count("line", r.line);
  f.optional_word("body", r.body, body_words());
  f.optional_word("state", r.state, state_words());
}

template <typename F, RecordOf<OperationNeedRecord> R>
void describe(F& f, R& r) {
  f.text("operation", r.operation);
  describe(f, r.need);
}

template <typename F, RecordOf<ToolNeedRecord> R>
void describe(F& f, R& r) {
  f.text("tool", r.tool);
  f.length("now", r.now_mm, Sign::non_negative);
  describe(f, r.need);
  f.list("operations", r.operations);
}

template <typename F, RecordOf<StickoutRecord> R>
void describe(F& f, R& r) {
  f.length("step", r.step_mm, Sign::non_negative);
  f.length("most_longer", r.max_longer_mm, Sign::non_negative);
  f.list("tools", r.tools);
}

template <typename F, RecordOf<CureOptionsRecord> R>
void describe(F& f, R& r) {
  f.length("lift_step", r.lift_step_mm, Sign::non_negative);
  f.length("most_lift", r.max_lift_mm, Sign::non_negative);
  f.number("max_tilt_rad", r.max_tilt_rad, Sign::non_negative);
  f.length("blend", r.blend_mm, Sign::non_negative);
}

template <typename F, RecordOf<BaselineEntryRecord> R>
void describe(F& f, R& r) {
  f.text("finding", r.finding);
  f.text("by", r.by);
  f.text("date", r.date);
  f.text("reason", r.reason);
  f.word("use", r.use, use_words());
  f.text("why", r.why);
}

template <typename F, RecordOf<BaselineRecord> R>
void describe(F& f, R& r) {
  f.text("file", r.file);
  f.count("accepted_findings", r.accepted_findings);
  f.count("accepted_moves", r.accepted_moves);
  f.list("entries", r.entries);
}

template <typename F, RecordOf<AcceptanceRecord> R>
void describe(F& f, R& r) {
  f.flag("is_accepted", r.is_accepted);
  f.counts("entries", r.entries);
  f.text("why_not", r.why_not);
}

template <typename F, RecordOf<TiltCureRecord> R>
void describe(F& f, R& r) {
  f.optional_number("rad", r.tilt_rad, Sign::non_negative);
  f.optional_text("reason", r.reason);
}

template <typename F, RecordOf<LiftCureRecord> R>
void describe(F& f, R& r) {
  f.optional_length("length", r.lift_mm, Sign::non_negative);
  f.flag("is_least", r.is_least);
  f.length("not_free_below", r.not_free_below_mm, Sign::non_negative);
  f.count("move", r.move);
  f.count("line", r.line);
  f.word("body", r.body, body_words());
  f.word("state", r.state, state_words());
}

template <typename F, RecordOf<CuresRecord> R>
void describe(F& f, R& r) {
  f.object("tilt", r.tilt);
  f.object("lift", r.lift);
}

template <typename F, RecordOf<EventRecord> R>
void describe(F& f, R& r) {
  f.optional_count("number", r.number, 1);
  f.word("state", r.state, state_words());
  f.count("first_move", r.first_move);
  f.count("last_move", r.last_move);
  f.count("moves", r.moves, 1);
  f.count("worst_move", r.worst_move);
  f.count("line", r.line);
  f.text("tool", r.tool);
  f.optional_count("tool_index", r.tool_index);
  f.word("body", r.body, body_words());
  f.word("against", r.against, against_words());
  f.optional_text("obstacle", r.obstacle);
  f.optional_object("acceptance", r.acceptance);
  f.optional_object("cures", r.cures);
}

template <typename F, RecordOf<ReasonRecord> R>
void describe(F& f, R& r) {
  f.word("state", r.state, state_words());
  f.text("reason", r.reason);
  f.count("moves", r.moves, 1);
  f.count("first_move", r.first_move);
  f.count("first_line", r.first_line);
}

template <typename F, RecordOf<TurnRecord> R>
void describe(F& f, R& r) {
  f.number("first", r.first, Sign::non_negative);
  f.number("second", r.second, Sign::non_negative);
}

template <typename F, RecordOf<WitnessRecord> R>
void describe(F& f, R& r) {
  f.number("t", r.t, Sign::any);
  f.point("point", r.point_mm);
  f.direction("normal", r.normal);
  f.word("body", r.body, body_words());
  f.word("against", r.against, against_words());
  f.text("mesh", r.mesh);
  f.count("triangle", r.triangle);
  f.object_if_any("turn", r.turn);
}

template <typename F, RecordOf<FurtherRecord> R>
void describe(F& f, R& r) {
  f.word("body", r.body, body_words());
  f.word("against", r.against, against_words());
  f.optional_length("depth", r.depth_mm, Sign::non_negative);
  f.optional_length("depth_upper", r.depth_upper_mm, Sign::non_negative);
  f.optional_object("witness", r.witness);
}

template <typename F, RecordOf<MoveRecord> R>
void describe(F& f, R& r) {
  f.count("move", r.move);
  f.count("line", r.line);
  f.word("kind", r.kind, kind_words());
  f.text("tool", r.tool);
  f.text("operation", r.operation);
  f.text("statement", r.statement);
  f.text("motion", r.motion);
  f.word("state", r.state, state_words());
  f.optional_length("depth", r.depth_mm, Sign::non_negative);
  f.optional_length("depth_upper", r.depth_upper_mm, Sign::non_negative);
  f.optional_length("overcut", r.overcut_mm, Sign::non_negative);
  f.optional_length("overcut_upper", r.overcut_upper_mm, Sign::non_negative);
  f.optional_length("clearance", r.clearance_mm, Sign::non_negative);
  f.optional_object("witness", r.witness);
  f.list_if_any("further", r.further);
  f.text("reason", r.reason);
}

template <typename F, RecordOf<Diagnostic> R>
void describe(F& f, R& r) {
  f.word("severity", r.severity, severity_words());
  f.text("code", r.code);
  f.text("file", r.file);
  f.count("line", r.line);
  f.text("message", r.message);
}

template <typename F, RecordOf<RunRecord> R>
void describe(F& f, R& r) {
  f.count("first_move", r.first_move);
  f.text("operation", r.operation);
  f.text("tool", r.tool);
}

template <typename F, RecordOf<ProgramRecord> R>
void describe(F& f, R& r) {
  f.constant("name", kProgramName);
  f.text("version", r.version);
}

template <typename F, RecordOf<ResultRecord> R>
void describe(F& f, R& r) {
  f.constant("format", kResultFormat);
  f.constant("format_version", kResultVersion);
  f.object("program", r.program);
  f.word("verdict", r.verdict, verdict_words());
  f.count("exit_status", r.exit_status);
  f.text("promise", r.guarantee);
  f.list("assumptions", r.assumptions);
  f.unit("unit", r.unit);
  f.list("inputs", r.inputs);
  f.object("options", r.options);
  f.text("placement", r.placement);
  f.object("toolpath", r.toolpath);
  f.list("parts", r.parts);
  f.list("fixtures", r.fixtures);
  f.list("heads", r.heads);
  f.list("tools", r.tools);
  f.object("totals", r.totals);
  f.optional_object("closeness", r.closeness);
  f.object_if_any("any_turn", r.any_turn);
  f.object_if_any("stock", r.stock);
  f.object_if_any("excess", r.excess);
  f.list_if_any("laws", r.laws);
  f.optional_object("stickout", r.stickout);
  f.optional_object("cures", r.cures);
  f.optional_object("baseline", r.baseline);
  f.list("events", r.events);
  f.list("reasons", r.reasons);
  f.list("moves", r.moves);
  f.optional_object("correction", r.correction);
  f.list("notes", r.notes);
  f.list("runs", r.runs);
  f.texts("motions", r.motions);
}

}  // namespace gouge
