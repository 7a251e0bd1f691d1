#include "postproc/report/identity_json.h"

#include <algorithm>
#include <array>

#include "lib/base/sha256.h"
#include "lib/path/motion_key.h"
#include "postproc/report/motion_list.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::string_view kBefore = ",\n \"digest\": \"sha256:", kAfter = "\"\n}\n", kEnd = "\n}\n";
constexpr std::size_t kDigits = 64;

}  // namespace

nlohmann::ordered_json motions_json(const Toolpath& path) {
  nlohmann::ordered_json texts = nlohmann::ordered_json::array();
  for (std::size_t first = 0; first < path.moves.size(); first += kMotionsOfText) {
    std::string text;
    const std::size_t end = std::min(first + kMotionsOfText, path.moves.size());
    for (std::size_t move = first; move < end; ++move) text.append(motion_key(path, move), 0, kListedDigits);
    texts.push_back(std::move(text));
  }
  return texts;
}

nlohmann::ordered_json runs_json(const Toolpath& path) {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < path.moves.size(); ++k) {
    const Move& move = path.moves[k];
    if (k > 0 && path.moves[k - 1].operation == move.operation && path.moves[k - 1].tool == move.tool) continue;
    runs.push_back({{"first_move", k},
                    {"operation", valid_utf8(operation_name(path, move.operation))},
                    {"tool", valid_utf8(tool_key(path, move.tool))}});
  }
  return runs;
}

std::string statement_json(const Toolpath& path, const Move& move) {
  constexpr std::size_t kMost = 2000;
  std::string_view text = statement_text(path, move).substr(0, kMost);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return valid_utf8(text);
}

nlohmann::ordered_json baseline_json(const ReportModel& model) {
  if (!model.baseline.is_given()) return nullptr;
  static constexpr std::array<const char*, 3> kUses = {"applied", "unused", "void"};
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const BaselineEntry& entry : model.baseline.entries) {
    entries.push_back({{"finding", valid_utf8(entry.finding)},
                       {"by", valid_utf8(entry.by)},
                       {"date", valid_utf8(entry.date)},
                       {"reason", valid_utf8(entry.reason)},
                       {"use", kUses.at(static_cast<std::size_t>(entry.use))},
                       {"why", valid_utf8(entry.why)}});
  }
  return {{"file", valid_utf8(model.baseline.file)},
          {"accepted_findings", model.baseline.accepted_findings()},
          {"accepted_moves", model.baseline.accepted_moves},
          {"entries", std::move(entries)}};
}

nlohmann::ordered_json acceptance_json(const ReportModel& model, std::size_t event) {
  if (event >= model.baseline.events.size()) return nullptr;
  const EventAcceptance& acceptance = model.baseline.events[event];
  if (acceptance.entries.empty()) return nullptr;
  return {{"is_accepted", acceptance.is_accepted},
          {"entries", acceptance.entries},
          {"why_not", valid_utf8(acceptance.why_not)}};
}

std::string with_digest(std::string json) {
  json.resize(json.size() - kEnd.size());
  const std::string digest = sha256_of(json);
  return json.append(kBefore).append(digest).append(kAfter);
}

DigestState check_digest(std::string_view json) {
  const std::size_t size = kBefore.size() + kDigits + kAfter.size();
  if (json.size() < size) return DigestState::missing;
  const std::string_view body = json.substr(0, json.size() - size), tail = json.substr(json.size() - size);
  if (!tail.starts_with(kBefore) || !tail.ends_with(kAfter))
    return json.find("\"digest\"") == std::string_view::npos ? DigestState::missing : DigestState::wrong;
  return tail.substr(kBefore.size(), kDigits) == sha256_of(body) ? DigestState::right : DigestState::wrong;
}

}  // namespace gouge
