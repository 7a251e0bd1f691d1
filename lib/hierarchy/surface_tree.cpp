#include "lib/hierarchy/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gouge {
namespace {

constexpr std::uint32_t kLeafTriangles = 4;

// Bounds are computed in doubles and then widened, so that rounding never lets a point outside.
double widened(double length_mm, double magnitude_mm) {
  return length_mm + 1e-14 * (length_mm + magnitude_mm);
}

class Builder {
 public:
  explicit Builder(std::vector<SurfaceTriangle>&& triangles) : source_(std::move(triangles)) {
    order_.resize(source_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    centroids_.reserve(source_.size());
    for (const SurfaceTriangle& t : source_) {
      centroids_.push_back((t.corners[0] + t.corners[1] + t.corners[2]) / 3.0);
    }
  }

  SurfaceTree build() {
    SurfaceTree tree;
    if (source_.empty()) return tree;
    tree.nodes.reserve(source_.size());
    tree.nodes.emplace_back();
    split(tree, 0, 0, static_cast<std::uint32_t>(source_.size()));
    tree.triangles.reserve(source_.size());
    for (const std::uint32_t i : order_) tree.triangles.push_back(source_[i]);
    return tree;
  }

 private:
  void split(SurfaceTree& tree, std::uint32_t node, std::uint32_t first, std::uint32_t last) {
    tree.nodes[node] = bound(first, last);
    if (last - first <= kLeafTriangles) {
      tree.nodes[node].first = first;
      tree.nodes[node].count = last - first;
      return;
    }
    const std::uint32_t middle = partition(first, last);
    const auto child = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes[node].first = child;
    tree.nodes.emplace_back();
    tree.nodes.emplace_back();
    split(tree, child, first, middle);
    split(tree, child + 1, middle, last);
  }

  std::uint32_t partition(std::uint32_t first, std::uint32_t last) {
    Box3 box;
    for (std::uint32_t i = first; i < last; ++i) box.extend(centroids_[order_[i]]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t middle = first + (last - first) / 2;
    const auto at = [this](std::uint32_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last), [this, axis](std::uint32_t a, std::uint32_t b) {
      const double x = centroids_[a][axis];
      const double y = centroids_[b][axis];
      return x < y || (!(y < x) && a < b);
    });
    return middle;
  }

  SurfaceNode bound(std::uint32_t first, std::uint32_t last) const {
    Vec3 normal = Vec3::Zero();
    for (std::uint32_t i = first; i < last; ++i) {
      const auto& c = source_[order_[i]].corners;
      normal += (c[1] - c[0]).cross(c[2] - c[0]);
    }
    const double length = normal.norm();
    SurfaceNode node;
    node.normal = length > 0 ? Vec3(normal / length) : Vec3::UnitZ();
    const Vec3 u = node.normal.unitOrthogonal();
    const Vec3 v = node.normal.cross(u);
    Box3 local;
    for (std::uint32_t i = first; i < last; ++i) {
      for (const Vec3& x : source_[order_[i]].corners) {
        local.extend(Vec3(u.dot(x), v.dot(x), node.normal.dot(x)));
      }
    }
    const Vec3 mid = local.center();
    node.center = mid.x() * u + mid.y() * v + mid.z() * node.normal;
    double radius2 = 0, disc2 = 0, thickness = 0;
    for (std::uint32_t i = first; i < last; ++i) {
      for (const Vec3& x : source_[order_[i]].corners) {
        const Vec3 d = x - node.center;
        const double height = node.normal.dot(d);
        thickness = std::max(thickness, std::abs(height));
        radius2 = std::max(radius2, d.squaredNorm());
        disc2 = std::max(disc2, (d - height * node.normal).squaredNorm());
      }
    }
    const double magnitude = node.center.cwiseAbs().sum() + local.diagonal().norm();
    node.radius_mm = widened(std::sqrt(radius2), magnitude);
    node.disc_radius_mm = widened(std::sqrt(disc2), magnitude);
    node.half_thickness_mm = widened(thickness, magnitude);
    return node;
  }

  std::vector<SurfaceTriangle> source_;
  std::vector<Vec3> centroids_;
  std::vector<std::uint32_t> order_;
};

void verify_node(const SurfaceTree& tree, std::uint32_t index, std::vector<std::uint32_t>& seen,
                 std::vector<std::uint32_t>& above, std::vector<std::string>& broken) {
  const SurfaceNode& node = tree.nodes[index];
  above.push_back(index);
  if (node.count == 0) {
    verify_node(tree, node.first, seen, above, broken);
    verify_node(tree, node.first + 1, seen, above, broken);
  }
  for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
    ++seen[t];
    for (const std::uint32_t a : above) {
      const SurfaceNode& bound = tree.nodes[a];
      for (const Vec3& x : tree.triangles[t].corners) {
        const Vec3 d = x - bound.center;
        const double height = bound.normal.dot(d);
        const bool is_inside = d.norm() <= bound.radius_mm && std::abs(height) <= bound.half_thickness_mm &&
                               (d - height * bound.normal).norm() <= bound.disc_radius_mm;
        if (!is_inside)
          broken.push_back("node " + std::to_string(a) + " does not hold triangle " + std::to_string(t));
      }
    }
  }
  above.pop_back();
}

}  // namespace

SurfaceTree build_surface_tree(const std::vector<IndexedMesh>& meshes) {
  std::vector<SurfaceTriangle> triangles;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    for (std::size_t t = 0; t < meshes[m].triangles.size(); ++t) {
      triangles.push_back({{meshes[m].corner(t, 0), meshes[m].corner(t, 1), meshes[m].corner(t, 2)},
                           static_cast<std::uint32_t>(m),
                           meshes[m].file_triangle[t]});
    }
  }
  return Builder(std::move(triangles)).build();
}

std::vector<std::string> verify_tree(const SurfaceTree& tree) {
  std::vector<std::string> broken;
  if (tree.nodes.empty()) return broken;
  std::vector<std::uint32_t> seen(tree.triangles.size(), 0), above;
  verify_node(tree, 0, seen, above, broken);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    if (seen[t] != 1)
      broken.push_back("triangle " + std::to_string(t) + " is in " + std::to_string(seen[t]) + " leaves");
  }
  return broken;
}

}  // namespace gouge
