#include "postproc/report/findings_html.h"

#include <algorithm>
#include <limits>

#include "lib/base/number_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/findings.h"
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

// Returns the largest overcut of the moves of a finding, as in the key of the heat map.
double overcut_of(const ReportModel& model, const Event& event) {
  double largest = 0;
  if (event.state != MoveState::gouge) return largest;
  for (std::size_t i = event.first_move; i <= event.last_move; ++i) {
    const MoveVerdict& verdict = model.result->verdicts[i];
    if (verdict.state == MoveState::gouge) largest = std::max(largest, verdict.overcut_mm.value_or(0));
  }
  return largest;
}

class FindingsTable {
 public:
  FindingsTable(const ReportModel& model, const std::vector<NamedFile>& pictures)
      : model_(model), pictures_(pictures), unit_(model.toolpath->unit), numbers_(finding_numbers(*model.result)) {}

  [[nodiscard]] std::string html() const {
    std::vector<const Event*> events;
    for (const Event& event : model_.result->events) {
      if (is_finding(event)) events.push_back(&event);
    }
    if (events.empty()) return {};
    std::ranges::sort(events, {}, [&](const Event* event) { return numbers_[index_of(*event)]; });
    std::vector<HtmlColumn> columns = {
        {"No.", "n"},     {"State"},    {"Line", "n"}, {"Depth", "n"},
        {"Overcut", "n"}, {"Body"},     {"Against"},   {"At, in " + std::string(unit_words(unit_))},
        {"Moves", "n"},   {"Operation"}};
    if (model_.cure_options) columns.push_back({"Cured by"});
    columns.push_back({""});
    HtmlTable table(columns);
    for (const Event* event : events) table.has_room() ? table.add(row(*event), attributes(*event)) : table.skip();
    return "<h2>Findings</h2>\n<p class=\"soft\">Neighbouring moves of one tool and body are one finding, the worst "
           "first. Line, depth and position are those of its deepest move, the overcut is the largest of its "
           "moves.</p>\n<div id=\"findings\">\n" +
           table.html() + "</div>\n<script>\n\"use strict\";\n" + std::string(kFindingsScript) + "</script>\n";
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

  [[nodiscard]] std::string acceptance(std::size_t event) const {
    std::string out = model_.baseline.is_accepted(event) ? " <span class=\"state\">accepted</span>" : "";
    for (const std::string& remark : acceptance_remarks(model_, event))
      out += "<div class=\"soft\">" + xml_escaped(remark) + "</div>";
    return out;
  }

  [[nodiscard]] std::string row(const Event& event) const {
    const MoveVerdict& verdict = model_.result->verdicts[event.worst_move];
    const Move& move = model_.toolpath->moves[event.worst_move];
    const std::string state = state_name(event.state);
    std::string depth = "-";
    if (event.state == MoveState::gouge) depth = depth_text(verdict.depth_mm, unit_, model_.options);
    if (has_wide_depth(model_, verdict)) depth += " to " + depth_text(verdict.depth_upper_mm, unit_, model_.options);
    if (event.state == MoveState::near_miss)
      depth = depth_text(verdict.clearance_mm.value_or(0), unit_, model_.options) + " left";
    const double overcut_mm = overcut_of(model_, event);
    std::string against = against_name(event.against);
    if (verdict.witness) against += " " + mesh_name(model_, *verdict.witness);
    const std::string span = event.moves < 2 ? std::to_string(event.worst_move)
                                             : std::to_string(event.first_move) + "-" + std::to_string(event.last_move);
    return html_cell(std::to_string(numbers_[index_of(event)]), "n") + "<td><span class=\"state " + state + "\">" +
           state + "</span>" + acceptance(index_of(event)) + "</td>" + html_cell(std::to_string(move.line), "n") +
           html_cell(depth, "n") + html_cell(overcut_mm > 0 ? depth_text(overcut_mm, unit_) : "", "n") +
           html_cell(std::string(body_name(event.body)) + " " + tool_label(*model_.toolpath, event.tool)) +
           html_cell(against) +
           html_cell(verdict.witness ? point_text(verdict.witness->point, unit_) : std::string(), "k") +
           html_cell(span, "n") + html_cell(operation_name(*model_.toolpath, move.operation)) + cures_cell(event) +
           "<td class=\"k\">" + link(event) + "</td>";
  }

  [[nodiscard]] std::string cures_cell(const Event& event) const {
    if (!model_.cure_options) return {};
    const FindingCures* const cures = cures_of(model_, index_of(event));
    return html_cell(cures != nullptr ? cure_text(model_, *cures) : std::string());
  }

  const ReportModel& model_;
  const std::vector<NamedFile>& pictures_;
  LengthUnit unit_;
  std::vector<std::size_t> numbers_;
};

/// Counts for an operation or a tool.
struct Share {
  std::size_t moves = 0, findings = 0, cured = 0;
  double depth_mm = 0, overcut_mm = 0;
};

/// Counts for each operation or tool; `of(move)` is its index. Moves without one are counted last.
template <class Of>
std::vector<Share> shares_of(const ReportModel& model, std::size_t count, Of&& of) {
  std::vector<Share> shares(count + 1);
  const auto at = [&](std::size_t move) -> Share& { return shares[std::min(of(model.toolpath->moves[move]), count)]; };
  for (std::size_t i = 0; i < model.toolpath->moves.size(); ++i) ++at(i).moves;
  for (std::size_t i = 0; i < model.result->events.size(); ++i) {
    const Event& event = model.result->events[i];
    if (event.state != MoveState::gouge && event.state != MoveState::buried) continue;
    Share& share = at(event.worst_move);
    ++share.findings;
    const FindingCures* const cures = model.cure_options ? cures_of(model, i) : nullptr;
    if (cures != nullptr && (cures->tilt.tilt_rad || cures->lift.lift_mm)) ++share.cured;
    if (event.state == MoveState::gouge)
      share.depth_mm = std::max(share.depth_mm, model.result->verdicts[event.worst_move].depth_mm);
    share.overcut_mm = std::max(share.overcut_mm, overcut_of(model, event));
  }
  return shares;
}

template <class Name>
std::string share_table(const ReportModel& model, const char* what, const std::vector<Share>& shares, Name&& name) {
  const LengthUnit unit = model.toolpath->unit;
  std::vector<HtmlColumn> columns = {{what}, {"Moves", "n"}, {"Findings", "n"}, {"Deepest", "n"}, {"Overcut", "n"}};
  if (model.cure_options) columns.push_back({"Findings with a cure", "n"});
  HtmlTable table(columns);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Share& s = shares[i];
    if (s.moves == 0) continue;
    const auto length = [&](double mm) { return html_cell(mm > 0 ? depth_text(mm, unit, model.options) : "", "n"); };
    const std::string cells = html_cell(i + 1 < shares.size() ? name(i) : "none") +
                              html_cell(std::to_string(s.moves), "n") + html_cell(std::to_string(s.findings), "n") +
                              length(s.depth_mm) + length(s.overcut_mm) +
                              (model.cure_options ? html_cell(std::to_string(s.cured), "n") : std::string());
    table.has_room() ? table.add(cells) : table.skip();
  }
  return table.html();
}

}  // namespace

std::string findings_html(const ReportModel& model, const std::vector<NamedFile>& pictures) {
  return FindingsTable(model, pictures).html();
}

std::string summaries_html(const ReportModel& model) {
  if (std::ranges::none_of(model.result->events, is_finding)) return {};
  const Toolpath& path = *model.toolpath;
  const std::vector<Share> operations =
      shares_of(model, path.operations.size(), [](const Move& move) -> std::size_t { return move.operation; });
  const std::vector<Share> tools =
      shares_of(model, path.tools.size(), [](const Move& move) -> std::size_t { return move.tool; });
  return "<h2>By operation and tool</h2>\n" +
         share_table(model, "Operation", operations,
                     [&](std::size_t i) {
                       const std::string name = operation_name(path, i);
                       return name.empty() ? "operation " + std::to_string(i + 1) : name;
                     }) +
         share_table(model, "Tool", tools, [&](std::size_t i) {
           const std::string words = i < model.tools.size() ? model.tools[i].description : std::string();
           return tool_label(path, i) + (words.empty() ? "" : ", " + words);
         });
}

}  // namespace gouge
