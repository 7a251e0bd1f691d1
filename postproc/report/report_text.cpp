#include "postproc/report/report_text.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

constexpr double kLeastReported_mm = 1e-6;

// Power of ten of the first digit, found by comparing so that no rounding of a logarithm enters.
int first_digit(double value) {
  int power = 0;
  for (double x = std::abs(value); x >= 10 && power < 300; x /= 10) ++power;
  for (double x = std::abs(value); x < 1 && x > 0 && power > -300; x *= 10) --power;
  return power;
}

std::string tool_phrase(const ReportModel& model, const Event& event) {
  return std::string(body_name(event.body)) + " " + tool_label(*model.toolpath, event.tool);
}

std::string counterpart(const ReportModel& model, const Witness& witness) {
  const std::string name = mesh_name(model, witness);
  const bool is_plain = witness.against == Against::part && model.parts.size() < 2;
  if (is_plain) return {};
  return " against " + std::string(against_name(witness.against)) + (name.empty() ? "" : " " + name);
}

}  // namespace

std::string depth_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any depth";
  const int usual = unit == LengthUnit::inch ? 4 : 3;
  // Below a millionth of a millimetre it is rounding, whose digits would only look like a finding.
  const bool is_reported = length_mm >= kLeastReported_mm;
  const int decimals = is_reported ? std::clamp(1 - first_digit(value), usual, 12) : usual;
  return people_text(value, decimals, Zeros::kept) + " " + unit_name(unit);
}

std::string length_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any length";
  const int power = first_digit(value);
  const int digits = power < 0 ? 4 : 6;
  return people_text(value, std::clamp(digits - 1 - power, 0, 15)) + " " + unit_name(unit);
}

std::string short_length_text(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  if (!std::isfinite(value)) return "any length";
  const int decimals = std::clamp(2 - first_digit(value), 6, 15);
  return people_text(value, decimals) + " " + unit_name(unit);
}

std::string point_text(const Vec3& point_mm, LengthUnit unit) {
  const int decimals = unit == LengthUnit::inch ? 4 : 3;
  std::string text = "(";
  for (int k = 0; k < 3; ++k) {
    text += (k > 0 ? ", " : "") + people_text(point_mm[k] / mm_per(unit), decimals);
  }
  return text + ")";
}

const char* unit_words(LengthUnit unit) { return unit == LengthUnit::inch ? "inches" : "mm"; }

std::string instant_text(double t) { return people_text(t, 4); }

std::size_t inserted_positions(const CorrectionFacts& correction) {
  return static_cast<std::size_t>(
      std::ranges::count_if(correction.changes, [](const CorrectedRecord& change) { return change.is_inserted; }));
}

std::size_t moved_positions(const CorrectionFacts& correction) {
  return static_cast<std::size_t>(std::ranges::count_if(
      correction.changes, [](const CorrectedRecord& change) { return !change.is_inserted && !change.is_uncut; }));
}

UncutTotal uncut_total(const CorrectionFacts& correction) {
  UncutTotal total;
  for (const UncutRecord& stretch : correction.uncut) {
    total.positions += stretch.positions;
    total.length_mm += stretch.length_mm;
  }
  return total;
}

std::string uncut_text(const CorrectionFacts& correction, LengthUnit unit) {
  if (correction.uncut.empty()) return {};
  const UncutTotal total = uncut_total(correction);
  const std::size_t stretches = correction.uncut.size();
  return count_text(total.positions, "position") + " and " + length_text(total.length_mm, unit) + " left uncut in " +
         std::to_string(stretches) + (stretches == 1 ? " stretch" : " stretches");
}

std::string thickness_text(const StockRecord& stretch, LengthUnit unit) {
  const std::string thickness = depth_text(stretch.thickness_mm, unit);
  return stretch.is_undecided ? "no more than " + thickness + " is not proved"
         : stretch.is_more    ? "more than " + thickness
                              : thickness;
}

std::string stock_text(const CorrectionFacts& correction, LengthUnit unit) {
  if (correction.stock.empty()) return {};
  const std::size_t stretches = correction.stock.size();
  const StockRecord& most = *std::ranges::max_element(correction.stock, {}, &StockRecord::thickness_mm);
  return (most.is_more || most.is_undecided ? "" : "up to ") + thickness_text(most, unit) +
         " of what was finished left in " + std::to_string(stretches) + (stretches == 1 ? " stretch" : " stretches") +
         ", " + (stretches == 1 ? "at " : "most at ") + point_text(most.point, unit) + ", lines " +
         std::to_string(most.first_line) + "-" + std::to_string(most.last_line);
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
  const std::vector<MeshFacts>& meshes = witness.against == Against::part ? model.parts : model.fixtures;
  return witness.mesh < meshes.size() ? meshes[witness.mesh].name : std::string();
}

std::string operation_name(const Toolpath& toolpath, std::size_t operation) {
  return operation < toolpath.operations.size() ? toolpath.operations[operation].name : std::string();
}

std::string event_text(const ReportModel& model, const Event& event) {
  const LengthUnit unit = model.toolpath->unit;
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  const std::string move = ", move " + std::to_string(event.worst_move);
  std::string text = std::string(state_name(event.state)) + ": ";
  if (event.state == MoveState::buried) {
    return text + tool_phrase(model, event) + " lies inside a solid, no surface within the " +
           (event.body == Body::cutter ? "tool" : body_name(event.body)) + move;
  }
  const bool is_near = event.state == MoveState::near_miss;
  const double length_mm = is_near ? verdict.clearance_mm.value_or(0) : verdict.depth_mm;
  text += depth_text(length_mm, unit) + (is_near ? " left " : " ");
  if (has_wide_depth(model, verdict)) text += "(at most " + depth_text(verdict.depth_upper_mm, unit) + ") ";
  text += tool_phrase(model, event);
  if (!verdict.witness) return text + move;
  return text + counterpart(model, *verdict.witness) + " at " + point_text(verdict.witness->point, unit) + move +
         " t=" + instant_text(verdict.witness->t);
}

std::string span_text(const Event& event) {
  if (event.moves < 2) return {};
  return " (" + count_text(event.moves, "move") + ", " + std::to_string(event.first_move) + "-" +
         std::to_string(event.last_move) + ")";
}

std::string group_text(const ReasonGroup& group) {
  const std::string what = group.state == MoveState::not_checked ? "not checked" : "not certified";
  const std::string reason = group.reason.empty() ? "no reason given" : group.reason;
  if (group.moves == 1) return what + ": " + reason + ", move " + std::to_string(group.first_move);
  return what + ": " + reason + " (" + count_text(group.moves, "move") + ", the first is move " +
         std::to_string(group.first_move) + ")";
}

}  // namespace gouge
