#include "postproc/report/record_of.h"

#include <algorithm>
#include <cmath>

#include "lib/base/printable_text.h"
#include "lib/path/motion_key.h"
#include "postproc/record/words.h"
#include "postproc/record/write_record.h"
#include "postproc/report/findings.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/tightness.h"
#include "postproc/report/write_report.h"

namespace gouge {
namespace {

/// Returns the value, or none for a bound that was never reached.
std::optional<double> finite(double value_mm) {
  return std::isfinite(value_mm) ? std::optional(value_mm) : std::nullopt;
}

std::optional<std::size_t> index_below(std::size_t index, std::size_t end) {
  return index < end ? std::optional(index) : std::nullopt;
}

/// Fills the sections about moves and findings.
class RecordMaker {
 public:
  explicit RecordMaker(const ReportModel& model) : model_(model), path_(*model.toolpath), result_(*model.result) {}

  [[nodiscard]] ToolpathRecord toolpath() const {
    ToolpathRecord record{path_.file, path_.dialect, path_.is_unit_stated, path_.moves.size(), {}, 0, {}};
    for (const Move& move : path_.moves) {
      MovesByKind& kinds = record.moves_by_kind;
      switch (move.kind) {
        case MoveKind::feed:
          ++kinds.feed;
          break;
        case MoveKind::rapid:
          ++kinds.rapid;
          break;
        case MoveKind::arc:
          ++kinds.arc;
          break;
        case MoveKind::cycle:
          ++kinds.cycle;
          break;
      }
    }
    record.operations = path_.operations.size();
    // Two words that are not UTF-8 may become equal.
    for (const auto& [word, count] : path_.words_not_understood) record.words_not_understood[valid_utf8(word)] += count;
    return record;
  }

  [[nodiscard]] std::vector<ToolRecord> tools() const {
    std::vector<ToolRecord> all;
    for (std::size_t i = 0; i < path_.tools.size(); ++i) {
      const PathTool& tool = path_.tools[i];
      const ToolFacts facts = i < model_.tools.size() ? model_.tools[i] : ToolFacts{tool.name, "", "", true, "", {}};
      ToolRecord record;
      if (tool.number) record.number = static_cast<std::size_t>(*tool.number);
      record.name = facts.name;
      record.defined_in = facts.defined_in;
      record.description = facts.description;
      record.line = tool.line;
      record.key = tool_key(path_, i);
      if (!facts.identity.empty()) record.identity = facts.identity;
      record.bodies = facts.bodies;
      all.push_back(std::move(record));
    }
    return all;
  }

  [[nodiscard]] TotalsRecord totals() const {
    const StateCounts& n = result_.counts;
    TotalsRecord t;
    t.moves = result_.verdicts.size();
    t.clean = n.clean;
    t.near = n.near_miss;
    t.gouge = n.gouge;
    t.buried = n.buried;
    t.not_checked = n.not_checked;
    t.not_certified = n.not_certified;
    t.left_out_as_asked = n.skipped;
    t.worst_depth_mm = result_.worst_depth_mm;
    t.worst_overcut_mm = result_.worst_overcut_mm;
    t.worst_overcut_upper_mm = finite(worst_overcut_upper_mm(result_));
    t.worst_move = index_below(result_.worst_move, result_.verdicts.size());
    t.largest_gap_mm = finite(result_.largest_gap_mm);
    t.wide_gaps = depth_gaps(model_).wide;
    t.largest_overcut_gap_mm = finite(overcut_gaps(model_).widest_mm);
    t.wide_overcut_gaps = overcut_gaps(model_).wide;
    return t;
  }

  [[nodiscard]] std::optional<StickoutRecord> stickout() const {
    if (!model_.stickout_options) return std::nullopt;
    StickoutRecord record{model_.stickout_options->step_mm, model_.stickout_options->max_longer_mm, {}};
    for (const StickoutFacts& tool : model_.stickouts) {
      ToolNeedRecord one{tool_key(path_, tool.found.tool), tool.found.now_mm, need(tool.found.all), {}};
      for (const OperationStickout& of : tool.found.operations)
        one.operations.push_back({operation_name(path_, of.operation), need(of.need)});
      record.tools.push_back(std::move(one));
    }
    return record;
  }

  [[nodiscard]] std::optional<BaselineRecord> baseline() const {
    const BaselineFacts& facts = model_.baseline;
    if (!facts.is_given()) return std::nullopt;
    BaselineRecord record{facts.file, facts.accepted_findings(), facts.accepted_moves, {}};
    for (const BaselineEntry& entry : facts.entries) {
      record.entries.push_back({entry.finding, entry.by, entry.date, entry.reason,
                                use_words().at(static_cast<std::size_t>(entry.use)), entry.why});
    }
    return record;
  }

  [[nodiscard]] std::vector<EventRecord> events() const {
    std::vector<EventRecord> all;
    const std::vector<std::size_t> numbers = finding_numbers(result_);
    for (std::size_t k = 0; k < result_.events.size(); ++k) {
      const Event& event = result_.events[k];
      EventRecord record;
      if (numbers[k] > 0) record.number = numbers[k];
      record.state = event.state;
      record.first_move = event.first_move;
      record.last_move = event.last_move;
      record.moves = event.moves;
      record.worst_move = event.worst_move;
      record.line = path_.moves[event.worst_move].line;
      record.tool = tool_key(path_, event.tool);
      record.tool_index = index_below(event.tool, path_.tools.size());
      record.body = event.body;
      record.against = event.against;
      const Boxed<Witness>& witness = result_.verdicts[event.worst_move].witness;
      if (witness) record.obstacle = mesh_name(model_, *witness);
      record.acceptance = acceptance(k);
      record.cures = cures(k);
      all.push_back(std::move(record));
    }
    return all;
  }

  [[nodiscard]] std::optional<StockRecord> stock() const {
    if (!result_.stock) return std::nullopt;
    const StockFacts& facts = *result_.stock;
    StockRecord record{facts.tolerance_mm, facts.resolution_mm, facts.examined, facts.clear, {}};
    for (const StockContact& contact : facts.contacts) {
      StockContactRecord& one = record.contacts.emplace_back();
      one.move = contact.move;
      one.line = path_.moves[contact.move].line;
      one.clear_until = contact.clear_until;
      one.contact_at = contact.contact_at;
      if (contact.cut_move == kNone) continue;
      one.cut_move = contact.cut_move;
      one.cut_line = contact.cut_line;
      if (!contact.cut_file.empty()) one.cut_file = contact.cut_file;
      one.missed_by_mm = contact.missed_by_mm;
    }
    if (model_.stock_left) {
      const StockLeft& left = *model_.stock_left;
      record.left = StockLeftRecord{left.cell_mm, left.perhaps_mm3, left.surely_mm3, left.apart_mm, left.sliver_cells};
    }
    return record;
  }

  [[nodiscard]] std::optional<ExcessRecord> excess() const {
    if (!result_.excess) return std::nullopt;
    const ExcessFacts& facts = *result_.excess;
    ExcessRecord record{facts.asked_mm, facts.resolution_mm, facts.surface_mm2, {}};
    for (const ExcessPlaceFacts& place : facts.places) {
      ExcessPlaceRecord& one = record.places.emplace_back();
      if (place.is_proved()) one.height_mm = place.height_mm;
      one.height_upper_mm = place.height_upper_mm;
      one.point_mm = place.point;
      one.normal = place.normal;
      one.part = model_.parts[place.part].name;
      one.facet = place.facet;
      one.area_mm2 = place.area_mm2;
      one.area_upper_mm2 = place.area_upper_mm2;
      if (place.unknown_move == kNone) continue;
      one.unknown_move = place.unknown_move;
      one.unknown_line = place.unknown_line;
      if (!place.unknown_file.empty()) one.unknown_file = place.unknown_file;
    }
    return record;
  }

  [[nodiscard]] std::vector<ReasonRecord> reasons() const {
    std::vector<ReasonRecord> all;
    for (const ReasonGroup& group : group_reasons(result_)) {
      all.push_back({group.state, group.reason, group.moves, group.first_move, path_.moves[group.first_move].line});
    }
    return all;
  }

  [[nodiscard]] std::vector<MoveRecord> moves() const {
    std::vector<MoveRecord> all;
    for (std::size_t i = 0; i < result_.verdicts.size(); ++i) {
      if (result_.verdicts[i].state != MoveState::clean) all.push_back(move(i));
    }
    return all;
  }

  [[nodiscard]] std::vector<RunRecord> runs() const {
    std::vector<RunRecord> all;
    for (std::size_t k = 0; k < path_.moves.size(); ++k) {
      const Move& move = path_.moves[k];
      if (k > 0 && path_.moves[k - 1].operation == move.operation && path_.moves[k - 1].tool == move.tool) continue;
      all.push_back({k, operation_name(path_, move.operation), tool_key(path_, move.tool)});
    }
    return all;
  }

  [[nodiscard]] std::vector<std::string> motions() const {
    std::vector<std::string> texts;
    for (std::size_t first = 0; first < path_.moves.size(); first += kMotionsOfText) {
      std::string& text = texts.emplace_back();
      const std::size_t end = std::min(first + kMotionsOfText, path_.moves.size());
      for (std::size_t move = first; move < end; ++move) text.append(motion(move), 0, kListedMotionDigits);
    }
    return texts;
  }

 private:
  [[nodiscard]] NeedRecord need(const StickoutNeed& need) const {
    NeedRecord record;
    record.needed_mm = need.stickout_mm;
    if (need.move == kNone) return record;
    record.move = need.move;
    record.line = path_.moves[need.move].line;
    record.body = need.body;
    record.state = need.state;
    return record;
  }

  [[nodiscard]] std::optional<AcceptanceRecord> acceptance(std::size_t event) const {
    if (event >= model_.baseline.events.size()) return std::nullopt;
    const EventAcceptance& acceptance = model_.baseline.events[event];
    if (acceptance.entries.empty()) return std::nullopt;
    return AcceptanceRecord{acceptance.is_accepted, acceptance.entries, acceptance.why_not};
  }

  [[nodiscard]] std::optional<CuresRecord> cures(std::size_t event) const {
    const FindingCures* const found = cures_of(model_, event);
    if (found == nullptr) return std::nullopt;
    const LiftCure& lift = found->lift;
    CuresRecord record;
    record.tilt.tilt_rad = found->tilt.tilt_rad;
    if (!found->tilt.tilt_rad) record.tilt.reason = found->tilt.reason;
    record.lift = {lift.lift_mm, lift.is_least(), lift.not_free_below_mm, lift.move, path_.moves[lift.move].line,
                   lift.body,    lift.state};
    return record;
  }

  [[nodiscard]] std::string motion(std::size_t move) const {
    return motion_key(path_, move, model_.options.law.is_by_axes(path_.moves[move]));
  }

  /// Returns the statement of a move without its line end, cut after 2000 bytes; empty if it is no text.
  [[nodiscard]] std::string statement(const Move& move) const {
    constexpr std::size_t kMaxBytes = 2000;
    std::string_view text = statement_text(path_, move).substr(0, kMaxBytes);
    if (!is_text(text)) return {};
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    return std::string(text);
  }

  [[nodiscard]] WitnessRecord witness(const Witness& w) const {
    WitnessRecord record{w.t, w.point, w.normal, w.body, w.against, mesh_name(model_, w), w.triangle, {}};
    if (w.turn) record.turn = {(*w.turn)[0], (*w.turn)[1]};
    return record;
  }

  [[nodiscard]] FurtherRecord further(const FurtherContact& contact) const {
    FurtherRecord record{contact.body, contact.against, {}, finite(contact.depth_upper_mm), {}};
    if (!contact.witness) return record;
    record.depth_mm = contact.depth_mm;
    record.witness = witness(*contact.witness);
    return record;
  }

  [[nodiscard]] MoveRecord move(std::size_t i) const {
    const MoveVerdict& verdict = result_.verdicts[i];
    const Move& move = path_.moves[i];
    MoveRecord record;
    record.move = i;
    record.line = move.line;
    record.kind = move.kind;
    record.tool = tool_key(path_, move.tool);
    record.operation = operation_name(path_, move.operation);
    record.statement = statement(move);
    record.motion = motion(i);
    record.state = verdict.state;
    if (verdict.state != MoveState::buried && verdict.state != MoveState::not_checked) {
      record.depth_mm = finite(verdict.depth_mm);
      record.depth_upper_mm = finite(verdict.depth_upper_mm);
    }
    if (verdict.overcut) {
      record.overcut_mm = finite(verdict.overcut->lower_mm);
      record.overcut_upper_mm = finite(verdict.overcut->upper_mm);
    }
    record.clearance_mm = verdict.clearance_mm.optional();
    if (verdict.witness) record.witness = witness(*verdict.witness);
    for (const FurtherContact& contact : result_.further_of(i)) record.further.push_back(further(contact));
    record.reason = reason_text(verdict.reason);
    return record;
  }

  const ReportModel& model_;
  const Toolpath& path_;
  const CheckResult& result_;
};

OptionsRecord options_of(const ReportModel& model) {
  const CheckOptions& o = model.options;
  OptionsRecord record{o.tolerance_mm,        o.resolution_mm, o.stock_to_leave_mm,       o.shank_clearance_mm,
                       o.holder_clearance_mm, o.near_miss_mm,  rapid_word(o.law.rapid()), {}};
  for (const OptionText& option : model.more_options) {
    const auto found = std::ranges::find(record.more, option.name, [](const auto& one) { return one.first; });
    if (found == record.more.end())
      record.more.emplace_back(option.name, std::vector{option.value});
    else
      found->second.push_back(option.value);
  }
  return record;
}

std::vector<MeshRecord> meshes_of(const std::vector<MeshFacts>& meshes) {
  std::vector<MeshRecord> all;
  for (const MeshFacts& mesh : meshes)
    all.push_back({mesh.name, mesh.triangles, mesh.vertices, mesh.dropped, mesh.is_closed, mesh.meaning});
  return all;
}

}  // namespace

ResultRecord record_of(const ReportModel& model) {
  const RecordMaker maker(model);
  const OverallVerdict verdict = overall_verdict(model);
  ResultRecord record;
  record.program.version = kProgramVersion;
  record.verdict = verdict_name(verdict);
  record.exit_status = static_cast<int>(exit_status(verdict));
  record.guarantee = guarantee_text(model);
  record.assumptions = model.result->assumptions;
  record.unit = model.toolpath->unit;
  record.inputs = model.inputs;
  record.options = options_of(model);
  record.placement = model.placement;
  record.toolpath = maker.toolpath();
  record.parts = meshes_of(model.parts);
  record.fixtures = meshes_of(model.fixtures);
  record.heads = meshes_of(model.heads);
  record.tools = maker.tools();
  record.totals = maker.totals();
  if (const std::optional<ClosestApproach>& closest = model.result->closest_approach)
    record.closeness = {closest->cuts, closest->positions, closest->nearest_mm, closest->median_mm};
  record.any_turn = model.result->any_turn;
  record.stock = maker.stock();
  record.excess = maker.excess();
  record.laws = model.laws;
  record.stickout = maker.stickout();
  if (const std::optional<CureOptions>& o = model.cure_options)
    record.cures = {o->lift_step_mm, o->max_lift_mm, o->tilt.max_tilt_rad, o->tilt.blend_mm};
  record.baseline = maker.baseline();
  record.events = maker.events();
  record.reasons = maker.reasons();
  record.moves = maker.moves();
  record.correction = correction_record_of(model);
  record.notes = model.notes;
  record.runs = maker.runs();
  record.motions = maker.motions();
  return record;
}

std::string write_json(const ReportModel& model) { return write_record(record_of(model)); }

}  // namespace gouge
