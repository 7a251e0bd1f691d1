#pragma once

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The points of a profile farthest in a direction: one point, or a straight stretch of the contour.
struct SupportStretch {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();  ///< (r, z)
};

/// Requires direction.x() >= 0, not zero, and a tool with elements. Cost linear in the elements.
[[nodiscard]] SupportStretch support_stretch(const CompiledTool& tool, const Vec2& direction);

/// What stays where it is when the tool is tilted at a position: the point where the cutter touches the part, and with
/// it the surface it cuts there. Of a ball that is its centre; of any other profile the point whose normal is that of
/// the part. Without a contact the tip stays.
class ContactPivot {
 public:
  explicit ContactPivot(const Pose& programmed) : programmed_(programmed), normal_(programmed.axis) {}
  /// `cutter` must outlive it. `normal`: of the part at the contact, unit, outward.
  ContactPivot(const Pose& programmed, const CompiledTool& cutter, const Vec3& normal);

  /// Outward from the part at the contact; without one the programmed axis.
  [[nodiscard]] const Vec3& normal() const { return normal_; }

  /// Where the tip goes when the axis becomes `axis`, a unit vector.
  ///
  /// Ensures  the cutter reaches exactly as far against the part's normal as before, and where one point of it alone
  ///          does, at the same point of the part. Where several do, as with a flat end on a flat floor, the one of them
  ///          stays that the tilted cutter touches with.
  [[nodiscard]] Vec3 tip_for(const Vec3& axis) const;

 private:
  Pose programmed_;
  const CompiledTool* cutter_ = nullptr;
  Vec3 normal_ = Vec3::UnitZ();
  SupportStretch touched_;
};

}  // namespace gouge
