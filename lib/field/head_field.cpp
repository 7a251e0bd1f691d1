#include "lib/field/head_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/field/field_instants.h"
#include "lib/geom/point_triangle.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/motion/body_motion.h"
#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

// Maximum step of a head as a share of the scene's size: a longer step would be visible as saw teeth.
constexpr double kSeenStep = 0.01;

double reach_of(std::span<const HeadBody> heads) {
  double reach = 0;
  for (const HeadBody& head : heads) {
    for (const Vec3& v : head.surface.mesh().vertices) reach = std::max(reach, v.norm());
  }
  return reach;
}

// Returns the number of instants at which the material that a swing leaves between two of them is a small share of the
// depth.
std::size_t head_instants(const Motion& motion, double reach_mm, double depth_mm, double max_step_mm) {
  const double travel = BodyMotion(motion).turn_rad() * reach_mm + path_length_mm(motion);
  const double step = std::clamp(std::sqrt(8 * reach_mm * 0.01 * std::max(depth_mm, Tolerance::kFilePoint_mm)),
                                 0.1 * max_step_mm, std::max(max_step_mm, Tolerance::kWitness_mm));
  return static_cast<std::size_t>(std::clamp(std::ceil(travel / step), 1.0, 400.0));
}

bool is_near(const Box3& head, const RigidTransform& to_part, const Box3& scene) {
  const Vec3 centre = to_part.point(head.center());
  return scene.squaredExteriorDistance(centre) <= 0.25 * head.diagonal().squaredNorm();
}

/// A head at one sampled pose, with the functions that PointDepths requires.
class PlacedHead {
 public:
  PlacedHead(const HeadBody& head, const RigidTransform& to_tool, double tolerance_mm)
      : head_(&head), box_(&head.box), to_tool_(&to_tool), tolerance_mm_(tolerance_mm) {}

  /// The triangle of the head that was nearest to the last queried point.
  struct Memory {
    std::optional<std::uint32_t> triangle;
  };
  static constexpr std::uint32_t parts = 0, first_part = 0;
  [[nodiscard]] static bool is_apart(const PointTree::Node&) { return false; }
  [[nodiscard]] static bool is_coarse(const PointTree::Node&) { return false; }

  [[nodiscard]] double floor_mm() const { return tolerance_mm_; }

  [[nodiscard]] DepthRange range_mm(const PointTree::Node& node, double cutoff_mm, Memory& memory) const {
    const Vec3 centre = to_tool_->point(node.centre);
    if (box_->squaredExteriorDistance(centre) >= node.radius * node.radius) return {};
    // No point is deeper than half the thickness of the head. If the node is that large, the tree gives no better
    // bound.
    const double half_mm = 0.5 * box_->sizes().minCoeff();
    if (node.radius >= half_mm) return up_to(half_mm);
    const double remembered_mm = max_from(node, memory);
    if (remembered_mm <= cutoff_mm) return up_to(remembered_mm);
    const ClosestPoint foot = nearest(centre, memory);
    const double least = -foot.signed_mm() - node.radius;
    const double most = std::min({node.radius - foot.signed_mm(), max_from(node, memory), half_mm});
    return {least > tolerance_mm_ ? least : 0, most, most, Vec3::Zero()};
  }

  [[nodiscard]] double depth_mm(const FieldPoint& at, double cutoff_mm, Memory& memory) const {
    const Vec3 point = to_tool_->point(at.at);
    if (!box_->contains(point) || max_at(point, memory) <= cutoff_mm) return 0;
    const ClosestPoint foot = nearest(point, memory);
    return foot.is_inside && foot.distance_mm > tolerance_mm_ ? foot.distance_mm : 0;
  }

 private:
  [[nodiscard]] static DepthRange up_to(double max_mm) { return {0, max_mm, max_mm, Vec3::Zero()}; }

  [[nodiscard]] ClosestPoint nearest(const Vec3& point, Memory& memory) const {
    const ClosestPoint foot = *head_->surface.closest_point(point);
    memory.triangle = foot.triangle;
    return foot;
  }

  // Returns an upper bound of a point's depth. A point inside is no deeper than its distance from any part of the
  // surface, such as the triangle nearest to its neighbour.
  [[nodiscard]] double max_at(const Vec3& point, const Memory& memory) const {
    if (!memory.triangle) return std::numeric_limits<double>::infinity();
    return std::sqrt(closest_on_triangle(point, head_->surface.corners(*memory.triangle)).distance2_mm2);
  }

  // Returns the same bound for a node. The distance is convex, so the node's corners suffice.
  [[nodiscard]] double max_from(const PointTree::Node& node, const Memory& memory) const {
    double most = 0;
    for (int k = 0; k < 8; ++k) most = std::max(most, max_at(corner(node, k), memory));
    return most;
  }

  [[nodiscard]] Vec3 corner(const PointTree::Node& node, int k) const {
    return to_tool_->point(node.box.corner(static_cast<Box3::CornerType>(k)));
  }

  const HeadBody* head_;
  const Box3* box_;
  const RigidTransform* to_tool_;
  double tolerance_mm_;
};

}  // namespace

HeadField::HeadField(const CheckedToolpath& input, std::size_t max_poses)
    : heads_(input.heads), tolerance_mm_(input.options.tolerance_mm) {
  if (heads_.empty()) return;
  Box3 scene;
  for (const ObstacleMeshes& obstacle : obstacles_of(*input.scene)) scene.extend(box_of(obstacle.meshes));
  if (scene.isEmpty()) return;
  const double reach = reach_of(heads_);
  const double max_step = kSeenStep * scene.diagonal().norm();
  const auto wanted = [&](const Motion& motion, std::size_t move) {
    return head_instants(motion, reach, input.result->verdicts[move].depth_mm, max_step);
  };
  std::vector<FieldInstants> picked = pick_instants(input, max_poses, wanted);
  // The deepest moves come first: after they have raised the depth, the others often need no query.
  const auto depth_of = [&](const FieldInstants& one) { return input.result->verdicts[one.move].depth_mm; };
  std::stable_sort(picked.begin(), picked.end(),
                   [&](const FieldInstants& a, const FieldInstants& b) { return depth_of(a) > depth_of(b); });
  for (const FieldInstants& one : picked) {
    const Motion stated = input.options.law.of(*input.toolpath, one.move);
    for (const Motion& motion : shown_motions(stated, input.result->verdicts[one.move].witness)) {
      const BodyMotion moving(motion);
      for (const double t : one.t) {
        const RigidTransform to_part = moving.at(t);
        for (std::size_t h = 0; h < heads_.size(); ++h) {
          if (is_near(heads_[h].box, to_part, scene)) swept_.push_back({h, to_part.inverse()});
        }
      }
    }
  }
}

template <class Bodies>
void HeadField::raise(const std::vector<FieldPoint>& points, std::vector<float>& values,
                      const Bodies& bodies_of) const {
  if (swept_.empty()) return;
  std::vector<PlacedHead> heads;
  heads.reserve(swept_.size());
  for (const SweptPose& p : swept_) heads.emplace_back(heads_[p.head], p.to_tool, tolerance_mm_);
  const std::vector<float> deep = PointDepths(points).deepest(bodies_of(heads));
  for (std::size_t i = 0; i < deep.size(); ++i) values[i] = std::max(values[i], deep[i]);
}

void HeadField::deepen(const std::vector<FieldPoint>& points, std::vector<float>& depth_mm) const {
  raise(
      points, depth_mm, [](const std::vector<PlacedHead>& heads) -> const auto& { return heads; });
}

void HeadField::find_any(const std::vector<FieldPoint>& points, double radius_mm, std::vector<float>& found) const {
  raise(points, found, [&](const std::vector<PlacedHead>& heads) { return any_depths(heads, radius_mm); });
}

}  // namespace gouge
