#include "postproc/report/axis_html.h"

#include <algorithm>
#include <functional>

#include "lib/base/number_text.h"
#include "postproc/report/axis_chart.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

class AxisSection {
 public:
  explicit AxisSection(const ReportModel& model)
      : model_(model),
        axes_(*model.correction.axes),
        before_(model.correction.toolpath_before ? *model.correction.toolpath_before : *model.toolpath),
        unit_(model.toolpath->unit) {}

  [[nodiscard]] std::string html() const { return "<h2>Tool axis</h2>\n" + table() + charts(); }

 private:
  using Cell = std::function<std::string(const AxisQuality&, const Toolpath&)>;

  [[nodiscard]] static std::string with_line(const std::string& text, const Toolpath& path, std::size_t move) {
    const std::string line = line_of_move(path, move);
    return line.empty() ? text : text + " (" + line + ")";
  }

  void add(HtmlTable& table, const std::string& what, const Cell& cell) const {
    table.add(html_cell(what) + html_cell(cell(axes_.before, before_), "n") +
              html_cell(cell(axes_.after, *model_.toolpath), "n"));
  }

  [[nodiscard]] std::string table() const {
    HtmlTable table({{"Feed moves"}, {"Before", "n"}, {"After", "n"}});
    add_turns(table);
    add_positions(table);
    add(table, "Feed time", [](const AxisQuality& q, const Toolpath&) { return feed_time_text(q.feed_seconds); });
    if (axes_.max_rotary_deg_per_min) {
      add(table, "Feed time, turning by at most " + people_text(*axes_.max_rotary_deg_per_min, 3) + "°/min",
          [](const AxisQuality& q, const Toolpath&) { return feed_time_text(q.limited_feed_seconds.value_or(0)); });
    }
    if (axes_.before.moves_without_feed + axes_.after.moves_without_feed > 0) {
      add(table, "Moves without a feed per minute, in no time",
          [](const AxisQuality& q, const Toolpath&) { return std::to_string(q.moves_without_feed); });
    }
    return table.html();
  }

  void add_turns(HtmlTable& table) const {
    const std::string unit = unit_name(unit_);
    add(table, "Largest turn per " + unit, [&](const AxisQuality& q, const Toolpath& path) {
      return with_line(turn_rate_text(q.turn_rad_per_mm.value, unit_, DegreeSign::sign), path, q.turn_rad_per_mm.move);
    });
    add(table, "Largest turn in a move", [](const AxisQuality& q, const Toolpath& path) {
      return with_line(angle_text(q.turn_rad.value, DegreeSign::sign), path, q.turn_rad.move);
    });
    if (axes_.before.turns_on_the_spot + axes_.after.turns_on_the_spot > 0) {
      add(table, "Turns on the spot, the largest of them", [](const AxisQuality& q, const Toolpath& path) {
        if (q.turns_on_the_spot == 0) return std::string("0");
        const std::string largest = angle_text(q.turn_on_the_spot_rad.value, DegreeSign::sign);
        return std::to_string(q.turns_on_the_spot) + ", " + with_line(largest, path, q.turn_on_the_spot_rad.move);
      });
    }
    add(table, "J, the integral of |u''|² of the axis u, in rad²/" + unit + "³",
        [&](const AxisQuality& q, const Toolpath&) { return bending_text(q.bending, unit_); });
  }

  void add_positions(HtmlTable& table) const {
    const auto after_alone = [&](const std::string& what, const std::string& value) {
      table.add(html_cell(what) + html_cell("", "n") + html_cell(value, "n"));
    };
    const std::size_t inserted = inserted_positions(model_.correction);
    after_alone("Positions moved, inserted",
                std::to_string(moved_positions(model_.correction)) + ", " + std::to_string(inserted));
    const AxisTilts& tilts = axes_.tilts;
    if (tilts.positions == 0) return;
    after_alone("Positions with a tilted axis", std::to_string(tilts.positions));
    after_alone("Largest tilt",
                with_line(angle_text(tilts.tilt_rad.value, DegreeSign::sign), *model_.toolpath, tilts.tilt_rad.move));
  }

  [[nodiscard]] std::string chart(const TiltedRun& run) const {
    const std::string svg = axis_chart(run, unit_);
    if (svg.empty()) return {};
    const Moves& moves = model_.toolpath->moves;
    const std::size_t first = moves[run.first].line, last = moves[run.last - 1].line;
    const std::string lines = first == last ? "Line " + std::to_string(first)
                                            : "Lines " + std::to_string(first) + " to " + std::to_string(last);
    // Two decimals of a millimetre are enough of a length that people compare with others.
    const std::string length =
        people_text((run.end_mm - run.begin_mm) / mm_per(unit_), facts_of(unit_).decimals - 1) + " " + unit_name(unit_);
    const std::string caption =
        lines + ": " + count_text(run.last - run.first, "move") + " over " + length + ", tilted by up to " +
        with_line(angle_text(run.tilt_rad.value, DegreeSign::sign), *model_.toolpath, run.tilt_rad.move);
    return "<figure>" + svg + "<figcaption>" + xml_escaped(caption) + "</figcaption></figure>\n";
  }

  [[nodiscard]] std::string charts() const {
    const AxisTilts& tilts = axes_.tilts;
    if (tilts.runs.empty()) return {};
    std::string out =
        "<p class=\"soft\">The axis along the corrected path, one picture for each run of tilted axes, beside the axis "
        "that was programmed there. Angles are measured from the mean of the programmed axes of the run: lead towards "
        "the feed, side to the left of it. Where the feed turns a corner, both jump.</p>\n";
    for (const TiltedRun& run : tilts.runs) out += chart(run);
    if (tilts.runs_left_out > 0)
      out += "<p class=\"soft\">and " + count_text(tilts.runs_left_out, "shorter run") + "</p>\n";
    return out;
  }

  const ReportModel& model_;
  const AxisFacts& axes_;
  const Toolpath& before_;
  LengthUnit unit_;
};

}  // namespace

std::string axis_section(const ReportModel& model) {
  if (!model.correction.axes || !model.correction.axes->is_of_interest()) return {};
  return AxisSection(model).html();
}

}  // namespace gouge
