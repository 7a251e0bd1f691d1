#include "lib/field/overcut_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/base/parallel.h"
#include "lib/field/point_tree.h"
#include "lib/penetration/closest_point.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr int kShrinks = 16, kSteps = 64;
// Overcuts of moves that are not the worst of their finding are searched less, and may be reported smaller than
// they are.
constexpr double kMoreThanReported = 2;
// A flat facet of a curved part is taken for the part: what lies below it may be a little nearer to its
// neighbour.
constexpr double kNearer = 0.95;
constexpr double kUnseen = 1.02;  // no eye could tell the difference

}  // namespace

OvercutField::OvercutField(const CheckedToolpath& input, const DepthField& depths)
    : parts_(input.scene->parts.size()), tolerance_mm_(input.options.tolerance_mm), depths_(depths) {
  const std::vector<MoveVerdict>& verdicts = input.result->verdicts;
  solids_.resize(parts_ + input.scene->fixtures.size());
  const double worst = input.result->worst_overcut_mm;
  for (const DepthField::FieldPose& pose : depths.poses()) {
    const MoveVerdict& verdict = verdicts[pose.move];
    const double reported = verdict.overcut_mm.value_or(0);
    if (!(reported > 0) || !verdict.witness || verdict.witness->body == Body::head) continue;
    swept_.push_back({pose, std::min(worst, kMoreThanReported * reported)});
    largest_mm_ = std::max(largest_mm_, reported);
    const Witness& w = *verdict.witness;
    const std::size_t mesh = w.mesh + (w.against == Against::part ? 0 : parts_);
    solids_[mesh] = &input.prepared->surface(w.against, w.mesh);
  }
}

/// Rays in a tree. A pose goes down where its tool can meet them, and follows each ray from its far end back to the
/// tool.
class OvercutField::RayTree {
 public:
  RayTree(const OvercutField& field, const std::vector<Ray>& rays)
      : field_(field), rays_(rays), tree_(starts(rays)), margins_(rays.size(), -1), reported_(rays.size(), 0.0F) {
    for (const PointTree::Node& node : tree_.nodes()) bundles_.push_back(bundle_of(node));
  }

  std::vector<float> result() {
    std::vector<std::uint32_t> all(field_.swept_.size());
    std::iota(all.begin(), all.end(), 0U);
    for_each_chunk(tree_.blocks().size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) visit(tree_.blocks()[b], all);
    });
    return reported_;
  }

 private:
  /// The directions of a node's rays: none differs from `inward` by more than `spread`.
  struct Bundle {
    Vec3 inward = Vec3::Zero();
    double spread = 0;
  };

  static std::vector<Vec3> starts(const std::vector<Ray>& rays) {
    std::vector<Vec3> at;
    at.reserve(rays.size());
    for (const Ray& ray : rays) at.push_back(ray.at);
    return at;
  }

  [[nodiscard]] Bundle bundle_of(const PointTree::Node& node) const {
    Bundle bundle;
    for (std::size_t i = node.first; i < node.last; ++i) bundle.inward += ray(i).inward;
    bundle.inward /= static_cast<double>(node.last - node.first);
    for (std::size_t i = node.first; i < node.last; ++i)
      bundle.spread = std::max(bundle.spread, (ray(i).inward - bundle.inward).norm());
    return bundle;
  }

  [[nodiscard]] const Ray& ray(std::size_t i) const { return rays_[tree_.order()[i]]; }

  /// A ray's point at depth s lies within |s - S/2| + spread S/2 + radius of the middle at S/2.
  [[nodiscard]] bool may_meet(std::size_t at, const SweptPose& swept) const {
    const PointTree::Node& node = tree_.nodes()[at];
    const double half = 0.5 * swept.most_mm;
    const double reach = node.radius + half * (1 + bundles_[at].spread);
    return signed_distance_mm(swept.pose.tool->bare, swept.pose.pose, node.centre + half * bundles_[at].inward) <=
           reach;
  }

  void visit(std::size_t at, const std::vector<std::uint32_t>& all_swept) {
    const PointTree::Node& node = tree_.nodes()[at];
    std::vector<std::uint32_t> near;
    for (const std::uint32_t p : all_swept) {
      if (may_meet(at, field_.swept_[p])) near.push_back(p);
    }
    if (near.empty()) return;
    if (node.child != 0) {
      visit(node.child, near);
      visit(node.child + 1, near);
      return;
    }
    for (std::size_t i = node.first; i < node.last; ++i) {
      for (const std::uint32_t p : near) follow(tree_.order()[i], field_.swept_[p]);
    }
  }

  void follow(std::size_t index, const SweptPose& swept) {
    const Ray& ray = rays_[index];
    const DepthBody* const solid = field_.solids_[ray.mesh];
    if (solid == nullptr || static_cast<double>(reported_[index]) * kUnseen >= swept.most_mm) return;
    double& margin = margins_[index];
    if (margin < 0) margin = field_.margin_mm(*solid, ray, kMoreThanReported * field_.largest_mm_);
    double s = std::min(margin, swept.most_mm);
    const double least = std::max(field_.tolerance_mm_, kUnseen * static_cast<double>(reported_[index]));
    for (int k = 0; k < kSteps && s > least; ++k) {
      const double out = signed_distance_mm(swept.pose.tool->bare, swept.pose.pose, ray.at + s * ray.inward);
      if (out <= 1e-3 * s) {
        reported_[index] = static_cast<float>(s);
        return;
      }
      s -= out;
    }
  }

  const OvercutField& field_;
  const std::vector<Ray>& rays_;
  PointTree tree_;
  std::vector<Bundle> bundles_;  ///< by node
  std::vector<double> margins_;  ///< by ray; negative: not asked for yet
  std::vector<float> reported_;
};

/// How far along the ray its own foot stays the nearest: the radius of the largest ball that touches the
/// surface there from within, found by shrinking it as long as another foot lies in it.
double OvercutField::margin_mm(const DepthBody& solid, const Ray& ray, double most_mm) const {
  double radius = most_mm;
  for (int k = 0; k < kShrinks; ++k) {
    const auto foot = closest_point(solid, ray.at + radius * ray.inward);
    if (!foot || (foot->is_inside && foot->distance_mm >= kNearer * radius)) return radius;
    const Vec3 to = foot->point - ray.at;
    const double deep = to.dot(ray.inward);
    const double next = deep > 0 ? to.squaredNorm() / (2 * deep) : 0.5 * radius;
    radius = std::min(next, kNearer * radius);
  }
  return radius;
}

std::vector<float> OvercutField::overcut_at(const std::vector<Ray>& rays) const {
  return RayTree(*this, rays).result();
}

std::vector<float> OvercutField::at(const std::vector<Ray>& rays) const {
  std::vector<FieldPoint> points;
  points.reserve(rays.size());
  for (const Ray& ray : rays) points.push_back({ray.at, ray.mesh >= parts_});
  std::vector<float> deepest = overcut_at(rays);
  const std::vector<float> depths = depths_.tool_depth_at(points);
  for (std::size_t i = 0; i < deepest.size(); ++i) {
    const bool has_overcut = solids_[rays[i].mesh] != nullptr && deepest[i] > 0;
    if (!has_overcut) deepest[i] = depths[i];
  }
  depths_.heads().deepen(points, deepest);
  return deepest;
}

}  // namespace gouge
