#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/parallel.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {
namespace {

// Widening of every stored length: twice what single precision does to a coordinate of that size.
constexpr double kSingle = 1.2e-7;

/// What is sorted: a triangle by the middle of its box and its direction.
struct Entry {
  std::array<float, 6> key;
  std::uint32_t triangle;
};

// Directions count as a place of their own: the two sides of a thin wall belong into different nodes, and a node
// that goes round a corner has no thin disc.
constexpr float kDirectionShare = 0.35F;

class Builder {
 public:
  Builder(std::span<const IndexedMesh> meshes, unsigned threads) : threads_(threads) {
    std::uint32_t total = 0;
    Box3 box;
    for (const IndexedMesh& mesh : meshes) {
      tree_.meshes.push_back(&mesh);
      tree_.first_triangle.push_back(total);
      total += static_cast<std::uint32_t>(mesh.triangles.size());
      box.extend(mesh.box());
    }
    if (total == 0) return;
    tree_.origin = box.center();
    tree_.rounding_mm = kSingle * 0.5 * box.diagonal().norm();
    entries_.resize(total);
  }

  BlockTree build() {
    if (entries_.empty()) return std::move(tree_);
    for_each_chunk(entries_.size(), 1 << 14, threads_, [this](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) entries_[i] = entry(static_cast<std::uint32_t>(i));
    });
    plan(0, entries_.size());
    tree_.leaves.resize((entries_.size() + kBlockLanes - 1) / kBlockLanes);
    // Whole subtrees are sorted and bounded side by side; the few blocks above them follow.
    for_each_chunk(jobs_.size(), 1, threads_, [this](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) run(jobs_[j]);
    });
    for (std::size_t k = upper_.size(); k-- > 0;) bound_children(upper_[k]);
    return std::move(tree_);
  }

 private:
  /// A node over the entries [first, last).
  struct Job {
    std::uint32_t node = 0;
    std::size_t first = 0, last = 0;
  };

  [[nodiscard]] Entry entry(std::uint32_t triangle) const {
    const std::array<Vec3, 3> c = tree_.corners(triangle);
    const Vec3 middle = 0.5 * (c[0].cwiseMin(c[1]).cwiseMin(c[2]) + c[0].cwiseMax(c[1]).cwiseMax(c[2]));
    const Vec3 area = (c[1] - c[0]).cross(c[2] - c[0]);
    const double length = area.norm();
    Entry e{{}, triangle};
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      e.key[at] = static_cast<float>(middle[k] - tree_.origin[k]);
      e.key[at + 3] = length > 0 ? static_cast<float>(area[k] / length) : 0.0F;
    }
    return e;
  }

  /// Triangles one child of a node over `count` of them holds: a power of 16, so that all blocks but the last of
  /// each level are full.
  static std::size_t child_capacity(std::size_t count) {
    std::size_t capacity = kBlockLanes;
    while (capacity * kBlockLanes < count) capacity *= kBlockLanes;
    return capacity;
  }

  static std::size_t nodes_below(std::size_t count) {
    if (count <= kBlockLanes * kBlockLanes) return 1;
    const std::size_t capacity = child_capacity(count);
    const std::size_t full = count / capacity;
    return 1 + full * nodes_below(capacity) + (count % capacity > 0 ? nodes_below(count % capacity) : 0);
  }

  // The nodes of a subtree stand together, the parent first, so that where they go is known before any is made.
  void plan(std::size_t first, std::size_t last) {
    constexpr std::size_t kJob = 1 << 16;
    tree_.nodes.resize(nodes_below(last - first));
    plan_node({0, first, last}, kJob);
  }

  void plan_node(const Job& at, std::size_t job_size) {
    if (at.last - at.first <= job_size) {
      jobs_.push_back(at);
      return;
    }
    upper_.push_back(at);
    for (const Job& child : divide(at)) plan_node(child, job_size);
  }

  /// Sorts the entries of a node into its children and names them in the node.
  std::vector<Job> divide(const Job& at) {
    const std::size_t count = at.last - at.first;
    const std::size_t capacity = child_capacity(count);
    NodeBlock& node = tree_.nodes[at.node];
    node.has_leaves = capacity == kBlockLanes;
    node.count = static_cast<std::uint32_t>((count + capacity - 1) / capacity);
    bisect(at.first, at.last, node.count, capacity);
    std::vector<Job> children;
    auto next = at.node + 1;
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const std::size_t first = at.first + i * capacity;
      const std::size_t last = std::min(at.last, first + capacity);
      node.child[i] = node.has_leaves ? static_cast<std::uint32_t>(first / kBlockLanes) : next;
      children.push_back({node.child[i], first, last});
      if (!node.has_leaves) next += static_cast<std::uint32_t>(nodes_below(last - first));
    }
    return children;
  }

  void bisect(std::size_t first, std::size_t last, std::size_t parts, std::size_t capacity) {
    if (parts <= 1) return;
    const std::size_t middle = first + (parts / 2) * capacity;
    const std::size_t axis = widest(first, last);
    const auto at = [this](std::size_t k) { return entries_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last), [axis](const Entry& a, const Entry& b) {
      return a.key[axis] < b.key[axis] || (!(b.key[axis] < a.key[axis]) && a.triangle < b.triangle);
    });
    bisect(first, middle, parts / 2, capacity);
    bisect(middle, last, parts - parts / 2, capacity);
  }

  [[nodiscard]] std::size_t widest(std::size_t first, std::size_t last) const {
    std::array<float, 6> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        low[k] = std::min(low[k], entries_[i].key[k]);
        high[k] = std::max(high[k], entries_[i].key[k]);
      }
    }
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (high[k] - low[k] > high[best] - low[best]) best = k;
    }
    const float size = (high[best] - low[best]) * kDirectionShare;
    std::size_t turn = 3;
    for (std::size_t k = 4; k < 6; ++k) {
      if (high[k] - low[k] > high[turn] - low[turn]) turn = k;
    }
    return (high[turn] - low[turn]) * size > high[best] - low[best] ? turn : best;
  }

  void run(const Job& job) {
    const bool is_above_leaves = child_capacity(job.last - job.first) == kBlockLanes;
    for (const Job& child : divide(job)) {
      if (is_above_leaves) {
        fill(tree_.leaves[child.node], child.first, child.last);
      } else {
        run(child);
      }
    }
    bound_children(job);
  }

  void fill(TriangleBlock& leaf, std::size_t first, std::size_t last) {
    leaf.count = static_cast<std::uint32_t>(last - first);
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      const std::size_t from = first + (i < leaf.count ? i : 0);
      leaf.triangle[i] = entries_[from].triangle;
      const std::array<Vec3, 3> c = tree_.corners(entries_[from].triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) {
          const auto jj = static_cast<Eigen::Index>(j);
          leaf.corner[k][j][i] = static_cast<float>(c[k][jj] - tree_.origin[jj]);
        }
      }
    }
  }

  void bound_children(const Job& at) {
    NodeBlock& node = tree_.nodes[at.node];
    const std::size_t capacity = child_capacity(at.last - at.first);
    for (std::size_t i = 0; i < node.count; ++i) {
      const std::size_t first = at.first + i * capacity;
      bound(node, i, first, std::min(at.last, first + capacity));
    }
    for (std::size_t i = node.count; i < kBlockLanes; ++i) repeat_first(node, i);
  }

  /// Calls `visit` with every rounded corner of the entries [first, last); they start a leaf.
  template <typename Visit>
  void each_corner(std::size_t first, std::size_t last, const Visit& visit) const {
    for (std::size_t i = first; i < last; ++i) {
      const TriangleBlock& leaf = tree_.leaves[i / kBlockLanes];
      const std::size_t lane = i % kBlockLanes;
      for (const auto& c : leaf.corner) visit(Vec3(c[0][lane], c[1][lane], c[2][lane]));
    }
  }

  void bound(NodeBlock& node, std::size_t lane, std::size_t first, std::size_t last) const {
    const Vec3 normal = direction(first, last);
    const Vec3 u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
    each_corner(first, last, [&](const Vec3& x) {
      const Vec3 local(u.dot(x), v.dot(x), normal.dot(x));
      low = low.cwiseMin(local);
      high = high.cwiseMax(local);
    });
    const Vec3 mid = 0.5 * (low + high);
    const Vec3 exact = mid.x() * u + mid.y() * v + mid.z() * normal;
    const Vec3 center = exact.cast<float>().cast<double>();
    double radius2 = 0, disc2 = 0, thickness = 0;
    each_corner(first, last, [&](const Vec3& x) {
      const Vec3 d = x - center;
      const double height = normal.dot(d);
      thickness = std::max(thickness, std::abs(height));
      radius2 = std::max(radius2, d.squaredNorm());
      disc2 = std::max(disc2, (d - height * normal).squaredNorm());
    });
    for (std::size_t k = 0; k < 3; ++k) {
      const auto kk = static_cast<Eigen::Index>(k);
      node.center[k][lane] = static_cast<float>(center[kk]);
      node.normal[k][lane] = static_cast<float>(normal[kk]);
    }
    // The rounded normal leans by 1e-7 from the exact one, hence the radius in the widening of all three.
    const double radius = std::sqrt(radius2);
    const double more = tree_.rounding_mm + 4 * kSingle * radius + 1e-9;
    node.half_thickness_mm[lane] = rounded_up(thickness + more);
    node.disc_radius_mm[lane] = rounded_up(std::sqrt(disc2) + more);
    node.radius_mm[lane] = rounded_up(radius + more);
  }

  [[nodiscard]] Vec3 direction(std::size_t first, std::size_t last) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i) {
      const auto& c = tree_.leaves[i / kBlockLanes].corner;
      const std::size_t lane = i % kBlockLanes;
      const auto at = [&](std::size_t k) { return Vec3(c[k][0][lane], c[k][1][lane], c[k][2][lane]); };
      sum += (at(1) - at(0)).cross(at(2) - at(0));
    }
    const double length = sum.norm();
    return (length > 0 ? Vec3(sum / length) : Vec3::UnitZ()).cast<float>().cast<double>();
  }

  static float rounded_up(double length) {
    return std::nextafter(static_cast<float>(length), std::numeric_limits<float>::max());
  }

  static void repeat_first(NodeBlock& node, std::size_t lane) {
    for (std::size_t k = 0; k < 3; ++k) {
      node.center[k][lane] = node.center[k][0];
      node.normal[k][lane] = node.normal[k][0];
    }
    node.half_thickness_mm[lane] = node.half_thickness_mm[0];
    node.disc_radius_mm[lane] = node.disc_radius_mm[0];
    node.radius_mm[lane] = node.radius_mm[0];
    node.child[lane] = node.child[0];
  }

  unsigned threads_;
  BlockTree tree_;
  std::vector<Entry> entries_;
  std::vector<Job> jobs_, upper_;
};

}  // namespace

BlockTree build_block_tree(std::span<const IndexedMesh> meshes, unsigned threads) {
  return Builder(meshes, threads).build();
}

}  // namespace gouge
