#include "postproc/report/findings.h"

#include <algorithm>
#include <limits>

#include "lib/base/sha256.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

class FindingList {
 public:
  explicit FindingList(const ReportModel& model) : model_(model), per_mm_(1 / mm_per(model.toolpath->unit)) {}

  std::vector<Finding> build() {
    for (std::size_t k = 0; k < model_.result->events.size(); ++k) {
      const Event& event = model_.result->events[k];
      if (event.state == MoveState::not_checked || event.state == MoveState::not_certified) continue;
      add(event);
      add_acceptance(k);
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
    if (model_.baseline.is_given()) finding.baseline_state = "new";
    finding.fingerprint = sha256_of(std::string(state_name(state)) + '\n' + finding.tool + '\n' + what + '\n' +
                                    std::string(statement_text(path, path.moves[move])))
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

  void add_acceptance(std::size_t event) {
    if (event >= model_.baseline.events.size()) return;
    const EventAcceptance& acceptance = model_.baseline.events[event];
    Finding& finding = findings_.back();
    if (!acceptance.why_not.empty()) finding.baseline_state = "updated";
    if (acceptance.is_accepted) finding.baseline_state = "unchanged";
    for (const std::string& remark : acceptance_remarks(model_, event)) {
      if (acceptance.is_accepted) finding.justification += (finding.justification.empty() ? "" : "; ") + remark;
      finding.message += "; " + remark;
    }
  }

  const ReportModel& model_;
  double per_mm_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<std::size_t> finding_numbers(const CheckResult& result) {
  const auto depth = [&](std::size_t k) {
    const Event& event = result.events[k];
    const MoveVerdict& worst = result.verdicts[event.worst_move];
    if (event.state == MoveState::buried) return std::numeric_limits<double>::infinity();
    return event.state == MoveState::near_miss ? -worst.clearance_mm.value_or(0) : worst.depth_mm;
  };
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < result.events.size(); ++k) {
    const MoveState state = result.events[k].state;
    if (state != MoveState::not_checked && state != MoveState::not_certified) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
  std::vector<std::size_t> numbers(result.events.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = i + 1;
  return numbers;
}

std::vector<Finding> list_findings(const ReportModel& model) { return FindingList(model).build(); }

namespace {

// Returns the rank of an event: the deeper, the larger. The distance of a near miss counts as negative.
double rank_of(const ReportModel& model, std::size_t index) {
  const Event& event = model.result->events[index];
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  if (event.state == MoveState::buried) return std::numeric_limits<double>::infinity();
  return event.state == MoveState::near_miss ? -verdict.clearance_mm.value_or(0) : verdict.depth_mm;
}

bool is_listed(const ReportModel& model, const Event& event, double min_depth_mm) {
  if (min_depth_mm <= 0 || event.state == MoveState::buried) return true;
  if (event.state != MoveState::gouge) return false;
  for (std::size_t move = event.first_move; move <= event.last_move; ++move) {
    if (model.result->verdicts[move].depth_upper_mm >= min_depth_mm) return true;
  }
  return false;
}

}  // namespace

ListedFindings list_events(const ReportModel& model, const FindingsView& view) {
  ListedFindings listed;
  const std::vector<Event>& events = model.result->events;
  for (std::size_t k = 0; k < events.size(); ++k) {
    const MoveState state = events[k].state;
    if (state != MoveState::gouge && state != MoveState::buried && state != MoveState::near_miss) continue;
    if (is_listed(model, events[k], view.min_depth_mm)) {
      listed.events.push_back(k);
    } else {
      ++listed.shallower;
    }
  }
  const bool is_cut = listed.events.size() > view.most;
  if (!view.is_deepest_first && !is_cut) return listed;
  std::ranges::stable_sort(listed.events, std::ranges::greater{}, [&](std::size_t k) { return rank_of(model, k); });
  if (is_cut) {
    listed.more = listed.events.size() - view.most;
    listed.deepest_more_mm = std::max(0.0, rank_of(model, listed.events[view.most]));
    listed.events.resize(view.most);
  }
  if (!view.is_deepest_first) std::ranges::sort(listed.events);
  return listed;
}

}  // namespace gouge
