#include <gougecheck/penetration.h>

#include <cmath>
#include <utility>

#include "cli/library/content.h"
#include "lib/base/tolerance.h"
#include "lib/check/check_options.h"
#include "lib/check/scene_reach.h"
#include "lib/clash/clash.h"
#include "lib/clash/free_shift.h"

namespace gougecheck {
namespace {

gouge::RigidTransform to_transform(const Transform& pose) {
  gouge::RigidTransform transform;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      transform.rotation(row, column) = pose.rotation[static_cast<std::size_t>(3 * row + column)];
  }
  transform.shift = to_vector(pose.shift);
  const Eigen::Matrix3d& r = transform.rotation;
  const double off = (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= gouge::Tolerance::kSameDirection) || !(r.determinant() > 0) || !transform.shift.allFinite()) {
    raise(gouge::make_error("usage",
                            "pose: expected a proper rotation to 1e-9 (no scale, no reflection) and a finite shift"));
  }
  return transform;
}

gouge::IndexedMesh placed(const gouge::IndexedMesh& mesh, const gouge::RigidTransform& transform) {
  gouge::IndexedMesh result = mesh;
  for (gouge::Vec3& vertex : result.vertices) vertex = transform.point(vertex);
  if (const auto error = gouge::find_too_far(result, "body", "the pose")) raise(*error);
  return result;
}

Penetration describe(const gouge::Clash& clash) {
  Penetration result;
  result.state = static_cast<ClashState>(clash.state);
  result.depth = clash.depth_mm;
  result.depth_upper = clash.depth_upper_mm;
  result.distance = clash.closest.distance_mm;
  result.point_a = to_array(clash.closest.a);
  result.point_b = to_array(clash.closest.b);
  if (!clash.deepest.empty()) {
    result.deepest = to_array(clash.deepest.front().point);
    result.normal = to_array(clash.deepest.front().normal);
  }
  result.a_is_inside_b = clash.containment == gouge::Containment::a_in_b;
  result.b_is_inside_a = clash.containment == gouge::Containment::b_in_a;
  result.reason = clash.reason;
  return result;
}

}  // namespace

const char* state_name(ClashState state) {
  constexpr const char* kNames[] = {"free", "touching", "penetrating", "not-certified"};
  return kNames[static_cast<std::size_t>(state)];
}

Penetration penetration(const Mesh& a, const Mesh& b, const Transform& pose_b, const PenetrationOptions& options) {
  if (!(options.tolerance >= 0) || !(options.resolution >= gouge::kFinestResolution_mm) ||
      !std::isfinite(options.tolerance) || !std::isfinite(options.resolution))
    raise(gouge::make_error("usage", "expected a tolerance of at least 0 and a resolution of at least 0.000001 mm"));
  gouge::ClashOptions clash_options;
  clash_options.tolerance_mm = options.tolerance;
  clash_options.resolution_mm = clash_options.gap_mm = options.resolution;
  const gouge::Surface surface_a = a.content().index.prepared(0).surface(gouge::Against::part, 0);
  const gouge::Surface surface_b(placed(b.content().mesh(), to_transform(pose_b)));
  const gouge::ClashBody body_a(surface_a), body_b(surface_b);
  const gouge::Clash clash = gouge::find_clash(body_a, body_b, gouge::Vec3::Zero(), clash_options);
  Penetration result = describe(clash);
  if (options.find_shift && clash.state == gouge::ClashState::penetrating)
    result.shift = to_array(gouge::find_free_shift(body_a, body_b, clash, clash_options).shift);
  return result;
}

}  // namespace gougecheck
