#include "lib/hierarchy/sight.h"

#include "lib/base/instruction_sets.h"
#include "lib/hierarchy/traverse.h"

namespace gouge {
namespace {

using LaneFlags = std::array<std::uint8_t, kBlockLanes>;

/// A ray in the tree's own frame.
struct Sight {
  std::array<float, 3> from, toward;
};

// Sets which balls the ray meets.
GOUGE_WIDE void meet_balls(const NodeBlock& node, const Sight& sight, LaneFlags& is_met) {
  for (std::size_t i = 0; i < kBlockLanes; ++i) {
    const float x = node.center[0][i] - sight.from[0];
    const float y = node.center[1][i] - sight.from[1];
    const float z = node.center[2][i] - sight.from[2];
    const float along = x * sight.toward[0] + y * sight.toward[1] + z * sight.toward[2];
    const float ax = x - along * sight.toward[0], ay = y - along * sight.toward[1], az = z - along * sight.toward[2];
    const float radius = node.radius_mm[i];
    is_met[i] = ((along + radius >= 0) & (ax * ax + ay * ay + az * az <= radius * radius)) ? 1 : 0;
  }
}

// Sets which triangles the ray meets, from either side.
GOUGE_WIDE void meet_triangles(const TriangleBlock& leaf, const Sight& sight, LaneFlags& is_met) {
  const float dx = sight.toward[0], dy = sight.toward[1], dz = sight.toward[2];
  for (std::size_t i = 0; i < kBlockLanes; ++i) {
    const float ax = leaf.corner[0][0][i], ay = leaf.corner[0][1][i], az = leaf.corner[0][2][i];
    const float ux = leaf.corner[1][0][i] - ax, uy = leaf.corner[1][1][i] - ay, uz = leaf.corner[1][2][i] - az;
    const float vx = leaf.corner[2][0][i] - ax, vy = leaf.corner[2][1][i] - ay, vz = leaf.corner[2][2][i] - az;
    const float px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    const float volume = ux * px + uy * py + uz * pz;
    const float sx = sight.from[0] - ax, sy = sight.from[1] - ay, sz = sight.from[2] - az;
    const float qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
    // All three shares and the distance are multiplied by the volume and its sign.
    const float sign = volume < 0 ? -1.0F : 1.0F;
    const float u = sign * (sx * px + sy * py + sz * pz);
    const float v = sign * (dx * qx + dy * qy + dz * qz);
    const float t = sign * (vx * qx + vy * qy + vz * qz);
    const float all = sign * volume;
    is_met[i] = ((all > 0) & (u >= 0) & (v >= 0) & (u + v <= all) & (t > 0)) ? 1 : 0;
  }
}

std::uint32_t mask_of(const LaneFlags& flags, std::uint32_t count) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i) mask |= std::uint32_t{flags[i]} << i;
  return mask;
}

/// Visitor that ends at the first triangle that the ray meets.
struct FirstMet {
  const Sight& sight;

  [[nodiscard]] MaskedLanes children(const NodeBlock& node) const {
    LaneFlags is_met{};
    meet_balls(node, sight, is_met);
    return MaskedLanes(mask_of(is_met, node.count));
  }
  [[nodiscard]] bool visit(const TriangleBlock& leaf) const {
    LaneFlags is_met{};
    meet_triangles(leaf, sight, is_met);
    return mask_of(is_met, leaf.count) != 0;
  }
};

}  // namespace

bool is_hidden(const BlockTree& tree, const Vec3& point, const Vec3& toward, double clear_mm) {
  const Vec3 from = point + clear_mm * toward - tree.origin;
  Sight sight{};
  for (int k = 0; k < 3; ++k) {
    sight.from[static_cast<std::size_t>(k)] = static_cast<float>(from[k]);
    sight.toward[static_cast<std::size_t>(k)] = static_cast<float>(toward[k]);
  }
  FirstMet first{sight};
  return traverse(tree, first);
}

}  // namespace gouge
