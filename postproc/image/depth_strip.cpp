#include "postproc/image/heat_map.h"

#include <algorithm>
#include <cmath>

#include "postproc/image/render_drawing.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr Colour kNotCheckedFill{226, 229, 233, 1};
constexpr Colour kNotCertifiedFill{252, 232, 190, 1};
constexpr Colour kBuriedFill{64, 20, 84, 1};
constexpr double kWithinTolerance = 0.5;  // opacity of the bars of moves that do not gouge

// A column of the strip shows one move, or the worst of several.
constexpr Colour kProvedFill{33, 125, 90, 0.30};

struct Column {
  double depth_mm = 0, upper_mm = 0;
  Body body = Body::cutter;
  bool is_gouge = false, is_not_checked = false, is_not_certified = false, is_buried = false;
};

class Strip {
 public:
  Strip(const PictureSet& set, const Area& area) : set_(set), area_(area) {
    const MoveVerdicts& verdicts = set.input.result->verdicts;
    moves_ = std::max<std::size_t>(verdicts.size(), 1);
    columns_.resize(std::min(moves_, static_cast<std::size_t>(area.width)));
    for (std::size_t i = 0; i < verdicts.size(); ++i) add(columns_[i * columns_.size() / moves_], verdicts[i]);
    const double worst = std::max(set.input.result->worst_depth_mm, 2 * set.model.options.tolerance_mm);
    scale_ = make_colour_scale(set.model.options.tolerance_mm, worst, set.model.toolpath->unit, 1.12);
  }

  [[nodiscard]] double x_of(double move) const { return area_.x + area_.width * move / static_cast<double>(moves_); }
  [[nodiscard]] double y_of(double depth_mm) const { return area_.bottom() - area_.height * scale_.place(depth_mm); }

  void draw(Page& page) const {
    draw_states(page);
    draw_grid(page);
    draw_bars(page);
    draw_tolerance(page);
    draw_markers(page);
  }

 private:
  static void add(Column& column, const MoveVerdict& verdict) {
    column.is_gouge = column.is_gouge || verdict.state == MoveState::gouge;
    column.is_buried = column.is_buried || verdict.state == MoveState::buried;
    column.is_not_checked = column.is_not_checked || verdict.state == MoveState::not_checked;
    column.is_not_certified = column.is_not_certified || verdict.state == MoveState::not_certified;
    if (verdict.depth_mm > column.depth_mm) {
      column.depth_mm = verdict.depth_mm;
      if (verdict.witness) column.body = verdict.witness->body;
    }
    column.upper_mm = std::max(column.upper_mm, verdict.depth_upper_mm);
  }

  [[nodiscard]] Area column_area(std::size_t first, std::size_t last) const {
    const double width = area_.width / static_cast<double>(columns_.size());
    return {area_.x + width * static_cast<double>(first), area_.y, width * static_cast<double>(last - first),
            area_.height};
  }

  // Draws neighbouring columns with the same state as one box, so that no seams show between them.
  template <class Flag>
  void draw_sections(Page& page, const Flag& has_flag, const Colour& fill) const {
    for (std::size_t i = 0; i < columns_.size();) {
      std::size_t j = i;
      while (j < columns_.size() && has_flag(columns_[j])) ++j;
      if (j > i) {
        Area area = column_area(i, j);
        area.width = std::max(area.width, 1.5);
        page.box(area, fill);
      }
      i = std::max(j, i + 1);
    }
  }

  void draw_states(Page& page) const {
    draw_sections(
        page, [](const Column& c) { return c.is_not_checked; }, kNotCheckedFill);
    draw_sections(
        page, [](const Column& c) { return c.is_not_certified; }, kNotCertifiedFill);
    draw_sections(
        page, [](const Column& c) { return c.is_buried; }, kBuriedFill);
  }

  void draw_grid(Page& page) const {
    const LengthUnit unit = set_.model.toolpath->unit;
    for (const Tick& tick : make_ticks(scale_, unit, 0.1)) {
      const double y = y_of(tick.depth_mm);
      page.line({area_.x, y}, {area_.right(), y}, kHairline, 1);
      page.text({area_.x - 10, y + 5}, tick.text, 15, kInk, TextAnchor::right);
    }
    const std::string title =
        "depth in " + std::string(unit_words(unit)) + (scale_.is_root ? ", square root scale" : "");
    page.text({area_.x - 62, area_.y - 16}, title, 15, kInk, TextAnchor::left, true);
    const double move_step = std::max(1.0, round_step(static_cast<double>(moves_), 10));
    for (int k = 0; k * move_step <= static_cast<double>(moves_) - 0.5; ++k) {
      const double x = x_of(k * move_step + 0.5);
      page.line({x, area_.bottom()}, {x, area_.bottom() + 6}, kSoftInk, 1);
      page.text({x, area_.bottom() + 24}, tick_text(k * move_step, move_step), 15, kInk, TextAnchor::middle);
    }
    page.text({area_.middle().x(), area_.bottom() + 50}, "move", 15, kInk, TextAnchor::middle, true);
  }

  void draw_bars(Page& page) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Column& c = columns_[i];
      Area bar = column_area(i, i + 1);
      if (bar.width > 6) {
        bar.x += 0.1 * bar.width;
        bar.width *= 0.8;
      }
      constexpr double kWidest = 90;
      bar.x += 0.5 * std::max(0.0, bar.width - kWidest);
      bar.width = std::clamp(bar.width, 1.0, kWidest);
      const double top = y_of(c.depth_mm);
      const double upper = std::isfinite(c.upper_mm) ? y_of(c.upper_mm) : area_.y;
      const Colour colour = body_colour(static_cast<int>(c.body));
      Colour pale = c.is_not_certified ? Colour{214, 150, 40, 0.55} : c.is_gouge ? colour : kProvedFill;
      if (c.is_gouge && !c.is_not_certified) pale.opacity = 0.22;
      if (c.upper_mm > c.depth_mm) page.box({bar.x, upper, bar.width, top - upper}, pale);
      if (!(c.depth_mm > 0)) continue;
      Colour solid = colour;
      if (!c.is_gouge) solid.opacity = kWithinTolerance;
      page.box({bar.x, top, bar.width, area_.bottom() - top}, solid);
    }
    page.line({area_.x, area_.bottom()}, {area_.right(), area_.bottom()}, kInk, 1.5);
  }

  void draw_tolerance(Page& page) const {
    const double tolerance_mm = set_.model.options.tolerance_mm;
    const double y = y_of(tolerance_mm);
    // For a clean move it is proved that its depth does not exceed this band.
    const double limit = y_of(tolerance_mm + set_.model.options.resolution_mm);
    page.box({area_.x, limit, area_.width, y - limit}, {178, 24, 43, 0.13});
    page.line({area_.x, y}, {area_.right() + 8, y}, kAlarm, 1.5, {9, 6});
    page.text({area_.right() + 14, y - 2}, "tolerance", 14, kAlarm);
    const std::string length = short_length_text(tolerance_mm, set_.model.toolpath->unit);
    const double left = area_.right() + 14;
    page.text({left, y + 15}, length, fitting_size(length, 14, kPageWidth - 8 - left), kAlarm);
  }

  void draw_markers(Page& page) const {
    std::vector<double> used;
    for (const PictureEvent& event : set_.events) {
      double x = x_of(static_cast<double>(event.event.worst_move) + 0.5);
      const double y = std::max(y_of(event.depth_mm) - 22, area_.y + 12);
      // Markers of neighbouring events are moved apart, so that they do not cover each other.
      for (int k = 1; k < 40; ++k) {
        const bool is_free = std::ranges::none_of(used, [&](double other) { return std::abs(other - x) < 27; });
        if (is_free) break;
        x = x_of(static_cast<double>(event.event.worst_move) + 0.5) + (k % 2 == 0 ? 1 : -1) * 14 * ((k + 1) / 2);
        x = std::clamp(x, area_.x + 12, area_.right() - 12);
      }
      used.push_back(x);
      const double target = x_of(static_cast<double>(event.event.worst_move) + 0.5);
      page.line({x, y}, {target, y_of(event.depth_mm)}, kInk, 1.2);
      page.disc({x, y}, 12, kInk);
      page.number_on_disc({x, y}, 12, event.number, kWhite);
    }
  }

  const PictureSet& set_;
  Area area_;
  std::vector<Column> columns_;
  std::size_t moves_ = 1;
  ColourScale scale_;
};

// Draws the present operation and tool as a row of labelled spans above the strip.
void draw_operations(Page& page, const PictureSet& set, const Area& area) {
  const Toolpath& path = *set.input.toolpath;
  const Moves& moves = path.moves;
  bool is_even = false;
  for (std::size_t i = 0; i < moves.size();) {
    std::size_t j = i;
    while (j < moves.size() && moves[j].tool == moves[i].tool && moves[j].operation == moves[i].operation) ++j;
    const double first = area.x + area.width * static_cast<double>(i) / static_cast<double>(moves.size());
    const double last = area.x + area.width * static_cast<double>(j) / static_cast<double>(moves.size());
    const Area span{first, area.y, last - first, area.height};
    page.box(span, is_even ? Colour{226, 232, 238, 1} : Colour{238, 242, 246, 1});
    page.line({first, area.y}, {first, area.bottom()}, kSoftInk, 1);
    const std::string operation = operation_name(path, moves[i].operation);
    const std::string words = tool_label(path, moves[i].tool) + (operation.empty() ? "" : "  " + operation);
    const std::string number = operation.empty() ? std::string() : std::to_string(moves[i].operation + 1);
    if (text_width(words, 14) <= span.width - 14 || span.width > 110) {
      page.text({first + 8, area.y + 19}, fitted(words, 14, span.width - 14), 14, kInk);
    } else if (!number.empty() && text_width(number, 13) <= span.width - 4) {
      page.text({span.middle().x(), area.y + 19}, number, 13, kSoftInk, TextAnchor::middle);
    }
    is_even = !is_even;
    i = j;
  }
}

void draw_legend(Page& page, const PictureSet& set, double y) {
  double x = 100;
  const auto entry = [&](const Colour& colour, const std::string& words) {
    page.box({x, y - 12, 22, 14}, colour);
    page.text({x + 30, y}, words, 15, kInk);
    x += 30 + text_width(words, 15) + 34;
  };
  for (const Body body : {Body::cutter, Body::shank, Body::holder})
    entry(body_colour(static_cast<int>(body)), body_name(body));
  const MoveVerdicts& verdicts = set.input.result->verdicts;
  const bool has_head =
      std::ranges::any_of(verdicts, [](const MoveVerdict& v) { return v.witness && v.witness->body == Body::head; });
  if (has_head) entry(body_colour(static_cast<int>(Body::head)), body_name(Body::head));
  const auto shallow = std::ranges::find_if(
      verdicts, [](const MoveVerdict& v) { return v.state != MoveState::gouge && v.witness && v.depth_mm > 0; });
  if (shallow != verdicts.end()) {
    Colour paler = body_colour(static_cast<int>(shallow->witness->body));
    paler.opacity = kWithinTolerance;
    entry(paler, "paler: found within the tolerance");
  }
  const StateCounts& n = set.input.result->counts;
  const std::string limit =
      short_length_text(set.model.options.tolerance_mm + set.model.options.resolution_mm, set.model.toolpath->unit);
  if (n.clean > 0) entry(kProvedFill, "clean: proved to be no deeper than this, at most " + limit);
  if (n.not_checked > 0) entry(kNotCheckedFill, "not checked");
  if (n.not_certified > 0) entry(kNotCertifiedFill, "not certified");
  if (n.buried > 0) entry(kBuriedFill, "tool buried");
}

}  // namespace

Page draw_depth_strip(const PictureSet& set) {
  Page page = make_page("Depth along the path", badge_text(set.model, *set.input.result),
                        badge_colour(*set.input.result), caption_lines(set.model, *set.input.toolpath));
  const Area area{100, 206, 1390, 636};
  page.text({area.x - 8, 149}, set.input.toolpath->operations.empty() ? "tool" : "operation", 13, kSoftInk,
            TextAnchor::right);
  draw_operations(page, set, {area.x, 130, area.width, 28});
  Strip(set, area).draw(page);
  draw_legend(page, set, 944);
  return page;
}

}  // namespace gouge
