#pragma once

#include <vector>

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The points of a profile that are farthest in a direction: one point, or a straight stretch of the contour.
struct SupportStretch {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();  ///< (r, z)
};

/// Finds the farthest points of the profile. Requires direction.x() >= 0, a direction that is not zero, and a tool with
/// elements. Cost linear in the elements.
[[nodiscard]] SupportStretch support_stretch(const CompiledTool& tool, const Vec2& direction);

/// The fixed point of a tilt at a position: the point where the cutter touches the part. So the cutter cuts the same
/// surface there as before. For a ball tip it is always the centre of the ball. For any other profile it is the point
/// with the normal of the part. Without a contact the tip is the fixed point.
class ContactPivot {
 public:
  /// Makes a pivot without a contact.
  explicit ContactPivot(const Pose& programmed) : programmed_(programmed) {}
  /// `normals` are the normals of the part at the contacts, unit and outward. A normal along the tool axis has more
  /// weight than a normal across it. The cutter must outlive the object.
  ContactPivot(const Pose& programmed, const CompiledTool& cutter, std::vector<Vec3> normals);

  /// Returns the outward normal of the part at the contact with the most weight; without a contact the programmed axis.
  [[nodiscard]] const Vec3& normal() const { return contacts_.empty() ? programmed_.axis : contacts_.front().normal; }

  /// Returns the new position of the tip if the axis becomes `axis`, a unit vector.
  ///
  /// Ensures  The cutter reaches exactly as far against the first normal as before. If only one point of the cutter
  ///          does so, it touches the part at the same point as before. If several points do so, as with a flat end on
  ///          a flat floor, the fixed point is the one with which the tilted cutter touches. Against other normals, as
  ///          of a wall beside that floor, the cutter reaches no farther than before, as far as a few shifts along them
  ///          achieve it.
  [[nodiscard]] Vec3 tip_for(const Vec3& axis) const;

 private:
  struct Contact {
    Vec3 normal = Vec3::UnitZ();
    SupportStretch touched;
  };
  [[nodiscard]] Vec3 kept_at(const Contact& contact, const Vec3& axis) const;
  [[nodiscard]] double reach(const Contact& contact, const Pose& pose) const;

  Pose programmed_;
  const CompiledTool* cutter_ = nullptr;
  std::vector<Contact> contacts_;
  double ball_mm_ = 0;  // height of the ball's centre above the tip; 0: the tip is not a ball
};

}  // namespace gouge
