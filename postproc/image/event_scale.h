#pragma once

#include "lib/field/checked_toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/heat_map.h"
#include "postproc/report/report_model.h"

// Scale of the pictures of a finding.

// Also the colours of a report, which are the same in all of its pictures. For a correction they include the path
// before it, so that both are comparable.

namespace gouge {

/// Returns the tool of a finding.
[[nodiscard]] const ToolVariants& variants_of(const PictureSet& set, const PictureEvent& event);

/// Returns, for a gouge of the tool, the radius of the body that gouges, or more if the point is deep inside the body.
[[nodiscard]] double tool_size_mm(const PictureSet& set, const PictureEvent& event);

/// Returns points of a finding's heads in part coordinates: corners of a box about each, and the tool's tip.
[[nodiscard]] std::vector<Vec3> head_corners(const PictureSet& set, const PictureEvent& event);

/// Returns the distance from the finding up to which heads are shown. With the whole column of a machine the part would
/// be too small.
[[nodiscard]] double head_reach_mm(const PictureSet& set, const PictureEvent& event);

/// Visible part of a flat picture about (0, 0).
struct FlatExtent {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  /// Includes a point, at most `reach` away.
  void take(const Vec2& p, double reach);
  [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }
  /// Returns the mm for a picture unit at which the extent fits, with a margin.
  [[nodiscard]] double mm_per_unit(double width, double height) const;
};

/// Returns the scale of the depths of moves.
[[nodiscard]] ColourScale depth_scale(const ReportModel& model, const CheckedToolpath& input);

/// Returns the scale of the coloured quantity: overcuts, and the depths of gouges without one or of a head.
[[nodiscard]] ColourScale surface_scale(const ReportModel& model, const CheckedToolpath& input);

}  // namespace gouge
