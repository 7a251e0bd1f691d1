#pragma once

#include "lib/field/checked_toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/heat_map.h"
#include "postproc/report/report_model.h"

// Scale of the pictures of a finding.

// The colours of a report, in every picture of it the same. Those of a correction cover the path before it, so that
// both can be compared.

namespace gouge {

/// Returns the tool of a finding.
[[nodiscard]] const ToolVariants& variants_of(const PictureSet& set, const PictureEvent& event);

/// Returns for a gouge of the tool: the radius of the body that gouges, or more when it is reached deep inside.
[[nodiscard]] double tool_size_mm(const PictureSet& set, const PictureEvent& event);

/// Returns the heads of a finding in part coordinates: corners of a box about each, and the tool's tip.
[[nodiscard]] std::vector<Vec3> head_corners(const PictureSet& set, const PictureEvent& event);

/// Returns how far from the finding a head is shown: a machine's whole column would leave nothing of the part.
[[nodiscard]] double head_reach_mm(const PictureSet& set, const PictureEvent& event);

/// Visible part of a flat picture about (0, 0).
struct FlatExtent {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  /// Takes in a point, no farther out than `reach`.
  void take(const Vec2& p, double reach);
  [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }
  /// Returns the mm of a picture unit with which it fits in, with a margin.
  [[nodiscard]] double mm_per_unit(double width, double height) const;
};

/// Returns the scale of the depths of moves.
[[nodiscard]] ColourScale depth_scale(const ReportModel& model, const CheckedToolpath& input);

/// Returns the scale of the coloured quantity: overcuts, and the depths of gouges without one or of a head.
[[nodiscard]] ColourScale surface_scale(const ReportModel& model, const CheckedToolpath& input);

}  // namespace gouge
