#include "postproc/image/page.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/printable_text.h"
#include "lib/base/tolerance.h"
#include "postproc/image/render_drawing.h"
#include "postproc/report/report_text.h"

namespace gouge {

void Page::line(const Vec2& a, const Vec2& b, const Colour& colour, double width, std::vector<double> dashes) {
  drawing.items.emplace_back(DrawnLine{{a, b}, colour, width, false, std::move(dashes)});
}

void Page::shape(std::vector<Vec2> points, const Colour& fill) {
  drawing.items.emplace_back(DrawnShape{std::move(points), fill});
}

void Page::box(const Area& a, const Colour& fill) {
  shape({{a.x, a.y}, {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}}, fill);
}

void Page::frame(const Area& a, const Colour& colour, double width) {
  drawing.items.emplace_back(
      DrawnLine{{{a.x, a.y}, {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}}, colour, width, true, {}});
}

void Page::disc(const Vec2& centre, double radius, const Colour& fill) {
  std::vector<Vec2> points;
  for (int k = 0; k < 48; ++k) {
    const double angle = 2 * std::numbers::pi * k / 48;
    points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  shape(std::move(points), fill);
}

void Page::text(const Vec2& at, const std::string& words, double size, const Colour& colour, TextAnchor anchor,
                bool is_bold) {
  drawing.items.emplace_back(DrawnText{at, words, size, colour, anchor, is_bold});
}

void Page::number_on_disc(const Vec2& centre, double radius, std::size_t number, const Colour& colour) {
  const std::string words = std::to_string(number);
  const double size = fitting_size(words, radius + 2, 1.65 * radius, true);
  text(centre + Vec2(0, 0.4 * radius), words, size, colour, TextAnchor::middle, true);
}

namespace {

bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

// Returns both ends of a text, without the remaining digits of a number that the cut divides.
std::string without_middle(const std::string& text, std::size_t head, std::size_t tail) {
  while (head > 0 && is_of_number(text[head - 1]) && is_of_number(text[head])) --head;
  while (tail < text.size() && is_of_number(text[tail]) && is_of_number(text[tail - 1])) ++tail;
  return text.substr(0, head) + "..." + text.substr(tail);
}

}  // namespace

std::string fitted(const std::string& words, double size, double width, bool is_bold) {
  const std::string text = printable(words);
  const auto begins_letter = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U; };
  if (text_width(text, size, is_bold) <= width) return text;
  for (std::size_t keep = text.size(); keep > 2; --keep) {
    std::size_t head = (keep + 1) / 2, tail = text.size() - (keep - head);
    while (head > 0 && !begins_letter(head)) --head;
    while (tail < text.size() && !begins_letter(tail)) ++tail;
    const std::string cut = without_middle(text, head, tail);
    if (text_width(cut, size, is_bold) <= width) return cut;
  }
  return {};
}

double fitting_size(const std::string& words, double size, double width, bool is_bold) {
  return size * std::min(1.0, width / std::max(text_width(words, size, is_bold), Tolerance::kSamePoint_mm));
}

Page make_page(const std::string& title, const std::string& verdict, const Colour& verdict_colour,
               const std::vector<std::string>& lines) {
  Page page;
  page.drawing.width = kPageWidth;
  page.drawing.height = kPageHeight;
  const double verdict_width = verdict.empty() ? 0 : text_width(verdict, 19, true) + 36;
  page.text({36, 46}, fitted(title, 27, kPageWidth - 100 - verdict_width, true), 27, kInk, TextAnchor::left, true);
  if (!verdict.empty()) {
    const Area badge{kPageWidth - 36 - verdict_width, 20, verdict_width, 36};
    page.box(badge, verdict_colour);
    page.text({badge.middle().x(), badge.y + 25}, verdict, 19, kWhite, TextAnchor::middle, true);
  }
  double y = 74;
  for (const std::string& line : lines) {
    page.text({36, y}, fitted(line, 15.5, kPageWidth - 72), 15.5, kSoftInk);
    y += 22;
  }
  page.line({36, 104}, {kPageWidth - 36, 104}, kHairline, 1);
  return page;
}

void add_colour_bar(Page& page, const Area& area, const ColourScale& scale, LengthUnit unit, const std::string& title) {
  const auto y_of = [&](double depth_mm) { return area.bottom() - area.height * scale.place(depth_mm); };
  page.box(area, kPartGrey);
  const int strips = static_cast<int>(area.height);
  for (int k = 0; k < strips; ++k) {
    const double depth_mm = scale.depth_at((area.height - k - 0.5) / area.height);
    if (depth_mm > scale.low_mm) page.box({area.x, area.y + k, area.width, 1.0}, scale.at(depth_mm));
  }
  page.frame(area, kSoftInk, 1);
  page.text({area.x, area.y - 32}, title, 15, kInk, TextAnchor::left, true);
  page.text({area.x, area.y - 13}, std::string("in ") + unit_words(unit), 14, kSoftInk);
  const double tolerance_y = y_of(scale.low_mm);
  for (const Tick& tick : make_ticks(scale, unit, 26 / area.height)) {
    const double y = y_of(tick.depth_mm);
    if (scale.low_mm > 0 && std::abs(y - tolerance_y) < 15) continue;
    page.line({area.right(), y}, {area.right() + 6, y}, kSoftInk, 1);
    page.text({area.right() + 11, y + 5}, tick.text, 15, kInk);
  }
  if (scale.low_mm > 0) {
    page.line({area.x - 5, tolerance_y}, {area.right() + 6, tolerance_y}, kInk, 1.5);
    page.text({area.right() + 11, tolerance_y + 5}, "tolerance", 14, kInk);
  }
}

void add_left_bar(Page& page, const Area& area, const ColourScale& scale, LengthUnit unit) {
  const ColourScale left = left_scale(scale);
  const auto y_of = [&](double height_mm) { return area.y + area.height * left.place(height_mm); };
  page.box(area, kPartGrey);
  const int strips = static_cast<int>(area.height);
  for (int k = 0; k < strips; ++k) {
    const double height_mm = left.depth_at((k + 0.5) / area.height);
    if (height_mm > left.low_mm) page.box({area.x, area.y + k, area.width, 1.0}, scale.at(-height_mm));
  }
  page.frame(area, kSoftInk, 1);
  const double asked_y = y_of(left.low_mm);
  for (const Tick& tick : make_ticks(left, unit, 26 / area.height)) {
    const double y = y_of(tick.depth_mm);
    if (std::abs(y - asked_y) < 15 || !(tick.depth_mm > 0)) continue;
    page.line({area.right(), y}, {area.right() + 6, y}, kSoftInk, 1);
    page.text({area.right() + 11, y + 5}, tick.text, 15, kInk);
  }
  page.line({area.x - 5, asked_y}, {area.right() + 6, asked_y}, kInk, 1.5);
  page.text({area.right() + 11, asked_y + 5}, "asked", 14, kInk);
}

namespace {

struct ScaleBar {
  double width = 0;
  std::string words;
};

ScaleBar scale_bar(const View& view, LengthUnit unit, double max_width) {
  const double unit_per_picture = view.mm_per_pixel * kSupersampling / mm_per(unit);
  const double length = round_down(max_width * unit_per_picture);
  return {length / unit_per_picture, tick_text(length, length) + " " + unit_name(unit)};
}

}  // namespace

double scale_bar_width(const View& view, LengthUnit unit, double max_width) {
  const ScaleBar bar = scale_bar(view, unit, max_width);
  return bar.width + 10 + text_width(bar.words, 15);
}

void add_scale_bar(Page& page, const Vec2& at, const View& view, LengthUnit unit, double max_width) {
  const auto [width, words] = scale_bar(view, unit, max_width);
  page.line(at, at + Vec2(width, 0), kInk, 2);
  page.line(at + Vec2(0, -5), at + Vec2(0, 5), kInk, 2);
  page.line(at + Vec2(width, -5), at + Vec2(width, 5), kInk, 2);
  page.text(at + Vec2(width + 10, 5), words, 15, kInk);
}

void add_triad(Page& page, const Vec2& at, const View& view, double size) {
  struct Axis {
    Vec3 direction;
    const char* name;
    Colour colour;
  };
  std::vector<Axis> axes{{Vec3::UnitX(), "X", {192, 57, 43, 1}},
                         {Vec3::UnitY(), "Y", {39, 134, 74, 1}},
                         {Vec3::UnitZ(), "Z", {36, 93, 173, 1}}};
  // The axis that points at the viewer is painted last.
  std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
    const double za = a.direction.dot(view.toward);
    const double zb = b.direction.dot(view.toward);
    return za < zb || (!(zb < za) && a.name[0] < b.name[0]);
  });
  for (const Axis& axis : axes) {
    const Vec2 d(axis.direction.dot(view.right), -axis.direction.dot(view.up));
    const Vec2 tip = at + size * d;
    page.line(at, tip, axis.colour, 2.5);
    const double length = d.norm();
    if (length < 0.12) {
      page.disc(at, 3.5, axis.colour);
      continue;
    }
    const Vec2 along = d / length;
    const Vec2 across(-along.y(), along.x());
    page.shape({tip + 7 * along, tip + 4 * across, tip - 4 * across}, axis.colour);
    page.text(tip + 17 * along + Vec2(0, 5), axis.name, 14, axis.colour, TextAnchor::middle, true);
  }
}

namespace {

bool overlaps(const Area& a, const Area& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace

void add_marker(Page& page, const Area& area, const Vec2& target, std::size_t number, bool is_hidden) {
  constexpr double kRadius = 14;
  Vec2 best = target + Vec2(40, -40);
  bool is_found = false;
  for (const double distance : {44.0, 60.0, 80.0, 105.0, 135.0, 170.0}) {
    for (int k = 0; k < 16 && !is_found; ++k) {
      // The first place is up and to the right; the next ones alternate between both sides of that direction.
      const double turn = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2) * std::numbers::pi / 8;
      const double angle = -std::numbers::pi / 4 + turn;
      const Vec2 centre = target + distance * Vec2(std::cos(angle), std::sin(angle));
      const Area spot{centre.x() - kRadius - 3, centre.y() - kRadius - 3, 2 * kRadius + 6, 2 * kRadius + 6};
      const bool is_inside =
          spot.x >= area.x && spot.y >= area.y && spot.right() <= area.right() && spot.bottom() <= area.bottom();
      const bool is_free = std::ranges::none_of(page.taken, [&](const Area& other) { return overlaps(spot, other); });
      if (!is_inside || !is_free) continue;
      best = centre;
      is_found = true;
      page.taken.push_back(spot);
    }
    if (is_found) break;
  }
  page.taken.push_back({target.x() - 8, target.y() - 8, 16, 16});
  const Vec2 along = (target - best).normalized();
  page.line(best + along * kRadius, target, {255, 255, 255, 0.85}, 4);
  page.line(best + along * kRadius, target, kInk, 1.6, is_hidden ? std::vector<double>{5, 4} : std::vector<double>{});
  page.disc(target, 4.5, kWhite);
  page.disc(target, 3, kInk);
  page.disc(best, kRadius, is_hidden ? kSoftInk : kInk);
  page.disc(best, kRadius - 2, is_hidden ? kWhite : kInk);
  page.number_on_disc(best, kRadius, number, is_hidden ? kSoftInk : kWhite);
}

}  // namespace gouge
