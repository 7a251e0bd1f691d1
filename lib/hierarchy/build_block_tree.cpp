#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/base/large_pages.h"
#include "lib/base/parallel.h"
#include "lib/base/stage.h"
#include "lib/base/tolerance.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/hierarchy/bound_leaves.h"
#include "lib/hierarchy/cut_entries.h"

namespace gouge {
namespace {

using detail::Entry;

// Factor that covers the rounding of the radius.
constexpr double kBlockRoundUp = 1 + Tolerance::kRounding;

// Subtrees of this many triangles are built completely, one by one: their leaves stay in the processor's cache.
constexpr std::size_t kSubtree = kBlockLanes * kBlockLanes * kBlockLanes;

// Ratio of the time that a triangle takes in its subtree to the time of one cut above it. It consists of twelve cuts in
// the cache, and bounds.
constexpr std::size_t kWorkOfSubtrees = 8;

/// Returns the number of triangles in each child of a node over `count` triangles. It is a power of 16, so all blocks
/// but the last of each level are full.
std::size_t child_capacity(std::size_t count) {
  std::size_t capacity = kBlockLanes;
  while (capacity * kBlockLanes < count) capacity *= kBlockLanes;
  return capacity;
}

std::size_t nodes_below(std::size_t count) {
  if (count <= kBlockLanes * kBlockLanes) return 1;
  const std::size_t capacity = child_capacity(count);
  const std::size_t full = count / capacity;
  return 1 + full * nodes_below(capacity) + (count % capacity > 0 ? nodes_below(count % capacity) : 0);
}

/// A node over the entries [first, last).
struct NodeRange {
  std::uint32_t node = 0;
  std::size_t first = 0, last = 0;
};

/// Entries of `parts` children with `capacity` entries each; the last child may have fewer.
struct Cut {
  std::size_t first = 0, last = 0, parts = 1, capacity = 0;
};

Cut children_of(std::size_t first, std::size_t last) {
  const std::size_t capacity = child_capacity(last - first);
  return {first, last, (last - first + capacity - 1) / capacity, capacity};
}

class Builder {
 public:
  Builder(std::span<const IndexedMesh> meshes, unsigned threads) : threads_(threads) {
    Box3 box;
    for (const IndexedMesh& mesh : meshes) {
      tree_.meshes.push_back(&mesh);
      tree_.first_triangle.push_back(static_cast<std::uint32_t>(total_));
      total_ += mesh.triangles.size();
      box.extend(mesh.box());
    }
    if (total_ == 0) return;
    tree_.origin = box.center();
    tree_.radius_mm = kBlockRoundUp * 0.5 * box.diagonal().norm();
    // Twice the rounding of a coordinate of that size to single precision.
    tree_.rounding_mm = Tolerance::kSingleRounding * 0.5 * box.diagonal().norm();
  }

  BlockTree build(std::string_view name, const ProgressCall& progress) {
    if (total_ == 0) return std::move(tree_);
    Stage stage(progress, name, total_, total_ * (1 + cuts_to_subtrees() + kWorkOfSubtrees));
    make_entries();
    stage.add(total_);
    sort_into_subtrees(stage);
    const std::size_t nodes = nodes_below(total_);
    reserve_large(tree_.nodes, nodes);
    tree_.nodes.resize(nodes);
    const std::size_t leaves = (total_ + kBlockLanes - 1) / kBlockLanes;
    reserve_large(tree_.leaves, leaves);
    tree_.leaves.resize(leaves);
    areas_.resize(tree_.leaves.size());
    plan({0, 0, total_});
    for_each_chunk(subtrees_.size(), 1, threads_, [this, &stage](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) {
        make_subtree(subtrees_[j]);
        stage.add((subtrees_[j].range.last - subtrees_[j].range.first) * kWorkOfSubtrees);
      }
    });
    for_each_chunk(lanes_.size(), 1, threads_, [this](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) bound(lanes_[j]);
    });
    for (const std::uint32_t node : upper_) repeat_first(tree_.nodes[node]);
    return std::move(tree_);
  }

 private:
  /// One child of a node and its range of entries.
  struct Lane {
    std::uint32_t node = 0;
    std::size_t lane = 0, first = 0, last = 0;
  };

  void make_entries() {
    reserve_large(entries_, total_);
    entries_.resize(total_);
    for_each_chunk(total_, 1 << 14, threads_, [this](std::size_t first, std::size_t last) {
      std::array<std::array<float, 3>, 3> c;
      for (std::size_t i = first; i < last; ++i) {
        const auto triangle = static_cast<std::uint32_t>(i);
        find_corners(triangle, c);
        Entry& entry = entries_[i];
        entry.triangle = triangle;
        for (std::size_t k = 0; k < 3; ++k) {
          entry.middle[k] = 0.5F * (std::min({c[0][k], c[1][k], c[2][k]}) + std::max({c[0][k], c[1][k], c[2][k]}));
        }
      }
    });
  }

  void find_corners(std::uint32_t triangle, std::array<std::array<float, 3>, 3>& corners) const {
    const std::size_t m = tree_.meshes.size() == 1 ? 0 : tree_.mesh_of(triangle);
    const IndexedMesh& mesh = *tree_.meshes[m];
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& at = mesh.corner(triangle - tree_.first_triangle[m], c);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto kk = static_cast<Eigen::Index>(k);
        corners[c][k] = static_cast<float>(at[kk] - tree_.origin[kk]);
      }
    }
  }

  // Returns approximately in how many cuts each triangle takes part.
  [[nodiscard]] std::size_t cuts_to_subtrees() const {
    return total_ <= kSubtree ? 0 : static_cast<std::size_t>(std::bit_width((total_ - 1) / kSubtree));
  }

  // Makes all cuts of one depth in parallel, from the whole down to the subtrees.
  void sort_into_subtrees(Stage& stage) {
    std::vector<Entry> scratch;
    reserve_large(scratch, total_);
    scratch.resize(total_);
    std::vector<Cut> cuts, next;
    keep_if_large(cuts, 0, total_);
    while (!cuts.empty()) {
      for_each_chunk(cuts.size(), 1, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          cut(cuts[i], {scratch.data() + cuts[i].first, scratch.size() - cuts[i].first});
          stage.add(cuts[i].last - cuts[i].first);
        }
      });
      next.clear();
      for (const Cut& c : cuts) {
        const std::size_t middle = c.first + c.parts / 2 * c.capacity;
        add_half(next, {c.first, middle, c.parts / 2, c.capacity});
        add_half(next, {middle, c.last, c.parts - c.parts / 2, c.capacity});
      }
      cuts.swap(next);
    }
  }

  static void keep_if_large(std::vector<Cut>& cuts, std::size_t first, std::size_t last) {
    if (last - first > kSubtree) cuts.push_back(children_of(first, last));
  }

  static void add_half(std::vector<Cut>& cuts, const Cut& half) {
    if (half.parts > 1) {
      cuts.push_back(half);
    } else {
      keep_if_large(cuts, half.first, half.last);
    }
  }

  void cut(const Cut& c, std::span<Entry> scratch) {
    detail::cut_entries({entries_.data() + c.first, c.last - c.first}, scratch, c.parts / 2 * c.capacity);
  }

  /// Sets the children of a node and calls `visit(lane, child)` for each.
  template <typename Visit>
  void each_child(const NodeRange& at, const Visit& visit) {
    const Cut all = children_of(at.first, at.last);
    NodeBlock& node = tree_.nodes[at.node];
    node.has_leaves = all.capacity == kBlockLanes;
    node.count = static_cast<std::uint32_t>(all.parts);
    auto next = at.node + 1;
    for (std::size_t i = 0; i < all.parts; ++i) {
      const std::size_t first = at.first + i * all.capacity;
      const std::size_t last = std::min(at.last, first + all.capacity);
      node.child[i] = node.has_leaves ? static_cast<std::uint32_t>(first / kBlockLanes) : next;
      visit(i, NodeRange{node.child[i], first, last});
      if (!node.has_leaves) next += static_cast<std::uint32_t>(nodes_below(last - first));
    }
  }

  // Plans the nodes. Those of a subtree are stored together, the parent first, so that their places are known before
  // any is built.
  void plan(const NodeRange& at) {
    if (at.last - at.first <= kSubtree) {
      subtrees_.push_back({at, kNoParent, 0});
      return;
    }
    upper_.push_back(at.node);
    each_child(at, [&](std::size_t lane, const NodeRange& child) {
      if (child.last - child.first <= kSubtree) {
        subtrees_.push_back({child, at.node, lane});
      } else {
        lanes_.push_back({at.node, lane, child.first, child.last});
        plan(child);
      }
    });
  }

  static constexpr std::uint32_t kNoParent = ~0U;

  struct Subtree {
    NodeRange range;
    std::uint32_t parent = kNoParent;
    std::size_t lane = 0;
  };

  void make_subtree(const Subtree& subtree) {
    const NodeRange& at = subtree.range;
    std::vector<Entry> scratch(at.last - at.first);
    sort_into_leaves(children_of(at.first, at.last), scratch);
    for (std::size_t i = at.first; i < at.last; i += kBlockLanes) fill(i, std::min(at.last, i + kBlockLanes));
    make_node(at);
    if (subtree.parent != kNoParent) bound({subtree.parent, subtree.lane, at.first, at.last});
  }

  void sort_into_leaves(const Cut& c, std::span<Entry> scratch) {
    if (c.parts > 1) {
      cut(c, scratch);
      const std::size_t middle = c.first + c.parts / 2 * c.capacity;
      sort_into_leaves({c.first, middle, c.parts / 2, c.capacity}, scratch);
      sort_into_leaves({middle, c.last, c.parts - c.parts / 2, c.capacity}, scratch);
    } else if (c.capacity > kBlockLanes) {
      sort_into_leaves(children_of(c.first, c.last), scratch);
    }
  }

  void fill(std::size_t first, std::size_t last) {
    const std::size_t index = first / kBlockLanes;
    TriangleBlock& leaf = tree_.leaves[index];
    leaf.count = static_cast<std::uint32_t>(last - first);
    std::array<std::array<float, 3>, 3> c;
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      leaf.triangle[i] = entries_[first + (i < leaf.count ? i : 0)].triangle;
      find_corners(leaf.triangle[i], c);
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) leaf.corner[k][j][i] = c[k][j];
      }
    }
    areas_[index] = detail::area_sum(leaf);
  }

  void make_node(const NodeRange& at) {
    each_child(at, [&](std::size_t lane, const NodeRange& child) {
      if (!tree_.nodes[at.node].has_leaves) make_node(child);
      bound({at.node, lane, child.first, child.last});
    });
    repeat_first(tree_.nodes[at.node]);
  }

  void bound(const Lane& at) {
    const std::size_t first = at.first / kBlockLanes, last = (at.last + kBlockLanes - 1) / kBlockLanes;
    Vec3 direction = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i) direction += Vec3(areas_[i][0], areas_[i][1], areas_[i][2]);
    detail::bound_leaves({tree_.leaves.data() + first, last - first}, direction, tree_.rounding_mm,
                         tree_.nodes[at.node], at.lane);
  }

  static void repeat_first(NodeBlock& node) {
    for (std::size_t lane = node.count; lane < kBlockLanes; ++lane) {
      for (std::size_t k = 0; k < 3; ++k) {
        node.center[k][lane] = node.center[k][0];
        node.normal[k][lane] = node.normal[k][0];
      }
      node.half_thickness_mm[lane] = node.half_thickness_mm[0];
      node.disc_radius_mm[lane] = node.disc_radius_mm[0];
      node.radius_mm[lane] = node.radius_mm[0];
      node.child[lane] = node.child[0];
    }
  }

  unsigned threads_;
  std::size_t total_ = 0;
  BlockTree tree_;
  std::vector<Entry> entries_;
  std::vector<std::array<float, 3>> areas_;  // by leaf
  std::vector<Subtree> subtrees_;
  std::vector<Lane> lanes_;           // lanes of the nodes above the subtrees
  std::vector<std::uint32_t> upper_;  // indices of the nodes above the subtrees
};

}  // namespace

BlockTree build_block_tree(std::span<const IndexedMesh> meshes, unsigned threads, std::string_view stage,
                           const ProgressCall& progress) {
  return Builder(meshes, threads).build(stage, progress);
}

}  // namespace gouge
