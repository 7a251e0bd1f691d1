#include "postproc/report/open_items.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/report/findings.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxFindings = 3, kMaxReasons = 2;

std::string item(const std::string& text) { return "<li>" + text + "</li>"; }

std::string more_item(std::size_t count, const std::string& noun) {
  return count == 0 ? std::string() : item("and " + count_text(count, noun));
}

// Returns the indices of gouges and buried tools without an acceptance, in the order of their numbers.
std::vector<std::size_t> open_events(const ReportModel& model, const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < model.result->events.size(); ++k) {
    const MoveState state = model.result->events[k].state;
    const bool is_gouge = state == MoveState::gouge || state == MoveState::buried;
    if (is_gouge && !model.baseline.is_accepted(k)) open.push_back(k);
  }
  std::ranges::sort(open, {}, [&](std::size_t k) { return numbers[k]; });
  return open;
}

std::string finding_items(const ReportModel& model) {
  const std::vector<std::size_t> numbers = finding_numbers(*model.result);
  const std::vector<std::size_t> open = open_events(model, numbers);
  std::string out;
  for (std::size_t i = 0; i < std::min(open.size(), kMaxFindings); ++i) {
    const Event& event = model.result->events[open[i]];
    out += item("<a href=\"#findings\">Finding " + std::to_string(numbers[open[i]]) + "</a>, line " +
                std::to_string(model.toolpath->moves[event.worst_move].line) + ": " +
                xml_escaped(event_text(model, event)));
  }
  return out + more_item(open.size() - std::min(open.size(), kMaxFindings), "more finding");
}

std::string reason_items(const ReportModel& model) {
  const std::vector<ReasonGroup> groups = group_reasons(*model.result);
  std::string out;
  for (std::size_t i = 0; i < std::min(groups.size(), kMaxReasons); ++i)
    out += item(
        xml_escaped(count_text(groups[i].moves, "move") + " " + state_name(groups[i].state) + ": " + groups[i].reason));
  return out + more_item(groups.size() - std::min(groups.size(), kMaxReasons), "more reason");
}

}  // namespace

std::string open_items_html(const ReportModel& model) {
  std::string items = finding_items(model) + reason_items(model);
  if (const std::size_t facts = open_facts(model).size(); facts > 0)
    items += item(count_text(facts, "fact") + " not established, named below");
  return items.empty() ? items : "<div>Open:<ul>" + items + "</ul></div>";
}

}  // namespace gouge
