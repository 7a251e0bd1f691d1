#include "postproc/image/tilt_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/image/path_plot.h"
#include "postproc/image/shade.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFieldTop = 118, kFieldBottom = kPageHeight - 24;
constexpr double kAxisLength = 130;  // length of the drawn axes on the page
constexpr double kAxisGap = 7;       // minimum distance of the tips of two axes on the page
constexpr double kLeast_rad = 1e-3;  // an axis with a smaller tilt counts as the programmed one

/// The tool at the end of a move of a tilted run.
struct TiltedPose {
  Pose pose;
  double tilt_rad = 0;
};

/// Returns the tilt at a place of the run, from its curve: the difference of both axes in lead and side tilt.
double tilt_at(const TiltedRun& run, double length_mm) {
  const auto behind = std::ranges::lower_bound(run.curve, length_mm, {}, &TiltPlace::length_mm);
  if (run.curve.empty()) return 0;
  const TiltPlace& place = behind == run.curve.end() ? run.curve.back() : *behind;
  return Vec2(place.lead_after_rad - place.lead_before_rad, place.side_after_rad - place.side_before_rad).norm();
}

std::vector<TiltedPose> tilted_poses(const ReportModel& model) {
  std::vector<TiltedPose> poses;
  const Moves& moves = model.toolpath->moves;
  for (const TiltedRun& run : model.correction.axes->tilts.runs) {
    double length_mm = run.begin_mm;
    for (std::size_t i = run.first; i < run.last; ++i) {
      if (moves[i].has_start) length_mm += (moves[i].end.tip - model.toolpath->start_of(i).tip).norm();
      const double tilt = tilt_at(run, length_mm);
      if (tilt > kLeast_rad) poses.push_back({moves[i].end, tilt});
    }
  }
  return poses;
}

/// Returns some of the poses, in the order of their depth in the view. No two of them have tips that are too close on
/// the page.
std::vector<TiltedPose> spread(std::vector<TiltedPose> poses, const View& view) {
  std::ranges::stable_sort(poses, {}, [&](const TiltedPose& at) { return view.project(at.pose.tip).z(); });
  std::vector<TiltedPose> kept;
  for (const TiltedPose& at : poses) {
    const Vec3 here = view.project(at.pose.tip);
    const bool is_apart = std::ranges::all_of(kept, [&](const TiltedPose& other) {
      const Vec3 there = view.project(other.pose.tip);
      return (here - there).head<2>().norm() > kAxisGap * kSupersampling;
    });
    if (is_apart) kept.push_back(at);
  }
  return kept;
}

// Returns a direction of view oblique to the mean tool axis, so that length and tilt of the axes are visible.
Vec3 direction_to_look(const std::vector<TiltedPose>& poses) {
  Vec3 axis = Vec3::Zero(), way = Vec3::Zero();
  for (const TiltedPose& at : poses) axis += at.pose.axis;
  way = poses.back().pose.tip - poses.front().pose.tip;
  axis = axis.norm() > 0 ? axis.normalized() : Vec3::UnitZ();
  way -= way.dot(axis) * axis;
  const Vec3 along = way.norm() > Tolerance::kNoSide ? way.normalized() : axis.unitOrthogonal();
  return (0.75 * along + 0.35 * axis.cross(along) + 0.55 * axis).normalized();
}

}  // namespace

bool has_tilt_field(const ReportModel& model) {
  return model.has_correction && model.correction.axes && !model.correction.axes->tilts.runs.empty();
}

Page draw_tilt_field(const PictureSet& set) {
  const AxisTilts& tilts = set.model.correction.axes->tilts;
  const std::vector<TiltedPose> poses = tilted_poses(set.model);
  Page page = make_page("Tilted tool axes", badge_text(set.model, *set.input.result), badge_colour(*set.input.result),
                        caption_lines(set.model, *set.input.toolpath));
  const Area area{36, kFieldTop, 1332, kFieldBottom - kFieldTop - 60};
  View view = make_view(poses.empty() ? Vec3(1, -1, 1) : direction_to_look(poses), Vec3::UnitZ(),
                        static_cast<int>(area.width) * kSupersampling, static_cast<int>(area.height) * kSupersampling);
  fit_view(view, set.scene.part_points(), 0.12);
  const SurfaceBuffer buffer = draw_surface(set.scene, view);
  Raster raster = shade(set.scene, buffer, {}, set.surface_scale);
  lay_path(raster, buffer, set.input);
  page.rasters.push_back({static_cast<int>(area.x), static_cast<int>(area.y), std::move(raster)});
  // The scale is made for lengths; here a millimetre stands for a degree.
  const ColourScale scale{0, round_up(std::max(tilts.tilt_rad.value / kDegree, 0.1)), false};
  const double length_mm = kAxisLength * kSupersampling * view.mm_per_pixel;
  for (const TiltedPose& at : spread(poses, view)) {
    const Vec2 tip = on_page(area, view.project(at.pose.tip));
    const Vec2 end = on_page(area, view.project(at.pose.tip + length_mm * at.pose.axis));
    page.line(tip, end, scale.at(at.tilt_rad / kDegree), 2);
    page.disc(tip, 1.8, kInk);
  }
  add_triad(page, {area.x + 52, kFieldBottom - 62}, view, 34);
  add_scale_bar(page, {area.x + 120, kFieldBottom - 26}, view, set.model.toolpath->unit, 180);
  page.line({1380, kFieldTop + 20}, {1380, kFieldBottom - 20}, kHairline, 1);
  page.text({1408, 168}, "Tilt", 15, kInk, TextAnchor::left, true);
  const Area bar{1408, 190, 26, 360};
  constexpr int kSteps = 90;
  for (int k = 0; k < kSteps; ++k) {
    const double share = (k + 0.5) / kSteps;
    page.box({bar.x, bar.bottom() - (k + 1) * bar.height / kSteps, bar.width, bar.height / kSteps + 0.5},
             scale.at(share * scale.high_mm));
  }
  const double step = round_step(scale.high_mm, 5);
  for (double tick = 0; tick <= scale.high_mm * (1 + Tolerance::kRounding); tick += step) {
    const double y = bar.bottom() - bar.height * tick / scale.high_mm;
    page.line({bar.right(), y}, {bar.right() + 6, y}, kInk, 1);
    page.text({bar.right() + 11, y + 5}, tick_text(tick, step) + "\u00b0", 14, kInk);
  }
  double y = bar.bottom() + 34;
  for (const std::string& words :
       {count_text(tilts.positions, "position") + " tilted", std::string("from the programmed axis,"),
        "by up to " + angle_text(tilts.tilt_rad.value, DegreeSign::sign)}) {
    page.text({bar.x, y}, words, fitting_size(words, 14, kPageWidth - 16 - bar.x), kSoftInk);
    y += 19;
  }
  return page;
}

}  // namespace gouge
