#pragma once

#include <vector>

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The points of a profile farthest in a direction: one point, or a straight stretch of the contour.
struct SupportStretch {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();  ///< (r, z)
};

/// Requires direction.x() >= 0, not zero, and a tool with elements. Cost linear in the elements.
[[nodiscard]] SupportStretch support_stretch(const CompiledTool& tool, const Vec2& direction);

/// The fixed point of a tilt at a position: the point where the cutter touches the part. With it the surface that the
/// cutter cuts there stays. For a tip that is a ball it is its centre, whatever it touches. For any other profile it is
/// the point whose normal is that of the part. Without a contact the tip stays.
class ContactPivot {
 public:
  /// Without a contact.
  explicit ContactPivot(const Pose& programmed) : programmed_(programmed) {}
  /// `cutter` must outlive it. `normals`: of the part at the contacts, unit, outward; one that is along the tool axis
  /// counts more than one across.
  ContactPivot(const Pose& programmed, const CompiledTool& cutter, std::vector<Vec3> normals);

  /// Returns the outward from the part at the contact that counts most; without one the programmed axis.
  [[nodiscard]] const Vec3& normal() const { return contacts_.empty() ? programmed_.axis : contacts_.front().normal; }

  /// Returns where the tip goes when the axis becomes `axis`, a unit vector.
  ///
  /// Ensures  The cutter reaches exactly as far against the first normal as before. Where one point of the cutter alone
  ///          does so, it does at the same point of the part. Where several do, as with a flat end on a flat floor, the
  ///          one stays that the tilted cutter touches with. Against other normals, as of a wall beside that floor, it
  ///          reaches no farther than before, as far as a few shifts along them do.
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
  double ball_mm_ = 0;  // the centre's height above the tip; 0: the tip is not a ball
};

}  // namespace gouge
