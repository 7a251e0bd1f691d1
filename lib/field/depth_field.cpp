#include "lib/field/depth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/field/field_instants.h"
#include "lib/field/group_neighbours.h"
#include "lib/field/tangent_bound.h"
#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

constexpr double kMaxSteps = 400;  // maximum number of steps for one move
constexpr std::size_t kPosesPerHeadPose = 25;
constexpr double kSpread = 0.5;  // share of a node's radius: poses with a larger spread are queried one by one

// Share of a depth that need not be visible.
constexpr double kUnseenShare = 0.01;

/// The spacing of the instants of a move.
struct PoseApproach {
  double step_mm = 0;    ///< spacing at which the material left between two instants is not visible
  double unseen_mm = 0;  ///< depth that is not visible
  double lever_mm = 0;   ///< distance from the tip at which the tool gouges; a turn of the axis moves that place
};

PoseApproach approach_of(const Motion& motion, const CompiledTool& tool, const MoveVerdict& verdict) {
  // A holder is wide, but it is mostly the cutter that moves slowly across the part, so the cutter's curvature counts.
  const double reach = std::clamp(tool.core_depth_mm, 0.1, std::max(tool.r_max_mm, 0.1));
  const Boxed<Witness>& witness = verdict.witness;
  PoseApproach out;
  out.lever_mm = witness ? (witness->point - motion.at(witness->t).tip).norm() : tool.z_max_mm - tool.z_min_mm;
  out.unseen_mm = kUnseenShare * std::max(verdict.depth_mm, Tolerance::kFilePoint_mm);
  out.step_mm = std::max(std::sqrt(8 * reach * out.unseen_mm), 0.02 * reach);
  return out;
}

/// A list of consecutive poses, without those that show nothing more than their neighbours.
class PoseList {
 public:
  void add(const DepthField::FieldPose& pose, bool is_worst, const PoseApproach& closest_approach) {
    if (!poses_.empty() && is_same(poses_.back(), pose)) {
      poses_.back().last_move = pose.last_move;
      may_go_ = may_go_ && !is_worst;
      return;
    }
    const bool goes = may_go_ && poses_.size() >= 2 && is_between(pose, closest_approach);
    if (goes) poses_.pop_back();
    poses_.push_back(pose);
    may_go_ = !is_worst && !goes;  // never drops two consecutive poses
    closest_approach_ = closest_approach;
  }
  [[nodiscard]] std::vector<DepthField::FieldPose> take() { return std::move(poses_); }

 private:
  // Returns whether two poses are the same, as the end of a move and the start of the next are.
  static bool is_same(const DepthField::FieldPose& a, const DepthField::FieldPose& b) {
    return a.tool == b.tool && (a.pose.tip - b.pose.tip).norm() <= Tolerance::kRounding &&
           (a.pose.axis - b.pose.axis).norm() <= Tolerance::kRounding;
  }

  // Returns whether the last pose lies between the one before it and `c`, and these two are close enough.
  [[nodiscard]] bool is_between(const DepthField::FieldPose& c, const PoseApproach& of_c) const {
    const DepthField::FieldPose &a = poses_[poses_.size() - 2], &b = poses_.back();
    const bool is_one_run =
        a.tool == b.tool && b.tool == c.tool && b.first_move <= a.last_move + 1 && c.first_move <= b.last_move + 1;
    if (!is_one_run) return false;
    const double lever_mm = std::max(closest_approach_.lever_mm, of_c.lever_mm);
    const auto apart_mm = [&](const Pose& from, const Pose& to) {
      return (from.tip - to.tip).norm() + lever_mm * (from.axis - to.axis).norm();
    };
    const double before_mm = apart_mm(a.pose, b.pose), after_mm = apart_mm(b.pose, c.pose);
    if (before_mm + after_mm > std::min(closest_approach_.step_mm, of_c.step_mm)) return false;
    const double share = before_mm / (before_mm + after_mm);
    const Pose straight{a.pose.tip + share * (c.pose.tip - a.pose.tip),
                        a.pose.axis + share * (c.pose.axis - a.pose.axis)};
    return apart_mm(b.pose, straight) <= std::min(closest_approach_.unseen_mm, of_c.unseen_mm);
  }

  std::vector<DepthField::FieldPose> poses_;
  PoseApproach closest_approach_;  ///< spacing for the last pose
  bool may_go_ = false;            ///< the last pose may be dropped
};

/// The kinds of contact for which points are queried.
struct AskedRules {
  std::array<bool, kContactRules.size()> has{};  ///< indexed by the row of the contact table
  double clearance_mm = 0;                       ///< the largest clearance of a mesh
};

/// A tool at one sampled pose, or a group of poses close to each other, with the functions that PointDepths requires.
class PlacedTool {
 public:
  struct Memory {};
  std::uint32_t parts = 0, first_part = 0;

  PlacedTool(const DepthField::FieldPose& pose, const AskedRules& asked, double tolerance_mm)
      : pose_(&pose.pose), tool_(pose.tool), asked_(asked), tolerance_mm_(tolerance_mm) {}

  /// Builds a group of `parts`, which are poses of one tool. Its own pose is that of the part in the middle.
  PlacedTool(std::span<const PlacedTool> of, std::uint32_t first) : PlacedTool(of[of.size() / 2]) {
    parts = static_cast<std::uint32_t>(of.size());
    first_part = first;
    for (const PlacedTool& part : of) {
      shift_mm_ = std::max(shift_mm_, (part.pose_->tip - pose_->tip).norm() + part.shift_mm_);
      turn_ = std::max(turn_, (part.pose_->axis - pose_->axis).norm() + part.turn_);
    }
  }

  [[nodiscard]] bool is_of(const PlacedTool& other) const { return tool_ == other.tool_; }
  /// Returns whether the parts are too far apart to be queried as one for the node.
  [[nodiscard]] bool is_apart(const PointTree::Node& node) const { return spread_mm(node) > kSpread * node.radius; }
  [[nodiscard]] bool is_coarse(const PointTree::Node& node) const { return node.child == 0 || is_apart(node); }

  [[nodiscard]] double floor_mm() const { return has_clearance() || asked_.clearance_mm > 0 ? 0.0 : tolerance_mm_; }

  // The form that is compared with the workpiece contains every other form, apart from clearances. So it decides about
  // distant nodes.
  [[nodiscard]] DepthRange range_mm(const PointTree::Node& node, double, Memory&) const {
    const Vec3 d = node.centre - pose_->tip;
    const double z = d.dot(pose_->axis);
    const Vec3 across = d - z * pose_->axis;
    const double r = across.norm();
    const double spread = parts > 0 ? spread_mm(node) : 0;
    std::optional<DepthRange> range;
    const auto ask = [&](const CompiledTool& form, double clearance_mm) {
      const ToolDistance here = evaluate(form, r, z);
      DepthRange one{-here.signed_distance_mm - node.radius - spread, 0, 0, Vec3::Zero()};
      one.at_centre_mm = clearance_mm - here.signed_distance_mm + spread;
      if (is_bounded_by_tangent(form, here, r, z, node.radius)) {
        one.slope = -here.normal.x() / r * across - here.normal.y() * pose_->axis;
        one.max_mm = one.at_centre_mm + PointTree::reach_mm(node, one.slope);
      } else {
        one.max_mm = one.at_centre_mm += node.radius;
      }
      range = range ? either(*range, one) : one;
    };
    for (std::size_t k = 0; k < kContactRules.size(); ++k) {
      if (asked_.has[k] || (kContactRules[k].is_workpiece && has_clearance())) ask(tool_->*kContactRules[k].form, 0);
    }
    if (asked_.clearance_mm > 0) ask(tool_->bare, asked_.clearance_mm);
    if (range->min_mm <= tolerance_mm_) range->min_mm = 0;
    return *range;
  }

  [[nodiscard]] double depth_mm(const FieldPoint& point, double, Memory&) const {
    const double depth = -signed_distance_mm(tool_->*rule_of(point.against).form, *pose_, point.at);
    const double in_clearance = has_clearance() ? -signed_distance_mm(tool_->with_clearance, *pose_, point.at) : 0;
    const double below_clearance =
        point.clearance_mm > 0 ? point.clearance_mm - signed_distance_mm(tool_->bare, *pose_, point.at) : 0;
    return std::max({depth > tolerance_mm_ ? depth : 0.0, in_clearance, below_clearance, 0.0});
  }

 private:
  static DepthRange either(const DepthRange& a, const DepthRange& b) {
    const double most = std::max(a.max_mm, b.max_mm);
    return {std::min(a.min_mm, b.min_mm), most, most, Vec3::Zero()};
  }

  // Returns the largest distance by which the tool moves, at a point of the node, between the poses of the parts.
  [[nodiscard]] double spread_mm(const PointTree::Node& node) const {
    return shift_mm_ + turn_ * ((node.centre - pose_->tip).norm() + node.radius);
  }

  [[nodiscard]] bool has_clearance() const { return !tool_->with_clearance.elements.empty(); }

  const Pose* pose_;
  const ToolVariants* tool_;
  AskedRules asked_;
  double tolerance_mm_;
  double shift_mm_ = 0, turn_ = 0;  ///< maximum difference of the parts' tips and axis ends from its own
};

}  // namespace

DepthField::DepthField(const CheckedToolpath& input, std::size_t max_poses)
    : heads_(input, max_poses / kPosesPerHeadPose + 1), tolerance_mm_(input.options.tolerance_mm) {
  for (const double clearance_mm : clearance_of_meshes(*input.scene))
    largest_clearance_mm_ = std::max(largest_clearance_mm_, clearance_mm);
  const auto variants_of = [&](std::size_t move) { return input.tools[input.toolpath->moves[move].tool]; };
  const auto closest_approach = [&](const Motion& motion, std::size_t move) {
    return approach_of(motion, variants_of(move)->against_part, input.result->verdicts[move]);
  };
  const auto wanted = [&](const Motion& motion, std::size_t move) {
    const PoseApproach close = closest_approach(motion, move);
    const double travel = path_length_mm(motion) + motion.turn_rad() * close.lever_mm;
    return static_cast<std::size_t>(std::clamp(std::ceil(travel / close.step_mm), 1.0, kMaxSteps));
  };
  PoseList poses;
  for (FieldInstants& one : pick_instants(input, max_poses, wanted)) {
    const Motion stated = input.options.law.of(*input.toolpath, one.move);
    const Boxed<Witness>& witness = input.result->verdicts[one.move].witness;
    std::ranges::sort(one.t);
    for (const Motion& motion : shown_motions(stated, witness)) {
      const bool is_of_witness = witness && motion.shares_at(witness->t) == witness->turn;
      for (const double t : one.t) {
        const bool is_worst = is_of_witness && !(witness->t < t) && !(t < witness->t);
        poses.add({motion.at(t), variants_of(one.move), one.move, one.move}, is_worst,
                  closest_approach(motion, one.move));
      }
    }
  }
  poses_ = poses.take();
}

namespace {

/// Returns the tools of the poses, followed by groups of neighbours, and the number of last groups that together
/// represent all.
std::pair<std::vector<PlacedTool>, std::size_t> grouped_tools(const std::vector<DepthField::FieldPose>& poses,
                                                              const AskedRules& asked, double tolerance_mm) {
  std::vector<PlacedTool> tools;
  tools.reserve(2 * poses.size());
  for (const DepthField::FieldPose& pose : poses) tools.emplace_back(pose, asked, tolerance_mm);
  const std::size_t roots = group_neighbours(tools);
  return {std::move(tools), roots};
}

}  // namespace

std::vector<float> DepthField::tool_depth_at(const std::vector<Point>& points) const {
  if (poses_.empty()) return std::vector<float>(points.size(), 0.0F);
  AskedRules asked;
  for (const Point& point : points) {
    asked.has[static_cast<std::size_t>(point.against)] = true;
    asked.clearance_mm = std::max(asked.clearance_mm, point.clearance_mm);
  }
  const auto [tools, roots] = grouped_tools(poses_, asked, tolerance_mm_);
  return PointDepths(points).deepest(tools, roots);
}

std::vector<std::uint8_t> DepthField::may_be_deep(const std::vector<Vec3>& centres, double radius_mm,
                                                  double around_mm) const {
  std::vector<Point> points;
  points.reserve(centres.size());
  for (const Vec3& centre : centres) points.push_back({centre});
  std::vector<float> found(points.size(), 0.0F);
  if (!poses_.empty()) {
    AskedRules asked;
    asked.has.fill(true);
    asked.clearance_mm = largest_clearance_mm_;
    const auto [tools, roots] = grouped_tools(poses_, asked, tolerance_mm_);
    const double floor_mm = around_mm > 0 ? 0 : std::numeric_limits<double>::infinity();
    const std::vector<AnyDepth<PlacedTool>> any = any_depths(tools, radius_mm + around_mm, floor_mm);
    found = PointDepths(points).deepest(any, roots);
  }
  heads_.find_any(points, radius_mm, found);
  std::vector<std::uint8_t> out(points.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = found[i] > 0 ? 1 : 0;
  return out;
}

std::vector<float> DepthField::depth_at(const std::vector<Point>& points) const {
  std::vector<float> depth = tool_depth_at(points);
  heads_.deepen(points, depth);
  return depth;
}

}  // namespace gouge
