#include "postproc/report/findings.h"

#include "lib/base/sha256.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

std::string statement_text(const Toolpath& path, const Move& move) {
  if (move.statement >= path.statements.size()) return {};
  const SourceStatement& s = path.statements[move.statement];
  if (s.first_byte > s.last_byte || s.last_byte > path.source.size()) return {};
  return path.source.substr(s.first_byte, s.last_byte - s.first_byte);
}

class FindingList {
 public:
  explicit FindingList(const ReportModel& model) : model_(model), per_mm_(1 / mm_per(model.toolpath->unit)) {}

  std::vector<Finding> build() {
    for (const Event& event : model_.result->events) {
      if (event.state != MoveState::not_checked && event.state != MoveState::not_certified) add(event);
    }
    for (const ReasonGroup& group : group_reasons(*model_.result)) {
      Finding& finding = begin(group.state, group.first_move, group.reason);
      finding.moves = group.moves;
      finding.message = group_text(group);
    }
    return std::move(findings_);
  }

 private:
  Finding& begin(MoveState state, std::size_t move, const std::string& what) {
    const Toolpath& path = *model_.toolpath;
    Finding finding;
    finding.state = state;
    finding.move = move;
    finding.line = path.moves[move].line;
    finding.tool = tool_key(path, path.moves[move].tool);
    finding.fingerprint = sha256_of(std::string(state_name(state)) + '\n' + finding.tool + '\n' + what + '\n' +
                                    statement_text(path, path.moves[move]))
                              .substr(0, 16);
    findings_.push_back(std::move(finding));
    return findings_.back();
  }

  void add(const Event& event) {
    Finding& finding =
        begin(event.state, event.worst_move, std::string(body_name(event.body)) + against_name(event.against));
    const MoveVerdict& verdict = model_.result->verdicts[event.worst_move];
    finding.moves = event.moves;
    finding.body = body_name(event.body);
    finding.message = event_text(model_, event) + span_text(event);
    if (event.state == MoveState::gouge) {
      finding.depth = verdict.depth_mm * per_mm_;
      finding.depth_upper = verdict.depth_upper_mm * per_mm_;
    }
    if (!verdict.witness) return;
    finding.against = mesh_name(model_, *verdict.witness);
    finding.t = verdict.witness->t;
    finding.point = verdict.witness->point * per_mm_;
  }

  const ReportModel& model_;
  double per_mm_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> list_findings(const ReportModel& model) { return FindingList(model).build(); }

}  // namespace gouge
