#include "lib/field/depth_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/check/path_motion.h"
#include "lib/field/field_instants.h"
#include "lib/tool/evaluate.h"
#include "lib/tool/evaluate_batch.h"

namespace gouge {
namespace {

constexpr std::size_t kPosesPerHeadPose = 25;

// Instants so close that what the tool leaves between two of them stays a small part of the depth.
std::size_t instants_of(const Motion& motion, const CompiledTool& tool, double depth_mm) {
  // A holder is wide, but what moves slowly across the part is mostly the cutter, and its curvature counts.
  const double reach = std::clamp(tool.core_depth_mm, 0.1, std::max(tool.r_max_mm, 0.1));
  const double travel = path_length_mm(motion) + std::abs(motion.angle_rad()) * 0.5 * (tool.z_max_mm - tool.z_min_mm);
  const double step = std::max(std::sqrt(8 * reach * 0.01 * std::max(depth_mm, 1e-3)), 0.02 * reach);
  return static_cast<std::size_t>(std::clamp(std::ceil(travel / step), 1.0, 400.0));
}

/// A tool where it was sampled, as PointDepths asks.
class PlacedTool {
 public:
  PlacedTool(const DepthField::FieldPose& pose, double tolerance_mm)
      : pose_(pose.pose), tool_(*pose.tool), tolerance_mm_(tolerance_mm) {}

  [[nodiscard]] double floor_mm() const { return has_clearance() ? 0.0 : tolerance_mm_; }

  // The part form holds every other form inside it up to its clearances, so it decides what is far away.
  [[nodiscard]] double most_mm(const PointTree::Node& node, double) const {
    return node.radius - std::min(signed_distance_mm(tool_.against_part, pose_, node.centre),
                                  signed_distance_mm(tool_.against_fixture, pose_, node.centre));
  }

  [[nodiscard]] PointDepths::LeafDepths depths(std::span<const FieldPoint> points, std::span<const float>) const {
    constexpr std::size_t kMost = PointTree::kLeafPoints;
    const std::size_t count = points.size();
    std::array<double, kMost> r{}, z{}, part{}, fixture{}, clearance{};
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 d = points[i].at - pose_.tip;
      z[i] = d.dot(pose_.axis);
      r[i] = (d - pose_.axis * z[i]).norm();
    }
    const auto ask = [&](const CompiledTool& form, std::array<double, kMost>& out) {
      signed_distances(form, {r.data(), count}, {z.data(), count}, {out.data(), count});
    };
    ask(tool_.against_part, part);
    ask(tool_.against_fixture, fixture);
    if (has_clearance()) ask(tool_.with_clearance, clearance);
    PointDepths::LeafDepths reported{};
    for (std::size_t i = 0; i < count; ++i) {
      const double depth = -(points[i].is_fixture ? fixture : part)[i];
      reported[i] = static_cast<float>(std::max({depth > tolerance_mm_ ? depth : 0.0, -clearance[i], 0.0}));
    }
    return reported;
  }

 private:
  [[nodiscard]] bool has_clearance() const { return !tool_.with_clearance.elements.empty(); }

  const Pose& pose_;
  const ToolVariants& tool_;
  double tolerance_mm_;
};

}  // namespace

DepthField::DepthField(const CheckedToolpath& input, std::size_t most_poses)
    : heads_(input, most_poses / kPosesPerHeadPose + 1), tolerance_mm_(input.options.tolerance_mm) {
  const auto variants_of = [&](std::size_t move) { return input.tools[input.toolpath->moves[move].tool]; };
  const auto wanted = [&](const Motion& motion, std::size_t move) {
    return instants_of(motion, variants_of(move)->against_part, input.result->verdicts[move].depth_mm);
  };
  for (const FieldInstants& one : pick_instants(input, most_poses, wanted)) {
    const Motion motion = motion_of(*input.toolpath, one.move, input.options.rapid);
    for (const double t : one.t) poses_.push_back({motion.at(t), variants_of(one.move), one.move});
  }
}

std::vector<float> DepthField::tool_depth_at(const std::vector<Point>& points) const {
  if (poses_.empty()) return std::vector<float>(points.size(), 0.0F);
  std::vector<PlacedTool> tools;
  tools.reserve(poses_.size());
  for (const FieldPose& pose : poses_) tools.emplace_back(pose, tolerance_mm_);
  return PointDepths(points).deepest(tools);
}

std::vector<float> DepthField::depth_at(const std::vector<Point>& points) const {
  std::vector<float> depth = tool_depth_at(points);
  heads_.deepen(points, depth);
  return depth;
}

}  // namespace gouge
