#include "postproc/report/report_text.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/path/run_kind.h"
#include "postproc/report/further_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

// Returns the power of ten of the first digit. It is found by comparison, without the rounding of a logarithm.
int first_digit(double value) {
  int power = 0;
  for (double x = std::abs(value); x >= 10 && power < 300; x /= 10) ++power;
  for (double x = std::abs(value); x < 1 && x > 0 && power > -300; x *= 10) --power;
  return power;
}

constexpr int kMaxDecimals = 12;

// Returns the number in a length with its unit.
double number_in(const std::string& text) { return parse_number(text.substr(0, text.find(' '))).value_or(0); }

int decimals_of(const std::string& text) {
  const std::size_t point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.find(' ') - point) - 1;
}

std::string tool_phrase(const ReportModel& model, const Event& event) {
  return std::string(body_name(event.body)) + " " + tool_label(*model.toolpath, event.tool);
}

const MeshFacts* facts_of(const ReportModel& model, const Witness& witness) {
  if (witness.against == Against::stock) return nullptr;
  const std::vector<MeshFacts>& meshes = rule_of(witness.against).is_workpiece ? model.parts : model.fixtures;
  return witness.mesh < meshes.size() ? &meshes[witness.mesh] : nullptr;
}

// Returns the words for a clearance. A depth against a mesh with a clearance is measured from the clearance.
std::string clearance_phrase(const ReportModel& model, const Witness& witness) {
  const double clearance_mm = mesh_clearance_mm(model, witness);
  if (!(clearance_mm > 0)) return {};
  return " and its clearance of " + depth_text(clearance_mm, model.toolpath->unit, model.options);
}

}  // namespace

std::string counterpart_text(const ReportModel& model, const Witness& witness) {
  const std::string name = mesh_name(model, witness);
  const bool is_plain = witness.against == Against::part && model.parts.size() < 2;
  if (is_plain || witness.against == Against::stock) return {};
  return " against " + std::string(against_name(witness.against)) + (name.empty() ? "" : " " + name) +
         clearance_phrase(model, witness);
}

std::string grouped_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t k = 3; k < text.size(); k += 4) text.insert(text.size() - k, ",");
  return text;
}

std::string left_out_text(std::size_t rapids) { return count_text(rapids, "rapid") + " left out as asked"; }

std::string depth_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any depth";
  const int usual = unit == LengthUnit::inch ? 4 : 3;
  // A length below a millionth of a millimetre is rounding. Its digits would look like a finding.
  const bool is_reported = length_mm >= Tolerance::kWitness_mm;
  const int decimals = is_reported ? std::clamp(1 - first_digit(value), usual, kMaxDecimals) : usual;
  return display_text(value, decimals, Zeros::kept) + " " + unit_name(unit);
}

std::string depth_text(double length_mm, LengthUnit unit, const CheckOptions& limits) {
  const std::string usual = depth_text(length_mm, unit);
  if (!std::isfinite(length_mm) || length_mm < Tolerance::kWitness_mm) return usual;
  const double value = length_mm / mm_per(unit);
  std::string text = usual;
  for (int decimals = decimals_of(usual);;
       ++decimals, text = display_text(value, decimals, Zeros::kept) + " " + unit_name(unit)) {
    const double read = number_in(text);
    const auto is_distinguished = [&](double limit_mm) {
      if (limit_mm <= 0) return true;
      const double limit = number_in(length_text(limit_mm, unit));
      if (length_mm < limit_mm) return read < limit;
      return length_mm > limit_mm ? read > limit : true;
    };
    const bool is_clear = is_distinguished(limits.tolerance_mm) && is_distinguished(limits.near_miss_mm) &&
                          is_distinguished(limits.tolerance_mm + limits.resolution_mm);
    if (is_clear) return text;
    if (decimals >= kMaxDecimals) return usual;
  }
}

std::string length_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any length";
  const int power = first_digit(value);
  const int digits = power < 0 ? 4 : 6;
  return display_text(value, std::clamp(digits - 1 - power, 0, 15)) + " " + unit_name(unit);
}

std::string short_length_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any length";
  const int decimals = std::clamp(2 - first_digit(value), 6, 15);
  return display_text(value, decimals) + " " + unit_name(unit);
}

std::string point_text(const Vec3& point_mm, LengthUnit unit) {
  const int decimals = unit == LengthUnit::inch ? 4 : 3;
  std::string text = "(";
  for (int k = 0; k < 3; ++k) {
    text += (k > 0 ? ", " : "") + display_text(point_mm[k] / mm_per(unit), decimals);
  }
  return text + ")";
}

const char* unit_words(LengthUnit unit) { return unit == LengthUnit::inch ? "inches" : "mm"; }

std::string instant_text(double t) { return display_text(t, 4); }

std::size_t inserted_positions(const CorrectionFacts& correction) {
  return static_cast<std::size_t>(
      std::ranges::count_if(correction.changes, [](const CorrectedRecord& change) { return change.is_inserted; }));
}

std::size_t moved_positions(const CorrectionFacts& correction) {
  return static_cast<std::size_t>(std::ranges::count_if(
      correction.changes, [](const CorrectedRecord& change) { return !change.is_inserted && !change.is_uncut(); }));
}

std::string moved_cuts_text(const CorrectionFacts& correction, LengthUnit unit) {
  if (correction.toolpath_before == nullptr) return {};
  double max_mm = 0;
  for (const CorrectedRecord& change : correction.changes) {
    const bool is_cut = !runs_rapid(correction.toolpath_before->moves[change.move]);
    if (is_cut && !change.is_uncut() && change.strategy != "tilt") max_mm = std::max(max_mm, change.shift_length_mm);
  }
  if (!(max_mm > 0)) return {};
  return "cuts were moved by up to " + depth_text(max_mm, unit) + ": less is cut there than was programmed";
}

UncutTotal uncut_total(const CorrectionFacts& correction) {
  UncutTotal total;
  for (const Uncut& stretch : correction.uncut) {
    if (stretch.kind == Uncut::Kind::hole) {
      ++total.holes;
      total.max_of_hole_mm = std::max(total.max_of_hole_mm, stretch.length_mm);
      continue;
    }
    ++total.stretches;
    total.positions += stretch.positions;
    total.length_mm += stretch.length_mm;
  }
  return total;
}

std::string uncut_text(const CorrectionFacts& correction, LengthUnit unit) {
  const UncutTotal total = uncut_total(correction);
  std::string text;
  if (total.stretches > 0) {
    text = count_text(total.positions, "position") + " and " + length_text(total.length_mm, unit) + " left uncut in " +
           count_text(total.stretches, "stretch", "stretches");
  }
  if (total.holes > 0) {
    text += (text.empty() ? "" : ", ") + count_text(total.holes, "hole") + " left uncut by up to " +
            depth_text(total.max_of_hole_mm, unit);
  }
  return text;
}

std::string thickness_text(const LeftStock& left, LengthUnit unit) {
  const std::string thickness = depth_text(left.thickness_mm, unit);
  return !left.is_proved ? "perhaps more than " + thickness : left.is_more ? thickness + " or more" : thickness;
}

std::string stock_text(const CorrectionFacts& correction, LengthUnit unit) {
  if (correction.stock.empty()) return {};
  const std::size_t stretches = correction.stock.size();
  const StockStretch& worst = *std::ranges::max_element(
      correction.stock, {}, [](const StockStretch& stretch) { return stretch.most.thickness_mm; });
  const LeftStock& most = worst.most;
  return (most.is_more || !most.is_proved ? "" : "up to ") + thickness_text(most, unit) +
         (most.is_proved ? " of what was finished left in " : " of what was finished may be left in ") +
         std::to_string(stretches) + (stretches == 1 ? " stretch" : " stretches") + ", " +
         (stretches == 1 ? "at " : "most at ") + point_text(most.point, unit) + ", lines " +
         std::to_string(worst.first_line) + "-" + std::to_string(worst.last_line);
}

std::string kept_text(double keeps_mm, LengthUnit unit) {
  return keeps_mm < 0 ? "may touch by up to " + depth_text(-keeps_mm, unit) : depth_text(keeps_mm, unit);
}

std::string low_rapids_text(const CorrectionFacts& correction, LengthUnit unit) {
  if (correction.low_rapids.empty()) return {};
  const LowRapid& least = *std::ranges::min_element(correction.low_rapids, {}, &LowRapid::keeps_mm);
  const bool is_one = correction.low_rapids.size() == 1, may_touch = least.keeps_mm < 0;
  return count_text(correction.low_rapids.size(), "rapid") +
         (is_one ? " that was written keeps" : " that were written keep") + " less than the clearance of " +
         length_text(correction.rapid_clearance_mm, unit) + ": " +
         (is_one      ? (may_touch ? "it " : "")
          : may_touch ? "the nearest "
                      : "the least ") +
         kept_text(least.keeps_mm, unit) + (may_touch ? ", a gouge only beyond the tolerance" : "") + ", line " +
         std::to_string(least.line);
}

std::string straightened_text(const CorrectionFacts& correction) {
  return count_text(correction.curves, "curve") + " became " + count_text(correction.straight_moves, "straight move");
}

std::string tool_label(const Toolpath& toolpath, std::size_t tool) {
  if (tool >= toolpath.tools.size()) return "no tool";
  const PathTool& t = toolpath.tools[tool];
  if (t.number) return "T" + std::to_string(*t.number);
  return t.name.empty() ? "unnamed tool" : "\"" + t.name + "\"";
}

std::string tool_key(const Toolpath& toolpath, std::size_t tool) {
  if (tool >= toolpath.tools.size()) return {};
  const PathTool& t = toolpath.tools[tool];
  return t.number ? std::to_string(*t.number) : t.name;
}

std::string mesh_name(const ReportModel& model, const Witness& witness) {
  const MeshFacts* mesh = facts_of(model, witness);
  return mesh == nullptr ? std::string() : mesh->name;
}

double mesh_clearance_mm(const ReportModel& model, const Witness& witness) {
  const MeshFacts* mesh = facts_of(model, witness);
  return mesh == nullptr ? 0 : mesh->clearance_mm;
}

std::string operation_name(const Toolpath& toolpath, std::size_t operation) {
  return operation < toolpath.operations.size() ? toolpath.operations[operation].name : std::string();
}

std::string_view statement_text(const Toolpath& path, const Move& move) {
  if (move.statement >= path.statements.size()) return {};
  const SourceStatement& s = path.statements[move.statement];
  if (s.first_byte > s.last_byte || s.last_byte > path.source.size()) return {};
  return std::string_view(path.source).substr(s.first_byte, s.last_byte - s.first_byte);
}

bool is_text(std::string_view statement) {
  return std::ranges::none_of(statement,
                              [](char c) { return c >= 0 && c < ' ' && c != '\t' && c != '\r' && c != '\n'; });
}

std::vector<std::string> statement_lines(const Toolpath& toolpath, std::size_t move) {
  constexpr std::size_t kMaxLines = 3, kMaxBytes = 200;
  const std::string_view all = statement_text(toolpath, toolpath.moves[move]);
  if (!is_text(all)) return {};
  std::vector<std::string> lines;
  for (std::string_view rest = all.substr(0, all.find_last_not_of("\r\n") + 1); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view one = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (!one.empty() && (one.back() == '\r' || one.back() == ' ')) one.remove_suffix(1);
    const bool is_cut = one.size() > kMaxBytes || (lines.size() + 1 == kMaxLines && !rest.empty());
    std::string shown(one.substr(0, kMaxBytes));
    std::ranges::replace(shown, '\t', ' ');
    lines.push_back(shown + (is_cut ? " ..." : ""));
    if (lines.size() == kMaxLines) break;
  }
  return lines;
}

std::string event_name(const ReportModel& model, const Event& event) {
  if (event.state != MoveState::gouge || event.against != Against::stock) return state_name(event.state);
  const Move& move = model.toolpath->moves[event.worst_move];
  if (runs_rapid(move) || !move.has_start) return "rapid into stock";
  if (move.is_spindle_stopped() && event.body == Body::cutter) return "stopped cutter in stock";
  return std::string(body_name(event.body)) + " in stock";
}

std::string event_text(const ReportModel& model, const Event& event) {
  const LengthUnit unit = model.toolpath->unit;
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  const std::string move = ", move " + std::to_string(event.worst_move);
  std::string text = std::string(event_name(model, event)) + ": ";
  if (event.state == MoveState::buried) {
    return text + tool_phrase(model, event) + " lies inside a solid, no surface within the " +
           (event.body == Body::cutter ? "tool" : body_name(event.body)) + move;
  }
  const bool is_near = event.state == MoveState::near_miss;
  const double length_mm = is_near ? verdict.clearance_mm.value_or(0) : verdict.depth_mm;
  text += depth_text(length_mm, unit, model.options) + (is_near ? " left " : " ");
  if (has_wide_depth(model, verdict))
    text += "(at most " + depth_text(verdict.depth_upper_mm, unit, model.options) + ") ";
  text += tool_phrase(model, event);
  if (!verdict.witness) return text + move;
  text += counterpart_text(model, *verdict.witness) + " at " + point_text(verdict.witness->point, unit) + move +
          " t=" + instant_text(verdict.witness->t);
  if (verdict.reason.is(Reason::Kind::stock_met)) return text + ", " + reason_text(verdict.reason);
  return text + further_text(model, event) + stock_too_text(*model.result, event);
}

std::string span_text(const Event& event) {
  if (event.moves < 2) return {};
  return " (" + count_text(event.moves, "move") + ", " + std::to_string(event.first_move) + "-" +
         std::to_string(event.last_move) + ")";
}

std::string feed_text(const Feed& feed, LengthUnit unit) {
  if (feed.unit == FeedUnit::rapid) return "rapid";
  if (!feed.is_number() || !(feed.mm > 0)) return {};
  return "feed " + length_text(feed.mm, unit) + (feed.unit == FeedUnit::per_minute ? "/min" : "/rev");
}

namespace {

// Returns the speed of the spindle in a move; empty: not known.
std::string spindle_text(const Move& move) {
  if (move.is_spindle_stopped()) return "spindle stopped";
  return move.spindle_rpm > 0 ? "spindle " + display_text(move.spindle_rpm, 1) + " rpm" : std::string();
}

// Returns the name of a numbered tool in the library, else in the toolpath; empty: it has none.
std::string shop_name(const ReportModel& model, std::size_t tool) {
  const Toolpath& path = *model.toolpath;
  if (tool >= model.tools.size() || tool >= path.tools.size() || !path.tools[tool].number) return {};
  const std::string& description = model.tools[tool].description;
  const std::size_t end = description.find(": ");
  return end == std::string::npos ? path.tools[tool].name : description.substr(0, end);
}

}  // namespace

std::string setting_text(const ReportModel& model, const Event& event) {
  const Toolpath& path = *model.toolpath;
  const Move& move = path.moves[event.worst_move];
  // A subprogram may stand behind the block that calls it, so the last move may have an earlier line than the first one.
  const auto [first, last] =
      std::minmax<std::size_t>({path.moves[event.first_move].line, path.moves[event.last_move].line});
  const std::string operation = operation_name(path, move.operation);
  const std::string tool = shop_name(model, event.tool);
  std::string text;
  if (first != last) text += ", lines " + std::to_string(first) + "-" + std::to_string(last);
  if (!operation.empty()) text += ", operation " + operation;
  if (!tool.empty()) text += ", tool " + tool;
  for (const std::string& speed : {feed_text(move.feed(), path.unit), spindle_text(move)}) {
    if (!speed.empty()) text += ", " + speed;
  }
  return text;
}

std::optional<Pose> witness_pose(const ReportModel& model, std::size_t move) {
  const Boxed<Witness>& witness = model.result->verdicts[move].witness;
  if (!witness) return std::nullopt;
  const Motion motion = model.options.law.of(*model.toolpath, move).with(witness->turn);
  return motion.is_defined() ? std::optional(motion.at(witness->t)) : std::nullopt;
}

std::string pose_text(const ReportModel& model, const Event& event) {
  const std::optional<Pose> pose = witness_pose(model, event.worst_move);
  if (!pose) return {};
  std::string axis;
  for (int k = 0; k < 3; ++k) axis += (k > 0 ? ", " : "") + display_text(pose->axis[k], 6);
  return "tip " + point_text(pose->tip, model.toolpath->unit) + ", axis (" + axis + ")";
}

std::string group_text(const ReasonGroup& group) {
  const std::string what = group.state == MoveState::not_checked ? "not checked" : "not certified";
  const std::string reason = group.reason.empty() ? "no reason given" : group.reason;
  if (group.moves == 1) return what + ": " + reason + ", move " + std::to_string(group.first_move);
  return what + ": " + reason + " (" + count_text(group.moves, "move") + ", the first is move " +
         std::to_string(group.first_move) + ")";
}

}  // namespace gouge
