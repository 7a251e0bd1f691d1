#include "postproc/report/operations_html.h"

#include "lib/base/number_text.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"
#include "postproc/report/shares.h"

namespace gouge {
namespace {

// Returns a length of a path, of which fractions of a millimetre do not matter.
std::string path_length_text(double length_mm, LengthUnit unit) {
  return fixed_text(length_mm / mm_per(unit), unit == LengthUnit::mm ? 0 : 1) + " " + unit_name(unit);
}

std::string length_cell(double length_mm, LengthUnit unit) {
  return html_cell(length_mm > 0 ? path_length_text(length_mm, unit) : std::string(), "n");
}

// Returns the columns of a share, for which share_cells has the cells.
void add_share_columns(const ReportModel& model, std::vector<HtmlColumn>& columns) {
  for (const char* title : {"Findings", "Deepest", "Overcut"}) columns.push_back({title, "n"});
  if (model.cure_options) columns.push_back({"Findings with a cure", "n"});
}

std::string share_cells(const ReportModel& model, const Share& share) {
  const auto length = [&](double mm) {
    return html_cell(mm > 0 ? depth_text(mm, model.toolpath->unit, model.options) : "", "n");
  };
  return html_cell(std::to_string(share.findings), "n") + length(share.depth_mm) + length(share.overcut_mm) +
         (model.cure_options ? html_cell(std::to_string(share.cured), "n") : std::string());
}

std::string operation_row(const ReportModel& model, const std::string& name, const Share& share,
                          const CycleTime& time) {
  const LengthUnit unit = model.toolpath->unit;
  const std::size_t open = time.moves_per_turn + time.moves_without_feed + time.moves_without_start;
  return html_cell(name) + html_cell(std::to_string(share.moves), "n") + html_cell(cycle_time_text(time), "n") +
         length_cell(time.feed_mm, unit) + length_cell(time.rapid_mm, unit) +
         html_cell(open > 0 ? std::to_string(open) : std::string(), "n") + share_cells(model, share);
}

std::string name_of_operation(const Toolpath& path, std::size_t index) {
  if (index >= path.operations.size()) return path.operations.empty() ? "all moves" : "without an operation";
  const std::string name = operation_name(path, index);
  return name.empty() ? "operation " + std::to_string(index + 1) : name;
}

// Returns one sentence about the time of the whole path, and one about what it leaves out.
std::string time_note(const CycleTime& time, LengthUnit unit) {
  std::vector<std::string> missing;
  if (time.rapids > 0)
    missing.push_back(count_text(time.rapids, "rapid") + " of " + path_length_text(time.rapid_mm, unit) +
                      ", whose speed the file does not state");
  if (time.moves_per_turn > 0)
    missing.push_back(count_text(time.moves_per_turn, "move") + " with a feed per revolution");
  if (time.moves_without_feed > 0)
    missing.push_back(count_text(time.moves_without_feed, "move") + " whose feed is not known");
  if (time.moves_without_start > 0)
    missing.push_back(count_text(time.moves_without_start, "position") + " to which no motion is known");
  missing.emplace_back("acceleration, limits of joints, tool changes and dwells");
  const std::string known = cycle_time_text(time);
  return "<p class=\"soft\">" +
         (known.empty() ? "The cycle time is not known: no move has a feed per minute."
                        : "Cycle time: " + known + " at the programmed feeds.") +
         " Not included: " + xml_escaped(listed(missing, "; ")) + ".</p>\n";
}

}  // namespace

std::string cycle_time_text(const CycleTime& time) {
  if (time.feed_mm <= 0) return {};
  return (time.moves_per_turn + time.moves_without_feed > 0 ? "at least " : "") + feed_time_text(time.feed_seconds);
}

CycleTime whole_time(const std::vector<CycleTime>& times) {
  CycleTime sum;
  for (const CycleTime& time : times) sum.add(time);
  return sum;
}

std::string operations_html(const ReportModel& model, const std::vector<CycleTime>& times) {
  const std::vector<Share> shares = shares_of_operations(model);
  const CycleTime whole = whole_time(times);
  std::vector<HtmlColumn> columns = {{"Operation"},        {"Moves", "n"},  {"Time at feeds", "n"},
                                     {"Feed length", "n"}, {"Rapids", "n"}, {"Moves without time", "n"}};
  add_share_columns(model, columns);
  HtmlTable table(columns);
  std::size_t rows = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i].moves == 0) continue;
    ++rows;
    if (!table.has_room()) {
      table.skip();
      continue;
    }
    table.add(operation_row(model, name_of_operation(*model.toolpath, i), shares[i], times[i]));
  }
  if (rows == 0) return {};
  if (rows > 1 && table.has_room()) table.add(operation_row(model, "in all", sum_of(shares), whole), " class=\"sum\"");
  return "<h2>Operations and cycle time</h2>\n" + table.html() + time_note(whole, model.toolpath->unit);
}

std::string tools_html(const ReportModel& model, const std::vector<std::string>& drawings) {
  if (model.tools.empty()) return {};
  const std::vector<Share> shares = shares_of_tools(model);
  const auto name_of = [&](std::size_t i) {
    const std::string& name = model.tools[i].name;
    return name == tool_label(*model.toolpath, i) ? std::string() : name;
  };
  bool has_names = false;
  for (std::size_t i = 0; i < model.tools.size(); ++i) has_names = has_names || !name_of(i).empty();
  std::vector<HtmlColumn> columns = {{"Tool"}};
  if (!drawings.empty()) columns.push_back({"Drawing"});
  if (has_names) columns.push_back({"Name"});
  columns.insert(columns.end(), {{"Shape"}, {"Defined in"}, {"Moves", "n"}});
  add_share_columns(model, columns);
  HtmlTable table(columns);
  for (std::size_t i = 0; i < model.tools.size(); ++i) {
    const ToolFacts& tool = model.tools[i];
    const Share share = i < shares.size() ? shares[i] : Share();
    const std::string drawing = i < drawings.size() ? drawings[i] : std::string();
    table.add(html_cell(tool_label(*model.toolpath, i), "k") +
              (drawings.empty() ? "" : "<td class=\"tool\">" + drawing + "</td>") +
              (has_names ? html_cell(name_of(i)) : std::string()) + html_cell(tool.description) +
              html_cell(tool.defined_in.empty() ? "nowhere: its moves are not checked" : tool.defined_in) +
              html_cell(std::to_string(share.moves), "n") + share_cells(model, share));
  }
  const std::string legend =
      "<p class=\"soft legend\"><i class=\"cutter\"></i>cutter <i class=\"shank\"></i>shank "
      "<i class=\"holder\"></i>holder. Each tool is drawn at a scale of its own.</p>\n";
  return "<h2>Tools</h2>\n" + table.html() + (drawings.empty() ? "" : legend);
}

}  // namespace gouge
