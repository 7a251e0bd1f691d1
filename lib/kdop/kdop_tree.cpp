#include "lib/kdop/kdop_tree.h"

#include <algorithm>
#include <numeric>

namespace gouge {
namespace {

class Builder {
 public:
  Builder(KdopTree& tree, std::span<const Vec3> centres, const KdopTreeOptions& options, const BoundItem& bound)
      : tree_(tree), centres_(centres), options_(options), bound_(bound), item_(2 * tree.stride) {}

  void run() {
    tree_.order.resize(centres_.size());
    std::iota(tree_.order.begin(), tree_.order.end(), 0U);
    if (centres_.empty()) return;
    tree_.nodes.reserve(2 * centres_.size() / options_.leaf_items + 1);
    add_node({0, static_cast<std::uint32_t>(centres_.size())}, 0);
    fill(0);
    tree_.bounds.resize(2 * tree_.stride * tree_.nodes.size());
    for (std::size_t n = tree_.nodes.size(); n-- > 0;) enclose(n);
  }

 private:
  struct Range {
    std::uint32_t first = 0, last = 0;
    [[nodiscard]] std::uint32_t count() const { return last - first; }
  };

  void add_node(const Range& range, std::uint16_t level) {
    KdopNode node;
    node.first = node.item_first = range.first;
    node.item_count = range.count();
    node.level = level;
    tree_.nodes.push_back(node);
  }

  void fill(std::size_t index) {
    const KdopNode node = tree_.nodes[index];
    if (node.item_count <= options_.leaf_items) return;
    const std::vector<Range> parts = cut({node.item_first, node.item_first + node.item_count});
    const std::size_t child = tree_.nodes.size();
    tree_.nodes[index].first = static_cast<std::uint32_t>(child);
    tree_.nodes[index].children = static_cast<std::uint16_t>(parts.size());
    for (const Range& part : parts) add_node(part, static_cast<std::uint16_t>(node.level + 1));
    for (std::size_t k = 0; k < parts.size(); ++k) fill(child + k);
  }

  /// Halves the parts repeatedly until there are `width` parts. A part that fits in a leaf is not divided.
  std::vector<Range> cut(const Range& all) {
    std::vector<Range> parts = {all};
    for (std::size_t now = 1; now < options_.width; now *= 2) {
      std::vector<Range> halves;
      for (const Range& part : parts) {
        if (part.count() <= options_.leaf_items) {
          halves.push_back(part);
          continue;
        }
        const std::uint32_t middle = halve(part);
        halves.push_back({part.first, middle});
        halves.push_back({middle, part.last});
      }
      parts = std::move(halves);
    }
    return parts;
  }

  std::uint32_t halve(const Range& range) {
    Box3 box;
    for (std::uint32_t i = range.first; i < range.last; ++i) box.extend(centres_[tree_.order[i]]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t middle = range.first + range.count() / 2;
    const auto at = [this](std::uint32_t k) { return tree_.order.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(range.first), at(middle), at(range.last), [this, axis](std::uint32_t a, std::uint32_t b) {
      const double x = centres_[a][axis], y = centres_[b][axis];
      return x < y || (!(y < x) && a < b);
    });
    return middle;
  }

  void enclose(std::size_t index) {
    const KdopNode& node = tree_.nodes[index];
    float* const bounds = tree_.bounds_of(index);
    const std::size_t parts = node.children > 0 ? node.children : node.item_count;
    for (std::uint32_t k = 0; k < parts; ++k) {
      const float* part = item_.data();
      if (node.children > 0) {
        part = tree_.bounds_of(node.first + k);
      } else {
        bound_(tree_.order[node.first + k], item_.data());
      }
      if (k == 0) {
        std::copy(part, part + 2 * tree_.stride, bounds);
      } else {
        unite_intervals(bounds, part, tree_.stride);
      }
    }
  }

  KdopTree& tree_;
  std::span<const Vec3> centres_;
  const KdopTreeOptions& options_;
  const BoundItem& bound_;
  std::vector<float> item_;
};

}  // namespace

KdopTree build_kdop_tree(const DirectionSet& directions, std::span<const Vec3> centres, const KdopTreeOptions& options,
                         const BoundItem& bound) {
  KdopTree tree;
  tree.directions = directions;
  tree.stride = interval_stride(directions.axes.size());
  Builder(tree, centres, options, bound).run();
  return tree;
}

void write_intervals(const DirectionSet& directions, std::span<const Vec3> points, double slack_mm, float* intervals) {
  const std::size_t axes = directions.axes.size(), stride = interval_stride(axes);
  for (std::size_t i = 0; i < stride; ++i) {
    double low = -1, high = 1;
    if (i < axes) {
      low = high = directions.axes[i].dot(points[0]);
      for (const Vec3& p : points.subspan(1)) {
        const double at = directions.axes[i].dot(p);
        low = std::min(low, at);
        high = std::max(high, at);
      }
      low -= slack_mm;
      high += slack_mm;
    }
    intervals[low_slot(i)] = static_cast<float>(low);
    intervals[high_slot(i)] = static_cast<float>(high);
  }
}

}  // namespace gouge
