#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lib/tool/compiled_tool.h"

// Finds the points within a tool that no surface can separate as long as it stays within a given depth of the tool.
// Proof: docs/method/inside_outside.md.

namespace gouge {

/// A connected part of the points that lie deeper in the tool than a given depth. It is a stretch of the axis with the
/// points around it, or a ring about the axis.
struct FreeRegion {
  double z_lo_mm = 0, z_hi_mm = 0;  ///< range on the axis; both are equal for a ring
  Vec2 deepest = Vec2::Zero();      ///< (r, z) of its deepest point
  double depth_mm = 0;              ///< depth of the deepest point
  std::size_t ring = kNoRing;       ///< index of the ring in the tool
  static constexpr std::size_t kNoRing = static_cast<std::size_t>(-1);

  /// Returns whether this region and `other`, found in one tool for two depths, lie in one region of the smaller depth.
  [[nodiscard]] bool meets(const FreeRegion& other) const {
    return ring == other.ring && z_lo_mm <= other.z_hi_mm && other.z_lo_mm <= z_hi_mm;
  }
};

struct FreeRegions {
  double depth_mm = 0;  ///< the regions contain the points that lie deeper than this
  std::vector<FreeRegion> regions;
  std::array<bool, 3> has_body{};    ///< by Body: the tool has a cutter, shank or holder
  std::array<bool, 3> is_covered{};  ///< by Body: some point of it lies deeper, so a region represents it
  [[nodiscard]] bool covers_all() const;
  /// Returns the first body that no region represents. Requires that there is one.
  [[nodiscard]] Body uncovered() const;
};

/// A finder of the regions of a tool for any depth.
class RegionFinder {
 public:
  /// Cost: a few thousand evaluations. The tool must outlive the object.
  explicit RegionFinder(const CompiledTool& tool);

  /// Finds the regions for a depth.
  ///
  /// Ensures  Every region is connected within the points that lie deeper than `depth_mm`. Two regions may belong
  ///          together. Any stretch of the axis that is in no region exceeds the depth by at most 0.00001 of the tool's
  ///          height.
  /// Cost     About height / (radius - depth) evaluations.
  [[nodiscard]] FreeRegions at(double depth_mm) const;

 private:
  struct Ring {
    Vec2 point = Vec2::Zero();
    double depth_mm = 0;
    double joint_z_mm = 0;      ///< height of the point on the axis that is best connected with the ring
    double joint_depth_mm = 0;  ///< minimum depth on the straight line to that point; not positive: not connected
  };
  void find_rings();
  [[nodiscard]] Ring climb(Vec2 point) const;
  void join_with_axis(Ring& ring) const;
  [[nodiscard]] double depth_at(double r, double z) const;

  const CompiledTool& tool_;
  double min_mm_;
  std::vector<Ring> rings_;
  std::array<bool, 3> has_body_{};
  std::array<double, 3> body_depth_mm_{};  // maximum depth in the range of heights of each body
};

}  // namespace gouge
