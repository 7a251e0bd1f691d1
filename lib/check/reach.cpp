#include "lib/check/reach.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

constexpr std::string_view kNoUnitAxis = "the tool axis is no unit vector";
constexpr std::string_view kNoLength =
    "an option of the check is no finite length, or the resolution is not above 0";

bool is_unit(const Vec3& axis) {
  constexpr double kRounding = 1e-6;
  return std::abs(axis.squaredNorm() - 1) <= kRounding;
}

}  // namespace

bool is_within_reach(const Vec3& point) {
  return (point.array().abs() <= kFarthest_mm).all();
}

std::string_view why_unfit(const Motion& motion) {
  if (!motion.is_within(kFarthest_mm)) return kOutOfReach;
  return is_unit(motion.at(0).axis) && is_unit(motion.at(1).axis) ? std::string_view() : kNoUnitAxis;
}

std::string_view why_unfit(const Scene& scene) {
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures}) {
    for (const IndexedMesh& mesh : *meshes) {
      if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) return kOutOfReach;
    }
  }
  return {};
}

std::string_view why_unfit(const CheckOptions& options) {
  const bool are_lengths = std::isfinite(options.tolerance_mm) && std::isfinite(options.resolution_mm) &&
                           std::isfinite(options.gouge_gap_mm) && std::isfinite(options.near_miss_mm);
  return are_lengths && options.resolution_mm > 0 ? std::string_view() : kNoLength;
}

}  // namespace gouge
