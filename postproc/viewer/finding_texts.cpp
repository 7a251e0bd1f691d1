#include "postproc/viewer/finding_texts.h"

#include <cmath>

#include "lib/motion/motion_law.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLinesAround = 3;
constexpr std::size_t kLongestLine = 160;  // characters quoted of a line
constexpr std::size_t kMostLines = 24;

Json scaled_json(const Vec3& v, double scale) {
  Json out = Json::array();
  for (int k = 0; k < 3; ++k) out.push_back(std::round(v[k] * scale) / scale);
  return out;
}

std::string line_of(std::string_view source, std::size_t first, std::size_t last) {
  std::string text = valid_utf8(source.substr(first, std::min(last - first, kLongestLine)));
  if (last - first > kLongestLine) text += " ...";
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.pop_back();
  return text;
}

/// The statement of a move and the lines around it; nothing of a binary file.
Json quote_of(const Toolpath& path, const Move& move) {
  if (move.statement == kNone || move.statement >= path.statements.size()) return nullptr;
  const SourceStatement& statement = path.statements[move.statement];
  const std::string_view source = path.source;
  const std::size_t begin = statement.first_byte, end = statement.last_byte;
  if (end > source.size() || begin >= end || source.substr(0, 4096).find('\0') != std::string_view::npos)
    return nullptr;
  std::size_t first = begin, number = statement.line;
  const auto start_of_line = [&](std::size_t at) {
    const std::size_t found = at == 0 ? std::string_view::npos : source.rfind('\n', at - 1);
    return found == std::string_view::npos ? 0 : found + 1;
  };
  first = start_of_line(first);
  for (std::size_t k = 0; k < kLinesAround && first > 0; ++k) {
    first = start_of_line(first - 1);
    --number;
  }
  Json lines = Json::array();
  std::size_t at = first, after = 0;
  for (std::size_t k = 0; k < kMostLines && at < source.size() && after < kLinesAround; ++k) {
    const std::size_t found = source.find('\n', at);
    const std::size_t stop = found == std::string_view::npos ? source.size() : found;
    if (at >= end) ++after;
    lines.push_back(line_of(source, at, stop));
    at = stop + 1;
  }
  return {{"first", number}, {"line", std::size_t{statement.line}}, {"lines", lines}};
}

Json finding_json(const ReportModel& model, const CheckedToolpath& input, const Event& event) {
  const Toolpath& path = *model.toolpath;
  const LengthUnit unit = path.unit;
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  const Move& move = path.moves[event.worst_move];
  const Motion motion = input.options.law.of(path, event.worst_move);
  const double t = verdict.witness && event.state != MoveState::buried ? verdict.witness->t : 1;
  const Pose pose = motion.is_defined() ? motion.at(t) : move.end;
  Json out = {{"state", state_name(event.state)},  {"move", event.worst_move},
              {"t", std::round(t * 1e6) / 1e6},    {"tool", event.tool},
              {"tip", scaled_json(pose.tip, 1e6)}, {"axis", scaled_json(pose.axis, 1e7)}};
  Json rows = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) rows.push_back(Json::array({name, valid_utf8(value)}));
  };
  if (event.state == MoveState::gouge) {
    add("Depth", depth_text(verdict.depth_mm, unit, model.options));
    add("At most", depth_text(verdict.depth_upper_mm, unit, model.options));
    if (verdict.overcut_mm.value_or(0) > 0) add("Overcut", depth_text(*verdict.overcut_mm, unit));
  }
  if (event.state == MoveState::near_miss)
    add("Left", depth_text(verdict.clearance_mm.value_or(0), unit, model.options));
  add("Body", std::string(body_name(event.body)) + " " + tool_label(path, event.tool));
  add("Against",
      std::string(against_name(event.against)) + (verdict.witness ? " " + mesh_name(model, *verdict.witness) : ""));
  if (verdict.witness) {
    add("At", point_text(verdict.witness->point, unit));
    out["point"] = scaled_json(verdict.witness->point, 1e6);
    out["normal"] = scaled_json(verdict.witness->normal, 1e6);
  }
  out["depth"] = event.state == MoveState::gouge ? verdict.depth_mm : 0.0;
  add("Instant", "move " + std::to_string(event.worst_move) + ", t = " + instant_text(t));
  if (event.moves > 1)
    add("Moves", std::to_string(event.moves) + ", " + std::to_string(event.first_move) + " to " +
                     std::to_string(event.last_move));
  add("Operation", operation_name(path, move.operation));
  out["rows"] = rows;
  out["quote"] = quote_of(path, move);
  return out;
}

}  // namespace

Json finding_texts(const ReportModel& model, const CheckedToolpath& input, std::size_t most) {
  Json out = Json::object();
  for (std::size_t i = 0; i < model.result->events.size() && out.size() < most; ++i) {
    const Event& event = model.result->events[i];
    if (event.state == MoveState::not_checked || event.state == MoveState::not_certified) continue;
    out[std::to_string(i)] = finding_json(model, input, event);
  }
  return out;
}

}  // namespace gouge
