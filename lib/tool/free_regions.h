#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lib/tool/compiled_tool.h"

// Finds the points within a tool that no surface can separate as long as none comes deeper into the tool than a given
// depth. Proof: docs/method/inside_outside.md.

namespace gouge {

/// A connected part of the points that lie deeper in the tool than some depth. It is a stretch of the axis with the
/// points around it, or a ring about the axis.
struct FreeRegion {
  double z_lo_mm = 0, z_hi_mm = 0;  ///< of the axis; equal for a ring
  Vec2 deepest = Vec2::Zero();      ///< (r, z) of its deepest point
  double depth_mm = 0;              ///< there
  std::size_t ring = kNoRing;       ///< which ring of the tool it is
  static constexpr std::size_t kNoRing = static_cast<std::size_t>(-1);

  /// Returns whether both, found in one tool for two depths, lie in one region of the lesser.
  [[nodiscard]] bool meets(const FreeRegion& other) const {
    return ring == other.ring && z_lo_mm <= other.z_hi_mm && other.z_lo_mm <= z_hi_mm;
  }
};

struct FreeRegions {
  double depth_mm = 0;  ///< regions of what lies deeper than this
  std::vector<FreeRegion> regions;
  std::array<bool, 3> has_body{};    ///< by Body: the tool has a cutter, shank, holder
  std::array<bool, 3> is_covered{};  ///< by Body: some point of it lies deeper, so a region represents it
  [[nodiscard]] bool covers_all() const;
  /// Returns the first body that none represents. Requires that there is one.
  [[nodiscard]] Body uncovered() const;
};

/// A tool's regions for any depth.
class RegionFinder {
 public:
  /// Cost: some thousand evaluations. The tool must outlive it.
  explicit RegionFinder(const CompiledTool& tool);

  /// Ensures  Every region is connected within what lies deeper than `depth_mm`; no two of them need be separate.
  ///          A stretch of the axis that is in none is at most 0.00001 of the tool's height deeper.
  /// Cost     About height / (radius - depth) evaluations.
  [[nodiscard]] FreeRegions at(double depth_mm) const;

 private:
  struct Ring {
    Vec2 point = Vec2::Zero();
    double depth_mm = 0;
    double joint_z_mm = 0;      ///< of the point on the axis it is best joined with
    double joint_depth_mm = 0;  ///< nothing on the straight line to there is less deep; not positive: not joined
  };
  void find_rings();
  [[nodiscard]] Ring climb(Vec2 point) const;
  void join_with_axis(Ring& ring) const;
  [[nodiscard]] double depth_at(double r, double z) const;

  const CompiledTool& tool_;
  double min_mm_;
  std::vector<Ring> rings_;
  std::array<bool, 3> has_body_{};
  std::array<double, 3> body_depth_mm_{};  // the deepest point at its heights
};

}  // namespace gouge
