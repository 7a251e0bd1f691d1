#include "lib/penetration/point_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/kdop/kdop_corners.h"

namespace gouge {

namespace {

constexpr double kPointSingle = 4.0 / (1 << 24);

void add_blocks(std::span<const Vec3> points, std::vector<float>& blocks) {
  for (std::size_t first = 0; first < points.size(); first += 4) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 4; ++k) {
        blocks.push_back(static_cast<float>(points[std::min(first + k, points.size() - 1)][axis]));
      }
    }
  }
}

std::uint32_t blocks_in(const std::vector<float>& blocks) { return static_cast<std::uint32_t>(blocks.size() / 12); }

}  // namespace

PointBody build_point_body(std::span<const Vec3> points, const PointBodyOptions& options) {
  PointBody body;
  body.options = options;
  body.points.assign(points.begin(), points.end());
  for (const Vec3& p : points) body.reach_mm = std::max(body.reach_mm, p.norm());
  const double slack = kPointSingle * body.reach_mm;
  body.tree = build_kdop_tree(options.directions, points, {options.width, options.leaf_points},
                              [&](std::uint32_t i, float* intervals) {
                                write_intervals(options.directions, points.subspan(i, 1), slack, intervals);
                              });
  std::vector<Vec3> below;
  for (const KdopNode& node : body.tree.nodes) {
    below.clear();
    for (std::uint32_t k = 0; k < node.item_count; ++k) below.push_back(points[body.tree.order[node.item_first + k]]);
    body.corner_first.push_back(blocks_in(body.corners));
    // If there are fewer points than any volume of this k has corners, their volume need not be computed at all.
    const bool may_pay = !options.is_cost_weighed || below.size() > options.directions.k();
    std::vector<Vec3> corners;
    if (may_pay) corners = kdop_corners(options.directions, intervals_of(options.directions, below));
    if (options.is_cost_weighed && corners.size() > below.size()) corners.clear();
    add_blocks(corners, body.corners);
    body.corner_count.push_back(static_cast<std::uint32_t>(corners.size()));
    body.leaf_first.push_back(blocks_in(body.leaf_points));
    if (node.children == 0) add_blocks(below, body.leaf_points);
  }
  body.corner_first.push_back(blocks_in(body.corners));
  return body;
}

std::vector<Vec3> surface_points(const IndexedMesh& mesh, double spacing_mm) {
  std::vector<Vec3> points = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const auto parts = static_cast<std::size_t>(std::ceil(longest / (std::numbers::sqrt3 * spacing_mm)));
    const double step = 1.0 / static_cast<double>(std::max<std::size_t>(parts, 1));
    for (std::size_t i = 0; i <= parts; ++i) {
      for (std::size_t j = 0; i + j <= parts; ++j) {
        const bool is_corner = i == parts || j == parts || (i == 0 && j == 0);
        if (is_corner) continue;
        points.emplace_back(a + static_cast<double>(i) * step * (b - a) + static_cast<double>(j) * step * (c - a));
      }
    }
  }
  return points;
}

}  // namespace gouge
