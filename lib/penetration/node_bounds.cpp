#include "lib/penetration/node_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lib/base/parallel.h"

namespace gouge {
namespace {

constexpr std::size_t kChunk = 256, kLanes = BoundBlock::kLanes;

void fill_boxes(DepthBody& body) {
  body.boxes.resize(6 * body.tree.nodes.size());
  for (std::size_t n = body.tree.nodes.size(); n-- > 0;) {
    const KdopNode& node = body.tree.nodes[n];
    float* const box = body.boxes.data() + 6 * n;
    Box3 all;
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      for (const Vec3& corner : body.corners[node.first + k]) all.extend(corner);
    }
    for (int i = 0; i < 3; ++i) {
      if (node.children == 0) {
        box[i] = static_cast<float>(all.min()[i]) - body.slack_mm;
        box[i + 3] = static_cast<float>(all.max()[i]) + body.slack_mm;
        continue;
      }
      const float* const first = body.boxes.data() + 6 * std::size_t{node.first};
      box[i] = first[i];
      box[i + 3] = first[i + 3];
      for (std::size_t k = 1; k < node.children; ++k) {
        box[i] = std::min(box[i], first[6 * k + static_cast<std::size_t>(i)]);
        box[i + 3] = std::max(box[i + 3], first[6 * k + static_cast<std::size_t>(i) + 3]);
      }
    }
  }
}

using Facets = std::span<const std::array<Vec3, 3>>;

/// Lanes that hold nothing are farther than any point.
void clear(BoundBlock& block) {
  const auto below = std::to_array(block.below);
  block = {};
  std::copy(below.begin(), below.end(), block.below);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      block.low[axis][lane] = block.high[axis][lane] = std::numeric_limits<float>::max();
  }
}

void set_lane(BoundBlock& block, std::size_t lane, const Facets& facets, float slack_mm) {
  Vec3 normal = Vec3::Zero();
  Box3 box;
  for (const std::array<Vec3, 3>& facet : facets) {
    normal += (facet[1] - facet[0]).cross(facet[2] - facet[0]);
    for (const Vec3& corner : facet) box.extend(corner);
  }
  normal = normal.squaredNorm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 centre = box.center();
  double low = std::numeric_limits<double>::infinity(), high = -low, radius2 = 0;
  for (const std::array<Vec3, 3>& facet : facets) {
    for (const Vec3& corner : facet) {
      low = std::min(low, normal.dot(corner));
      high = std::max(high, normal.dot(corner));
      radius2 = std::max(radius2, (corner - centre).squaredNorm());
    }
  }
  for (int i = 0; i < 3; ++i) {
    block.low[i][lane] = static_cast<float>(box.min()[i]) - slack_mm;
    block.high[i][lane] = static_cast<float>(box.max()[i]) + slack_mm;
    block.normal[i][lane] = static_cast<float>(normal[i]);
    block.centre[i][lane] = static_cast<float>(centre[i]);
  }
  block.offset[lane] = static_cast<float>(0.5 * (low + high));
  block.half[lane] = static_cast<float>(0.5 * (high - low)) + slack_mm;
  block.radius[lane] = static_cast<float>(std::sqrt(radius2)) + slack_mm;
}

/// Makes the block of a node, and those below it, out of its children or of its facets.
class BlockBuilder {
 public:
  explicit BlockBuilder(DepthBody& body) : body_(body) {}

  void run() {
    const KdopNode& root = body_.tree.nodes[0];
    body_.blocks.emplace_back();
    add(0, root.children > 0 ? &root : nullptr, {root.item_first, root.item_count});
    for_each_chunk(groups_.size(), kChunk, 0, [this](std::size_t first, std::size_t last) {
      for (std::size_t g = first; g < last; ++g) fill(body_.blocks[g], groups_[g]);
    });
  }

 private:
  struct Range {
    std::uint32_t first = 0, count = 0;
  };
  struct Group {
    std::array<Range, kLanes> lanes;
    std::size_t count = 0;
  };

  /// `node`: null for facets of a leaf.
  void add(std::uint32_t block, const KdopNode* node, const Range& facets) {
    Group group;
    std::array<const KdopNode*, kLanes> nodes{};
    if (node != nullptr) {
      for (std::uint32_t k = 0; k < node->children; ++k) {
        const KdopNode& child = body_.tree.nodes[node->first + k];
        nodes[group.count] = child.children > 0 ? &child : nullptr;
        group.lanes[group.count++] = {child.item_first, child.item_count};
      }
    } else {
      for (std::uint32_t k = 0; k < kLanes; ++k) {
        const std::uint32_t from = facets.count * k / kLanes, to = facets.count * (k + 1) / kLanes;
        if (to > from) group.lanes[group.count++] = {facets.first + from, to - from};
      }
    }
    groups_.resize(body_.blocks.size());
    groups_[block] = group;
    const auto child = static_cast<std::uint32_t>(body_.blocks.size());
    std::uint32_t blocks = 0;
    for (std::size_t k = 0; k < group.count; ++k) {
      const bool is_facet = group.lanes[k].count == 1;
      body_.blocks[block].below[k] = is_facet ? group.lanes[k].first | BoundBlock::kIsFacet : child + blocks++;
    }
    body_.blocks.resize(body_.blocks.size() + blocks);
    groups_.resize(body_.blocks.size());
    blocks = 0;
    for (std::size_t k = 0; k < group.count; ++k) {
      if (group.lanes[k].count > 1) add(child + blocks++, nodes[k], group.lanes[k]);
    }
  }

  void fill(BoundBlock& block, const Group& group) const {
    const Facets all(body_.corners);
    clear(block);
    for (std::size_t k = 0; k < group.count; ++k)
      set_lane(block, k, all.subspan(group.lanes[k].first, group.lanes[k].count), body_.slack_mm);
  }

  DepthBody& body_;
  std::vector<Group> groups_;  ///< by block
};

}  // namespace

void fill_node_bounds(DepthBody& body) {
  fill_boxes(body);
  if (!body.tree.nodes.empty()) BlockBuilder(body).run();
}

}  // namespace gouge
