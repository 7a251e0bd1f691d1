#include "lib/surface/sheet_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

constexpr double kSheet = 10;  // number of roundings along a ray within which triangles are one sheet

/// A ray from a sheet to its front. It counts the triangles ahead of it and those of the sheet.
class SheetRay {
 public:
  SheetRay(const BlockTree& tree, const Vec3& point, const Vec3& direction, double rounding_mm)
      : tree_(tree),
        point_(point),
        direction_(direction),
        rounding_mm_(rounding_mm),
        beside_{direction.unitOrthogonal(), direction.cross(direction.unitOrthogonal())} {}

  std::optional<SheetSides> run() {
    if (tree_.nodes.empty() || !visit(0)) return std::nullopt;
    sides_.back = sides_.front + through_;
    return sides_;
  }

 private:
  /// Visits a node. Returns false as soon as a result depends on rounding.
  bool visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const LaneBound lane(tree_, node, i);
      const Vec3 from = lane.center - point_;
      const double along = from.dot(direction_), reach = lane.radius_mm + kSheet * rounding_mm_;
      if (along < -reach || from.squaredNorm() - along * along > reach * reach) continue;
      if (!node.has_leaves) {
        if (!visit(node.child[i])) return false;
        continue;
      }
      const TriangleBlock& leaf = tree_.leaves[node.child[i]];
      for (std::size_t k = 0; k < leaf.count; ++k) {
        if (!count(leaf.triangle[k])) return false;
      }
    }
    return true;
  }

  bool count(std::uint32_t triangle) {
    const std::array<Vec3, 3> corners = tree_.corners(triangle);
    std::array<Vec2, 3> flat;
    std::array<double, 3> along{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 from = corners[k] - point_;
      flat[k] = {from.dot(beside_[0]), from.dot(beside_[1])};
      along[k] = from.dot(direction_);
    }
    const double sheet = kSheet * rounding_mm_;
    if (std::max({along[0], along[1], along[2]}) < -sheet) return true;
    std::array<double, 3> turns{};
    bool has_left = false, has_right = false, is_near = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 &a = flat[k], &b = flat[(k + 1) % 3];
      turns[k] = a.x() * b.y() - a.y() * b.x();
      const double slack = rounding_mm_ * (b - a).norm();
      has_left = has_left || turns[k] > slack;
      has_right = has_right || turns[k] < -slack;
      is_near = is_near || std::abs(turns[k]) <= slack;
    }
    if (has_left && has_right) return true;
    if (is_near) return false;
    const double height =
        (turns[1] * along[0] + turns[2] * along[1] + turns[0] * along[2]) / (turns[0] + turns[1] + turns[2]);
    const int sign = has_left ? 1 : -1;
    if (height > sheet) sides_.front += sign;
    if (std::abs(height) <= sheet) {
      through_ += sign;
      sides_.lowest = is_on_sheet_ ? std::min(sides_.lowest, triangle) : triangle;
      is_on_sheet_ = true;
    }
    return true;
  }

  const BlockTree& tree_;
  Vec3 point_, direction_;
  double rounding_mm_;
  std::array<Vec3, 2> beside_;
  SheetSides sides_;
  int through_ = 0;  // increase of the winding number from the front of the sheet to its back
  bool is_on_sheet_ = false;
};

}  // namespace

std::optional<SheetSides> find_sheet_sides(const BlockTree& tree, const Vec3& point, const Vec3& normal,
                                           double rounding_mm) {
  // The directions are oblique, so that few rays run along faces and edges of simple bodies.
  static constexpr std::array<std::array<double, 2>, 8> kTilts = {{{0.31, 0.17},
                                                                   {-0.23, 0.41},
                                                                   {0.53, -0.37},
                                                                   {-0.61, -0.29},
                                                                   {0.07, 0.83},
                                                                   {0.89, 0.13},
                                                                   {-0.11, -0.71},
                                                                   {-0.97, 0.59}}};
  const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
  for (const auto& [a, b] : kTilts) {
    const Vec3 direction = (normal + a * first + b * second).normalized();
    if (const auto sides = SheetRay(tree, point, direction, rounding_mm).run()) return sides;
  }
  return std::nullopt;
}

}  // namespace gouge
