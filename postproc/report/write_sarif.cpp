#include "postproc/report/write_report.h"

#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

struct Rule {
  MoveState state;
  const char* level;
  const char* meaning;
};

constexpr std::array<Rule, 5> kRules{{
    {MoveState::gouge, "error", "The tool cuts deeper into the part, or closer to it, than is allowed"},
    {MoveState::buried, "error", "The tool lies inside a closed solid with no surface within the tool"},
    {MoveState::near_miss, "note", "The tool comes closer than the near-miss distance asked for"},
    {MoveState::not_checked, "warning", "The motion could not be checked"},
    {MoveState::not_certified, "warning", "The check did not reach its resolution within its budget"},
}};

std::size_t rule_index(MoveState state) {
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    if (kRules[i].state == state) return i;
  }
  return 0;
}

// A relative reference of RFC 3986, as the user named the file; absolute paths become file URIs.
std::string uri_of(const std::string& name) {
  std::string uri = !name.empty() && name[0] == '/' ? "file://" : "";
  for (const char c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("-._~/").find(c) != std::string_view::npos;
    if (is_plain) {
      uri += c;
    } else {
      constexpr std::string_view kDigits = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return uri;
}

class SarifReport {
 public:
  explicit SarifReport(const ReportModel& model) : model_(model) {}

  [[nodiscard]] Json build() {
    for (const Event& event : model_.result->events) {
      if (event.state == MoveState::not_checked || event.state == MoveState::not_certified) continue;
      const std::string what = event_text(model_, event) + span_text(event);
      add(event.state, what, event.worst_move, std::string(body_name(event.body)) + against_name(event.against));
    }
    for (const ReasonGroup& group : group_reasons(*model_.result)) {
      add(group.state, group_text(group), group.first_move, group.reason);
    }
    Json rules = Json::array();
    for (const Rule& rule : kRules) {
      rules.push_back({{"id", state_name(rule.state)},
                       {"shortDescription", {{"text", rule.meaning}}},
                       {"defaultConfiguration", {{"level", rule.level}}}});
    }
    Json run;
    run["tool"] = {{"driver", {{"name", kProgramName}, {"version", kProgramVersion}, {"rules", rules}}}};
    run["invocations"] = Json::array({{{"executionSuccessful", true},
                                       {"exitCode", static_cast<int>(exit_status(overall_verdict(*model_.result)))},
                                       {"toolExecutionNotifications", notifications()}}});
    run["artifacts"] = Json::array({{{"location", {{"uri", uri_of(model_.toolpath->file)}}}}});
    run["columnKind"] = "utf16CodeUnits";
    run["results"] = results_;
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
            {"version", "2.1.0"},
            {"runs", Json::array({run})}};
  }

 private:
  [[nodiscard]] Json notifications() const {
    Json all = Json::array();
    for (const Diagnostic& note : model_.notes) {
      if (note.severity != Severity::warning) continue;
      all.push_back({{"level", "warning"},
                     {"message", {{"text", valid_utf8(to_text(note))}}},
                     {"descriptor", {{"id", valid_utf8(note.code)}}}});
    }
    return all;
  }

  [[nodiscard]] std::string statement_text(const Move& move) const {
    const Toolpath& path = *model_.toolpath;
    if (move.statement >= path.statements.size()) return {};
    const SourceStatement& s = path.statements[move.statement];
    if (s.first_byte > s.last_byte || s.last_byte > path.source.size()) return {};
    return path.source.substr(s.first_byte, s.last_byte - s.first_byte);
  }

  void add(MoveState state, const std::string& message, std::size_t move_index, const std::string& what) {
    const Move& move = model_.toolpath->moves[move_index];
    const std::string key = std::string(state_name(state)) + '\n' + tool_key(*model_.toolpath, move.tool) + '\n' +
                            what + '\n' + statement_text(move);
    const std::string hash = sha256_of(key).substr(0, 16);
    const std::size_t occurrence = ++seen_[hash];
    Json location = {{"artifactLocation", {{"uri", uri_of(model_.toolpath->file)}, {"index", 0}}}};
    if (move.line > 0) location["region"] = {{"startLine", std::size_t{move.line}}};
    const std::size_t rule = rule_index(state);
    results_.push_back({{"ruleId", state_name(state)},
                        {"ruleIndex", rule},
                        {"level", kRules.at(rule).level},
                        {"message", {{"text", valid_utf8(message)}}},
                        {"locations", Json::array({{{"physicalLocation", location}}})},
                        {"partialFingerprints", {{"gougecheckFinding/v2", hash + ":" + std::to_string(occurrence)}}}});
  }

  const ReportModel& model_;
  Json results_ = Json::array();
  std::map<std::string, std::size_t> seen_;
};

}  // namespace

std::string write_sarif(const ReportModel& model) { return SarifReport(model).build().dump(1) + "\n"; }

}  // namespace gouge
