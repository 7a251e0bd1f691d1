#include "lib/overcut/deep_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lib/check/search.h"
#include "lib/check/sweep_filter.h"
#include "lib/check/sweep_frame.h"
#include "lib/check/sweep_kernel.h"
#include "lib/check/triangle_lanes.h"

namespace gouge {
namespace {

constexpr int kCuts = 20;                 // maximum number of divisions of triangles and time
constexpr std::size_t kMaxBlocks = 2000;  // number of examined blocks, after which all that is open counts as deep

using Blocks = std::vector<TriangleBlock>;

/// The search of one motion against one tree.
class DeepFinder {
 public:
  DeepFinder(const Motion& motion, const BlockTree& tree, const Eigen::Matrix3d& frame, double depth_mm, double size_mm)
      : motion_(motion),
        tree_(tree),
        frame_(frame),
        need_(std::nextafter(static_cast<float>(-depth_mm), std::numeric_limits<float>::max())),
        size_mm_(static_cast<float>(size_mm)),
        boxes_(motion.segments().size()) {}

  std::vector<Box3> find(const ConvexCover& cover, const std::vector<SearchSeed>& seeds) {
    const Blocks all = blocks_of(seeds);
    std::vector<SweepInterval> steps;
    append_steps(motion_, 0, steps);
    for (const CoverPiece& piece : cover.pieces) {
      piece_ = kernel_piece(piece);
      for (const SweepInterval& step : steps) {
        deep_ = &boxes_[step.segment];
        examine(all, step, 0);
      }
    }
    return std::move(boxes_);
  }

 private:
  [[nodiscard]] Blocks blocks_of(const std::vector<SearchSeed>& seeds) const {
    Blocks blocks;
    for (const SearchSeed& seed : seeds) {
      TriangleBlock one;
      one.count = 1;
      one.triangle[0] = seed.triangle;
      const std::array<Vec3, 3> corners = tree_.corners(seed.triangle);
      for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::Vector3f corner = (corners[c] - tree_.origin).cast<float>();
        for (std::size_t k = 0; k < 3; ++k) one.corner[c][k][0] = corner[static_cast<Eigen::Index>(k)];
      }
      append_lane(blocks, one, 0);
    }
    return blocks;
  }

  /// Returns the rounding of the corners in the tree, plus that of the middles of edges for each division.
  [[nodiscard]] double rounding_mm() const { return (kCuts + 2) * tree_.rounding_mm; }

  void examine(const Blocks& blocks, const SweepInterval& step, int cuts) {
    const SweepFrame frame = sweep_frame({&step, 1}, tree_.origin, rounding_mm());
    Blocks open;
    float longest = 0;
    for (const TriangleBlock& block : blocks) {
      KernelResult result;
      fastest_sweep_kernel().triangles(block, frame, piece_, need_, result);
      for (std::uint32_t i = 0; i < block.count; ++i) {
        if ((result.open >> i & 1U) == 0 || is_known(block, i)) continue;
        append_lane(open, block, i);
        longest = std::max(longest, longest_edge(block, i));
      }
    }
    if (open.empty()) return;
    examined_ += blocks.size();
    const bool is_small = std::max(longest, frame.displacement_mm) <= size_mm_;
    if (is_small || cuts == kCuts || examined_ > kMaxBlocks) return add(open);
    if (frame.displacement_mm > longest) {
      for (const SweepInterval& half : halved(motion_, step)) examine(open, half, cuts + 1);
      return;
    }
    examine(quartered(open, 0.5F * longest), step, cuts + 1);
  }

  /// Divides the triangles that have an edge longer than `edge_mm`.
  static Blocks quartered(const Blocks& blocks, float edge_mm) {
    Blocks parts;
    for (const TriangleBlock& block : blocks) {
      for (std::size_t i = 0; i < block.count; ++i) {
        if (longest_edge(block, i) <= edge_mm) {
          append_lane(parts, block, i);
          continue;
        }
        TriangleBlock four;
        four.count = 0;
        add_quarters(four, block, i);
        for (std::size_t k = 0; k < four.count; ++k) append_lane(parts, four, k);
      }
    }
    return parts;
  }

  [[nodiscard]] Vec3 corner(const TriangleBlock& block, std::size_t lane, std::size_t c) const {
    const auto& at = block.corner[c];
    return frame_ * (tree_.origin + Eigen::Vector3f(at[0][lane], at[1][lane], at[2][lane]).cast<double>());
  }

  [[nodiscard]] bool is_known(const TriangleBlock& block, std::size_t lane) const {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!deep_->contains(corner(block, lane, c))) return false;
    }
    return true;
  }

  void add(const Blocks& blocks) {
    const Vec3 rounding = Vec3::Constant(rounding_mm());
    for (const TriangleBlock& block : blocks) {
      for (std::size_t i = 0; i < block.count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const Vec3 at = corner(block, i, c);
          deep_->extend(Vec3(at - rounding)).extend(Vec3(at + rounding));
        }
      }
    }
  }

  const Motion& motion_;
  const BlockTree& tree_;
  const Eigen::Matrix3d& frame_;
  float need_;
  float size_mm_;
  KernelPiece piece_;
  std::size_t examined_ = 0;
  std::vector<Box3> boxes_;  // by segment
  Box3* deep_ = nullptr;     // of the present segment
};

/// Returns the triangles that may be deeper than `depth_mm`.
std::vector<SearchSeed> deep_triangles(const Motion& motion, const ConvexCover& cover, const BlockTree& tree,
                                       double depth_mm) {
  // A sweep without a tool measures nothing, so it prunes at the depth itself.
  const std::array<CoverTarget, 1> targets{CoverTarget{&cover, &tree, nullptr, 0}};
  SearchQuery query;
  query.tolerance_mm = depth_mm;
  return sweep_covers({&motion, 1}, targets, query).front().start.seeds;
}

}  // namespace

std::vector<Box3> deep_surface(const Motion& motion, const ConvexCover& cover, const BlockTree& tree,
                               const Eigen::Matrix3d& frame, double depth_mm, double size_mm) {
  return DeepFinder(motion, tree, frame, depth_mm, size_mm).find(cover, deep_triangles(motion, cover, tree, depth_mm));
}

}  // namespace gouge
