#include "lib/penetration/find_penetration.h"

#include <algorithm>
#include <limits>

namespace gouge {
namespace {

constexpr float kSingle = 8.0F / (1 << 24);
constexpr std::size_t kFloatsPerBlock = 12;

/// Smallest and largest a . p over blocks of points.
void project(const float* blocks, std::size_t count, float ax, float ay, float az, float& low, float& high) {
  const Float4 x = all4(ax), y = all4(ay), z = all4(az);
  Float4 least = all4(std::numeric_limits<float>::max()), most = -least;
  for (std::size_t b = 0; b < count; ++b) {
    const float* const p = blocks + kFloatsPerBlock * b;
    const Float4 at = x * load4(p) + y * load4(p + 4) + z * load4(p + 8);
    least = min4(least, at);
    most = max4(most, at);
  }
  low = lowest4(least);
  high = highest4(most);
}

float size_of(const float* volume, std::size_t stride) {
  float size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max(size, volume[stride + i] - volume[i]);
  return size;
}

}  // namespace

PenetrationFinder::PenetrationFinder(const DepthBody& body, const PointBody& points,
                                     const PenetrationOptions& options)
    : body_(body),
      points_(points),
      options_(options),
      narrow_(body, options.mode),
      stride_(body.tree.stride),
      axes_(3 * stride_, 0.0F),
      shifts_(stride_, 0.0F),
      turned_(2 * stride_ * points.tree.nodes.size()),
      turn_of_(points.tree.nodes.size(), 0) {
  std::size_t levels = 0;
  for (const KdopNode& node : points.tree.nodes) levels = std::max<std::size_t>(levels, node.level + 1U);
  volume_.resize(2 * stride_ * (levels + 1));
}

const PenetrationAnswer& PenetrationFinder::find(const RigidTransform& pose) {
  answer_.contacts.clear();
  answer_.counters = {};
  if (points_.tree.nodes.empty() || body_.tree.nodes.empty()) return answer_;
  const bool is_turned = !has_turned_ || (pose.rotation.array() != pose_.rotation.array()).any();
  pose_ = pose;
  if (is_turned) turn_axes();
  for (std::size_t i = 0; i < body_.tree.directions.axes.size(); ++i)
    shifts_[i] = static_cast<float>(body_.tree.directions.axes[i].dot(pose.shift));
  slack_ = kSingle * static_cast<float>(points_.reach_mm + pose.shift.cwiseAbs().maxCoeff());
  stack_.assign(1, 0);
  visit(0, {0, 1});
  std::sort(answer_.contacts.begin(), answer_.contacts.end(),
            [](const PointContact& a, const PointContact& b) { return a.point < b.point; });
  return answer_;
}

void PenetrationFinder::turn_axes() {
  const std::vector<Vec3>& axes = body_.tree.directions.axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vec3 turned = pose_.rotation.transpose() * axes[i];
    for (std::size_t k = 0; k < 3; ++k)
      axes_[k * stride_ + i] = static_cast<float>(turned[static_cast<int>(k)]);
  }
  has_turned_ = true;
  ++turn_;
}

void PenetrationFinder::visit(std::uint32_t index, const List& candidates) {
  const KdopNode& node = points_.tree.nodes[index];
  answer_.counters.moving_level = std::max<std::uint32_t>(answer_.counters.moving_level, node.level);
  if (node.children == 0) return visit_leaf(index, candidates);
  List near = candidates;
  const bool has_volume = points_.corner_count[index] > 0;
  if (has_volume) {
    float* const volume = volume_.data() + 2 * stride_ * node.level;
    update_volume(index, volume);
    near = refine(volume, size_of(volume, stride_), candidates);
  }
  if (near.is_empty()) {
    tell_lump(index);
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
  const List near = refine(volume, -1, candidates);
  if (near.is_empty()) {
    tell_lump(index);
  } else {
    narrow_.set_leaves(std::span(stack_).subspan(near.first, near.last - near.first));
    test_points(index);
  }
  stack_.resize(near.first);
}

/// The candidates that meet the volume, opened as long as they are larger than `size`; a negative size opens
/// them down to the leaves. They end up behind all lists in use.
PenetrationFinder::List PenetrationFinder::refine(const float* volume, float size, const List& candidates) {
  const std::size_t first = stack_.size();
  pending_.assign(stack_.begin() + static_cast<std::ptrdiff_t>(candidates.first),
                  stack_.begin() + static_cast<std::ptrdiff_t>(candidates.last));
  while (!pending_.empty()) {
    const std::uint32_t index = pending_.back();
    pending_.pop_back();
    ++answer_.counters.volume_pairs;
    const float* const bounds = body_.tree.bounds_of(index);
    if (!do_overlap(volume, bounds, stride_)) continue;
    const KdopNode& node = body_.tree.nodes[index];
    answer_.counters.static_level = std::max<std::uint32_t>(answer_.counters.static_level, node.level);
    if (node.children == 0 || size_of(bounds, stride_) < size) {
      stack_.push_back(index);
      continue;
    }
    for (std::uint32_t child = node.first; child < node.first + node.children; ++child)
      pending_.push_back(child);
  }
  return {first, stack_.size()};
}

void PenetrationFinder::update_volume(std::uint32_t index, float* volume) {
  float* const turned = turned_.data() + 2 * stride_ * index;
  ++answer_.counters.volumes_updated;
  if (turn_of_[index] == turn_) {
    ++answer_.counters.volumes_shifted;
  } else {
    turn_volume(index, turned);
    turn_of_[index] = turn_;
    answer_.counters.corners_transformed += points_.corner_count[index];
  }
  const Float4 slack = all4(slack_);
  for (std::size_t i = 0; i < stride_; i += 4) {
    const Float4 shift = load4(shifts_.data() + i);
    store4(volume + i, load4(turned + i) + shift - slack);
    store4(volume + stride_ + i, load4(turned + stride_ + i) + shift + slack);
  }
}

void PenetrationFinder::turn_volume(std::uint32_t index, float* volume) {
  const std::uint32_t first = points_.corner_first[index];
  const float* const blocks = points_.corners.data() + kFloatsPerBlock * first;
  const std::size_t count = points_.corner_first[index + 1] - first;
  for (std::size_t i = 0; i < stride_; ++i) {
    project(blocks, count, axes_[i], axes_[stride_ + i], axes_[2 * stride_ + i], volume[i],
            volume[stride_ + i]);
  }
}

void PenetrationFinder::bound_points(std::uint32_t index, float* volume) {
  const std::size_t count = (points_.tree.nodes[index].item_count + 3) / 4;
  const float* const blocks = points_.leaf_points.data() + kFloatsPerBlock * points_.leaf_first[index];
  for (std::size_t i = 0; i < stride_; ++i) {
    project(blocks, count, axes_[i], axes_[stride_ + i], axes_[2 * stride_ + i], volume[i],
            volume[stride_ + i]);
    volume[i] += shifts_[i] - slack_;
    volume[stride_ + i] += shifts_[i] + slack_;
  }
  answer_.counters.points_transformed += points_.tree.nodes[index].item_count;
}

/// Nothing of the surface lies in the node's volume: all its points are on one side, far from the surface.
void PenetrationFinder::tell_lump(std::uint32_t index) {
  if (!options_.is_deeper_told || options_.mode != NarrowMode::exact) return;
  const KdopNode& node = points_.tree.nodes[index];
  const auto place_of = [&](std::uint32_t k) {
    return pose_.point(points_.points[points_.tree.order[node.item_first + k]]);
  };
  const Vec3 first = place_of(0);
  if (!is_in_box(first)) return;
  ++answer_.counters.inside_tests;
  const auto foot = nearest_foot(body_, first);
  if (!foot || !foot->is_inside) return;
  for (std::uint32_t k = 0; k < node.item_count; ++k)
    tell_if_deep(points_.tree.order[node.item_first + k], place_of(k));
}

void PenetrationFinder::test_points(std::uint32_t index) {
  const KdopNode& node = points_.tree.nodes[index];
  for (std::uint32_t k = 0; k < node.item_count; ++k) {
    const std::uint32_t point = points_.tree.order[node.item_first + k];
    const Vec3 place = pose_.point(points_.points[point]);
    const NarrowAnswer found = narrow_.test(place, answer_.counters);
    if (found.side == NarrowAnswer::Side::inside && found.depth_mm > 0) {
      answer_.contacts.push_back(
          {{place, found.normal, found.depth_mm, options_.body, body_.mesh.file_triangle[found.triangle]},
           point,
           false});
    } else if (found.side == NarrowAnswer::Side::unknown && options_.mode == NarrowMode::exact) {
      tell_if_deep(point, place);
    }
  }
}

void PenetrationFinder::tell_if_deep(std::uint32_t point, const Vec3& place) {
  if (!options_.is_deeper_told || !is_in_box(place)) return;
  ++answer_.counters.inside_tests;
  const auto foot = nearest_foot(body_, place);
  if (!foot || !foot->is_inside) return;
  answer_.contacts.push_back(
      {{place, foot->normal, foot->distance_mm, options_.body, body_.mesh.file_triangle[foot->triangle]},
       point,
       foot->distance_mm > body_.options.depth_mm});
}

bool PenetrationFinder::is_in_box(const Vec3& place) const {
  const float* const box = body_.boxes.data();
  for (int i = 0; i < 3; ++i) {
    if (place[i] < static_cast<double>(box[i]) || place[i] > static_cast<double>(box[i + 3])) return false;
  }
  return true;
}

}  // namespace gouge
