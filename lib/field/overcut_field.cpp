#include "lib/field/overcut_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/field/group_neighbours.h"
#include "lib/field/point_tree.h"
#include "lib/field/tangent_bound.h"

namespace gouge {
namespace {

constexpr int kShrinks = 16, kSteps = 64, kLooks = 8;
// Factor for the overcuts of moves that are not the worst of their finding. They are searched less thoroughly and may
// be reported too small.
constexpr double kMoreThanReported = 2;
// A flat facet of a curved part replaces the part's surface, so points below it may be slightly nearer to its
// neighbour.
constexpr double kNearer = 0.95;
constexpr double kMet = 1e-3;  // share of a depth: a ray that is this near to the tool has met it
constexpr double kOnBoundary_mm = 1e-3;
constexpr double kUnseen = 1.02;  // ratio of two depths that look the same
// Share of a node's radius: poses with a larger spread are evaluated one by one.
constexpr double kCoarse = 0.5;

}  // namespace

/// A tool at one sampled pose, or a group of poses close to each other.
class OvercutField::SweptPose {
 public:
  std::uint32_t parts = 0, first_part = 0;
  double max_mm = 0;  ///< maximum distance that the tool reaches below the surface

  SweptPose(const DepthField::FieldPose& pose, double most) : max_mm(most), pose_(&pose) {}
  /// Builds a group of `parts`, which are poses of one tool. Its own pose is that of the part in the middle.
  SweptPose(std::span<const SweptPose> of, std::uint32_t first) : SweptPose(of[of.size() / 2]) {
    parts = static_cast<std::uint32_t>(of.size());
    first_part = first;
    double shift_mm = 0, turn = 0;
    for (const SweptPose& part : of) {
      max_mm = std::max(max_mm, part.max_mm);
      shift_mm = std::max(shift_mm, (part.pose_->pose.tip - pose_->pose.tip).norm() + part.shift_mm_);
      turn = std::max(turn, (part.pose_->pose.axis - pose_->pose.axis).norm() + part.turn_);
    }
    shift_mm_ = shift_mm;
    turn_ = turn;
  }
  [[nodiscard]] bool is_of(const SweptPose& other) const { return pose_->tool == other.pose_->tool; }

  [[nodiscard]] double distance_mm(const Vec3& point) const {
    return signed_distance_mm(pose_->tool->bare, pose_->pose, point);
  }
  /// Returns a lower bound of the distance from the tool for all points of a node. The node is moved with its centre to
  /// `at`, and by up to `more_mm` farther. The node is flat. Next to a flat tool, the tangent plane of the tool gives a
  /// better bound than the nearest point.
  [[nodiscard]] double out_mm(const PointTree::Node& node, const Vec3& at, double more_mm) const {
    const Pose& pose = pose_->pose;
    const Vec3 d = at - pose.tip;
    const double z = d.dot(pose.axis);
    const Vec3 across = d - z * pose.axis;
    const double r = across.norm();
    const CompiledTool& tool = pose_->tool->bare;
    const ToolDistance here = evaluate(tool, r, z);
    const double out = here.signed_distance_mm - node.radius - more_mm;
    if (!(r > 0)) return out;
    const Vec3 normal = here.normal.x() / r * across + here.normal.y() * pose.axis;
    const double by_plane = here.signed_distance_mm - PointTree::reach_mm(node, normal) - more_mm;
    // The points stay outside even if they are moved by the returned distance.
    const double radius_mm = node.radius + more_mm + std::max(by_plane, 0.0);
    return by_plane > out && is_bounded_by_tangent(tool, here, r, z, radius_mm) ? by_plane : out;
  }
  /// Returns the maximum distance between the parts and this pose, as seen at the point. A change of the axis moves a
  /// point at most by the chord between the axis ends, times the distance from the tip.
  [[nodiscard]] double spread_mm(const Vec3& point) const {
    return parts > 0 ? shift_mm_ + turn_ * (point - pose_->pose.tip).norm() : 0;
  }

 private:
  const DepthField::FieldPose* pose_;
  double shift_mm_ = 0, turn_ = 0;
};

OvercutField::~OvercutField() = default;

OvercutField::OvercutField(const CheckedToolpath& input, const DepthField& depths)
    : obstacles_(obstacle_of_meshes(*input.scene)), tolerance_mm_(input.options.tolerance_mm), depths_(depths) {
  const MoveVerdicts& verdicts = input.result->verdicts;
  solids_.resize(obstacles_.size());
  const double worst = input.result->worst_overcut_mm;
  for (const DepthField::FieldPose& pose : depths.poses()) {
    double largest = 0;
    for (std::size_t move = pose.first_move; move <= pose.last_move; ++move) {
      const MoveVerdict& verdict = verdicts[move];
      const double reported = verdict.overcut_mm();
      if (!(reported > 0) || !verdict.witness || verdict.witness->body == Body::head) continue;
      largest = std::max(largest, reported);
      const Witness& w = *verdict.witness;
      const auto first = std::ranges::find(obstacles_, w.against);
      solids_[static_cast<std::size_t>(first - obstacles_.begin()) + w.mesh] =
          &input.prepared->surface(w.against, w.mesh).boundary();
    }
    if (!(largest > 0)) continue;
    swept_.emplace_back(pose, std::min(worst, kMoreThanReported * largest));
    reach_mm_ = std::max(reach_mm_, swept_.back().max_mm);
    largest_mm_ = std::max(largest_mm_, largest);
  }
  roots_ = group_neighbours(swept_);
}

/// Rays in a tree. It is fast if neighbours in the list are neighbours in space. A pose descends to the nodes where its
/// tool can meet rays, and follows each ray from its far end back to the tool.
class OvercutField::RayTree {
 public:
  RayTree(const OvercutField& field, const std::vector<Ray>& rays)
      : field_(field),
        rays_(rays),
        tree_(rays.size(), [&](std::size_t i) { return rays[i].at; }),
        bundles_(tree_.nodes().size()),
        margins_(rays.size(), -1),
        reported_(rays.size(), 0.0F) {
    for (std::size_t n = bundles_.size(); n-- > 0;) bundles_[n] = bundle_of(tree_.nodes()[n]);
  }

  std::vector<float> result() {
    if (tree_.nodes().empty()) return reported_;
    Swept all;
    for (std::size_t p = field_.swept_.size() - field_.roots_; p < field_.swept_.size(); ++p)
      all.push_back({static_cast<std::uint32_t>(p), field_.swept_[p].max_mm});
    std::vector<Task> tasks;
    split(0, all, tasks);
    for_each_chunk(tasks.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) visit(tasks[k].node, tasks[k].near);
    });
    return reported_;
  }

 private:
  /// A pose, and how far along the rays of a node its tool reaches at most.
  struct Reach {
    std::uint32_t swept = 0;
    double max_mm = 0;
  };
  using Swept = std::vector<Reach>;
  struct Task {
    std::size_t node = 0;
    Swept near;
  };

  /// The directions of a node's rays: each differs from `inward` by at most `spread`.
  struct Bundle {
    Vec3 inward = Vec3::Zero();
    double spread = 0;
  };

  // Computes the bundle of a node. For an inner node it follows from the bundles of the children, which come after it.
  [[nodiscard]] Bundle bundle_of(const PointTree::Node& node) const {
    Bundle bundle;
    if (node.child == 0) {
      for (std::size_t i = node.first; i < node.last; ++i) bundle.inward += rays_[i].inward;
      bundle.inward /= static_cast<double>(node.last - node.first);
      for (std::size_t i = node.first; i < node.last; ++i)
        bundle.spread = std::max(bundle.spread, (rays_[i].inward - bundle.inward).norm());
      return bundle;
    }
    const Bundle &a = bundles_[node.child], &b = bundles_[node.child + 1];
    bundle.inward = 0.5 * (a.inward + b.inward);
    bundle.spread = 0.5 * (a.inward - b.inward).norm() + std::max(a.spread, b.spread);
    return bundle;
  }

  [[nodiscard]] Swept near_of(std::size_t at, const Swept& swept) const {
    Swept near;
    for (const Reach& one : swept) add_near(at, one, near);
    return near;
  }

  /// Goes from the far end of the middle ray back to the place at which the tool may meet any ray. A ray's point at
  /// depth s is near that of the middle ray: within the node's radius plus s times the spread.
  void add_near(std::size_t at, const Reach& of, Swept& near) const {
    const PointTree::Node& node = tree_.nodes()[at];
    const Bundle& bundle = bundles_[at];
    const SweptPose& swept = field_.swept_[of.swept];
    double s = std::min(of.max_mm, swept.max_mm);
    const double apart_mm = swept.spread_mm(node.centre + s * bundle.inward);
    const double slack = s * bundle.spread + apart_mm;
    for (int k = 0; k < kLooks; ++k) {
      const double out = swept.out_mm(node, node.centre + s * bundle.inward, slack);
      if (out <= 0) break;
      s -= out;
      if (s <= field_.tolerance_mm_) return;
    }
    const bool is_coarse = node.child == 0 || apart_mm > kCoarse * node.radius;
    if (swept.parts == 0 || !is_coarse) return near.push_back({of.swept, s});
    for (std::uint32_t k = 0; k < swept.parts; ++k) add_near(at, {swept.first_part + k, s}, near);
  }

  // Descends to the blocks, which become tasks.
  void split(std::size_t at, const Swept& swept, std::vector<Task>& tasks) const {
    Swept near = near_of(at, swept);
    if (near.empty()) return;
    const PointTree::Node& node = tree_.nodes()[at];
    if (node.is_block) {
      tasks.push_back({at, std::move(near)});
      return;
    }
    split(node.child, near, tasks);
    split(node.child + 1, near, tasks);
  }

  void visit(std::size_t at, const Swept& swept) {
    Swept near = near_of(at, swept);
    if (near.empty()) return;
    const PointTree::Node& node = tree_.nodes()[at];
    if (node.child != 0) {
      visit(node.child, near);
      visit(node.child + 1, near);
      return;
    }
    std::ranges::sort(near, [](const Reach& a, const Reach& b) {
      return a.max_mm > b.max_mm || (a.max_mm >= b.max_mm && a.swept < b.swept);
    });
    for (std::size_t i = node.first; i < node.last; ++i) {
      if (field_.solids_[rays_[i].mesh] == nullptr) continue;
      for (const Reach& one : near) {
        if (min_of(i) >= one.max_mm) break;
        follow(i, one);
      }
    }
  }

  [[nodiscard]] double min_of(std::size_t index) const {
    return std::max(field_.tolerance_mm_, kUnseen * static_cast<double>(reported_[index]));
  }

  void follow(std::size_t index, const Reach& one) {
    const Ray& ray = rays_[index];
    const SweptPose& swept = field_.swept_[one.swept];
    double s = deepest_in(swept, ray, one.max_mm, min_of(index));
    if (!(s > 0)) return;
    double& margin = margins_[index];
    if (margin < 0) margin = field_.margin_mm(*field_.solids_[ray.mesh], ray, kMoreThanReported * field_.largest_mm_);
    if (s > margin) s = deepest_in(swept, ray, margin, min_of(index));
    if (s > 0) reported_[index] = static_cast<float>(s);
  }

  // Returns the farthest point of the ray in the tool, searched from `s` back; 0 if no point is beyond `min_mm`.
  static double deepest_in(const SweptPose& swept, const Ray& ray, double s, double min_mm) {
    for (int k = 0; k < kSteps && s > min_mm; ++k) {
      const double out = swept.distance_mm(ray.at + s * ray.inward);
      if (out <= kMet * s) return s;
      s -= out;
    }
    return 0;
  }

  const OvercutField& field_;
  const std::vector<Ray>& rays_;
  PointTree tree_;
  std::vector<Bundle> bundles_;  ///< by node
  std::vector<double> margins_;  ///< by ray; negative: not computed yet
  std::vector<float> reported_;
};

/// Returns how far along the ray its own starting point stays the closest point of the surface. That is the radius of
/// the largest ball inside that touches the surface at this point. The ball is shrunk as long as it contains another
/// surface point.
double OvercutField::margin_mm(const Surface& solid, const Ray& ray, double max_mm) const {
  if (!solid.closest_point(ray.at, kOnBoundary_mm)) return 0;  // the ray is on a shell inside the solid
  double radius = max_mm;
  for (int k = 0; k < kShrinks; ++k) {
    const auto foot = solid.closest_point(ray.at + radius * ray.inward);
    if (!foot || (foot->is_inside && foot->distance_mm >= kNearer * radius)) return radius;
    const Vec3 to = foot->point - ray.at;
    const double deep = to.dot(ray.inward);
    const double next = deep > 0 ? to.squaredNorm() / (2 * deep) : 0.5 * radius;
    radius = std::min(next, kNearer * radius);
  }
  return radius;
}

std::vector<std::uint8_t> OvercutField::may_be_deep(const std::vector<Vec3>& centres, double radius_mm) const {
  // The end of a ray counts as in the tool even slightly outside of it.
  return depths_.may_be_deep(centres, radius_mm, reach_mm_ * (1 + 2 * kMet));
}

std::vector<float> OvercutField::overcut_at(const std::vector<Ray>& rays) const {
  return RayTree(*this, rays).result();
}

std::vector<float> OvercutField::at(const std::vector<Ray>& rays) const {
  std::vector<float> deepest = overcut_at(rays);
  const auto point = [&](std::size_t i) { return FieldPoint{rays[i].at, obstacles_[rays[i].mesh]}; };
  std::vector<std::size_t> without;
  std::vector<FieldPoint> points;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (solids_[rays[i].mesh] != nullptr && deepest[i] > 0) continue;
    without.push_back(i);
    points.push_back(point(i));
  }
  const std::vector<float> depths = depths_.tool_depth_at(points);
  for (std::size_t k = 0; k < without.size(); ++k) deepest[without[k]] = depths[k];
  if (depths_.heads().is_empty()) return deepest;
  points.clear();
  for (std::size_t i = 0; i < rays.size(); ++i) points.push_back(point(i));
  depths_.heads().deepen(points, deepest);
  return deepest;
}

}  // namespace gouge
