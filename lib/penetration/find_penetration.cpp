#include "lib/penetration/find_penetration.h"

#include <algorithm>
#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr float kPenetrationSingle = 8.0F / (1 << 24);
constexpr std::size_t kFloatsPerTriangleBlock = 12;
constexpr std::size_t kManyFacets = 192, kManyItems = 2000, kNoLimit = std::numeric_limits<std::size_t>::max();

/// Returns the largest side of the volume along its first three axes. In most direction sets these are x, y and z.
float size_of(const float* volume) {
  return std::max({volume[high_slot(0)] - volume[low_slot(0)], volume[high_slot(1)] - volume[low_slot(1)],
                   volume[high_slot(2)] - volume[low_slot(2)]});
}

}  // namespace

PenetrationFinder::PenetrationFinder(const DepthBody& body, const PointBody& points, const PenetrationOptions& options)
    : body_(body),
      points_(points),
      options_(options),
      narrow_(body),
      stride_(body.tree.stride),
      axes_(body.tree.directions),
      shifts_(stride_, 0.0F),
      turned_(2 * stride_ * points.tree.nodes.size()),
      turn_of_(points.tree.nodes.size(), 0) {
  std::size_t levels = 0;
  for (const KdopNode& node : points.tree.nodes) levels = std::max<std::size_t>(levels, node.level + 1U);
  volume_.resize(2 * stride_ * (levels + 1));
}

const PenetrationResult& PenetrationFinder::find(const RigidTransform& pose) {
  result_.contacts.clear();
  result_.counters = {};
  if (points_.tree.nodes.empty() || body_.tree.nodes.empty()) return result_;
  const bool is_turned = !has_turned_ || (pose.rotation.array() != pose_.rotation.array()).any();
  pose_ = pose;
  if (is_turned) {
    axes_.turn(pose.rotation);
    has_turned_ = true;
    ++turn_;
  }
  for (std::size_t i = 0; i < body_.tree.directions.axes.size(); ++i)
    shifts_[i] = static_cast<float>(body_.tree.directions.axes[i].dot(pose.shift));
  slack_ = kPenetrationSingle * static_cast<float>(points_.reach_mm + pose.shift.cwiseAbs().maxCoeff());
  stack_.assign(1, 0);
  visit(0, {0, 1});
  std::sort(result_.contacts.begin(), result_.contacts.end(),
            [](const PointContact& a, const PointContact& b) { return a.point < b.point; });
  return result_;
}

void PenetrationFinder::visit(std::uint32_t index, const List& candidates) {
  const KdopNode& node = points_.tree.nodes[index];
  result_.counters.moving_level = std::max<std::uint32_t>(result_.counters.moving_level, node.level);
  if (node.children == 0) return visit_leaf(index, candidates);
  List near = candidates;
  const bool has_volume = points_.corner_count[index] > 0;
  if (has_volume) {
    float* const volume = volume_.data() + 2 * stride_ * node.level;
    update_volume(index, volume);
    near = refine(volume, size_of(volume), candidates, kNoLimit);
  }
  if (near.is_empty()) {
    report_lump(index);
  } else {
    for (std::uint32_t child = node.first; child < node.first + node.children; ++child) visit(child, near);
  }
  if (has_volume) stack_.resize(near.first);
}

void PenetrationFinder::visit_leaf(std::uint32_t index, const List& candidates) {
  float* const volume = volume_.data() + 2 * stride_ * points_.tree.nodes[index].level;
  if (points_.corner_count[index] > 0) {
    update_volume(index, volume);
  } else {
    bound_points(index, volume);
  }
  // The first refinement opens only nodes larger than half of the volume. If the nodes that remain contain many facets, the
  // facets are small, and a search for each point is cheaper.
  const List coarse = refine(volume, 0.5F * size_of(volume), candidates, kNoLimit);
  if (coarse.is_empty()) {
    report_lump(index);
  } else if (items_of(coarse) > kManyItems) {
    search_points(index);
  } else {
    const List near = refine(volume, -1, coarse, kManyFacets);
    if (near.is_empty()) {
      report_lump(index);
    } else if (near.last - near.first > kManyFacets) {
      search_points(index);
    } else {
      narrow_.set_leaves(std::span(stack_).subspan(near.first, near.last - near.first));
      test_points(index);
    }
  }
  stack_.resize(coarse.first);
}

std::size_t PenetrationFinder::items_of(const List& list) const {
  std::size_t items = 0;
  for (std::size_t i = list.first; i < list.last; ++i) items += body_.tree.nodes[stack_[i]].item_count;
  return items;
}

/// Returns the candidates that meet the volume. They are opened as long as they are larger than `size`; with a negative
/// size down to the leaves. They are stored after all lists in use.
PenetrationFinder::List PenetrationFinder::refine(const float* volume, float size, const List& candidates,
                                                  std::size_t most) {
  const std::size_t first = stack_.size();
  pending_.assign(stack_.begin() + static_cast<std::ptrdiff_t>(candidates.first),
                  stack_.begin() + static_cast<std::ptrdiff_t>(candidates.last));
  while (!pending_.empty() && stack_.size() - first <= most) {
    const std::uint32_t index = pending_.back();
    pending_.pop_back();
    ++result_.counters.volume_pairs;
    const float* const bounds = body_.tree.bounds_of(index);
    if (!do_overlap(volume, bounds, stride_)) continue;
    const KdopNode& node = body_.tree.nodes[index];
    result_.counters.static_level = std::max<std::uint32_t>(result_.counters.static_level, node.level);
    if (node.children == 0 || size_of(bounds) < size) {
      stack_.push_back(index);
      continue;
    }
    for (std::uint32_t child = node.first; child < node.first + node.children; ++child) pending_.push_back(child);
  }
  return {first, stack_.size()};
}

void PenetrationFinder::update_volume(std::uint32_t index, float* volume) {
  float* const turned = turned_.data() + 2 * stride_ * index;
  ++result_.counters.volumes_updated;
  if (turn_of_[index] == turn_) {
    ++result_.counters.volumes_shifted;
  } else {
    const std::uint32_t first = points_.corner_first[index];
    axes_.bound(points_.corners.data() + kFloatsPerTriangleBlock * first, points_.corner_first[index + 1] - first,
                turned);
    turn_of_[index] = turn_;
    result_.counters.corners_transformed += points_.corner_count[index];
  }
  const Float4 slack = all4(slack_);
  for (std::size_t i = 0; i < stride_; i += 4) {
    const Float4 shift = load4(shifts_.data() + i);
    store4(volume + 2 * i, load4(turned + 2 * i) + shift - slack);
    store4(volume + 2 * i + 4, load4(turned + 2 * i + 4) + shift + slack);
  }
}

void PenetrationFinder::bound_points(std::uint32_t index, float* volume) {
  const std::size_t count = (points_.tree.nodes[index].item_count + 3) / 4;
  const float* const blocks = points_.leaf_points.data() + kFloatsPerTriangleBlock * points_.leaf_first[index];
  axes_.bound(blocks, count, volume);
  for (std::size_t i = 0; i < stride_; ++i) {
    volume[low_slot(i)] += shifts_[i] - slack_;
    volume[high_slot(i)] += shifts_[i] + slack_;
  }
  result_.counters.points_transformed += points_.tree.nodes[index].item_count;
}

/// Reports the points of a node whose volume contains no surface. All its points are then on one side, far from the
/// surface.
void PenetrationFinder::report_lump(std::uint32_t index) {
  if (!options_.is_deeper_reported) return;
  const KdopNode& node = points_.tree.nodes[index];
  const auto position_of = [&](std::uint32_t k) {
    return pose_.point(points_.points[points_.tree.order[node.item_first + k]]);
  };
  const Vec3 first = position_of(0);
  const DepthGrid::Cover side = body_.depths.at(first);
  if (side == DepthGrid::Cover::outside || side == DepthGrid::Cover::shallow) return;
  for (std::uint32_t k = 0; k < node.item_count; ++k)
    report_if_deep(points_.tree.order[node.item_first + k], position_of(k));
}

void PenetrationFinder::test_points(std::uint32_t index) {
  const KdopNode& node = points_.tree.nodes[index];
  for (std::uint32_t k = 0; k < node.item_count; ++k) {
    const std::uint32_t point = points_.tree.order[node.item_first + k];
    const Vec3 position = pose_.point(points_.points[point]);
    const DepthGrid::Cover side = body_.depths.at(position);
    if (side == DepthGrid::Cover::outside) continue;
    const NarrowResult found = narrow_.test(position, result_.counters);
    if (found.is_inside && found.depth_mm > 0) {
      report(point, position, found.normal, found.depth_mm, found.triangle);
    } else if (!found.is_inside && side != DepthGrid::Cover::shallow) {
      report_if_deep(point, position);
    }
  }
}

/// Searches the stationary tree for each point. If facets are small compared with the depth, this is cheaper than
/// testing all facets within reach. The last closest point bounds the next search: the distance changes by at most the
/// distance between the points.
void PenetrationFinder::search_points(std::uint32_t index) {
  const KdopNode& node = points_.tree.nodes[index];
  double last_mm = std::numeric_limits<double>::infinity();
  Vec3 last_position = Vec3::Zero();
  for (std::uint32_t k = 0; k < node.item_count; ++k) {
    const std::uint32_t point = points_.tree.order[node.item_first + k];
    const Vec3 position = pose_.point(points_.points[point]);
    if (body_.depths.at(position) == DepthGrid::Cover::outside) continue;
    ++result_.counters.exact_pairs;
    const double within =
        (last_mm + (position - last_position).norm()) * (1 + Tolerance::kRounding) + Tolerance::kRounding;
    const auto foot = body_.surface.closest_point(position, within);
    if (!foot) continue;
    last_mm = foot->distance_mm;
    last_position = position;
    const bool is_reported = options_.is_deeper_reported || foot->distance_mm <= body_.options.depth_mm;
    if (foot->is_inside && foot->distance_mm > 0 && is_reported)
      report(point, position, foot->normal, foot->distance_mm, foot->triangle);
  }
}

void PenetrationFinder::report(std::uint32_t point, const Vec3& position, const Vec3& normal, double depth_mm,
                               std::uint32_t triangle) {
  result_.contacts.push_back({{position, normal, depth_mm, options_.body, body_.mesh().file_triangle[triangle]},
                              point,
                              depth_mm > body_.options.depth_mm});
}

void PenetrationFinder::report_if_deep(std::uint32_t point, const Vec3& position) {
  if (!options_.is_deeper_reported) return;
  ++result_.counters.inside_tests;
  const auto foot = body_.surface.closest_point(position);
  if (foot && foot->is_inside) report(point, position, foot->normal, foot->distance_mm, foot->triangle);
}

}  // namespace gouge
