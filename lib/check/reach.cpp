#include "lib/check/reach.h"

#include <algorithm>
#include <cmath>

#include "lib/check/contact_rule.h"

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

Reason::Kind why_unfit(const Pose& pose) {
  if (!is_within_reach(pose.tip)) return Reason::Kind::out_of_reach;
  return is_unit(pose.axis) ? Reason::Kind::none : Reason::Kind::axis_not_unit;
}

Reason::Kind why_unfit(const Scene& scene) {
  for (const ObstacleMeshes& obstacle : obstacles_of(scene)) {
    for (const IndexedMesh& mesh : obstacle.meshes) {
      if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) return Reason::Kind::out_of_reach;
    }
  }
  return Reason::Kind::none;
}

Reason::Kind why_unfit(const ToolVariants& tool) {
  const auto is_near = [](const Vec2& point) { return (point.array().abs() <= kFarthest_mm).all(); };
  const auto is_fit = [&](const BoundaryElement& e) {
    const bool is_shape = e.center.allFinite() && std::isfinite(e.radius_mm) && is_near(e.normal);
    return is_shape && is_near(e.a) && is_near(e.b);
  };
  const auto is_form_fit = [&](const CompiledTool& form) { return std::ranges::all_of(form.elements, is_fit); };
  const bool are_fit =
      is_form_fit(tool.bare) && is_form_fit(tool.with_clearance) &&
      std::ranges::all_of(kContactRules, [&](const ContactRule& rule) { return is_form_fit(tool.*rule.form); });
  return are_fit ? Reason::Kind::none : Reason::Kind::out_of_reach;
}

Reason::Kind why_unfit(const CheckOptions& options) {
  const bool are_lengths = std::isfinite(options.tolerance_mm) && std::isfinite(options.resolution_mm) &&
                           std::isfinite(options.gouge_gap_mm) && std::isfinite(options.near_miss_mm);
  return are_lengths && options.resolution_mm > 0 ? Reason::Kind::none : Reason::Kind::options_invalid;
}

}  // namespace gouge
