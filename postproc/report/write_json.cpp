#include "postproc/report/write_report.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/path/motion_key.h"
#include "postproc/report/cure_text.h"
#include "postproc/report/findings.h"
#include "postproc/report/identity_json.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_json.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

// Text of files may hold anything; JSON may not.
Json text(std::string_view value) { return valid_utf8(value); }

class JsonReport {
 public:
  explicit JsonReport(const ReportModel& model) : model_(model), unit_(model.toolpath->unit) {}

  [[nodiscard]] Json build() const {
    const OverallVerdict verdict = overall_verdict(model_);
    Json out;
    out["format"] = "gougecheck-report";
    out["format_version"] = 1;
    out["program"] = {{"name", kProgramName}, {"version", kProgramVersion}};
    out["verdict"] = verdict_name(verdict);
    out["exit_status"] = static_cast<int>(exit_status(verdict));
    out["promise"] = guarantee_text(model_);
    out["unit"] = unit_name(unit_);
    out["inputs"] = inputs();
    out["options"] = options();
    out["placement"] = text(model_.placement);
    out["toolpath"] = toolpath();
    out["parts"] = meshes(model_.parts);
    out["fixtures"] = meshes(model_.fixtures);
    out["heads"] = meshes(model_.heads);
    out["tools"] = tools();
    out["totals"] = totals();
    out["closeness"] = closeness();
    out["stickout"] = stickout_json(model_);
    out["cures"] = cure_options();
    out["baseline"] = baseline_json(model_);
    out["events"] = events();
    out["reasons"] = reasons();
    out["moves"] = moves();
    out["correction"] = model_.has_correction ? correction() : Json(nullptr);
    out["notes"] = notes();
    out["runs"] = runs_json(*model_.toolpath);
    out["motions"] = motions_json(*model_.toolpath);
    return out;
  }

 private:
  [[nodiscard]] Json length(double length_mm) const { return length_json(length_mm, unit_); }
  [[nodiscard]] Json lengths(const Vec3& v) const { return Json::array({length(v.x()), length(v.y()), length(v.z())}); }

  [[nodiscard]] Json inputs() const {
    Json all = Json::array();
    for (const InputFile& input : model_.inputs) {
      all.push_back({{"role", text(input.role)},
                     {"name", text(input.name)},
                     {"bytes", input.bytes},
                     {"checksum", text(input.checksum)}});
    }
    return all;
  }

  [[nodiscard]] Json options() const {
    static constexpr std::array<const char*, 3> kRapid{"straight", "dogleg", "skip"};
    const CheckOptions& o = model_.options;
    Json more = Json::object();
    for (const OptionText& option : model_.more_options) {
      Json& value = more[valid_utf8(option.name)];
      if (value.is_string()) value = Json::array({value});
      if (value.is_array())
        value.push_back(text(option.value));
      else
        value = text(option.value);
    }
    return {{"tolerance", length(o.tolerance_mm)},
            {"resolution", length(o.resolution_mm)},
            {"stock_to_leave", length(o.stock_to_leave_mm)},
            {"shank_clearance", length(o.shank_clearance_mm)},
            {"holder_clearance", length(o.holder_clearance_mm)},
            {"near_miss", length(o.near_miss_mm)},
            {"rapid", kRapid.at(static_cast<std::size_t>(o.rapid))},
            {"more", more}};
  }

  [[nodiscard]] Json toolpath() const {
    const Toolpath& path = *model_.toolpath;
    Json kinds = {{"feed", 0}, {"rapid", 0}, {"arc", 0}, {"cycle", 0}};
    for (const Move& move : path.moves)
      kinds[kind_name(move.kind)] = kinds[kind_name(move.kind)].get<std::size_t>() + 1;
    Json words = Json::object();
    for (const auto& [word, count] : path.words_not_understood) words[valid_utf8(word)] = count;
    return {{"file", text(path.file)},      {"dialect", text(path.dialect)}, {"unit_is_stated", path.is_unit_stated},
            {"moves", path.moves.size()},   {"moves_by_kind", kinds},        {"operations", path.operations.size()},
            {"words_not_understood", words}};
  }

  [[nodiscard]] static Json meshes(const std::vector<MeshFacts>& meshes) {
    Json all = Json::array();
    for (const MeshFacts& mesh : meshes) {
      all.push_back({{"name", text(mesh.name)},
                     {"triangles", mesh.triangles},
                     {"vertices", mesh.vertices},
                     {"dropped_triangles", mesh.dropped},
                     {"is_closed", mesh.is_closed},
                     {"meaning", text(mesh.meaning)}});
    }
    return all;
  }

  [[nodiscard]] Json tools() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < model_.toolpath->tools.size(); ++i) {
      const PathTool& tool = model_.toolpath->tools[i];
      const ToolFacts facts = i < model_.tools.size() ? model_.tools[i] : ToolFacts{tool.name, "", "", true, "", {}};
      Json bodies = Json::array();
      for (const Body body : facts.bodies) bodies.push_back(body_name(body));
      all.push_back({{"number", tool.number ? Json(*tool.number) : Json(nullptr)},
                     {"name", text(facts.name)},
                     {"defined_in", text(facts.defined_in)},
                     {"description", text(facts.description)},
                     {"line", tool.line},
                     {"key", text(tool_key(*model_.toolpath, i))},
                     {"identity", facts.identity.empty() ? Json(nullptr) : Json(facts.identity)},
                     {"bodies", std::move(bodies)}});
    }
    return all;
  }

  [[nodiscard]] Json totals() const {
    const CheckResult& result = *model_.result;
    const StateCounts& n = result.counts;
    const bool has_worst = result.worst_move < result.verdicts.size();
    return {{"moves", result.verdicts.size()},
            {"clean", n.clean},
            {"near", n.near_miss},
            {"gouge", n.gouge},
            {"buried", n.buried},
            {"not_checked", n.not_checked},
            {"not_certified", n.not_certified},
            {"left_out_as_asked", n.skipped},
            {"worst_depth", length(result.worst_depth_mm)},
            {"worst_overcut", length(result.worst_overcut_mm)},
            {"worst_overcut_upper", length(worst_overcut_upper_mm(result))},
            {"worst_move", has_worst ? Json(result.worst_move) : Json(nullptr)},
            {"largest_gap", length(result.largest_gap_mm)},
            {"wide_gaps", depth_gaps(model_).wide},
            {"largest_overcut_gap", length(overcut_gaps(model_).widest_mm)},
            {"wide_overcut_gaps", overcut_gaps(model_).wide}};
  }

  [[nodiscard]] Json witness(const Witness& w) const {
    return {{"t", w.t},
            {"point", lengths(w.point)},
            {"normal", Json::array({w.normal.x(), w.normal.y(), w.normal.z()})},
            {"body", body_name(w.body)},
            {"against", against_name(w.against)},
            {"mesh", text(mesh_name(model_, w))},
            {"triangle", w.triangle}};
  }

  [[nodiscard]] Json events() const {
    Json all = Json::array();
    const std::vector<std::size_t> numbers = finding_numbers(*model_.result);
    for (std::size_t k = 0; k < model_.result->events.size(); ++k) {
      const Event& event = model_.result->events[k];
      all.push_back({{"number", numbers[k] > 0 ? Json(numbers[k]) : Json(nullptr)},
                     {"state", state_name(event.state)},
                     {"first_move", event.first_move},
                     {"last_move", event.last_move},
                     {"moves", event.moves},
                     {"worst_move", event.worst_move},
                     {"line", std::size_t{model_.toolpath->moves[event.worst_move].line}},
                     {"tool", text(tool_key(*model_.toolpath, event.tool))},
                     {"tool_index", event.tool < model_.toolpath->tools.size() ? Json(event.tool) : Json(nullptr)},
                     {"body", body_name(event.body)},
                     {"against", against_name(event.against)},
                     {"acceptance", acceptance_json(model_, k)},
                     {"cures", cures(k)}});
    }
    return all;
  }

  [[nodiscard]] Json cures(std::size_t event) const {
    const FindingCures* const found = cures_of(model_, event);
    if (found == nullptr) return nullptr;
    const LiftCure& lift = found->lift;
    return {{"tilt",
             {{"rad", found->tilt.tilt_rad ? Json(*found->tilt.tilt_rad) : Json(nullptr)},
              {"reason", found->tilt.tilt_rad ? Json(nullptr) : text(found->tilt.reason)}}},
            {"lift",
             {{"length", lift.lift_mm ? length(*lift.lift_mm) : Json(nullptr)},
              {"move", lift.move},
              {"line", std::size_t{model_.toolpath->moves[lift.move].line}},
              {"body", body_name(lift.body)},
              {"state", state_name(lift.state)}}}};
  }

  [[nodiscard]] Json cure_options() const {
    if (!model_.cure_options) return nullptr;
    return {{"lift_step", length(model_.cure_options->lift_step_mm)},
            {"most_lift", length(model_.cure_options->most_lift_mm)},
            {"max_tilt_rad", model_.cure_options->tilt.max_tilt_rad},
            {"blend", length(model_.cure_options->tilt.blend_mm)}};
  }

  [[nodiscard]] Json reasons() const {
    Json all = Json::array();
    for (const ReasonGroup& group : group_reasons(*model_.result)) {
      all.push_back({{"state", state_name(group.state)},
                     {"reason", text(group.reason)},
                     {"moves", group.moves},
                     {"first_move", group.first_move},
                     {"first_line", std::size_t{model_.toolpath->moves[group.first_move].line}}});
    }
    return all;
  }

  [[nodiscard]] Json moves() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < model_.result->verdicts.size(); ++i) {
      const MoveVerdict& verdict = model_.result->verdicts[i];
      if (verdict.state == MoveState::clean) continue;
      const bool has_depth = verdict.state != MoveState::buried && verdict.state != MoveState::not_checked;
      const Move& move = model_.toolpath->moves[i];
      all.push_back({{"move", i},
                     {"line", std::size_t{move.line}},
                     {"kind", kind_name(move.kind)},
                     {"tool", text(tool_key(*model_.toolpath, move.tool))},
                     {"operation", text(operation_name(*model_.toolpath, move.operation))},
                     {"statement", statement_json(*model_.toolpath, move)},
                     {"motion", motion_key(*model_.toolpath, i)},
                     {"state", state_name(verdict.state)},
                     {"depth", has_depth ? length(verdict.depth_mm) : Json(nullptr)},
                     {"depth_upper", has_depth ? length(verdict.depth_upper_mm) : Json(nullptr)},
                     {"overcut", verdict.overcut_mm ? length(*verdict.overcut_mm) : Json(nullptr)},
                     {"overcut_upper", verdict.overcut_mm ? length(verdict.overcut_upper_mm) : Json(nullptr)},
                     {"clearance", verdict.clearance_mm ? length(*verdict.clearance_mm) : Json(nullptr)},
                     {"witness", verdict.witness ? witness(*verdict.witness) : Json(nullptr)},
                     {"reason", text(reason_text(verdict.reason))}});
    }
    return all;
  }

  [[nodiscard]] Json closeness() const {
    if (!model_.closeness) return nullptr;
    const Closeness& c = *model_.closeness;
    const auto distance = [&](const std::optional<double>& mm) { return mm ? length(*mm) : Json(nullptr); };
    return {{"cuts", c.cuts},
            {"positions", c.positions},
            {"nearest", distance(c.nearest_mm)},
            {"median", distance(c.median_mm)}};
  }

  // Per length to the power given, in the toolpath's unit.
  [[nodiscard]] Json per_length(double value, int power) const { return value * std::pow(mm_per(unit_), power) + 0.0; }

  // A feed of next to nothing takes no time that a number says.
  [[nodiscard]] static Json seconds(const std::optional<double>& time) {
    return time && std::isfinite(*time) ? Json(*time) : Json(nullptr);
  }

  [[nodiscard]] static Json move_of(const LargestOfMoves& largest) {
    return largest.move == kNone ? Json(nullptr) : Json(largest.move);
  }
  [[nodiscard]] static Json line_of(const LargestOfMoves& largest, const Toolpath& path) {
    return largest.move < path.moves.size() ? Json(std::size_t{path.moves[largest.move].line}) : Json(nullptr);
  }

  [[nodiscard]] Json axis_quality(const AxisQuality& q, const Toolpath& path) const {
    const auto turn = [&](const LargestOfMoves& largest, int power) -> Json {
      return {{"rad", per_length(largest.value, power)}, {"move", move_of(largest)}, {"line", line_of(largest, path)}};
    };
    return {{"largest_turn_per_length", turn(q.turn_rad_per_mm, 1)},
            {"largest_turn", turn(q.turn_rad, 0)},
            {"turns_on_the_spot", q.turns_on_the_spot},
            {"largest_turn_on_the_spot", turn(q.turn_on_the_spot_rad, 0)},
            {"bending", per_length(q.bending, 3)},
            {"feed_seconds", seconds(q.feed_seconds)},
            {"feed_seconds_with_max_rotary_speed", seconds(q.limited_feed_seconds)},
            {"moves_without_feed", q.moves_without_feed}};
  }

  [[nodiscard]] Json quality(const CorrectionFacts& c) const {
    if (!c.axes) return nullptr;
    const AxisTilts& tilts = c.axes->tilts;
    const std::size_t inserted = inserted_positions(c);
    const Toolpath& before = c.toolpath_before ? *c.toolpath_before : *model_.toolpath;
    return {{"before", axis_quality(c.axes->before, before)},
            {"after", axis_quality(c.axes->after, *model_.toolpath)},
            {"max_rotary_speed_deg_per_min",
             c.axes->max_rotary_deg_per_min ? Json(*c.axes->max_rotary_deg_per_min) : Json(nullptr)},
            {"largest_tilt",
             {{"rad", tilts.tilt_rad.value},
              {"move", move_of(tilts.tilt_rad)},
              {"line", line_of(tilts.tilt_rad, *model_.toolpath)}}},
            {"positions", {{"moved", moved_positions(c)}, {"inserted", inserted}, {"tilted", tilts.positions}}},
            {"tilted_runs", tilts.runs.size() + tilts.runs_left_out}};
  }

  // What the change cures: of a buried move no surface is named.
  [[nodiscard]] Json cause(const CorrectionFacts& c, const CorrectedRecord& r) const {
    if (!r.cause || c.result_before == nullptr) return nullptr;
    const MoveVerdict& verdict = c.result_before->verdicts[*r.cause];
    const Toolpath& before = c.toolpath_before ? *c.toolpath_before : *model_.toolpath;
    const bool has_witness = verdict.witness.has_value();
    return {{"move", *r.cause},
            {"line", std::size_t{before.moves[*r.cause].line}},
            {"state", state_name(verdict.state)},
            {"depth", length(verdict.depth_mm)},
            {"body", body_name(has_witness ? verdict.witness->body : verdict.reason.body)},
            {"against", has_witness ? Json(against_name(verdict.witness->against)) : Json(nullptr)},
            {"mesh", has_witness ? text(mesh_name(model_, *verdict.witness)) : Json(nullptr)}};
  }

  [[nodiscard]] Json uncut(const CorrectionFacts& c) const {
    Json stretches = Json::array();
    for (const UncutRecord& r : c.uncut) {
      stretches.push_back({{"first_move", r.first_move},
                           {"last_move", r.last_move},
                           {"first_line", r.first_line},
                           {"last_line", r.last_line},
                           {"positions", r.positions},
                           {"length", length(r.length_mm)}});
    }
    const UncutTotal total = uncut_total(c);
    return {{"positions", total.positions}, {"length", length(total.length_mm)}, {"stretches", stretches}};
  }

  [[nodiscard]] Json correction() const {
    const CorrectionFacts& c = model_.correction;
    Json changes = Json::array();
    for (const CorrectedRecord& r : c.changes) {
      changes.push_back({{"move", r.move},
                         {"line", r.line},
                         {"strategy", text(r.strategy)},
                         {"is_inserted", r.is_inserted},
                         {"shift", lengths(r.shift_mm)},
                         {"shift_length", length(r.shift_length_mm)},
                         {"tilt_rad", r.tilt_rad},
                         {"depth_before", length(r.depth_before_mm)},
                         {"depth_after", length(r.depth_after_mm)},
                         {"iterations", r.iterations},
                         {"cause", cause(c, r)},
                         {"old_record", r.old_record ? text(*r.old_record) : Json(nullptr)},
                         {"new_record", r.new_record ? text(*r.new_record) : Json(nullptr)}});
    }
    Json left = Json::array();
    for (const UncorrectedRecord& r : c.uncorrected) {
      left.push_back({{"move", r.move},
                      {"line", r.line},
                      {"depth", length(r.depth_mm)},
                      {"reason", text(r.reason)},
                      {"is_changed", r.is_changed}});
    }
    Json written = Json::array();
    for (const WrittenRecord& r : c.written) written.push_back({{"kind", r.kind}, {"line", r.line}});
    return {{"output_file", text(c.output_file)},
            {"strategy", text(c.strategy)},
            {"max_shift", c.max_shift_mm > 0 ? length(c.max_shift_mm) : Json(nullptr)},
            {"max_side_shift", c.max_side_shift_mm ? length(*c.max_side_shift_mm) : Json(nullptr)},
            {"rapid_clearance", length(c.rapid_clearance_mm)},
            {"quality", quality(c)},
            {"straightened", {{"curves", c.curves}, {"straight_moves", c.straight_moves}}},
            {"uncut", uncut(c)},
            {"changes", changes},
            {"uncorrected", left},
            {"written", written}};
  }

  [[nodiscard]] Json notes() const {
    Json all = Json::array();
    for (const Diagnostic& note : model_.notes) {
      const char* severity = note.severity == Severity::error     ? "error"
                             : note.severity == Severity::warning ? "warning"
                                                                  : "note";
      all.push_back({{"severity", severity},
                     {"code", text(note.code)},
                     {"file", text(note.file)},
                     {"line", note.line},
                     {"message", text(note.message)}});
    }
    return all;
  }

  const ReportModel& model_;
  LengthUnit unit_;
};

}  // namespace

std::string write_json(const ReportModel& model) { return with_digest(JsonReport(model).build().dump(1) + "\n"); }

}  // namespace gouge
