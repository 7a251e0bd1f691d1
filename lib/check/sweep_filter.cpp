#include "lib/check/sweep_filter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "lib/check/triangle_lanes.h"
#include "lib/geom/point_triangle.h"
#include "lib/tool/convex_cover.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr std::size_t kGroup = 4;  // number of steps or groups that share a frame one level up
// A node is opened for a whole group only if it is larger than half the group's path length by this factor: space is
// divided first. Smaller nodes are left to the parts of the group: time is divided first.
constexpr float kSpaceFirst = 12.0F;
// Limits of the sweep, after which the exact search takes over: how often triangles and time are divided, and the
// number of examined parts.
constexpr std::size_t kCuts = 10;
constexpr std::uint32_t kMaxParts = 1200;
constexpr std::size_t kMaxBlocks = 200;
constexpr float kProgress = 0.95F;
constexpr int kFailures = 1;
// Limit for a standing tool. There, bounds of whole triangles fail mostly at edges of the tool, where smaller triangles
// do not help.
constexpr std::uint32_t kMaxStandingParts = 10;
// A point is measured if it may exceed the deepest known one by this share of the gap.
constexpr float kWorthMeasuring = 0.75F;
// Maximum swing of a triangle's corners for which smaller triangles do not pay.
constexpr float kSmallSwing_mm = 0.01F;

/// Bounds of one move so far.
struct MoveWork {
  float min_pruned = std::numeric_limits<float>::max();         ///< smallest pruned bound of the current target
  double certified_mm = std::numeric_limits<double>::lowest();  ///< upper bound of the value in all pruned parts
  std::vector<SearchSeed> open;                                 ///< parts that no bound has pruned
};

/// The work that a group leaves to its parts.
struct Remainder {
  std::vector<std::uint32_t> nodes;
  std::vector<const TriangleBlock*> blocks;
  std::deque<TriangleBlock> gathered;  // triangles from several leaves, side by side
};

class Sweep {
 public:
  Sweep(std::span<const Motion> motions, std::span<const CoverTarget> targets, const SearchQuery& query,
        const SweepKernel& kernel)
      : motions_(motions),
        targets_(targets),
        query_(query),
        kernel_(kernel),
        work_(motions.size()),
        swept_(motions.size()) {}

  std::vector<SweptMove> run() {
    for (std::uint32_t m = 0; m < motions_.size(); ++m) append_steps(motions_[m], m, steps_);
    for (target_ = 0; target_ < targets_.size(); ++target_) {
      tool_ = targets_[target_].tool;
      tree_ = targets_[target_].tree;
      reach_mm_ = query_.reach_mm + targets_[target_].reach_mm;
      if (tree_->nodes.empty() || steps_.empty()) continue;
      forget_frames();
      for (const CoverPiece& piece : targets_[target_].cover->pieces) {
        piece_ = kernel_piece(piece);
        Remainder all;
        all.nodes.push_back(0);
        visit_group(frames_.size() - 1, 0, all, std::numeric_limits<float>::max());
      }
      for (MoveWork& work : work_) close_target(work);
    }
    for (std::size_t m = 0; m < motions_.size(); ++m) finish(m);
    return std::move(swept_);
  }

 private:
  // Targets may differ in their reach, so their certified bounds are combined as values, not as distances.
  void close_target(MoveWork& work) const {
    const float least = std::exchange(work.min_pruned, std::numeric_limits<float>::max());
    work.certified_mm = std::max(work.certified_mm, reach_mm_ - static_cast<double>(least));
  }

  // Discards all frames; they are built again when needed. Most are never needed: the parts of a pruned group have no
  // frames.
  void forget_frames() {
    frames_.clear();
    for (std::size_t size = 1;; size *= kGroup) {
      frames_.emplace_back((steps_.size() + size - 1) / size);
      if (frames_.back().size() == 1) break;
    }
    remainders_.resize(frames_.size());
  }

  const SweepFrame& frame_of(std::size_t level, std::size_t index) {
    std::optional<SweepFrame>& frame = frames_[level][index];
    if (!frame) {
      const std::size_t size = steps_below(level), first = index * size;
      frame = sweep_frame(std::span(steps_).subspan(first, std::min(size, steps_.size() - first)), tree_->origin,
                          rounding_mm());
    }
    return *frame;
  }

  // Returns the rounding of the corners in the tree, plus that of the middles of edges for each division of a triangle.
  [[nodiscard]] double rounding_mm() const { return static_cast<double>(kCuts + 2) * tree_->rounding_mm; }

  /// Returns the signed distance to prove for a move, given the largest value found on it.
  [[nodiscard]] float need(double value_mm) const {
    // Any bound reaches this distance, even that of a part that no piece bounds.
    if (query_.is_met_by(value_mm)) return std::numeric_limits<float>::lowest();
    const double distance = reach_mm_ - query_.pruning_threshold_mm(value_mm);
    return std::nextafter(static_cast<float>(distance), std::numeric_limits<float>::max());
  }

  void visit_group(std::size_t level, std::size_t index, const Remainder& work, float least) {
    if (level == 0) return visit_step(index, work, least);
    const SweepFrame& frame = frame_of(level, index);
    Remainder& rest = remainders_[level];
    rest.nodes.clear();
    rest.blocks.clear();
    rest.gathered.clear();
    min_ = least;
    need_ = need(0);
    smallest_ = kSpaceFirst * (0.5F * frame.displacement_mm + frame.rest_mm);
    for (const TriangleBlock* block : work.blocks) gather(*block, frame, rest);
    for (const std::uint32_t node : work.nodes) visit_node_for_group(node, frame, rest);
    const float now = min_;
    // Bounds that are computed for the whole group count for its first move.
    swept_[steps_[index * steps_below(level)].move].bounds += std::exchange(bounds_, 0);
    const std::size_t first = index * kGroup;
    const std::size_t last = std::min(first + kGroup, frames_[level - 1].size());
    if (rest.nodes.empty() && rest.blocks.empty()) return settle_group(level, index, now);
    for (std::size_t k = first; k < last; ++k) visit_group(level - 1, k, rest, now);
  }

  static std::size_t steps_below(std::size_t level) {
    std::size_t size = 1;
    for (std::size_t k = 0; k < level; ++k) size *= kGroup;
    return size;
  }

  void settle_group(std::size_t level, std::size_t index, float least) {
    const std::size_t size = steps_below(level);
    const std::size_t last = std::min(steps_.size(), (index + 1) * size);
    for (std::size_t s = index * size; s < last; ++s) {
      float& known = work_[steps_[s].move].min_pruned;
      known = std::min(known, least);
    }
  }

  void visit_node_for_group(std::uint32_t index, const SweepFrame& frame, Remainder& rest) {
    const NodeBlock& node = tree_->nodes[index];
    KernelResult result;
    kernel_.nodes(node, frame, piece_, need_, result);
    ++bounds_;
    min_ = std::min(min_, result.min_pruned);
    float widest = 0;
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      widest = std::max(widest, node.radius_mm[static_cast<std::size_t>(std::countr_zero(open))]);
    }
    if (result.open == 0) return;
    if (widest <= smallest_) return rest.nodes.push_back(index);
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      const std::uint32_t child = node.child[static_cast<std::size_t>(std::countr_zero(open))];
      if (node.has_leaves) {
        gather(tree_->leaves[child], frame, rest);
      } else {
        visit_node_for_group(child, frame, rest);
      }
    }
  }

  void gather(const TriangleBlock& leaf, const SweepFrame& frame, Remainder& rest) {
    KernelResult result;
    kernel_.triangles(leaf, frame, piece_, need_, result);
    ++bounds_;
    min_ = std::min(min_, result.min_pruned);
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      if (rest.gathered.empty() || rest.gathered.back().count == kBlockLanes) {
        rest.gathered.emplace_back();
        rest.blocks.push_back(&rest.gathered.back());
      }
      add_lane(rest.gathered.back(), leaf, static_cast<std::size_t>(std::countr_zero(open)));
    }
  }

  void visit_step(std::size_t index, const Remainder& work, float least) {
    step_ = &steps_[index];
    frame_ = &frame_of(0, index);
    min_ = least;
    const std::uint32_t m = step_->move;
    if (tool_ != nullptr && m > 0 && swept_[m].start.value_mm <= 0 &&
        swept_[m - 1].start.value_mm > query_.tolerance_mm && swept_[m - 1].start.at.target == target_) {
      measure(*step_, swept_[m - 1].start.at.triangle, swept_[m - 1].start.point);
    }
    need_ = need(swept_[m].start.value_mm);
    begin(0);
    for (const TriangleBlock* block : work.blocks) visit_triangles(*block);
    for (const std::uint32_t node : work.nodes) visit_node(node);
    parts_ = 0;
    if (tool_ == nullptr) {
      give_up(waiting_[0]);  // without measured points, dividing the triangles further is left to the caller's search
    } else {
      refine(*step_, *frame_, 0, short_of_, 0);
    }
    work_[m].min_pruned = std::min(work_[m].min_pruned, min_);
    swept_[m].bounds += std::exchange(bounds_, 0);
  }

  void visit_node(std::uint32_t index) {
    const NodeBlock& node = tree_->nodes[index];
    KernelResult result;
    float asked = need_;
    kernel_.nodes(node, *frame_, piece_, asked, result);
    ++bounds_;
    min_ = std::min(min_, result.min_pruned);
    // The deepest child comes first: its result prunes most of the others.
    std::array<std::uint8_t, kBlockLanes> order;
    std::size_t count = 0;
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::uint8_t>(std::countr_zero(open));
      std::size_t at = count++;
      for (; at > 0 && result.distance[lane] < result.distance[order[at - 1]]; --at) order[at] = order[at - 1];
      order[at] = lane;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t lane = order[k];
      if (need_ < asked) {
        // A bound below the requested distance is not proved, because the distance of its closest points was not
        // tested.
        asked = need_;
        kernel_.nodes(node, *frame_, piece_, asked, result);
        ++bounds_;
      }
      if (result.bound[lane] >= asked) {
        min_ = std::min(min_, result.bound[lane]);
      } else if (node.has_leaves) {
        visit_triangles(tree_->leaves[node.child[lane]]);
      } else {
        visit_node(node.child[lane]);
      }
    }
  }

  void visit_triangles(const TriangleBlock& block) { look(block, *step_, *frame_, waiting_[0]); }

  /// Examines triangles during a part of a move. Those that stay open are added to `waiting`.
  void look(const TriangleBlock& block, const SweepInterval& step, const SweepFrame& frame,
            std::vector<TriangleBlock>& waiting) {
    KernelResult result;
    bool is_measured = false;
    for (;;) {
      kernel_.triangles(block, frame, piece_, need_, result);
      ++bounds_;
      if (result.open == 0 || std::exchange(is_measured, true)) break;
      const float asked = need_;
      measure_deepest(block, result, step, frame);
      // A deeper point lowers the distance to prove.
      if (need_ >= asked) break;
    }
    min_ = std::min(min_, result.min_pruned);
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      short_of_ = std::max(short_of_, need_ - result.bound[lane]);
      append_lane(waiting, block, lane);
    }
  }

  void measure_deepest(const TriangleBlock& block, const KernelResult& result, const SweepInterval& step,
                       const SweepFrame& frame) {
    if (tool_ == nullptr) return;
    auto deepest = static_cast<std::size_t>(std::countr_zero(result.open));
    for (std::uint32_t open = result.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      if (result.distance[lane] < result.distance[deepest]) deepest = lane;
    }
    // A point that is deeper prunes more, even if it is not a gouge by itself.
    if (!(result.distance[deepest] < need_ + kWorthMeasuring * static_cast<float>(query_.gap_mm))) return;
    const Vec3 from_tip(result.point[0][deepest], result.point[1][deepest], result.point[2][deepest]);
    measure(step, block.triangle[deepest], from_tip + Vec3(frame.tip[0], frame.tip[1], frame.tip[2]) + tree_->origin);
  }

  // Divides triangles or time. If a triangle is examined from its nearest point, time makes the bound slack. The bound
  // includes the motion of the nearest point and the swing of the triangle's corners about it. Smaller triangles swing
  // less.
  void refine(const SweepInterval& step, const SweepFrame& frame, std::size_t depth, float short_of, int failures) {
    if (waiting_[depth].empty()) return;
    const bool is_standing = !(step.t1 > step.t0);
    const std::uint32_t max_parts = is_standing ? kMaxStandingParts : kMaxParts;
    if (depth == kCuts || waiting_[depth].size() > kMaxBlocks || parts_ >= max_parts) return give_up(waiting_[depth]);
    parts_ += static_cast<std::uint32_t>(waiting_[depth].size());
    const float edge_mm = kSmallSwing_mm / std::max(frame.half_turn, 1e-9F);
    if (is_standing || (piece_.core_r_mm > 0 && !are_short(waiting_[depth], edge_mm))) {
      begin(depth + 1);
      short_of_ = short_of;
      for (const TriangleBlock& block : waiting_[depth])
        look_at_quarters(block, step, frame, is_standing ? 0 : edge_mm, waiting_[depth + 1]);
      return refine(step, frame, depth + 1, short_of_, failures);
    }
    for (const SweepInterval& half : halved(motions_[step.move], step)) {
      const float needed = need_;
      const SweepFrame half_frame = sweep_frame({&half, 1}, tree_->origin, rounding_mm());
      begin(depth + 1);
      for (const TriangleBlock& block : waiting_[depth]) look(block, half, half_frame, waiting_[depth + 1]);
      // Half the time should halve the missing distance. It does not at edges of the tool and where the cover is not
      // tight; there the exact search is better.
      const int failed = short_of_ > kProgress * short_of && need_ >= needed ? failures + 1 : 0;
      if (failed > kFailures) {
        give_up(waiting_[depth + 1]);
      } else {
        refine(half, half_frame, depth + 1, short_of_, failed);
      }
    }
  }

  void begin(std::size_t depth) {
    waiting_[depth].clear();
    short_of_ = 0;
  }

  /// Divides triangles with an edge longer than `edge_mm` into four; the other triangles stay in `waiting`.
  void look_at_quarters(const TriangleBlock& block, const SweepInterval& step, const SweepFrame& frame, float edge_mm,
                        std::vector<TriangleBlock>& waiting) {
    TriangleBlock quarters;
    quarters.count = 0;
    for (std::size_t i = 0; i < block.count; ++i) {
      if (longest_edge(block, i) > edge_mm) {
        add_quarters(quarters, block, i);
      } else {
        append_lane(waiting, block, i);
      }
      if (quarters.count + 4 <= kBlockLanes && i + 1 < block.count) continue;
      if (quarters.count > 0) look(quarters, step, frame, waiting);
      quarters.count = 0;
    }
  }

  void give_up(const std::vector<TriangleBlock>& blocks) {
    for (const TriangleBlock& block : blocks) {
      for (std::size_t i = 0; i < block.count; ++i) {
        work_[step_->move].open.push_back({target_, block.triangle[i]});
      }
    }
  }

  /// Measures the value at the point of the triangle nearest to `about`, at three instants of the step.
  void measure(const SweepInterval& step, std::uint32_t triangle, const Vec3& about) {
    SearchStart& swept = swept_[step.move].start;
    const Vec3 p = closest_on_triangle(about, tree_->corners(triangle)).point;
    for (const double t : {step.t0, step.middle(), step.t1}) {
      const double value = reach_mm_ - signed_distance_mm(*tool_, motions_[step.move].at(t), p);
      if (value <= swept.value_mm) continue;
      swept.value_mm = value;
      swept.t = t;
      swept.point = p;
      swept.at = {target_, triangle};
    }
    need_ = need(swept.value_mm);
  }

  // Stores the result of a move. A triangle may have stayed open for several pieces or steps; it is listed once.
  void finish(std::size_t m) {
    std::vector<SearchSeed>& open = work_[m].open;
    const auto key = [](const SearchSeed& seed) { return std::pair(seed.target, seed.triangle); };
    std::sort(open.begin(), open.end(), [key](const auto& a, const auto& b) { return key(a) < key(b); });
    open.erase(std::unique(open.begin(), open.end(), [key](const auto& a, const auto& b) { return key(a) == key(b); }),
               open.end());
    swept_[m].start.seeds = std::move(open);
    swept_[m].start.certified_mm = work_[m].certified_mm;
  }

  std::span<const Motion> motions_;
  std::span<const CoverTarget> targets_;
  const SearchQuery& query_;
  const SweepKernel& kernel_;
  std::vector<SweepInterval> steps_;
  std::vector<MoveWork> work_;
  std::vector<SweptMove> swept_;

  // Members for the current target and piece.
  std::uint32_t target_ = 0;
  const CompiledTool* tool_ = nullptr;
  const BlockTree* tree_ = nullptr;
  double reach_mm_ = 0;
  KernelPiece piece_;
  std::vector<std::vector<std::optional<SweepFrame>>> frames_;  // [level][index]; level 0 has one for each step
  std::vector<Remainder> remainders_;                           // one for each level

  // Members for the current group or step.
  std::array<std::vector<TriangleBlock>, kCuts + 1> waiting_;
  const SweepInterval* step_ = nullptr;
  const SweepFrame* frame_ = nullptr;
  float need_ = 0, min_ = 0, smallest_ = 0;
  float short_of_ = 0;  ///< largest missing distance of the waiting triangles
  std::uint32_t parts_ = 0;
  std::uint64_t bounds_ = 0;
};

}  // namespace

std::vector<SweptMove> sweep_moves(std::span<const Motion> motions, const std::vector<SearchTarget>& targets,
                                   const SearchQuery& query, const SweepKernel& kernel) {
  std::vector<ConvexCover> covers(targets.size());
  std::vector<CoverTarget> covered(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!targets[i].tree->nodes.empty()) covers[i] = make_convex_cover(*targets[i].tool);
    covered[i] = {&covers[i], targets[i].tree, targets[i].tool, targets[i].reach_mm};
  }
  return sweep_covers(motions, covered, query, kernel);
}

std::vector<SweptMove> sweep_covers(std::span<const Motion> motions, std::span<const CoverTarget> targets,
                                    const SearchQuery& query, const SweepKernel& kernel) {
  return Sweep(motions, targets, query, kernel).run();
}

}  // namespace gouge
