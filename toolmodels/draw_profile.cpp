#include "toolmodels/draw_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/draw_parts.h"
#include "toolmodels/offset_curves.h"

namespace gouge {
namespace {

using detail::ProfileView;

constexpr double kWidth = 1500, kHeight = 1000;
constexpr double kProfileTop = 120, kProfileBottom = 930;  // vertical extent of both panels
constexpr double kAssemblyMiddle = 430;                    // horizontal position of the axis in the left panel
constexpr double kTipLeft = 880, kTipRight = 1460;
constexpr Colour kProfileInk{25, 28, 35, 1};
constexpr Colour kProfileFaint{120, 124, 132, 1};

class Sheet {
 public:
  Sheet(const ToolAssembly& tool, const BodyProfiles& bodies, const Profile& profile, LengthUnit unit)
      : tool_(tool), bodies_(bodies), profile_(profile), compiled_(compile_tool(label(tool), profile)), unit_(unit) {}

  Drawing draw() {
    drawing_.width = kWidth;
    drawing_.height = kHeight;
    draw_title();
    draw_assembly();
    draw_tip();
    return std::move(drawing_);
  }

 private:
  [[nodiscard]] std::string length(double value_mm) const {
    const double digits = unit_ == LengthUnit::inch ? 1e4 : 1e3;
    return exact_text(std::round(value_mm / mm_per(unit_) * digits) / digits);
  }

  void draw_title() {
    detail::draw_text(drawing_, {40, 48}, label(tool_), 26, TextAnchor::left, true);
    std::string facts = describe_cutter(tool_.cutter, unit_) + ", length " + length(length_mm(tool_.cutter)) +
                        ", assembly " + length(compiled_.z_max_mm) + " " + unit_name(unit_);
    if (tool_.stickout_mm > 0) facts += ", stick-out " + length(tool_.stickout_mm);
    if (tool_.gauge_length_mm > 0) facts += ", gauge length " + length(tool_.gauge_length_mm);
    if (tool_.holder.empty()) facts += ", no holder";
    detail::draw_text(drawing_, {40, 78}, facts, 16, TextAnchor::left);
    detail::draw_line(drawing_, {40, 94}, {kWidth - 40, 94}, kProfileFaint, 1);
    detail::draw_text(drawing_, {40, kHeight - 24},
                      "Tinted: the region of each boundary element (Voronoi diagram of the profile). Arrows: the way "
                      "out for a point at their tail.",
                      14, TextAnchor::left);
    detail::draw_text(drawing_, {kWidth - 40, kHeight - 24},
                      unit_ == LengthUnit::inch ? "dimensions in inches" : "dimensions in mm", 14, TextAnchor::right);
  }

  // ---- left panel

  void draw_assembly() {
    const double height = compiled_.z_max_mm - compiled_.z_min_mm;
    ProfileView view;
    view.scale = std::min(0.96 * (kProfileBottom - kProfileTop) / height, 225 / compiled_.r_max_mm);
    view.low = Vec2(0, compiled_.z_min_mm);
    view.high = Vec2(compiled_.r_max_mm, compiled_.z_max_mm);
    const double middle = 0.5 * (kProfileTop + kProfileBottom);
    view.origin = Vec2(kAssemblyMiddle, middle + 0.5 * view.scale * (compiled_.z_max_mm + compiled_.z_min_mm));
    fill_bodies(view);
    detail::draw_regions(drawing_, compiled_, view, false);
    detail::draw_contour(drawing_, profile_, view, 2);
    detail::draw_line(drawing_, view.at(Vec2(0, view.high.y())) - Vec2(0, 22),
                      view.at(Vec2(0, view.low.y())) + Vec2(0, 22), kProfileFaint, 1, {14, 4, 3, 4});
    draw_lengths(view);
    draw_diameters(view);
  }

  void fill_bodies(const ProfileView& view) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i].elements.empty()) continue;
      DrawnShape shape;
      shape.fill = detail::lightened(detail::body_colour(static_cast<Body>(i)), 0.25);
      for (const ProfileElement& e : bodies_[i].elements)
        for (const Vec2& p : sample(e, 48)) shape.points.push_back(view.mirrored(p));
      DrawnLine outline{shape.points, kProfileInk, 1.2, false, {}};
      drawing_.items.emplace_back(std::move(shape));
      drawing_.items.emplace_back(std::move(outline));
    }
  }

  void draw_length(const ProfileView& view, double x, double low, double high, const std::string& text) {
    const Vec2 from(x, view.at(Vec2(0, low)).y()), to(x, view.at(Vec2(0, high)).y());
    const double gap = from.y() - to.y();
    if (gap > 16) {
      const double half = std::min(0.5 * gap, 12.0);
      const Vec2 middle = 0.5 * (from + to);
      detail::draw_arrow(drawing_, middle + Vec2(0, half - 1), from, kProfileInk, 1);
      detail::draw_arrow(drawing_, middle - Vec2(0, half - 1), to, kProfileInk, 1);
    }
    for (const Vec2& end : {from, to}) detail::draw_line(drawing_, end - Vec2(7, 0), end + Vec2(7, 0), kProfileInk, 1);
    detail::draw_text(drawing_, {x - 9, 0.5 * (from.y() + to.y()) + 5}, text, 14, TextAnchor::right);
  }

  // Draws the lengths of the bodies one above the other, and the length of the whole tool to the left of them.
  void draw_lengths(const ProfileView& view) {
    const double left = view.mirrored(Vec2(compiled_.r_max_mm, 0)).x() - 30;
    double bodies_drawn = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i].elements.empty()) continue;
      const double high = bodies_[i].elements.back().b.y();
      double low = i == 0 ? 0.0 : bodies_[i].elements.front().a.y();
      for (const ProfileElement& e : bodies_[i].elements) low = std::min({low, e.a.y(), e.b.y()});
      draw_length(view, left, low, high, std::string(body_name(static_cast<Body>(i))) + " " + length(high - low));
      ++bodies_drawn;
    }
    if (bodies_drawn > 1) draw_length(view, left - 110, 0, compiled_.z_max_mm, length(compiled_.z_max_mm));
  }

  struct Label {
    double y;
    Vec2 at;
    std::string text;
  };

  [[nodiscard]] std::string diameters(double lower, double upper) const {
    return std::abs(lower - upper) <= Tolerance::kRounding * upper ? "D " + length(upper)
                                                                   : "D " + length(lower) + " to " + length(upper);
  }

  // Returns the widest point of the flutes, which on an arc may lie between its ends.
  [[nodiscard]] Vec2 widest_of_cutter() const {
    Vec2 widest = Vec2::Zero();
    for (const ProfileElement& e : bodies_[0].elements)
      for (const Vec2& p : {e.a, e.b, Vec2(e.center + Vec2(e.radius_mm, 0))}) {
        const bool is_on_it =
            p == e.a || p == e.b ||
            (e.is_arc && !e.is_concave && detail::passes(e, p, Tolerance::kFewRoundings * compiled_.r_max_mm));
        if (is_on_it && p.x() > widest.x() + Tolerance::kRounding * compiled_.r_max_mm) widest = p;
      }
    return widest;
  }

  std::vector<Label> diameter_labels(const ProfileView& view) const {
    std::vector<Label> labels;
    const Vec2 top = bodies_[0].elements.back().a, widest = widest_of_cutter();
    const double below = std::max(0.7 * top.y(), top.y() - 8 / view.scale);
    const bool is_at_top = widest.x() <= top.x() * (1 + Tolerance::kRounding);
    const Vec2 at = view.at(is_at_top ? Vec2(top.x(), below) : widest);
    labels.push_back({at.y(), at, diameters(2 * widest.x(), 2 * widest.x())});
    for (const PositionedSegment& placed : position_segments(tool_)) {
      const ToolSegment& s = placed.segment;
      const Vec2 middle =
          view.at(Vec2(0.25 * (s.lower_diameter_mm + s.upper_diameter_mm), placed.z_mm + 0.5 * s.length_mm));
      const bool has_own_name = placed.name.rfind("shank", 0) != 0 && placed.name.rfind("holder", 0) != 0;
      labels.push_back(
          {middle.y(), middle,
           diameters(s.lower_diameter_mm, s.upper_diameter_mm) + (has_own_name ? "  " + placed.name : "")});
    }
    return labels;
  }

  // Writes the diameters at the right of the tool; labels of short segments are moved upwards, so that none overlap.
  void draw_diameters(const ProfileView& view) {
    const double x = view.at(Vec2(compiled_.r_max_mm, 0)).x() + 34;
    double lowest = kProfileBottom + 40;
    for (Label label : diameter_labels(view)) {
      label.y = std::min(label.y, lowest - 20);
      lowest = label.y;
      const Colour thin{120, 124, 132, 1};
      drawing_.items.emplace_back(DrawnLine{{label.at, {x - 20, label.y}, {x - 4, label.y}}, thin, 1, false, {}});
      detail::draw_text(drawing_, {x, label.y + 5}, label.text, 14, TextAnchor::left);
    }
  }

  // ---- right panel

  void draw_tip() {
    const Vec2 widest = widest_of_cutter();
    const auto [low, high] = heights_of_tip();
    ProfileView view;
    const double tall = kProfileBottom - kProfileTop;
    view.scale = std::min((kTipRight - kTipLeft) / (1.45 * widest.x()),
                          0.72 * tall / std::max(high - low, Tolerance::kRounding));
    view.origin = Vec2(kTipLeft, kProfileBottom - 0.17 * tall + view.scale * low);
    view.low = Vec2(0, (view.origin.y() - kProfileBottom) / view.scale);
    view.high = Vec2((kTipRight - kTipLeft) / view.scale, (view.origin.y() - kProfileTop) / view.scale);
    detail::draw_regions(drawing_, compiled_, view, true);
    detail::draw_exit_arrows(drawing_, compiled_, view, 44);
    detail::draw_contour(drawing_, profile_, view, 2.5);
    const Vec2 frame[] = {
        {kTipLeft, kProfileTop}, {kTipRight, kProfileTop}, {kTipRight, kProfileBottom}, {kTipLeft, kProfileBottom}};
    drawing_.items.emplace_back(DrawnLine{{frame, frame + 4}, kProfileFaint, 1, true, {}});
    detail::draw_line(drawing_, frame[0], frame[3], kProfileFaint, 1.5, {14, 4, 3, 4});
    draw_scale_bar(view);
    draw_corner(view);
    draw_radius(view, widest);
  }

  // Returns the range of heights of the flutes without their straight side.
  [[nodiscard]] std::pair<double, double> heights_of_tip() const {
    double low = 0, high = 0;
    const std::vector<ProfileElement>& flutes = bodies_[0].elements;
    for (std::size_t i = 0; i + 1 < flutes.size(); ++i)
      for (const Vec2& p : sample(flutes[i], 24)) {
        low = std::min(low, p.y());
        if (flutes[i].is_arc || p == flutes[i].a) high = std::max(high, p.y());
      }
    return {low, high};
  }

  // Draws the length from the axis to the widest point, below the tip.
  void draw_radius(const ProfileView& view, const Vec2& widest) {
    const double y = kProfileBottom - 56;
    const Vec2 from(kTipLeft, y), to(view.at(widest).x(), y);
    const Vec2 above(to.x(), std::max(view.at(widest).y() + 4, kProfileTop));
    detail::draw_line(drawing_, above, to + Vec2(0, 8), kProfileFaint, 1, {4, 4});
    detail::draw_arrow(drawing_, to - Vec2(60, 0), to, kProfileInk, 1);
    detail::draw_line(drawing_, from, to - Vec2(60, 0), kProfileInk, 1);
    // The title gives the nominal diameter, which for a tapered tool differs from the diameter at the widest point.
    const bool is_nominal = std::abs(nominal_size(tool_.cutter).diameter_mm - 2 * widest.x()) < 1e-3;
    detail::draw_text(drawing_, {0.5 * (from.x() + to.x()), y - 6},
                      (is_nominal ? "D/2 = " : "widest D/2 = ") + length(widest.x()), 15, TextAnchor::middle, true);
  }

  void draw_scale_bar(const ProfileView& view) {
    const double wanted = 110 / view.scale / mm_per(unit_);
    double bar = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double factor : {5.0, 2.0})
      if (factor * bar <= wanted) {
        bar *= factor;
        break;
      }
    const double pixels = bar * mm_per(unit_) * view.scale;
    const Vec2 left(kTipRight - 20 - pixels, kProfileBottom - 18);
    detail::draw_line(drawing_, left, left + Vec2(pixels, 0), kProfileInk, 3);
    detail::draw_text(drawing_, left + Vec2(pixels / 2, -8),
                      exact_text(std::round(bar * 1e6) / 1e6) + " " + unit_name(unit_), 14, TextAnchor::middle);
  }

  void draw_corner(const ProfileView& view) {
    for (const ProfileElement& e : bodies_[0].elements) {
      const Vec2 direction = start_direction(e);
      if (e.is_arc) {
        const Vec2 middle = sample(e, 2)[1];
        const Vec2 from = view.at(middle), to = from + Vec2(60, 50);
        detail::draw_arrow(drawing_, to, from, kProfileInk, 1.2);
        detail::draw_text(drawing_, to + Vec2(4, 6), "R " + length(e.radius_mm), 15, TextAnchor::left, true);
      } else if (direction.y() > 0.02 && std::abs(direction.x()) > Tolerance::kRounding) {
        draw_slope(view, e, direction);
      }
    }
  }

  void draw_slope(const ProfileView& view, const ProfileElement& e, const Vec2& direction) {
    const double from_axis = std::atan2(direction.x(), direction.y()) * 180 / 3.14159265358979323846;
    const Vec2 low = view.at(e.a);
    const Vec2 high = view.at(e.b);
    const double y = std::max(0.5 * (low.y() + high.y()), kProfileTop + 60);
    const double t = std::clamp((y - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    const Vec2 at = low + t * (high - low);
    const std::string text = exact_text(std::round(from_axis * 1e3) / 1e3) + " deg from the axis";
    const bool is_steep = std::abs(from_axis) > 45;
    const Vec2 to = at + (is_steep ? Vec2(30, 44) : Vec2(30, -20));
    detail::draw_arrow(drawing_, to, at, kProfileInk, 1.2);
    detail::draw_text(drawing_, to + Vec2(4, 5), text, 15, TextAnchor::left, true);
  }

  const ToolAssembly& tool_;
  const BodyProfiles& bodies_;
  const Profile& profile_;
  CompiledTool compiled_;
  LengthUnit unit_;
  Drawing drawing_;
};

}  // namespace

Result<Drawing> draw_profile(const ToolAssembly& tool, LengthUnit unit) {
  const Result<BodyProfiles> bodies = make_body_profiles(tool);
  if (!bodies) return bodies.error();
  const Result<Profile> profile = make_profile(tool);
  if (!profile) return profile.error();
  return Sheet(tool, *bodies, *profile, unit).draw();
}

}  // namespace gouge
