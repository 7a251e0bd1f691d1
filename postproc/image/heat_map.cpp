#include "postproc/image/heat_map.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/image/material_left.h"
#include "postproc/image/path_plot.h"
#include "postproc/image/pixel_points.h"
#include "postproc/image/shade.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kContentTop = 118;
// The overcut is stated only if depth and overcut differ by this factor. For shallow gouges they agree.
constexpr double kNoteworthy = 1.02;
constexpr double kContentBottom = kPageHeight - 24;

/// Returns boxes about the findings in fixtures, as points. A view must show them, although fixtures may reach far.
std::vector<Vec3> corners_about_fixture_findings(const PictureSet& set) {
  constexpr double kShareOfPart = 0.1;
  const double reach_mm = kShareOfPart * set.scene.part_size_mm();
  std::vector<Vec3> corners;
  for (const PictureEvent& event : set.events) {
    if (!event.has_witness || event.witness.against != Against::fixture) continue;
    for (int corner = 0; corner < 8; ++corner)
      corners.push_back(event.witness.point + reach_mm * Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                              (corner & 4) != 0 ? 1 : -1));
  }
  return corners;
}

View view_for(const PictureSet& set, const Vec3& toward, const Area& area) {
  View view = make_view(toward, Vec3::UnitZ(), static_cast<int>(area.width) * kSupersampling,
                        static_cast<int>(area.height) * kSupersampling);
  const auto part = set.scene.part_points();
  const std::vector<Vec3> corners = corners_about_fixture_findings(set);
  std::vector<std::span<const Vec3>> points(part.begin(), part.end());
  points.emplace_back(corners);
  fit_view(view, points, 0.07);
  return view;
}

// Draws one view into `area` and returns it for the labels. Without gouges the path can be shown in place of depths.
// Otherwise a part without colours would look the same for every path.
View add_view(Page& page, const PictureSet& set, const Vec3& toward, const Area& area, bool shows_path) {
  const View view = view_for(set, toward, area);
  const SurfaceBuffer buffer = draw_surface(set.scene, view);
  std::vector<float> depth = set.overcuts.is_empty() ? depth_on_pixels(set.field, set.scene, buffer)
                                                     : overcut_on_pixels(set.overcuts, set.scene, buffer);
  add_material_left(*set.input.result, buffer, depth);
  Raster raster = shade(set.scene, buffer, depth, set.surface_scale);
  if (shows_path && set.events.empty() && !shows_material_left(*set.input.result)) lay_path(raster, buffer, set.input);
  page.rasters.push_back({static_cast<int>(area.x), static_cast<int>(area.y), std::move(raster)});
  for (const PictureEvent& event : set.events) {
    const Vec2 target = on_page(area, view.project(event.at));
    page.taken.push_back({target.x() - 8, target.y() - 8, 16, 16});
  }
  for (const PictureEvent& event : set.events) {
    add_marker(page, area, on_page(area, view.project(event.at)), event.number,
               !is_visible(buffer, event.at, 3 * view.mm_per_pixel + 1e-3));
  }
  return view;
}

// Returns the area for the part, which must not overlap the triad and the scale. These are below it, or on its left in
// flat views.
Area above_furniture(const Area& area) {
  if (area.width > 2 * area.height) return {area.x + 120, area.y, area.width - 120, area.height - 34};
  return {area.x, area.y, area.width, area.height - 90};
}

// Returns the larger of both views' scales, in mm for a pixel.
double scale_in(const PictureSet& set, const std::array<Area, 2>& areas) {
  double worst = 0;
  for (std::size_t i = 0; i < set.directions.size() && i < areas.size(); ++i) {
    worst = std::max(worst, view_for(set, set.directions[i], above_furniture(areas[i])).mm_per_pixel);
  }
  return worst;
}

void add_corner_furniture(Page& page, const View& view, const Area& area, LengthUnit unit) {
  add_triad(page, {area.x + 52, area.bottom() - 62}, view, 34);
  add_scale_bar(page, {area.x + 120, area.bottom() - 26}, view, unit, 180);
}

std::string tool_names(const ReportModel& model) {
  std::string text;
  const std::vector<PathTool>& tools = model.toolpath->tools;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (i == 4) return text + " and " + std::to_string(tools.size() - i) + " more";
    const std::string words = i < model.tools.size() ? model.tools[i].description : std::string();
    const std::string name =
        i < model.tools.size() && !model.tools[i].name.empty() ? model.tools[i].name : tools[i].name;
    text += (i > 0 ? ", " : "") + tool_label(*model.toolpath, i);
    const std::string& more = words.empty() ? name : words;
    if (!more.empty() && tools[i].number) text += " " + more;
  }
  return text.empty() ? "no tool" : text;
}

// Adds the bar of material left, with its title and the highest places.
void add_material_bar(Page& page, const Area& area, const PictureSet& set, double title_y) {
  const LengthUnit unit = set.model.toolpath->unit;
  add_left_bar(page, area, set.surface_scale, unit);
  page.text({area.x, title_y}, "Material left", 15, kInk, TextAnchor::left, true);
  page.text({area.x, title_y + 19}, std::string("in ") + unit_words(unit), 14, kSoftInk);
}

// Adds the highest places of material left, as far as there is room.
void add_place_key(Page& page, const PictureSet& set, double x, double y) {
  constexpr std::size_t kMaxPlaces = 5;
  const ExcessFacts& facts = *set.input.result->excess;
  const LengthUnit unit = set.model.toolpath->unit;
  page.text({x, y}, "Highest places", 15, kInk, TextAnchor::left, true);
  const double room = kPageWidth - 24 - x;
  for (std::size_t k = 0; k < std::min(facts.proved(), kMaxPlaces); ++k) {
    const std::string height = depth_text(facts.places[k].height_mm, unit) + " left";
    const std::string where = "at " + point_text(facts.places[k].point, unit);
    page.text({x, y + 26}, height, fitting_size(height, 15, room, true), kInk, TextAnchor::left, true);
    page.text({x, y + 44}, where, fitting_size(where, 13, room), kSoftInk);
    y += 44;
  }
}

// Adds one bar for both sides of the surface: what is cut below it upwards, and what is left above it downwards.
void add_two_bars(Page& page, const Area& area, const PictureSet& set, const std::string& title) {
  if (set.events.empty()) {
    add_material_bar(page, area, set, area.y - 32);
    return add_place_key(page, set, area.x, area.bottom() + 44);
  }
  const double half = 0.5 * area.height;
  add_colour_bar(page, {area.x, area.y, area.width, half}, set.surface_scale, set.model.toolpath->unit, title);
  add_material_bar(page, {area.x, area.y + half, area.width, half}, set, area.bottom() + 24);
}

void add_surface_bar(Page& page, const Area& area, const PictureSet& set) {
  const bool is_depth = set.overcuts.is_empty();
  const LengthUnit unit = set.model.toolpath->unit;
  const char* const title = is_depth ? "Gouge depth" : "Overcut";
  if (shows_material_left(*set.input.result)) return add_two_bars(page, area, set, title);
  add_colour_bar(page, area, set.surface_scale, unit, title);
  if (is_depth) return;
  page.text({area.x, area.bottom() + 22}, "how far below the", 12.5, kSoftInk);
  page.text({area.x, area.bottom() + 38}, "surface the tool reached", 12.5, kSoftInk);
}

void add_path_key(Page& page, const PictureSet& set, double x, double y) {
  const StateCounts& n = set.input.result->counts;
  const auto entry = [&](const Colour& colour, std::initializer_list<const char*> lines) {
    page.box({x, y - 12, 22, 14}, colour);
    for (const char* words : lines) {
      page.text({x + 30, y}, words, 14, kInk);
      y += 19;
    }
    y += 12;
  };
  entry(kCheckedPath, {"path of the tip", "while it cuts:", "checked"});
  if (n.not_checked + n.not_certified > 0) entry(kUncheckedPath, {"not checked", "or not certified"});
  if (!set.model.result->closest_approach) return;
  const ClosestApproach& c = *set.model.result->closest_approach;
  const LengthUnit unit = set.model.toolpath->unit;
  y += 18;
  for (const std::string& words :
       {std::string("Distance from the part:"), "closest approach: " + closest_approach_words(c.nearest_mm, unit),
        "half of " + count_text(c.positions, "cutting position") + ":", closest_approach_words(c.median_mm, unit)}) {
    page.text({x, y}, words, fitting_size(words, 14, kPageWidth - 16 - x), kSoftInk);
    y += 19;
  }
}

double largest_overcut_mm(const CheckResult& result, const Event& event) {
  double largest = 0;
  for (std::size_t i = event.first_move; i <= event.last_move; ++i) {
    const MoveVerdict& v = result.verdicts[i];
    if (v.state == MoveState::gouge) largest = std::max(largest, v.overcut_mm());
  }
  return largest;
}

void add_event_key(Page& page, const PictureSet& set, double x, double y) {
  if (set.events.empty()) return;
  page.text({x, y}, "Deepest findings", 15, kInk, TextAnchor::left, true);
  const LengthUnit unit = set.model.toolpath->unit;
  for (const PictureEvent& event : set.events) {
    y += 40;
    const Vec2 disc(x + 11, y - 5);
    page.disc(disc, 11, kInk);
    page.number_on_disc(disc, 11, event.number, kWhite);
    const std::string depth =
        event.event.state == MoveState::buried ? std::string("buried") : depth_text(event.depth_mm, unit) + " deep";
    const double room = kPageWidth - 24 - x - 30;
    page.text({x + 30, y - 7}, depth, fitting_size(depth, 15, room, true), kInk, TextAnchor::left, true);
    const std::size_t move = event.event.worst_move;
    const auto add_line = [&](double below, const std::string& words) {
      page.text({x + 30, y + below}, words, fitting_size(words, 13, room), kSoftInk);
    };
    const std::string where =
        std::string(body_name(event.event.body)) + ", line " + std::to_string(set.input.toolpath->moves[move].line);
    add_line(11, where);
    const double overcut_mm = largest_overcut_mm(*set.input.result, event.event);
    const bool is_same = std::max(overcut_mm, event.depth_mm) <= kNoteworthy * std::min(overcut_mm, event.depth_mm);
    if (set.overcuts.is_empty() || overcut_mm <= 0 || is_same) continue;
    add_line(27, "overcut " + depth_text(overcut_mm, unit));
    y += 20;
  }
}

std::string gouges_text(const CheckResult& result, LengthUnit unit) {
  const StateCounts& n = result.counts;
  std::string text = std::to_string(n.gouge) + " of " + count_text(result.verdicts.size(), "move") + " gouge";
  if (n.gouge > 0) text += ", worst " + depth_text(result.worst_depth_mm, unit);
  if (n.buried > 0) text += ", " + std::to_string(n.buried) + " buried";
  return text;
}

}  // namespace

std::vector<std::string> caption_lines(const ReportModel& model, const Toolpath& toolpath) {
  std::string files = toolpath.file;
  for (std::size_t i = 0; i < model.parts.size(); ++i) files += (i == 0 ? " against " : ", ") + model.parts[i].name;
  for (std::size_t i = 0; i < model.fixtures.size(); ++i) {
    files += (i == 0 ? ", fixture " : ", ") + model.fixtures[i].name;
  }
  const LengthUnit unit = toolpath.unit;
  return {files, tool_names(model) + "; tolerance " + short_length_text(model.options.tolerance_mm, unit) +
                     ", resolution " + short_length_text(model.options.resolution_mm, unit)};
}

std::string badge_text(const ReportModel& model, const CheckResult& result) {
  const OverallVerdict verdict = overall_verdict(result);
  if (verdict == OverallVerdict::clean) return "CLEAN";
  if (verdict == OverallVerdict::material_left)
    return "MATERIAL LEFT " + length_text(result.excess->places.front().height_mm, model.toolpath->unit);
  if (verdict == OverallVerdict::not_fully_checked) return "NOT FULLY CHECKED";
  if (!(result.worst_depth_mm > 0)) return "TOOL BURIED";
  const LengthUnit unit = model.toolpath->unit;
  const std::string worst = "WORST " + depth_text(result.worst_depth_mm, unit);
  const bool has_news = result.worst_overcut_mm > kNoteworthy * result.worst_depth_mm;
  return has_news ? worst + ", OVERCUT " + depth_text(result.worst_overcut_mm, unit) : worst;
}

Colour badge_colour(const CheckResult& result) {
  const OverallVerdict verdict = overall_verdict(result);
  if (verdict == OverallVerdict::clean) return kCalm;
  return exit_status(verdict) == kExitGouges ? kAlarm : Colour{166, 110, 12, 1};
}

std::string heat_map_title(const PictureSet& set) {
  if (shows_material_left(*set.input.result)) {
    if (set.events.empty()) return "Material left on the part";
    return set.overcuts.is_empty() ? "Gouge depth and material left on the part"
                                   : "Overcut and material left on the part";
  }
  if (set.events.empty()) {
    const bool is_clean = overall_verdict(*set.input.result) == OverallVerdict::clean;
    return is_clean ? "The path on the part: no gouge" : "The path on the part: no gouge found";
  }
  return set.overcuts.is_empty() ? "Gouge depth on the part" : "Overcut on the part";
}

Page draw_heat_map(const PictureSet& set) {
  Page page = make_page(heat_map_title(set), badge_text(set.model, *set.input.result), badge_colour(*set.input.result),
                        caption_lines(set.model, *set.input.toolpath));
  const LengthUnit unit = set.model.toolpath->unit;
  const double height = kContentBottom - kContentTop;
  // The views are side by side or one above the other: the layout that shows the part larger.
  std::array<Area, 2> areas{Area{36, kContentTop, 768, height}, Area{820, kContentTop, 548, height}};
  const double half = 0.5 * (height - 16);
  const std::array<Area, 2> rows{Area{36, kContentTop, 1332, half}, Area{36, kContentTop + half + 16, 1332, half}};
  const bool is_stacked = scale_in(set, rows) < scale_in(set, areas);
  if (is_stacked) areas = rows;
  for (std::size_t i = 0; i < set.directions.size() && i < areas.size(); ++i) {
    const View view = add_view(page, set, set.directions[i], above_furniture(areas[i]), true);
    add_corner_furniture(page, view, areas[i], unit);
  }
  if (is_stacked)
    page.line({56, rows[1].y - 8}, {1356, rows[1].y - 8}, kHairline, 1);
  else
    page.line({812, kContentTop + 20}, {812, kContentBottom - 20}, kHairline, 1);
  page.line({1380, kContentTop + 20}, {1380, kContentBottom - 20}, kHairline, 1);
  if (set.events.empty() && !shows_material_left(*set.input.result)) {
    add_path_key(page, set, 1408, 190);
    return page;
  }
  add_surface_bar(page, {1408, 190, 26, 360}, set);
  const double key = shows_material_left(*set.input.result) ? 650 : set.overcuts.is_empty() ? 604 : 626;
  add_event_key(page, set, 1408, key);
  return page;
}

Page draw_before_after(const PictureSet& before, const PictureSet& after) {
  Page page = make_page("Before and after correction", badge_text(after.model, *after.input.result),
                        badge_colour(*after.input.result), caption_lines(after.model, *after.input.toolpath));
  const LengthUnit unit = after.model.toolpath->unit;
  constexpr double kHalf = 660;
  const Area left{36, 156, kHalf, kContentBottom - 156};
  const Area right{36 + kHalf + 12, 156, kHalf, kContentBottom - 156};
  const Vec3& toward = before.directions.front();
  const View view = add_view(page, before, toward, above_furniture(left), false);
  add_view(page, after, toward, above_furniture(right), false);
  add_corner_furniture(page, view, left, unit);
  const auto label = [&](const Area& area, const std::string& words, const CheckResult& result) {
    page.text({area.x + 8, area.y - 12}, words, 19, kInk, TextAnchor::left, true);
    const bool is_bad = result.counts.gouge + result.counts.buried > 0;
    page.text({area.right() - 12, area.y - 12}, gouges_text(result, unit), 16, is_bad ? kAlarm : kCalm,
              TextAnchor::right);
  };
  label(left, "Before", *before.input.result);
  label(right, "After", *after.input.result);
  page.line({36 + kHalf + 6, 130}, {36 + kHalf + 6, kContentBottom - 10}, kHairline, 1);
  page.line({1380, 130}, {1380, kContentBottom - 10}, kHairline, 1);
  add_surface_bar(page, {1408, 200, 26, 360}, before);
  return page;
}

}  // namespace gouge
