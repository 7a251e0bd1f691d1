#include "lib/field/depth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lib/check/path_motion.h"
#include "lib/field/field_instants.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr std::size_t kPosesPerHeadPose = 25;
constexpr std::size_t kGroup = 4;  // instants asked together, and such groups
constexpr double kSpread = 0.5;    // of a node's radius: farther apart they are asked one by one

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// Instants so close that what the tool leaves between two of them stays a small part of the depth.
std::size_t depth_instants(const Motion& motion, const CompiledTool& tool, double depth_mm,
                           const std::optional<Witness>& witness) {
  // A holder is wide, but what moves slowly across the part is mostly the cutter, and its curvature counts.
  const double reach = std::clamp(tool.core_depth_mm, 0.1, std::max(tool.r_max_mm, 0.1));
  // Where it gouges the tool turns about its tip with this lever.
  const double lever = witness ? (witness->point - motion.at(witness->t).tip).norm() : tool.z_max_mm - tool.z_min_mm;
  const double travel = path_length_mm(motion) + std::abs(motion.angle_rad()) * lever;
  const double step = std::max(std::sqrt(8 * reach * 0.01 * std::max(depth_mm, 1e-3)), 0.02 * reach);
  return static_cast<std::size_t>(std::clamp(std::ceil(travel / step), 1.0, 400.0));
}

/// What there is among the points asked about.
struct Kinds {
  bool has_parts = false, has_fixtures = false;
};

/// A tool where it was sampled, or about there at several instants that follow each other, as PointDepths asks.
class PlacedTool {
 public:
  struct Memory {};
  std::uint32_t parts = 0, first_part = 0;

  PlacedTool(const DepthField::FieldPose& pose, const Kinds& kinds, double tolerance_mm)
      : pose_(&pose.pose), tool_(pose.tool), kinds_(kinds), tolerance_mm_(tolerance_mm) {}

  /// Stands for `parts`, those of one tool, and is where the one in the middle is.
  PlacedTool(std::span<const PlacedTool> of, std::uint32_t first) : PlacedTool(of[of.size() / 2]) {
    parts = static_cast<std::uint32_t>(of.size());
    first_part = first;
    for (const PlacedTool& part : of) {
      shift_mm_ = std::max(shift_mm_, (part.pose_->tip - pose_->tip).norm() + part.shift_mm_);
      turn_rad_ = std::max(turn_rad_, angle_between(part.pose_->axis, pose_->axis) + part.turn_rad_);
    }
  }

  [[nodiscard]] bool is_of(const PlacedTool& other) const { return tool_ == other.tool_; }
  [[nodiscard]] bool is_coarse(const PointTree::Node& node) const { return spread_mm(node) > kSpread * node.radius; }

  [[nodiscard]] double floor_mm() const { return has_clearance() ? 0.0 : tolerance_mm_; }

  // The part form holds every other form inside it up to its clearances, so it decides what is far away.
  [[nodiscard]] DepthRange range_mm(const PointTree::Node& node, double, Memory&) const {
    const Vec3 d = node.centre - pose_->tip;
    const double z = d.dot(pose_->axis);
    const Vec3 across = d - z * pose_->axis;
    const double r = across.norm();
    const double spread = parts > 0 ? spread_mm(node) : 0;
    std::optional<DepthRange> range;
    const auto ask = [&](const CompiledTool& form) {
      const ToolDistance here = evaluate(form, r, z);
      DepthRange one{-here.signed_distance_mm - node.radius - spread, 0, 0, Vec3::Zero()};
      one.at_centre_mm = -here.signed_distance_mm + spread;
      if (is_bounded_by_tangent(form, here, node, r, z)) {
        one.slope = -here.normal.x() / r * across - here.normal.y() * pose_->axis;
        one.most_mm = one.at_centre_mm + PointTree::reach_mm(node, one.slope);
      } else {
        one.most_mm = one.at_centre_mm += node.radius;
      }
      range = range ? either(*range, one) : one;
    };
    if (kinds_.has_parts || has_clearance()) ask(tool_->against_part);
    if (kinds_.has_fixtures) ask(tool_->against_fixture);
    if (range->least_mm <= tolerance_mm_) range->least_mm = 0;
    return *range;
  }

  [[nodiscard]] double depth_mm(const FieldPoint& point, double, Memory&) const {
    const double depth =
        -signed_distance_mm(point.is_fixture ? tool_->against_fixture : tool_->against_part, *pose_, point.at);
    const double in_clearance = has_clearance() ? -signed_distance_mm(tool_->with_clearance, *pose_, point.at) : 0;
    return std::max({depth > tolerance_mm_ ? depth : 0.0, in_clearance, 0.0});
  }

 private:
  static DepthRange either(const DepthRange& a, const DepthRange& b) {
    const double most = std::max(a.most_mm, b.most_mm);
    return {std::min(a.least_mm, b.least_mm), most, most, Vec3::Zero()};
  }

  /// Whether the plane tangent to the tool at the foot of the node's centre bounds the node's depth (SupportRange).
  [[nodiscard]] static bool is_bounded_by_tangent(const CompiledTool& form, const ToolDistance& here,
                                                  const PointTree::Node& node, double r, double z) {
    const SupportRange& support = form.elements[here.element].support;
    return std::min(z, here.foot.y()) - node.radius >= support.z_lo_mm &&
           std::max(z, here.foot.y()) + node.radius <= support.z_hi_mm && r - node.radius >= support.r_min_mm && r > 0;
  }

  // As a point of the node sees the tool move between its parts' poses.
  [[nodiscard]] double spread_mm(const PointTree::Node& node) const {
    return shift_mm_ + turn_rad_ * ((node.centre - pose_->tip).norm() + node.radius);
  }

  [[nodiscard]] bool has_clearance() const { return !tool_->with_clearance.elements.empty(); }

  const Pose* pose_;
  const ToolVariants* tool_;
  Kinds kinds_;
  double tolerance_mm_;
  double shift_mm_ = 0, turn_rad_ = 0;  ///< how far from it the parts' tips and axes are
};

// Appends groups of neighbours, groups of those, and so on. Returns how many there are at last.
std::size_t group(std::vector<PlacedTool>& tools) {
  std::size_t first = 0;
  while (true) {
    const std::size_t last = tools.size();
    if (last - first <= kGroup) return last - first;
    for (std::size_t at = first; at < last;) {
      std::size_t end = at + 1;
      while (end < last && end - at < kGroup && tools[end].is_of(tools[at])) ++end;
      tools.push_back(PlacedTool(std::span(tools).subspan(at, end - at), static_cast<std::uint32_t>(at)));
      at = end;
    }
    if (tools.size() - last == last - first) return last - first;
    first = last;
  }
}

}  // namespace

DepthField::DepthField(const CheckedToolpath& input, std::size_t most_poses)
    : heads_(input, most_poses / kPosesPerHeadPose + 1), tolerance_mm_(input.options.tolerance_mm) {
  const auto variants_of = [&](std::size_t move) { return input.tools[input.toolpath->moves[move].tool]; };
  const auto wanted = [&](const Motion& motion, std::size_t move) {
    const MoveVerdict& verdict = input.result->verdicts[move];
    return depth_instants(motion, variants_of(move)->against_part, verdict.depth_mm, verdict.witness);
  };
  for (const FieldInstants& one : pick_instants(input, most_poses, wanted)) {
    const Motion motion = motion_of(*input.toolpath, one.move, input.options.rapid);
    for (const double t : one.t) poses_.push_back({motion.at(t), variants_of(one.move), one.move});
  }
}

std::vector<float> DepthField::tool_depth_at(const std::vector<Point>& points) const {
  if (poses_.empty()) return std::vector<float>(points.size(), 0.0F);
  Kinds kinds;
  for (const Point& point : points) (point.is_fixture ? kinds.has_fixtures : kinds.has_parts) = true;
  std::vector<PlacedTool> tools;
  tools.reserve(poses_.size());
  for (const FieldPose& pose : poses_) tools.emplace_back(pose, kinds, tolerance_mm_);
  const std::size_t roots = group(tools);
  return PointDepths(points).deepest(tools, roots);
}

std::vector<float> DepthField::depth_at(const std::vector<Point>& points) const {
  std::vector<float> depth = tool_depth_at(points);
  heads_.deepen(points, depth);
  return depth;
}

}  // namespace gouge
