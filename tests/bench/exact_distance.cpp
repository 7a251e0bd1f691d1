#include "tests/bench/exact_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gouge::bench {
namespace {

constexpr std::uint32_t kLeafTriangles = 4;
constexpr double kRounding_mm = 1e-9;  // far above that of doubles at 100 mm, far below every required accuracy

}  // namespace

ExactDistance::ExactDistance(const IndexedMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  middles_.reserve(order_.size());
  for (std::size_t t = 0; t < order_.size(); ++t) {
    middles_.push_back((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0);
  }
  nodes_.reserve(order_.size());
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(order_.size()));
}

void ExactDistance::split(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
  nodes_[node] = bound(first, last);
  if (last - first <= kLeafTriangles) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  Box3 box;
  for (std::uint32_t i = first; i < last; ++i) box.extend(middles_[order_[i]]);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto at = [this](std::uint32_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(first), at(middle), at(last), [this, axis](std::uint32_t a, std::uint32_t b) {
    const double x = middles_[a][axis], y = middles_[b][axis];
    return x < y || (!(y < x) && a < b);
  });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = child;
  nodes_.emplace_back();
  nodes_.emplace_back();
  split(child, first, middle);
  split(child + 1, middle, last);
}

ExactDistance::Node ExactDistance::bound(std::uint32_t first, std::uint32_t last) const {
  Node node;
  Vec3 normal = Vec3::Zero();
  Box3 box;
  for (std::uint32_t i = first; i < last; ++i) {
    const auto t = triangle(order_[i]);
    normal += (t[1] - t[0]).cross(t[2] - t[0]);
    for (const Vec3& p : t) box.extend(p);
  }
  if (normal.norm() > 0) node.normal = normal.normalized();
  node.center = box.center();
  for (std::uint32_t i = first; i < last; ++i) {
    for (const Vec3& p : triangle(order_[i])) {
      const Vec3 d = p - node.center;
      const double height = node.normal.dot(d);
      node.radius = std::max(node.radius, d.norm() + kRounding_mm);
      node.half_thickness = std::max(node.half_thickness, std::abs(height) + kRounding_mm);
      node.disc_radius = std::max(node.disc_radius, (d - height * node.normal).norm() + kRounding_mm);
    }
  }
  return node;
}

std::array<Vec3, 3> ExactDistance::triangle(std::uint32_t index) const {
  return {mesh_.corner(index, 0), mesh_.corner(index, 1), mesh_.corner(index, 2)};
}

double ExactDistance::lower_bound(const ConvexPiece& piece, const Pose& pose, const Node& node) const {
  const PieceSample s = sample_piece(piece, pose, node.center);
  const double steep = s.gradient.dot(node.normal);
  const double flat = (s.gradient - steep * node.normal).norm();
  return s.distance_mm -
         std::min(node.radius, std::abs(steep) * node.half_thickness + flat * node.disc_radius + kRounding_mm);
}

void ExactDistance::descend(const ConvexPiece& piece, const Pose& pose, std::uint32_t index, double accuracy,
                            TriangleMinimum& best) const {
  const Node& node = nodes_[index];
  if (node.count > 0) {
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      lower_over_triangle(piece, pose, triangle(order_[i]), accuracy, best);
    }
    return;
  }
  const double one = lower_bound(piece, pose, nodes_[node.first]);
  const double other = lower_bound(piece, pose, nodes_[node.first + 1]);
  const std::uint32_t near = other < one ? 1 : 0;
  if (std::min(one, other) < best.distance_mm - accuracy) {
    descend(piece, pose, node.first + near, accuracy, best);
  }
  if (std::max(one, other) < best.distance_mm - accuracy) {
    descend(piece, pose, node.first + 1 - near, accuracy, best);
  }
}

TriangleMinimum ExactDistance::minimum(const ConvexPiece& piece, const Pose& pose, double at_max_mm,
                                       double accuracy_mm) const {
  TriangleMinimum best;
  best.distance_mm = at_max_mm;
  descend(piece, pose, 0, accuracy_mm, best);
  return best;
}

void ExactDistance::gather(const ConvexPiece& piece, const Pose& pose, std::uint32_t index, double below,
                           std::vector<std::uint32_t>& found) const {
  const Node& node = nodes_[index];
  if (lower_bound(piece, pose, node) >= below) return;
  if (node.count == 0) {
    gather(piece, pose, node.first, below, found);
    gather(piece, pose, node.first + 1, below, found);
    return;
  }
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    TriangleMinimum best;
    best.distance_mm = below;
    lower_over_triangle(piece, pose, triangle(order_[i]), 1e-6, best);
    if (best.distance_mm < below) found.push_back(order_[i]);
  }
}

std::vector<std::uint32_t> ExactDistance::triangles_below(const ConvexPiece& piece, const Pose& pose,
                                                          double below_mm) const {
  std::vector<std::uint32_t> found;
  gather(piece, pose, 0, below_mm, found);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace gouge::bench
