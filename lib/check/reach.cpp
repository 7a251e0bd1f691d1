#include "lib/check/reach.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

bool is_unit(const Vec3& axis) {
  constexpr double kRounding = 1e-6;
  return std::abs(axis.squaredNorm() - 1) <= kRounding;
}

}  // namespace

bool is_within_reach(const Vec3& point) { return (point.array().abs() <= kFarthest_mm).all(); }

Reason::Kind why_unfit(const Motion& motion) {
  if (!motion.is_within(kFarthest_mm)) return Reason::Kind::out_of_reach;
  return is_unit(motion.at(0).axis) && is_unit(motion.at(1).axis) ? Reason::Kind::none : Reason::Kind::axis_not_unit;
}

Reason::Kind why_unfit(const Scene& scene) {
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures}) {
    for (const IndexedMesh& mesh : *meshes) {
      if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) return Reason::Kind::out_of_reach;
    }
  }
  return Reason::Kind::none;
}

Reason::Kind why_unfit(const CheckOptions& options) {
  const bool are_lengths = std::isfinite(options.tolerance_mm) && std::isfinite(options.resolution_mm) &&
                           std::isfinite(options.gouge_gap_mm) && std::isfinite(options.near_miss_mm);
  return are_lengths && options.resolution_mm > 0 ? Reason::Kind::none : Reason::Kind::options_invalid;
}

}  // namespace gouge
