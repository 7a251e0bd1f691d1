#include "postproc/image/overcut_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/base/parallel.h"
#include "lib/penetration/nearest_foot.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr std::size_t kLeafRays = 16, kBlocks = 64;
constexpr int kShrinks = 16, kSteps = 64;
// Overcuts of moves that are not the worst of their finding are searched less, and may be told smaller than
// they are.
constexpr double kMoreThanTold = 2;
// A flat facet of a curved part is taken for the part: what lies below it may be a little nearer to its
// neighbour.
constexpr double kNearer = 0.95;
constexpr double kUnseen = 1.02;  // no eye could tell the difference

double distance_in(const CompiledTool& tool, const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  return evaluate(tool, (d - pose.axis * z).norm(), z).signed_distance_mm;
}

}  // namespace

OvercutField::OvercutField(const PictureInput& input, const DepthField& depths)
    : tolerance_mm_(input.options.tolerance_mm), depths_(depths) {
  const std::vector<MoveVerdict>& verdicts = input.result->verdicts;
  solids_.resize(input.scene->parts.size() + input.scene->fixtures.size());
  const double worst = input.result->worst_overcut_mm;
  for (const DepthField::FieldPose& pose : depths.poses()) {
    const MoveVerdict& verdict = verdicts[pose.move];
    const double told = verdict.overcut_mm.value_or(0);
    if (!(told > 0) || !verdict.witness || verdict.witness->body == Body::head) continue;
    places_.push_back({pose, std::min(worst, kMoreThanTold * told)});
    largest_mm_ = std::max(largest_mm_, told);
    const Witness& w = *verdict.witness;
    const bool is_part = w.against == Against::part;
    const std::size_t mesh = w.mesh + (is_part ? 0 : input.scene->parts.size());
    if (solids_[mesh]) continue;
    DepthBodyOptions options;
    options.directions = *make_directions(DirectionFamily::cube, 6);
    options.is_lean = true;
    const std::vector<IndexedMesh>& meshes = is_part ? input.scene->parts : input.scene->fixtures;
    solids_[mesh] = std::make_unique<DepthBody>(build_depth_body(meshes[w.mesh], options));
  }
}

/// Rays in a tree of boxes. A pose goes down where its tool can meet them, and follows each ray from its far
/// end back to the tool.
class OvercutField::RayTree {
 public:
  RayTree(const OvercutField& field, const std::vector<Ray>& rays)
      : field_(field), rays_(rays), order_(rays.size()), rooms_(rays.size(), -1), told_(rays.size(), 0.0F) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!rays.empty()) split(0, rays.size(), std::max(rays.size() / kBlocks, kLeafRays), false);
  }

  std::vector<float> answer() {
    std::vector<std::uint32_t> all(field_.places_.size());
    std::iota(all.begin(), all.end(), 0U);
    // Blocks share no rays, so they may be done in any order.
    for_each_chunk(blocks_.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) visit(blocks_[b], all);
    });
    return told_;
  }

 private:
  struct Node {
    Vec3 centre = Vec3::Zero(), inward = Vec3::Zero();
    double radius = 0, spread = 0;  ///< spread: the most that a ray's direction differs from `inward`
    std::size_t first = 0, last = 0, child = 0;
  };

  std::size_t split(std::size_t first, std::size_t last, std::size_t block, bool is_in_block) {
    const std::size_t at = nodes_.size();
    nodes_.push_back(node_of(first, last));
    if (!is_in_block && last - first <= block) {
      blocks_.push_back(at);
      is_in_block = true;
    }
    if (last - first <= kLeafRays) return at;
    Box3 box;
    for (std::size_t i = first; i < last; ++i) box.extend(rays_[order_[i]].at);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(first), place(middle), place(last), [&](std::size_t a, std::size_t b) {
      const double xa = rays_[a].at[axis], xb = rays_[b].at[axis];
      return xa < xb || (!(xb < xa) && a < b);
    });
    split(first, middle, block, is_in_block);
    nodes_[at].child = split(middle, last, block, is_in_block);
    return at;
  }

  [[nodiscard]] Node node_of(std::size_t first, std::size_t last) const {
    Node node;
    node.first = first;
    node.last = last;
    Box3 box;
    for (std::size_t i = first; i < last; ++i) {
      box.extend(rays_[order_[i]].at);
      node.inward += rays_[order_[i]].inward;
    }
    node.centre = box.center();
    node.radius = 0.5 * box.diagonal().norm();
    node.inward /= static_cast<double>(last - first);
    for (std::size_t i = first; i < last; ++i)
      node.spread = std::max(node.spread, (rays_[order_[i]].inward - node.inward).norm());
    return node;
  }

  /// A ray's point at depth s lies within |s - S/2| + spread S/2 + radius of the middle at S/2.
  [[nodiscard]] bool may_meet(const Node& node, const Place& place) const {
    const double half = 0.5 * place.most_mm;
    const double reach = node.radius + half * (1 + node.spread);
    return distance_in(place.pose.tool->bare, place.pose.pose, node.centre + half * node.inward) <= reach;
  }

  void visit(std::size_t at, const std::vector<std::uint32_t>& places) {
    const Node& node = nodes_[at];
    std::vector<std::uint32_t> near;
    for (const std::uint32_t p : places) {
      if (may_meet(node, field_.places_[p])) near.push_back(p);
    }
    if (near.empty()) return;
    if (node.child != 0) {
      visit(at + 1, near);
      visit(node.child, near);
      return;
    }
    for (std::size_t i = node.first; i < node.last; ++i) {
      for (const std::uint32_t p : near) follow(order_[i], field_.places_[p]);
    }
  }

  void follow(std::size_t index, const Place& place) {
    const Ray& ray = rays_[index];
    const DepthBody* const solid = field_.solids_[ray.mesh].get();
    if (solid == nullptr || static_cast<double>(told_[index]) * kUnseen >= place.most_mm) return;
    double& room = rooms_[index];
    if (room < 0) room = field_.room_mm(*solid, ray, kMoreThanTold * field_.largest_mm_);
    double s = std::min(room, place.most_mm);
    const double least = std::max(field_.tolerance_mm_, kUnseen * static_cast<double>(told_[index]));
    for (int k = 0; k < kSteps && s > least; ++k) {
      const double out = distance_in(place.pose.tool->bare, place.pose.pose, ray.at + s * ray.inward);
      if (out <= 1e-3 * s) {
        told_[index] = static_cast<float>(s);
        return;
      }
      s -= out;
    }
  }

  const OvercutField& field_;
  const std::vector<Ray>& rays_;
  std::vector<std::size_t> order_;
  std::vector<double> rooms_;  ///< by ray; negative: not asked for yet
  std::vector<float> told_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> blocks_;
};

/// How far along the ray its own foot stays the nearest: the radius of the largest ball that touches the
/// surface there from within, found by shrinking it as long as another foot lies in it.
double OvercutField::room_mm(const DepthBody& solid, const Ray& ray, double most_mm) const {
  double radius = most_mm;
  for (int k = 0; k < kShrinks; ++k) {
    const auto foot = nearest_foot(solid, ray.at + radius * ray.inward);
    if (!foot || (foot->is_inside && foot->distance_mm >= kNearer * radius)) return radius;
    const Vec3 to = foot->point - ray.at;
    const double deep = to.dot(ray.inward);
    const double next = deep > 0 ? to.squaredNorm() / (2 * deep) : 0.5 * radius;
    radius = std::min(next, kNearer * radius);
  }
  return radius;
}

std::vector<float> OvercutField::at(const std::vector<Ray>& rays) const {
  return RayTree(*this, rays).answer();
}

std::vector<float> OvercutField::on_pixels(const PictureScene& scene, const SurfaceBuffer& buffer) const {
  const PixelPoints seen = pixel_points(buffer);
  std::vector<Ray> rays;
  std::vector<DepthField::Point> points;
  for (const PixelPoints::Point& p : seen.points) {
    const PictureScene::Face& face = scene.faces[p.face];
    const Vec3& a = scene.vertices[face.corners[0]];
    const Vec3 normal = (scene.vertices[face.corners[1]] - a).cross(scene.vertices[face.corners[2]] - a);
    const double length = normal.norm();
    rays.push_back({p.at, length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), face.mesh});
    points.push_back({p.at, face.is_fixture});
  }
  std::vector<float> told = at(rays);
  const std::vector<float> depths = depths_.tool_depth_at(points);
  for (std::size_t i = 0; i < told.size(); ++i) {
    const bool has_overcut = solids_[rays[i].mesh] != nullptr && told[i] > 0;
    if (!has_overcut) told[i] = depths[i];
  }
  depths_.heads().deepen(points, told);
  return seen.spread(told);
}

}  // namespace gouge
