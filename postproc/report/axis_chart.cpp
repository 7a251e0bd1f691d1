#include "postproc/report/axis_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kWidth = 1030, kLeft = 76, kRight = 14;
constexpr double kTop = 34, kPanel = 132, kBetween = 16, kBottom = 44;
constexpr double kHeight = kTop + 2 * kPanel + kBetween + kBottom;
constexpr double kMinSpan_deg = 2, kAir = 0.08;
constexpr double kMinLength = 1e-6;

using Series = double TiltPlace::*;
constexpr std::array<Series, 4> kSeries = {&TiltPlace::lead_before_rad, &TiltPlace::side_before_rad,
                                           &TiltPlace::lead_after_rad, &TiltPlace::side_after_rad};

std::string number(double value) { return display_text(value, 1); }

/// Returns a step of 1, 2 or 5 times a power of ten, such that at most `most` steps fill `span`.
double tick_step(double span, double most) {
  double power = 1;
  while (power * most > span) power /= 10;
  while (power * 10 * most <= span) power *= 10;
  for (const double times : {1.0, 2.0, 5.0}) {
    if (power * times * most >= span) return power * times;
  }
  return power * 10;
}

int tick_decimals(double step) {
  int decimals = 0;
  for (double x = step; x < 0.999 && decimals < 9; x *= 10) ++decimals;
  return decimals;
}

/// Range of the angles of one panel, in degrees.
struct Range {
  double low = 0, high = 0;

  void take(double angle) {
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  void widen_to(double span) {
    const double middle = (low + high) / 2;
    low = middle - span / 2;
    high = middle + span / 2;
  }
};

class AxisChart {
 public:
  AxisChart(const TiltedRun& run, LengthUnit unit) : run_(run), unit_(unit), scale_(mm_per(unit)) {
    length_ = run.curve.empty() ? 0 : run.curve.back().length_mm;
  }

  [[nodiscard]] std::string svg() {
    if (!(length_ > kMinLength) || !std::isfinite(length_)) return {};
    keep_what_shows();
    const std::string size = number(kWidth) + " " + number(kHeight);
    std::string out = "<svg class=\"axes\" viewBox=\"0 0 " + size + "\" role=\"img\" aria-label=\"Lead and side tilt " +
                      "over the length of the path\">\n";
    Range lead = range(kSeries[0], kSeries[2]), side = range(kSeries[1], kSeries[3]);
    // Both panels have the same span, so that slopes are comparable.
    const double span = std::max({lead.high - lead.low, side.high - side.low, kMinSpan_deg}) * (1 + 2 * kAir);
    lead.widen_to(span);
    side.widen_to(span);
    out += legend() + panel(kTop, "lead", lead, kSeries[0], kSeries[2], false) +
           panel(kTop + kPanel + kBetween, "side", side, kSeries[1], kSeries[3], true);
    return out + "</svg>\n";
  }

 private:
  [[nodiscard]] double x_of(double length_mm) const {
    return kLeft + (kWidth - kLeft - kRight) * std::clamp(length_mm / length_, 0.0, 1.0);
  }
  [[nodiscard]] static double y_of(double top, const Range& range, double angle) {
    return top + kPanel * (range.high - angle) / (range.high - range.low);
  }

  /// Keeps the places that change the picture. More places than a pixel can show would not change it.
  void keep_what_shows() {
    const std::vector<TiltPlace>& all = run_.curve;
    for (std::size_t from = 0; from < all.size();) {
      const double column = std::floor(x_of(all[from].length_mm));
      std::size_t to = from + 1;
      while (to < all.size() && !(std::floor(x_of(all[to].length_mm)) > column)) ++to;
      std::vector<std::size_t> kept = {from, to - 1};
      for (const Series series : kSeries) {
        const auto less = [&](const TiltPlace& a, const TiltPlace& b) { return a.*series < b.*series; };
        const auto [least, most] = std::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(from),
                                                       all.begin() + static_cast<std::ptrdiff_t>(to), less);
        kept.push_back(static_cast<std::size_t>(least - all.begin()));
        kept.push_back(static_cast<std::size_t>(most - all.begin()));
      }
      std::sort(kept.begin(), kept.end());
      kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
      for (const std::size_t i : kept) shown_.push_back(all[i]);
      from = to;
    }
  }

  [[nodiscard]] Range range(Series before, Series after) const {
    const double first = shown_.front().*before * kDegrees;
    Range range{first, first};
    for (const TiltPlace& place : shown_) {
      range.take(place.*before * kDegrees);
      range.take(place.*after * kDegrees);
    }
    return range;
  }

  [[nodiscard]] std::string points(double top, const Range& range, Series series, bool is_backward = false) const {
    std::string out;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      const TiltPlace& place = shown_[is_backward ? shown_.size() - 1 - i : i];
      out +=
          (i > 0 ? " " : "") + number(x_of(place.length_mm)) + "," + number(y_of(top, range, place.*series * kDegrees));
    }
    return out;
  }

  [[nodiscard]] static std::string line(double x1, double y1, double x2, double y2, const char* css) {
    return "<line class=\"" + std::string(css) + "\" x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" +
           number(x2) + "\" y2=\"" + number(y2) + "\"/>\n";
  }
  [[nodiscard]] static std::string box(double x, double y, double width, double height, const char* css) {
    return "<rect class=\"" + std::string(css) + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" +
           number(width) + "\" height=\"" + number(height) + "\"/>\n";
  }
  [[nodiscard]] static std::string words(double x, double y, const char* anchor, const std::string& text) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
  }

  [[nodiscard]] static std::string legend() {
    constexpr double kMiddle = 15, kBaseLine = 19.5;
    return line(kLeft, kMiddle, kLeft + 34, kMiddle, "before") + words(kLeft + 41, kBaseLine, "start", "before") +
           line(kLeft + 110, kMiddle, kLeft + 144, kMiddle, "after") + words(kLeft + 151, kBaseLine, "start", "after") +
           box(kLeft + 208, kMiddle - 7, 30, 14, "tilted") +
           words(kLeft + 245, kBaseLine, "start", "moves with a tilted axis");
  }

  [[nodiscard]] std::string panel(double top, const std::string& name, const Range& range, Series before, Series after,
                                  bool is_lowest) const {
    const double right = kWidth - kRight, bottom = top + kPanel;
    std::string out = box(x_of(run_.begin_mm), top, x_of(run_.end_mm) - x_of(run_.begin_mm), kPanel, "tilted");
    const double step = tick_step(range.high - range.low, 5);
    for (double k = std::ceil(range.low / step); k * step <= range.high; ++k) {
      const double y = y_of(top, range, k * step);
      out += line(kLeft, y, right, y, std::abs(k) < 0.5 ? "zero" : "grid") +
             words(kLeft - 8, y + 4.5, "end", display_text(k * step, tick_decimals(step)) + "°");
    }
    const double along = tick_step(length_ / scale_, 12);
    for (double k = 0; k * along * scale_ <= length_ * (1 + Tolerance::kRounding); ++k) {
      const double x = x_of(k * along * scale_);
      out += line(x, bottom, x, bottom + 4, "frame");
      if (is_lowest) out += words(x, bottom + 18, "middle", display_text(k * along, tick_decimals(along)));
    }
    out += "<polygon class=\"gap\" points=\"" + points(top, range, before) + " " + points(top, range, after, true) +
           "\"/>\n<polyline class=\"before\" points=\"" + points(top, range, before) +
           "\"/>\n<polyline class=\"after\" points=\"" + points(top, range, after) + "\"/>\n";
    out += box(kLeft, top, right - kLeft, kPanel, "frame");
    const double middle = (top + bottom) / 2;
    out += "<text class=\"name\" transform=\"translate(16 " + number(middle) +
           ") rotate(-90)\" text-anchor=\"middle\">" + name + " tilt</text>\n";
    if (is_lowest)
      out +=
          words((kLeft + right) / 2, bottom + 38, "middle", "length of the path in " + std::string(unit_words(unit_)));
    return out;
  }

  const TiltedRun& run_;
  LengthUnit unit_;
  double scale_, length_ = 0;
  std::vector<TiltPlace> shown_;
};

}  // namespace

std::string axis_chart(const TiltedRun& run, LengthUnit unit) { return AxisChart(run, unit).svg(); }

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
      add(table, "Feed time, turning by at most " + display_text(*axes_.max_rotary_deg_per_min, 3) + "°/min",
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
    // Two decimals of a millimetre are sufficient for a length that people compare with others.
    const std::string length = display_text((run.end_mm - run.begin_mm) / mm_per(unit_), facts_of(unit_).decimals - 1) +
                               " " + unit_name(unit_);
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
