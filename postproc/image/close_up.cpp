#include "lib/base/tolerance.h"
#include "postproc/image/heat_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "postproc/image/event_scale.h"
#include "postproc/image/glass.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/pixel_points.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/shade.h"
#include "postproc/image/tool_outline.h"

namespace gouge {
namespace {

constexpr Area kCloseUp{152, 142, 830, 742};
// Number of directions from which a close-up may be seen, at each of two elevations. Gouges around the finding, within
// this share of the picture's height, are considered. A surface that is nearer to a point than one of this many pixels
// does not hide it.
constexpr int kSides = 12;
constexpr double kNear = 0.15;
constexpr int kProbeWidth = 120, kProbeHeight = 108;

// Returns the view of a finding of a head. It shows the heads, up to the shown distance, the finding and the tool's
// tip. If a head is buried in the part, it shows the part too.
View head_view(const PictureSet& set, const PictureEvent& event, const Vec3& toward, int width, int height) {
  View view = make_view(toward, event.pose.axis, width, height);
  const double reach = head_reach_mm(set, event);
  FlatExtent extent;
  const auto take = [&](std::span<const Vec3> points) {
    for (const Vec3& p : points) extent.take({(p - event.at).dot(view.right), (p - event.at).dot(view.up)}, reach);
  };
  take(head_corners(set, event));
  if (!event.has_witness) {
    for (const std::span<const Vec3> points : set.scene.part_points()) take(points);
  }
  view.mm_per_pixel = extent.mm_per_unit(width, height);
  view.centre = event.at + extent.middle().x() * view.right + extent.middle().y() * view.up;
  return view;
}

View tool_view(const PictureSet& set, const PictureEvent& event, const Vec3& toward, int width, int height) {
  const double part_mm = set.scene.part_size_mm();
  const double times = event.event.body == Body::cutter ? 8 : 5.5;
  const double reach = event.has_witness ? times * tool_size_mm(set, event) : 1.2 * part_mm;
  // A gouge may be deeper than the part is large.
  const double height_mm =
      std::max(std::min(reach, std::max(1.1 * part_mm, 1e-3)), std::min(8 * event.depth_mm, reach));
  View view = make_view(toward, event.pose.axis, width, height);
  view.mm_per_pixel = height_mm / height;
  // The view shows a little of the tool above the finding, and mostly the part around it.
  const double lift = std::min(0.18 * height_mm, 0.5 * variants_of(set, event).bare.z_max_mm);
  view.centre = event.at + view.up * lift;
  return view;
}

View close_view(const PictureSet& set, const PictureEvent& event, const Vec3& toward, int width, int height) {
  return event.head ? head_view(set, event, toward, width, height) : tool_view(set, event, toward, width, height);
}

// Returns the share of the gouged surface around the finding that is visible and faces the viewer.
double gouged_share(const PictureSet& set, const std::vector<GougeWitness>& gouges, const Vec3& toward,
                    double clear_mm) {
  double seen = 0, all = 0;
  for (const GougeWitness& gouge : gouges) {
    const double facing = gouge.normal.dot(toward);
    all += gouge.weight;
    if (facing > 0 && is_in_sight(set.input, gouge.at, toward, clear_mm)) seen += facing * gouge.weight;
  }
  return all > 0 ? seen / all : 0;
}

Vec3 best_direction(const PictureSet& set, const PictureEvent& event) {
  const Vec3 side = std::abs(event.pose.axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e1 = event.pose.axis.cross(side).normalized();
  const Vec3 e2 = event.pose.axis.cross(e1);
  const View like = close_view(set, event, event.pose.axis, kProbeWidth, kProbeHeight);
  const double clear_mm = like.mm_per_pixel + 1e-3;
  std::vector<GougeWitness> near;
  for (const GougeWitness& gouge : set.gouges) {
    if ((gouge.at - event.at).norm() < kNear * like.mm_per_pixel * kProbeHeight) near.push_back(gouge);
  }
  Vec3 best = event.pose.axis;
  double best_score = -1;
  for (const double rise : {0.45, 0.8}) {
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kSides;
      const Vec3 around = std::cos(angle) * e1 + std::sin(angle) * e2;
      const Vec3 toward = std::cos(rise) * around + std::sin(rise) * event.pose.axis;
      double score = is_in_sight(set.input, event.at, toward, clear_mm) ? 1 : 0;
      score += 0.5 * gouged_share(set, near, toward, clear_mm);
      if (event.has_witness) score += 0.3 * event.witness.normal.dot(toward);
      if (rise < 0.5) score += 0.05;
      if (score > best_score + Tolerance::kRounding) {
        best_score = score;
        best = toward;
      }
    }
  }
  return best;
}

// Adds `words` in a box, on the side that leaves `clear_of` free, with a line to the target.
void add_callout(Page& page, const Area& area, const Vec2& target, const Vec2& clear_of, const std::string& words) {
  const double width = text_width(words, 21, true) + 28;
  const bool is_left = clear_of.x() < area.middle().x();
  const Vec2 corner(is_left ? area.right() - width - 24 : area.x + 24, area.bottom() - 150);
  const Area box{corner.x(), corner.y(), width, 38};
  const Vec2 from(is_left ? box.x : box.right(), box.middle().y());
  page.line(from, target, {255, 255, 255, 0.9}, 5);
  page.line(from, target, kInk, 1.8);
  page.disc(target, 6, kWhite);
  page.disc(target, 4.2, kAlarm);
  page.box(box, {255, 255, 255, 0.94});
  page.frame(box, kInk, 1.5);
  page.text({box.middle().x(), box.y + 26}, words, 21, kAlarm, TextAnchor::middle, true);
}

}  // namespace

void add_close_up(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words) {
  const ToolVariants& variants = variants_of(set, event);
  const Vec3 toward = best_direction(set, event);
  const View view = close_view(set, event, toward, static_cast<int>(kCloseUp.width) * kSupersampling,
                               static_cast<int>(kCloseUp.height) * kSupersampling);
  const SurfaceBuffer buffer = draw_surface(set.scene, view);
  Raster raster = shade(set.scene, buffer, depth_on_pixels(set.field, set.scene, buffer), set.scale);
  lay_glass(raster, buffer, tool_surface(variants.bare, event.pose), PictureScene(set.input.heads, event.heads));
  page.rasters.push_back({static_cast<int>(kCloseUp.x), static_cast<int>(kCloseUp.y), std::move(raster)});
  const Vec2 target = on_page(kCloseUp, view.project(event.at));
  // The finding of a head may be far from the tool, which must be visible too.
  const Vec2 tip = on_page(kCloseUp, view.project(event.pose.tip));
  add_callout(page, kCloseUp, target, event.head ? tip : target, words);
  page.frame(kCloseUp, kSoftInk, 1);
  const char* const title =
      event.head ? "Part, tool and head at the worst instant" : "Part and tool at the worst instant";
  page.text({kCloseUp.x, kCloseUp.y - 10}, title, 15, kInk, TextAnchor::left, true);
  add_triad(page, {kCloseUp.x + 40, kCloseUp.bottom() + 58}, view, 28);
  add_scale_bar(page, {kCloseUp.x + 112, kCloseUp.bottom() + 56}, view, set.model.toolpath->unit, 160);
  add_colour_bar(page, {40, 204, 22, 350}, set.scale, set.model.toolpath->unit, "Gouge depth");
}

}  // namespace gouge
