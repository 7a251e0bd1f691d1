#include "postproc/image/event_scale.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "postproc/image/material_left.h"
#include "postproc/image/tool_outline.h"

namespace gouge {

namespace {

constexpr double kReach = 1.2;  // relative to the size of the parts
constexpr double kFilled = 0.84;

// Returns the radius of the body that gouges, which determines the scale of its picture.
double body_radius(const CompiledTool& tool, Body body) {
  double radius = 0;
  for (const OutlineRun& run : tool_outline(tool)) {
    if (run.body != body) continue;
    for (const Vec2& p : run.points) radius = std::max(radius, p.x());
  }
  return radius > 0 ? radius : tool.r_max_mm;
}

}  // namespace

const ToolVariants& variants_of(const PictureSet& set, const PictureEvent& event) {
  return *set.input.tools[event.event.tool];
}

double tool_size_mm(const PictureSet& set, const PictureEvent& event) {
  const Vec3 d = event.at - event.pose.tip;
  const double from_axis = (d - event.pose.axis * d.dot(event.pose.axis)).norm();
  return std::max({body_radius(variants_of(set, event).bare, event.event.body), from_axis, 1.3 * event.depth_mm});
}

std::vector<Vec3> head_corners(const PictureSet& set, const PictureEvent& event) {
  std::vector<Vec3> corners{event.pose.tip};
  for (const HeadBody& head : set.input.heads) {
    const Box3 box = head.box;
    for (int k = 0; k < 8; ++k) corners.push_back(event.heads.point(box.corner(static_cast<Box3::CornerType>(k))));
  }
  return corners;
}

double head_reach_mm(const PictureSet& set, const PictureEvent& event) {
  return std::max({kReach * set.scene.part_size_mm(), 4 * event.depth_mm, 1e-3});
}

void FlatExtent::take(const Vec2& p, double reach) {
  for (int k = 0; k < 2; ++k) {
    const double x = std::clamp(p[k], -reach, reach);
    low[k] = std::min(low[k], x);
    high[k] = std::max(high[k], x);
  }
}

double FlatExtent::mm_per_unit(double width, double height) const {
  const Vec2 size = high - low;
  return std::max({size.x() / (kFilled * width), size.y() / (kFilled * height), Tolerance::kSamePoint_mm});
}

namespace {

// Returns the worst depth for the colours. For a correction it includes the path before it, so that both halves are
// comparable.
double worst_depth(const ReportModel& model, const CheckedToolpath& input) {
  const CheckResult* before = model.has_correction ? model.correction.result_before : nullptr;
  return std::max(input.result->worst_depth_mm, before != nullptr ? before->worst_depth_mm : 0.0);
}

/// Returns the maximum of the coloured quantity: an overcut, or the depth of a gouge without one or of a head.
double worst_on_surface(const CheckResult& result) {
  double worst = 0;
  for (const MoveVerdict& v : result.verdicts) {
    if (v.state != MoveState::gouge) continue;
    const bool is_head = v.witness && v.witness->body == Body::head;
    worst = std::max(worst, v.overcut_mm() > 0 && !is_head ? v.overcut_mm() : v.depth_mm);
  }
  return worst;
}

double worst_on_surface_of(const ReportModel& model, const CheckedToolpath& input) {
  const CheckResult* before = model.has_correction ? model.correction.result_before : nullptr;
  return std::max(worst_on_surface(*input.result), before != nullptr ? worst_on_surface(*before) : 0.0);
}

}  // namespace

ColourScale depth_scale(const ReportModel& model, const CheckedToolpath& input) {
  return make_colour_scale(model.options.tolerance_mm, worst_depth(model, input), model.toolpath->unit);
}

ColourScale surface_scale(const ReportModel& model, const CheckedToolpath& input) {
  ColourScale scale =
      make_colour_scale(model.options.tolerance_mm, worst_on_surface_of(model, input), model.toolpath->unit);
  add_material_left(*input.result, model.toolpath->unit, scale);
  return scale;
}

}  // namespace gouge
