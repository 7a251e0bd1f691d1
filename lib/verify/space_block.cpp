#include "lib/verify/space_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/verify/bounds.h"

namespace gouge {

std::array<Vec3, 8> SpaceBlock::corners() const {
  std::array<Vec3, 8> all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = center;
    for (std::size_t i = 0; i < 3; ++i) all[k] += ((k >> i) & 1U) != 0 ? arms[i] : Vec3(-arms[i]);
  }
  return all;
}

double SpaceBlock::radius_mm() const {
  double diagonal = 0;
  // Opposite corners have the same distance.
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      diagonal = std::max(diagonal,
                          length(Bounds3(arms[0]) + Bounds(y) * Bounds3(arms[1]) + Bounds(z) * Bounds3(arms[2])).sup());
  return diagonal;
}

std::size_t SpaceBlock::longest() const {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (arms[k].squaredNorm() > arms[longest].squaredNorm()) longest = k;
  return longest;
}

std::array<SpaceBlock, 2> SpaceBlock::halves(std::size_t arm) const {
  std::array<SpaceBlock, 2> both{*this, *this};
  const Vec3 half = 0.5 * arms[arm];
  both[0].arms[arm] = both[1].arms[arm] = half;
  both[0].center = center - half;
  both[1].center = center + half;
  return both;
}

SpaceBlock SpaceBlock::section(std::size_t arm) const {
  SpaceBlock flat = *this;
  flat.arms[arm] = Vec3::Zero();
  return flat;
}

SpaceBlock SpaceBlock::grown(double by_mm) const {
  SpaceBlock block = *this;
  for (Vec3& arm : block.arms) {
    const double size = arm.norm();
    if (size > 0) arm *= std::max(0.0, size + by_mm) / size;
  }
  return block;
}

SpaceBlock block_around(const Vec3& low, const Vec3& high, const BlockFrame& frame) {
  constexpr double kRounding_mm = 1e-6;
  const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  SpaceBlock block{middle, {}};
  for (std::size_t k = 0; k < 3; ++k) block.arms[k] = (frame[k].cwiseAbs().dot(half) + kRounding_mm) * frame[k];
  return block;
}

BlockFrame frame_along(const Vec3& axis, const Vec3& along) {
  constexpr double kLeast = 1e-3;
  Vec3 first = along - along.dot(axis) * axis;
  if (first.norm() < kLeast * along.norm() || !(along.squaredNorm() > 0)) {
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    first = Vec3::Unit(least) - axis[least] * axis;
  }
  first.normalize();
  return {first, axis.cross(first), axis};
}

SurfacePatch block_patch(const SpaceBlock& block) {
  SurfacePatch patch;
  patch.shape = PatchShape::block;
  patch.center = block.center;
  patch.arms = block.arms;
  patch.radius_mm = block.radius_mm();
  return patch;
}

}  // namespace gouge
