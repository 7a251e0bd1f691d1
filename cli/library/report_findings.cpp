#include "cli/library/report_findings.h"

#include "postproc/report/findings.h"
#include "postproc/report/report_text.h"

namespace gougecheck {
namespace {

void add_verdict(const gouge::MoveVerdict& verdict, Finding& finding) {
  if (finding.state == State::gouge) {
    finding.depth = verdict.depth_mm;
    finding.depth_upper = verdict.depth_upper_mm;
    if (verdict.overcut) finding.overcut = verdict.overcut->lower_mm;
  }
  if (finding.state == State::near_miss) finding.clearance = verdict.clearance_mm.value_or(Finding::kNone);
  if (!verdict.witness) return;
  finding.t = verdict.witness->t;
  finding.body = static_cast<Body>(verdict.witness->body);
  finding.point = to_array(verdict.witness->point);
  finding.normal = to_array(verdict.witness->normal);
}

/// Returns the name of the tool that was checked, if the path gives its tool no number.
std::string given_name(const gouge::ReportModel& model, std::size_t tool) {
  const gouge::Toolpath& path = *model.toolpath;
  const bool has_number = tool >= path.tools.size() || path.tools[tool].number;
  return has_number || tool >= model.tools.size() ? std::string() : model.tools[tool].name;
}

Finding finding_of(const gouge::ReportModel& model, gouge::Finding found) {
  const gouge::Toolpath& path = *model.toolpath;
  Finding finding;
  finding.state = static_cast<State>(found.state);
  finding.move = found.move;
  finding.moves = found.moves;
  finding.line = found.line;
  finding.against = std::move(found.against);
  const std::string name = given_name(model, path.moves[found.move].tool);
  finding.tool = name.empty() ? std::move(found.tool) : name;
  finding.operation = gouge::operation_name(path, path.moves[found.move].operation);
  finding.message = std::move(found.message);
  const gouge::Pose pose = gouge::witness_pose(model, found.move).value_or(path.moves[found.move].end);
  finding.tip = to_array(pose.tip);
  finding.axis = to_array(pose.axis);
  const bool is_open = finding.state == State::not_checked || finding.state == State::not_certified;
  if (!is_open) add_verdict(model.result->verdicts[found.move], finding);
  return finding;
}

}  // namespace

std::vector<Finding> findings_of(const CheckedPath& checked, const gouge::CheckResult& result) {
  const gouge::ReportModel model = checked.model(result);
  std::vector<Finding> all;
  for (gouge::Finding& found : gouge::list_findings(model)) all.push_back(finding_of(model, std::move(found)));
  return all;
}

}  // namespace gougecheck
