#include "postproc/report/write_report.h"

#include <array>
#include <nlohmann/json.hpp>

#include "lib/path/motion_key.h"
#include "postproc/report/assumption_report.h"
#include "postproc/report/correction_json.h"
#include "postproc/report/findings.h"
#include "postproc/report/identity_json.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
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
    out["assumptions"] = assumptions_json(*model_.result);
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
    out["closeness"] = closest_approach();
    out["stickout"] = stickout_json(model_);
    out["cures"] = cure_options();
    out["baseline"] = baseline_json(model_);
    out["events"] = events();
    out["reasons"] = reasons();
    out["moves"] = moves();
    out["correction"] = correction_json(model_);
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
            {"rapid", rapid_word(o.law.rapid())},
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
                     {"obstacle", obstacle(event)},
                     {"acceptance", acceptance_json(model_, k)},
                     {"cures", cures(k)}});
    }
    return all;
  }

  [[nodiscard]] Json obstacle(const Event& event) const {
    const std::optional<Witness>& witness = model_.result->verdicts[event.worst_move].witness;
    return witness ? Json(text(mesh_name(model_, *witness))) : Json(nullptr);
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
              {"is_least", lift.is_least()},
              {"not_free_below", length(lift.not_free_below_mm)},
              {"move", lift.move},
              {"line", std::size_t{model_.toolpath->moves[lift.move].line}},
              {"body", body_name(lift.body)},
              {"state", state_name(lift.state)}}}};
  }

  [[nodiscard]] Json cure_options() const {
    if (!model_.cure_options) return nullptr;
    return {{"lift_step", length(model_.cure_options->lift_step_mm)},
            {"most_lift", length(model_.cure_options->max_lift_mm)},
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

  [[nodiscard]] Json closest_approach() const {
    if (!model_.result->closest_approach) return nullptr;
    const ClosestApproach& c = *model_.result->closest_approach;
    const auto distance = [&](const std::optional<double>& mm) { return mm ? length(*mm) : Json(nullptr); };
    return {{"cuts", c.cuts},
            {"positions", c.positions},
            {"nearest", distance(c.nearest_mm)},
            {"median", distance(c.median_mm)}};
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
