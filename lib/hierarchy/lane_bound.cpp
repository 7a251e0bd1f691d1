#include "lib/hierarchy/lane_bound.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

// The length of the stored normal differs from 1 by less than this; so does a distance across it from the true one.
constexpr double kBoundNormal = 1e-6;

Vec3 vector_of(const std::array<Lanes, 3>& lanes, std::size_t lane) {
  return {static_cast<double>(lanes[0][lane]), static_cast<double>(lanes[1][lane]),
          static_cast<double>(lanes[2][lane])};
}

}  // namespace

LaneBound::LaneBound(const BlockTree& tree, const NodeBlock& node, std::size_t lane)
    : center(tree.origin + vector_of(node.center, lane)),
      normal(vector_of(node.normal, lane)),
      half_thickness_mm(static_cast<double>(node.half_thickness_mm[lane])),
      disc_radius_mm(static_cast<double>(node.disc_radius_mm[lane])),
      radius_mm(static_cast<double>(node.radius_mm[lane])) {}

LaneBound::LaneBound(const BlockTree& tree)
    : center(tree.origin),
      half_thickness_mm(tree.radius_mm),
      disc_radius_mm(tree.radius_mm),
      radius_mm(tree.radius_mm) {}

double LaneBound::extent_mm(const Vec3& direction) const {
  const double cosine = std::abs(normal.dot(direction));
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double of_cylinder =
      cosine * half_thickness_mm + sine * disc_radius_mm + kBoundNormal * (half_thickness_mm + disc_radius_mm);
  return std::min(radius_mm, of_cylinder);
}

double LaneBound::min_distance_mm(const Vec3& point) const {
  const Vec3 t = point - center;
  const double height = normal.dot(t);
  const double over = std::max(0.0, std::abs(height) - half_thickness_mm);
  const double beyond = std::max(0.0, (t - height * normal).norm() - disc_radius_mm);
  return std::max({0.0, t.norm() - radius_mm, (1 - kBoundNormal) * std::sqrt(over * over + beyond * beyond)});
}

std::array<Vec3, 8> LaneBound::hull() const {
  const Vec3 up = normal.normalized(), across = up.unitOrthogonal();
  const double disc_mm = disc_radius_mm + kBoundNormal * half_thickness_mm;
  const Vec3 u = disc_mm * across, v = disc_mm * up.cross(across);
  const Vec3 w = (1 + kBoundNormal) * half_thickness_mm * up;
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    corners[k] =
        center + ((k & 1U) != 0 ? u : Vec3(-u)) + ((k & 2U) != 0 ? v : Vec3(-v)) + ((k & 4U) != 0 ? w : Vec3(-w));
  }
  return corners;
}

}  // namespace gouge
