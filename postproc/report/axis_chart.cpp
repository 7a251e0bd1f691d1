#include "postproc/report/axis_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kWidth = 1030, kLeft = 76, kRight = 14;
constexpr double kTop = 34, kPanel = 132, kBetween = 16, kBottom = 44;
constexpr double kHeight = kTop + 2 * kPanel + kBetween + kBottom;
constexpr double kLeastSpan_deg = 2, kAir = 0.08;
constexpr double kLeastLength = 1e-6;

using Series = double TiltPlace::*;
constexpr std::array<Series, 4> kSeries = {&TiltPlace::lead_before_rad, &TiltPlace::side_before_rad,
                                           &TiltPlace::lead_after_rad, &TiltPlace::side_after_rad};

std::string number(double value) { return people_text(value, 1); }

/// 1, 2 or 5 times a power of ten, so that at most `most` of them make `span`.
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
    if (!(length_ > kLeastLength) || !std::isfinite(length_)) return {};
    keep_what_shows();
    const std::string size = number(kWidth) + " " + number(kHeight);
    std::string out = "<svg class=\"axes\" viewBox=\"0 0 " + size + "\" role=\"img\" aria-label=\"Lead and side tilt " +
                      "over the length of the path\">\n";
    Range lead = range(kSeries[0], kSeries[2]), side = range(kSeries[1], kSeries[3]);
    // One span for both, so that slopes compare.
    const double span = std::max({lead.high - lead.low, side.high - side.low, kLeastSpan_deg}) * (1 + 2 * kAir);
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

  /// Places that change the picture: more than a pixel can hold are as good as these.
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
             words(kLeft - 8, y + 4.5, "end", people_text(k * step, tick_decimals(step)) + "°");
    }
    const double along = tick_step(length_ / scale_, 12);
    for (double k = 0; k * along * scale_ <= length_ * (1 + Tolerance::kRounding); ++k) {
      const double x = x_of(k * along * scale_);
      out += line(x, bottom, x, bottom + 4, "frame");
      if (is_lowest) out += words(x, bottom + 18, "middle", people_text(k * along, tick_decimals(along)));
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

}  // namespace gouge
