#include "postproc/report/findings_html.h"

#include <algorithm>
#include <limits>

#include "lib/base/number_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/findings.h"
#include "postproc/report/further_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_sources.h"
#include "postproc/report/report_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

bool is_finding(const Event& event) {
  return event.state != MoveState::not_checked && event.state != MoveState::not_certified;
}

class FindingsTable {
 public:
  FindingsTable(const ReportModel& model, const std::vector<NamedFile>& pictures, const std::string& review)
      : model_(model),
        pictures_(pictures),
        review_(review),
        unit_(model.toolpath->unit),
        numbers_(finding_numbers(*model.result)) {}

  [[nodiscard]] std::string html() const {
    std::vector<const Event*> events;
    for (const Event& event : model_.result->events) {
      if (is_finding(event)) events.push_back(&event);
    }
    if (events.empty()) return {};
    std::ranges::sort(events, {}, [&](const Event* event) { return numbers_[index_of(*event)]; });
    std::vector<HtmlColumn> columns = {
        {"No.", "n"},     {"State"}, {"Line", "n"}, {"Depth", "n"},
        {"Overcut", "n"}, {"Body"},  {"Against"},   {"At, in " + std::string(unit_words(unit_))},
        {"Moves", "n"}};
    if (has_operations()) columns.push_back({"Operation"});
    if (model_.cure_options) columns.push_back({"Cured by"});
    if (model_.baseline.is_given()) columns.push_back({"Acceptance"});
    if (!review_.empty()) columns.push_back({"Review"});
    columns.push_back({""});
    HtmlTable table(columns);
    for (const Event* event : events) table.has_room() ? table.add(row(*event), attributes(*event)) : table.skip();
    return "<h2>Findings</h2>\n<p class=\"soft\">Neighbouring moves of one tool and body are one finding, the worst "
           "first. Line, depth and position are those of its deepest move, the overcut is the largest of its "
           "moves.</p>\n<div id=\"findings\">\n" +
           table.html() + "</div>\n" + review_ + "<script>\n\"use strict\";\n" + std::string(kFindingsScript) +
           "</script>\n";
  }

 private:
  // Returns the rank. Buried tools have no depth and come first. Near misses come last, the nearest first.
  [[nodiscard]] double rank(const Event& event) const {
    const MoveVerdict& worst = model_.result->verdicts[event.worst_move];
    if (event.state == MoveState::buried) return std::numeric_limits<double>::infinity();
    return event.state == MoveState::near_miss ? -worst.clearance_mm.value_or(0) : worst.depth_mm;
  }

  // Returns the attributes for the script; lengths are in the path's unit.
  [[nodiscard]] std::string attributes(const Event& event) const {
    const auto add = [](const char* name, const std::string& value) {
      return std::string(" data-") + name + "=\"" + xml_escaped(value) + "\"";
    };
    const double per = mm_per(unit_), depth = rank(event);
    const double shown = event.state == MoveState::buried ? 1e30 : depth / per;
    return add("finding", std::to_string(index_of(event))) + add("state", state_name(event.state)) +
           add("depth", exact_text(shown)) + add("overcut", exact_text(overcut_of(model_, event) / per)) +
           add("body", body_name(event.body)) + add("tool", tool_label(*model_.toolpath, event.tool)) +
           (model_.baseline.is_given()
                ? add("accepted", model_.baseline.is_accepted(index_of(event)) ? "accepted" : "not accepted")
                : std::string());
  }

  [[nodiscard]] std::string link(const Event& event) const {
    for (const NamedFile& file : pictures_) {
      if (file.name.starts_with("event_") && file.move == event.worst_move) {
        const std::string id = file.name.substr(0, file.name.find('.'));
        return "<a href=\"#" + xml_escaped(id) + "\">picture " + xml_escaped(id.substr(6)) + "</a>";
      }
    }
    return {};
  }

  [[nodiscard]] std::size_t index_of(const Event& event) const {
    return static_cast<std::size_t>(&event - model_.result->events.data());
  }

  // Returns the reason of an acceptance, or why one does not hold.
  [[nodiscard]] std::string acceptance_cell(std::size_t event) const {
    if (!model_.baseline.is_given()) return {};
    return html_cell(listed(acceptance_remarks(model_, event), "; "), "why");
  }

  [[nodiscard]] bool has_operations() const { return !model_.toolpath->operations.empty(); }

  [[nodiscard]] std::string row(const Event& event) const {
    const MoveVerdict& verdict = model_.result->verdicts[event.worst_move];
    const Move& move = model_.toolpath->moves[event.worst_move];
    const std::string state = state_name(event.state);
    const std::string accepted =
        model_.baseline.is_accepted(index_of(event)) ? " <span class=\"state\">accepted</span>" : "";
    std::string depth = "-";
    if (event.state == MoveState::gouge) depth = depth_text(verdict.depth_mm, unit_, model_.options);
    if (has_wide_depth(model_, verdict)) depth += " to " + depth_text(verdict.depth_upper_mm, unit_, model_.options);
    if (event.state == MoveState::near_miss)
      depth = depth_text(verdict.clearance_mm.value_or(0), unit_, model_.options) + " left";
    const double overcut_mm = overcut_of(model_, event);
    std::string against = against_name(event.against);
    if (verdict.witness) against += " " + mesh_name(model_, *verdict.witness);
    against += other_obstacle_text(*model_.result, event);
    const std::string body = std::string(body_name(event.body)) + " " + tool_label(*model_.toolpath, event.tool) +
                             other_bodies_text(*model_.result, event);
    const std::string span = event.moves < 2 ? std::to_string(event.worst_move)
                                             : std::to_string(event.first_move) + "-" + std::to_string(event.last_move);
    return html_cell(std::to_string(numbers_[index_of(event)]), "n") + "<td><span class=\"state " + state + "\">" +
           state + "</span>" + accepted + "</td>" + html_cell(std::to_string(move.line), "n") + html_cell(depth, "n") +
           html_cell(overcut_mm > 0 ? depth_text(overcut_mm, unit_) : "", "n") + html_cell(body) + html_cell(against) +
           html_cell(verdict.witness ? point_text(verdict.witness->point, unit_) : std::string(), "k") +
           html_cell(span, "n") +
           (has_operations() ? html_cell(operation_name(*model_.toolpath, move.operation)) : std::string()) +
           cures_cell(event) + acceptance_cell(index_of(event)) +
           (review_.empty() ? "" : "<td class=\"review\"></td>") + "<td class=\"k\">" + link(event) + "</td>";
  }

  [[nodiscard]] std::string cures_cell(const Event& event) const {
    if (!model_.cure_options) return {};
    const FindingCures* const cures = cures_of(model_, index_of(event));
    return html_cell(cures != nullptr ? cure_text(model_, *cures) : std::string());
  }

  const ReportModel& model_;
  const std::vector<NamedFile>& pictures_;
  const std::string& review_;
  LengthUnit unit_;
  std::vector<std::size_t> numbers_;
};

}  // namespace

double overcut_of(const ReportModel& model, const Event& event) {
  double largest = 0;
  if (event.state != MoveState::gouge) return largest;
  for (std::size_t i = event.first_move; i <= event.last_move; ++i) {
    const MoveVerdict& verdict = model.result->verdicts[i];
    if (verdict.state == MoveState::gouge) largest = std::max(largest, verdict.overcut_mm());
  }
  return largest;
}

std::string findings_html(const ReportModel& model, const std::vector<NamedFile>& pictures, const std::string& review) {
  const std::string data =
      review.empty() ? "" : "<script type=\"application/json\" id=\"review-data\">" + review + "</script>\n";
  return FindingsTable(model, pictures, data).html();
}

}  // namespace gouge
