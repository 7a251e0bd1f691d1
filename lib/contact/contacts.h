#pragma once

#include <optional>
#include <vector>

#include "lib/check/prepared_scene.h"

namespace gouge {

/// A surface point inside the tool (or closer than allowed) at one pose. The correction of thesis 5.3 uses only these.
struct ToolContact {
  Vec3 point = Vec3::Zero();    ///< part coordinates, mm
  Vec3 normal = Vec3::UnitZ();  ///< unit direction in which the tool must move away
  double excess_mm = 0;         ///< distance by which the point exceeds the aim
  Vec3 face = Vec3::Zero();     ///< unit normal of the point's triangle; zero if that has no area
};

/// Maximum depth of surface points in the tool after a correction. It is below the check's tolerance, as a margin for
/// rounding in the written file and for the motion between positions. A negative value keeps a gap of that size.
struct CorrectionAim {
  double workpiece_mm = 0;  ///< for the workpiece in the whole tool
  double others_mm = 0;     ///< for the other obstacles in the whole tool
  double clearance_mm = 0;  ///< for all obstacles, in bodies that must keep a clearance
};

/// Returns one contact for every triangle that exceeds the aim by more than `notable_mm` >= 0. The contact is the
/// triangle's deepest point, to a tenth of its excess. Where a rounded tool meets a flat face, the normal of the deepest
/// contact is exactly that of the face. The order is that of the tree. Cost O(triangles inside the tool).
[[nodiscard]] std::vector<ToolContact> find_contacts(const Pose& pose, const ToolVariants& tool,
                                                     const PreparedScene& scene, const CorrectionAim& aim,
                                                     double notable_mm = 0);

/// Returns the same for one tool and the triangles of one tree.
[[nodiscard]] std::vector<ToolContact> find_contacts(const Pose& pose, const CompiledTool& tool, const BlockTree& tree,
                                                     double aim_mm, double notable_mm = 0);

/// Returns the contact of find_contacts with the largest excess; of equal ones the first. Returns nothing if there is no
/// contact. Triangles that cannot have it are not examined.
[[nodiscard]] std::optional<ToolContact> find_deepest_contact(const Pose& pose, const ToolVariants& tool,
                                                              const PreparedScene& scene, const CorrectionAim& aim,
                                                              double notable_mm = 0);
[[nodiscard]] std::optional<ToolContact> find_deepest_contact(const Pose& pose, const CompiledTool& tool,
                                                              const BlockTree& tree, double aim_mm);

/// Returns a lower bound, close to the truth, of how far the deepest point exceeds the aim at a pose. It is 0 only if
/// the aim is proved to be met to `accuracy_mm`. If `bounds` is given, the number of computed bounds is added to it.
[[nodiscard]] double largest_excess(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene,
                                    const CorrectionAim& aim, double accuracy_mm, std::uint64_t* bounds = nullptr);

/// Returns the same for one tool and the parts.
[[nodiscard]] double largest_excess(const Pose& pose, const CompiledTool& tool, const PreparedScene& scene,
                                    double aim_mm, double accuracy_mm);

/// Maximum depth of a corrected position, as a share of the tolerance. The other half is for the rounding of the
/// written numbers and for the motion between corrected positions.
inline constexpr double kPositionAimShare = 0.5;

/// Maximum depth of a motion between corrected positions, as a share of the tolerance. The rest is for the file's
/// digits.
inline constexpr double kMotionAimShare = 0.8;

/// Gap that the tool keeps from fixtures, and that bodies with a clearance keep additionally.
inline constexpr double kAir_mm = 2e-3;

}  // namespace gouge
