#pragma once

#include <array>

#include "lib/geom/vec.h"
#include "lib/verify/separation.h"

namespace gouge {

/// Three perpendicular directions of unit length, up to rounding.
using BlockFrame = std::array<Vec3, 3>;

/// A part of space: the points center + x arms[0] + y arms[1] + z arms[2] with x, y, z in [-1, 1]. mm, part coordinates.
struct SpaceBlock {
  Vec3 center = Vec3::Zero();
  std::array<Vec3, 3> arms{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

  [[nodiscard]] std::array<Vec3, 8> corners() const;
  /// Returns an upper bound of the distance of its points from the centre. Requires RoundsUpward.
  [[nodiscard]] double radius_mm() const;
  /// Returns the longest arm, the first of equal ones.
  [[nodiscard]] std::size_t longest() const;
  /// Cuts an arm in its middle. The half on its negative side comes first.
  [[nodiscard]] std::array<SpaceBlock, 2> halves(std::size_t arm) const;
  /// Returns the section across an arm.
  [[nodiscard]] SpaceBlock section(std::size_t arm) const;
  /// Returns the block whose faces are moved out by a length; in, where it is negative, at most to the centre.
  [[nodiscard]] SpaceBlock grown(double by_mm) const;
};

/// Returns the smallest block along a frame that contains a box, moved out by 1e-6 mm.
[[nodiscard]] SpaceBlock block_around(const Vec3& low, const Vec3& high, const BlockFrame& frame);

/// Returns a frame with `axis` as its third direction. Its first direction is that of `along` without the part along the
/// axis; a coordinate direction takes the place of `along` where little is left.
[[nodiscard]] BlockFrame frame_along(const Vec3& axis, const Vec3& along);

[[nodiscard]] SurfacePatch block_patch(const SpaceBlock& block);

}  // namespace gouge
