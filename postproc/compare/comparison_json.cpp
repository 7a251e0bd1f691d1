#include "lib/base/printable_text.h"
#include "postproc/compare/comparison_object.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const StoredResult& result) {
  return {{"file", valid_utf8(result.file)},
          {"toolpath", valid_utf8(result.record.toolpath.file)},
          {"verdict", valid_utf8(result.record.verdict)},
          {"version", valid_utf8(result.record.program.version)}};
}

Json length(const std::optional<double>& length_mm, LengthUnit unit) {
  return length_mm ? Json(*length_mm / mm_per(unit)) : Json(nullptr);
}

Json findings_json(const StoredResult& result, const std::vector<std::size_t>& findings, LengthUnit unit) {
  Json all = Json::array();
  for (const std::size_t k : findings) {
    const EventRecord& finding = result.findings[k];
    const MoveRecord& worst = result.worst_of(finding);
    Json point = nullptr;
    if (worst.witness) {
      point = Json::array();
      for (int i = 0; i < 3; ++i) point.push_back(worst.witness->point_mm[i] / mm_per(unit) + 0.0);
    }
    all.push_back({{"number", *finding.number},
                   {"state", state_name(finding.state)},
                   {"line", finding.line},
                   {"move", worst.move},
                   {"tool", finding.tool},
                   {"body", body_name(finding.body)},
                   {"against", against_name(finding.against)},
                   {"operation", worst.operation},
                   {"statement", worst.statement},
                   {"depth", length(worst.depth_mm, unit)},
                   {"depth_upper", length(worst.depth_upper_mm, unit)},
                   {"overcut", length(worst.overcut_mm, unit)},
                   {"point", std::move(point)}});
  }
  return all;
}

Json valid_utf8_texts(const std::vector<std::string>& texts) {
  Json all = Json::array();
  for (const std::string& text : texts) all.push_back(valid_utf8(text));
  return all;
}

}  // namespace

Json comparison_object(const Comparison& c) {
  const LengthUnit unit = c.after->record.unit;
  Json counts = Json::object(), findings = Json::array();
  for (std::size_t k = 0; k < kChanges; ++k)
    counts[change_name(static_cast<Change>(k))] = c.count(static_cast<Change>(k));
  for (const ComparedFinding& one : c.findings) {
    findings.push_back({{"change", change_name(one.change)},
                        {"why", one.why},
                        {"before", findings_json(*c.before, one.before, unit)},
                        {"after", findings_json(*c.after, one.after, unit)}});
  }
  return {{"format", "gougecheck-comparison"},
          {"format_version", 1},
          {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
          {"exit_status", static_cast<int>(c.exit_status())},
          {"unit", unit_name(unit)},
          {"before", run_json(*c.before)},
          {"after", run_json(*c.after)},
          {"differences", c.differences},
          {"open_moves", c.open_moves},
          {"open_facts", valid_utf8_texts(c.open_facts)},
          {"material_left",
           c.excess ? Json({{"change", change_name(c.excess->change)}, {"text", c.excess->text}}) : Json()},
          {"counts", std::move(counts)},
          {"findings", std::move(findings)}};
}

std::string comparison_json(const Comparison& c) { return comparison_object(c).dump(1) + "\n"; }

}  // namespace gouge
