#pragma once

#include <vector>

#include "lib/check/prepared_scene.h"

namespace gouge {

/// A surface point inside the tool (or closer than allowed) at one pose. The one currency of thesis 5.3.
struct ToolContact {
  Vec3 point = Vec3::Zero();    ///< part coordinates, mm
  Vec3 normal = Vec3::UnitZ();  ///< unit direction in which the tool must move away
  double excess_mm = 0;         ///< how much further than the aim allows
  Vec3 face = Vec3::Zero();     ///< unit normal of the triangle it is on; zero where that has no area
};

/// Maximum depth of surface points in the tool after a correction. Below the check's tolerance, so that
/// rounding in the written file and the motion between positions have a margin; a negative value keeps that gap.
struct CorrectionAim {
  double workpiece_mm = 0;  ///< of the workpiece, in the whole tool
  double others_mm = 0;     ///< of the other obstacles, in the whole tool
  double clearance_mm = 0;  ///< of all, in bodies that must keep a clearance
};

/// Returns one contact for every triangle that exceeds the aim by more than `notable_mm` >= 0: its deepest point, to a
/// tenth of its excess. In tree order. Cost O(triangles inside the tool).
[[nodiscard]] std::vector<ToolContact> find_contacts(const Pose& pose, const ToolVariants& tool,
                                                     const PreparedScene& scene, const CorrectionAim& aim,
                                                     double notable_mm = 0);

/// Returns the same of one tool and the triangles of one tree.
[[nodiscard]] std::vector<ToolContact> find_contacts(const Pose& pose, const CompiledTool& tool, const BlockTree& tree,
                                                     double aim_mm, double notable_mm = 0);

/// Returns how much the deepest point exceeds the aim at a pose: never more than the truth, and not much less. 0 only
/// when the aim is proven to be met to `accuracy_mm`. `bounds`, where given, is raised by how many were computed.
[[nodiscard]] double largest_excess(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene,
                                    const CorrectionAim& aim, double accuracy_mm, std::uint64_t* bounds = nullptr);

/// Returns the same of one tool against the parts.
[[nodiscard]] double largest_excess(const Pose& pose, const CompiledTool& tool, const PreparedScene& scene,
                                    double aim_mm, double accuracy_mm);

/// Share of the tolerance by which a corrected position may be deep. The other half is for the rounding of the written
/// numbers and for the motion between corrected positions.
inline constexpr double kPositionAimShare = 0.5;

/// Motions between corrected positions are held to this share of the tolerance: the rest is for the file's digits.
inline constexpr double kMotionAimShare = 0.8;

/// Gap kept from fixtures and by bodies that must keep a clearance.
inline constexpr double kAir_mm = 2e-3;

}  // namespace gouge
