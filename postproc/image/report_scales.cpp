#include "postproc/image/report_scales.h"

#include <algorithm>

namespace gouge {
namespace {

// Colours of a correction cover the path before it, so that both halves can be compared.
double worst_depth(const ReportModel& model, const CheckedToolpath& input) {
  const CheckResult* before = model.has_correction ? model.correction.result_before : nullptr;
  return std::max(input.result->worst_depth_mm, before != nullptr ? before->worst_depth_mm : 0.0);
}

/// What colours the surface at most: an overcut, or the depth of a gouge without one or of a head.
double worst_on_surface(const CheckResult& result) {
  double worst = 0;
  for (const MoveVerdict& v : result.verdicts) {
    if (v.state != MoveState::gouge) continue;
    const bool is_head = v.witness && v.witness->body == Body::head;
    worst = std::max(worst, v.overcut_mm.value_or(0) > 0 && !is_head ? *v.overcut_mm : v.depth_mm);
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
  return make_colour_scale(model.options.tolerance_mm, worst_on_surface_of(model, input), model.toolpath->unit);
}

}  // namespace gouge
